// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex hulls of dual points by CGAL, as bodies with volume, corners and facets.
#include "cgal_intersection.h"

#include "ncsim/base/vec3.h"

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

namespace ncsim::bench {

namespace {

template <class Kernel>
CgalBody intersection(const std::vector<cda::Plane>& planes) {
    std::vector<typename Kernel::Plane_3> halfspaces;
    halfspaces.reserve(planes.size());
    for (const cda::Plane& p : planes)
        halfspaces.emplace_back(p.nx, p.ny, p.nz, -static_cast<double>(p.d));
    CGAL::Polyhedron_3<Kernel> body;
    CGAL::halfspace_intersection_3(halfspaces.begin(), halfspaces.end(), body);
    CgalBody result;
    result.corners = body.size_of_vertices();
    result.facets = body.size_of_facets();
    if (result.corners == 0) return result;
    const auto corner = [](const auto& halfedge) {
        const auto& p = halfedge->vertex()->point();
        // Only some digits of a lazy number are known before exact().
        return Vec3{CGAL::to_double(CGAL::exact(p.x())), CGAL::to_double(CGAL::exact(p.y())),
                    CGAL::to_double(CGAL::exact(p.z()))};
    };
    const Vec3 centre = corner(body.halfedges_begin());
    for (auto f = body.facets_begin(); f != body.facets_end(); ++f) {
        const auto first = f->halfedge();
        const Vec3 a = corner(first) - centre;
        for (auto h = first->next(); h->next() != first; h = h->next()) {
            result.volume += dot(a, cross(corner(h) - centre, corner(h->next()) - centre)) / 6.0;
        }
    }
    return result;
}

}  // namespace

CgalBody cgal_intersection_exact(const std::vector<cda::Plane>& planes) {
    return intersection<CGAL::Exact_predicates_exact_constructions_kernel>(planes);
}

CgalBody cgal_intersection_in_doubles(const std::vector<cda::Plane>& planes) {
    return intersection<CGAL::Exact_predicates_inexact_constructions_kernel>(planes);
}

}  // namespace ncsim::bench
