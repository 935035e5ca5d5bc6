// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundary evaluation with Nef polyhedra of CGAL.
#include "nef/nef_part.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ncsim::test {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

// Halfspace with normal · x <= offset.
struct Halfspace {
    Vector normal;
    Number offset;
};

Halfspace halfspace_of(const cda::Plane& plane) {
    return {Vector(plane.nx, plane.ny, plane.nz), Number(static_cast<double>(plane.d))};
}

// Returns the ends of the segment that all halfspaces leave of the line in which the planes `i` and
// `j` meet; empty if there is no segment.
std::optional<std::pair<Point, Point>> edge_of(const std::vector<Halfspace>& all, std::size_t i,
                                               std::size_t j) {
    const Vector along = CGAL::cross_product(all[i].normal, all[j].normal);
    const Number square = along.squared_length();
    if (square == 0) return std::nullopt;
    // The point of both planes that is nearest to the origin.
    const Vector on = (all[i].offset * CGAL::cross_product(all[j].normal, along) +
                       all[j].offset * CGAL::cross_product(along, all[i].normal)) /
                      square;
    std::optional<Number> low, high;
    for (const Halfspace& h : all) {
        const Number slope = h.normal * along;
        const Number room = h.offset - h.normal * on;
        if (slope == 0) {
            if (room < 0) return std::nullopt;
            continue;
        }
        const Number at = room / slope;
        if (slope > 0 && (!high || at < *high)) high = at;
        if (slope < 0 && (!low || at > *low)) low = at;
        if (low && high && *low > *high) return std::nullopt;
    }
    if (!low || !high) return std::nullopt;
    return std::pair{CGAL::ORIGIN + (on + *low * along), CGAL::ORIGIN + (on + *high * along)};
}

// Returns the polyhedron of a cell; empty if the cell has no volume.
Nef nef_of(const cda::Cell& cell) {
    std::vector<Halfspace> all;
    for (const cda::Plane& plane : cell.planes)
        all.push_back(halfspace_of(plane));
    std::vector<Point> corners;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (const auto edge = edge_of(all, i, j)) {
                corners.push_back(edge->first);
                corners.push_back(edge->second);
            }
        }
    }
    Polyhedron hull;
    if (corners.size() >= 4) CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
    if (!hull.is_closed() || hull.size_of_facets() < 4) return Nef(Nef::EMPTY);
    return Nef(hull);
}

double rounded(const Number& x) {
    return CGAL::to_double(CGAL::exact(x));
}

}  // namespace

class NefPart::Impl {
public:
    Nef part;
};

NefPart::NefPart(const cda::Cell& stock) : impl_(std::make_unique<Impl>()) {
    impl_->part = nef_of(stock);
}

NefPart::~NefPart() = default;

void NefPart::subtract(const cda::Cell& cell) {
    impl_->part = (impl_->part - nef_of(cell)).regularization();
}

std::vector<Vec3> NefPart::corners() const {
    std::vector<Vec3> corners;
    for (auto v = impl_->part.vertices_begin(); v != impl_->part.vertices_end(); ++v) {
        corners.push_back(
            {rounded(v->point().x()), rounded(v->point().y()), rounded(v->point().z())});
    }
    std::ranges::sort(corners, {}, [](const Vec3& p) { return std::tuple{p.x, p.y, p.z}; });
    return corners;
}

double NefPart::volume() const {
    // Sums over the facet cycles of the material's shells. Outlines and holes have opposite
    // orientations.
    Number sum = 0;
    const Nef& part = impl_->part;
    for (auto f = part.halffacets_begin(); f != part.halffacets_end(); ++f) {
        // Each facet has two sides; only the side at the material counts.
        if (!f->incident_volume()->mark()) continue;
        for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
            if (!cycle.is_shalfedge()) continue;
            const Nef::SHalfedge_const_handle start = cycle;
            Nef::SHalfedge_around_facet_const_circulator edge{start}, first{edge};
            const Vector a = edge->source()->source()->point() - CGAL::ORIGIN;
            std::vector<Vector> points;
            CGAL_For_all(edge, first)
                points.push_back(edge->source()->source()->point() - CGAL::ORIGIN);
            for (std::size_t i = 1; i + 1 < points.size(); ++i)
                sum += a * CGAL::cross_product(points[i], points[i + 1]);
        }
    }
    return rounded(sum < 0 ? Number(-sum / 6) : Number(sum / 6));
}

}  // namespace ncsim::test
