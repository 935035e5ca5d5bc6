// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of polygons into triangles.
#include "meshes/polygons.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/triangulate.h"

#include <cmath>
#include <cstddef>

namespace ncsim::setup {

namespace {

// Returns Newell's normal, whose length is twice the area.
Vec3 normal_of(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& face) {
    Vec3 sum;
    const Vec3 origin = points[face[0]];
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum = sum + cross(points[face[i]] - origin, points[face[i + 1]] - origin);
    return sum;
}

}  // namespace

std::vector<Vec3> corners_of(const Polygons& polygons) {
    // Beyond this, doubles are too coarse for the computations.
    constexpr double kFarthest = 1e9;
    for (const Vec3& p : polygons.points) {
        if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest))
            throw Refused{"it has a corner that is no place"};
    }
    cda::Boundary surface;
    surface.vertices = polygons.points;
    std::vector<Vec3> corners;
    for (const std::vector<std::uint32_t>& face : polygons.faces) {
        if (face.size() < 3) continue;
        for (const std::uint32_t corner : face) {
            if (corner >= polygons.points.size())
                throw Refused{"a face names a corner that is not there"};
        }
        if (face.size() == 3) {
            for (const std::uint32_t corner : face)
                corners.push_back(polygons.points[corner]);
            continue;
        }
        const Vec3 normal = normal_of(polygons.points, face);
        if (!(norm(normal) > 0.0)) continue;
        cda::BoundaryFace flat;
        flat.normal = normalized(normal);
        flat.offset = dot(flat.normal, polygons.points[face[0]]);
        flat.loops = {face};
        surface.faces.push_back(std::move(flat));
    }
    if (surface.faces.empty()) return corners;
    const TriangleMesh mesh = cda::triangulate(surface);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle)
            corners.push_back(mesh.vertices[corner]);
    }
    return corners;
}

}  // namespace ncsim::setup
