// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact clipping of convex polygons.
#include "ncsim/cda/polygon.h"

namespace ncsim::cda {

ConvexPolygon ConvexPolygon::of_facet(const ConvexPolytope& polytope, std::uint32_t facet) {
    const auto& f = polytope.facets()[facet];
    ConvexPolygon polygon;
    polygon.plane = f.plane;
    polygon.corners.reserve(f.vertices.size());
    polygon.edges.reserve(f.vertices.size());
    for (const std::uint32_t v : f.vertices)
        polygon.corners.push_back(polytope.vertices()[v]);
    for (const std::uint32_t n : f.neighbours) {
        polygon.edges.push_back(polytope.facets()[n].plane);
    }
    return polygon;
}

std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, const Plane& cut) {
    const std::size_t n = polygon.corners.size();
    std::vector<Side> side(n);
    bool any_below = false;
    bool any_above = false;
    for (std::size_t i = 0; i < n; ++i) {
        side[i] = classify(polygon.corners[i], cut);
        any_below |= side[i] == Side::Below;
        any_above |= side[i] == Side::Above;
    }
    if (!any_below) return std::nullopt;
    if (!any_above) return polygon;
    ConvexPolygon part;
    part.plane = polygon.plane;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = (i + 1) % n;
        const bool enters = side[i] == Side::Above && side[k] == Side::Below;
        const bool leaves = side[i] == Side::Below && side[k] == Side::Above;
        if (side[i] != Side::Above) {
            part.corners.push_back(polygon.corners[i]);
            // The edge after a corner on the cut is in the cut, unless the edge leads back inside.
            part.edges.push_back(side[i] == Side::On && side[k] != Side::Below ? cut
                                                                               : polygon.edges[i]);
        }
        if (enters || leaves) {
            part.corners.push_back(*meet(polygon.plane, polygon.edges[i], cut));
            part.edges.push_back(enters ? polygon.edges[i] : cut);
        }
    }
    return part;
}

std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, std::span<const Plane> cuts) {
    std::optional<ConvexPolygon> part = polygon;
    for (const Plane& cut : cuts) {
        if (!part) break;
        part = below(*part, cut);
    }
    return part;
}

Overlap overlap(const ConvexPolygon& polygon, std::span<const Plane> cuts,
                std::vector<Plane>& crossing) {
    crossing.clear();
    for (const Plane& cut : cuts) {
        bool any_below = false;
        bool any_above = false;
        for (const ExactPoint& corner : polygon.corners) {
            const Side side = classify(corner, cut);
            any_below |= side == Side::Below;
            any_above |= side == Side::Above;
        }
        if (!any_below) return Overlap::None;
        if (any_above) crossing.push_back(cut);
    }
    return crossing.empty() ? Overlap::Covered : Overlap::Undecided;
}

void subtract(const ConvexPolygon& polygon, std::span<const Plane> cuts,
              std::vector<ConvexPolygon>& rest) {
    std::vector<Plane> crossing;
    switch (overlap(polygon, cuts, crossing)) {
        case Overlap::None: rest.push_back(polygon); return;
        case Overlap::Covered: return;
        case Overlap::Undecided: break;
    }
    const std::size_t before = rest.size();
    ConvexPolygon inside = polygon;
    for (const Plane& cut : crossing) {
        auto next = below(inside, cut);
        if (!next) {  // no common area
            rest.resize(before);
            rest.push_back(polygon);
            return;
        }
        if (auto outside = below(inside, cut.opposite())) rest.push_back(std::move(*outside));
        inside = std::move(*next);
    }
}

ConvexPolygon reversed(const ConvexPolygon& polygon) {
    ConvexPolygon turned;
    turned.plane = polygon.plane.opposite();
    turned.corners.assign(polygon.corners.rbegin(), polygon.corners.rend());
    // The edge into a corner becomes the edge out of the corner.
    const std::size_t n = polygon.edges.size();
    for (std::size_t i = 0; i < n; ++i)
        turned.edges.push_back(polygon.edges[(2 * n - 2 - i) % n]);
    return turned;
}

double area(const ConvexPolygon& polygon) {
    const Vec3 a = polygon.corners[0].approx;
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
        sum = sum + cross(polygon.corners[i].approx - a, polygon.corners[i + 1].approx - a);
    }
    return 0.5 * dot(unit_normal(polygon.plane), sum);
}

}  // namespace ncsim::cda
