// SPDX-License-Identifier: GPL-3.0-or-later
//
// Difference of polygons with exact rational corners. The result is expressed in planes: every edge
// of the result lies on an edge of the facet or of a mask.
#include "flat/facet_difference.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>

namespace ncsim::cda {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Exact = Number::ET;
using Point2 = Kernel::Point_2;
using Polygon2 = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles2 = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet2 = CGAL::Polygon_set_2<Kernel>;

Exact exact(Int128 v) {
    // Three digits of 43 bits, each exactly a double.
    const bool negative = v < 0;
    if (negative) v = -v;
    constexpr Int128 kBase = Int128{1} << 43;
    Exact sum(0);
    for (const Int128 digit : {v >> 86, (v >> 43) % kBase, v % kBase}) {
        sum = sum * Exact(static_cast<double>(kBase)) + Exact(static_cast<double>(digit));
    }
    return negative ? Exact(-sum) : sum;
}

// Projection of the plane along the axis in which the normal is longest, oriented so that
// counter-clockwise loops seen from above the plane stay counter-clockwise.
struct Projection {
    int first = 0, second = 1, dropped = 2;

    explicit Projection(const Plane& plane) {
        const std::array<std::int64_t, 3> n{plane.nx, plane.ny, plane.nz};
        dropped = static_cast<int>(
            std::max_element(n.begin(), n.end(),
                             [](auto a, auto b) { return std::abs(a) < std::abs(b); }) -
            n.begin());
        first = (dropped + 1) % 3;
        second = (dropped + 2) % 3;
        if (n[static_cast<std::size_t>(dropped)] < 0) std::swap(first, second);
    }

    Point2 operator()(const ExactPoint& p) const {
        const std::array<Int128, 3> c{p.x, p.y, p.z};
        const Exact w = exact(p.w);
        return {Number(exact(c[static_cast<std::size_t>(first)]) / w),
                Number(exact(c[static_cast<std::size_t>(second)]) / w)};
    }
};

std::array<std::int64_t, 3> normal_of(const Plane& p) {
    return {p.nx, p.ny, p.nz};
}

// The line in which `edge` cuts `plane`, in projected coordinates: a·x + b·y = c.
struct ProjectedLine {
    Number a, b, c;
    Plane edge;

    ProjectedLine(const Plane& plane, const Plane& cut, const Projection& view) : edge(cut) {
        // Eliminates the dropped coordinate.
        const auto n = normal_of(plane);
        const auto m = normal_of(cut);
        const auto at = [](const auto& v, int i) {
            return static_cast<Int128>(v[static_cast<std::size_t>(i)]);
        };
        const Int128 p = at(m, view.dropped);
        const Int128 q = at(n, view.dropped);
        a = Number(exact(q * at(m, view.first) - p * at(n, view.first)));
        b = Number(exact(q * at(m, view.second) - p * at(n, view.second)));
        c = Number(exact(q * cut.d - p * plane.d));
    }
    bool passes_through(const Point2& v) const { return a * v.x() + b * v.y() == c; }
};

Polygon2 project(const ConvexPolygon& polygon, const Projection& view) {
    Polygon2 projected;
    for (const ExactPoint& corner : polygon.corners)
        projected.push_back(view(corner));
    if (projected.orientation() == CGAL::CLOCKWISE) projected.reverse_orientation();
    return projected;
}

// Expresses a loop of the result in planes; empty if the loop has no area.
std::vector<Fragment::Corner> name_loop(const Polygon2& loop, const Plane& plane,
                                        const std::vector<ProjectedLine>& lines) {
    const std::size_t n = loop.size();
    std::vector<Plane> edges;
    for (std::size_t i = 0; i < n; ++i) {
        const Point2& tail = loop[i];
        const Point2& head = loop[(i + 1) % n];
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const ProjectedLine& l) {
            return l.passes_through(tail) && l.passes_through(head);
        });
        if (line != lines.end()) edges.push_back(line->edge);
    }
    std::vector<Fragment::Corner> corners;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        // Corners on a straight edge are not corners; `meet` returns no point there.
        const Plane& before = edges[(i + edges.size() - 1) % edges.size()];
        if (const auto corner = meet(plane, before, edges[i])) {
            corners.push_back({*corner, edges[i]});
        }
    }
    return corners.size() < 3 ? std::vector<Fragment::Corner>{} : corners;
}

}  // namespace

std::vector<Fragment> facet_difference(const ConvexPolygon& facet,
                                       std::span<const ConvexPolygon> masks, Origin origin) {
    const Projection view(facet.plane);
    std::vector<Polygon2> holes;
    std::vector<ProjectedLine> lines;
    const auto add_lines = [&](const ConvexPolygon& polygon) {
        for (const Plane& edge : polygon.edges) {
            const bool known = std::any_of(lines.begin(), lines.end(), [&](const ProjectedLine& l) {
                return l.edge == edge || l.edge == edge.opposite();
            });
            if (!known) lines.emplace_back(facet.plane, edge, view);
        }
    };
    add_lines(facet);
    for (const ConvexPolygon& mask : masks) {
        holes.push_back(project(mask, view));
        add_lines(mask);
    }
    PolygonSet2 rest;
    rest.join(holes.begin(), holes.end());
    PolygonSet2 result(project(facet, view));
    result.difference(rest);

    std::vector<PolygonWithHoles2> parts;
    result.polygons_with_holes(std::back_inserter(parts));
    std::vector<Fragment> fragments;
    for (const PolygonWithHoles2& part : parts) {
        Fragment fragment;
        fragment.plane = facet.plane;
        fragment.origin = origin;
        auto outline = name_loop(part.outer_boundary(), facet.plane, lines);
        if (outline.empty()) continue;
        fragment.loops.push_back(std::move(outline));
        for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) {
            auto loop = name_loop(*hole, facet.plane, lines);
            if (!loop.empty()) fragment.loops.push_back(std::move(loop));
        }
        fragments.push_back(std::move(fragment));
    }
    return fragments;
}

}  // namespace ncsim::cda
