// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of cubic B-splines whose inner knots have multiplicity 2: Spline, ParameterCurve.
#pragma once

#include "geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace ncsim::brep {

/// Piece of a spline between two knots, as a cubic of Bézier.
template <class Curve>
struct SplinePiece {
    using Point = typename decltype(Curve::points)::value_type;

    /// Requires: `number` + 1 is the index of a knot.
    SplinePiece(const Curve& curve, std::size_t number)
        : points{node_of(curve, number), curve.points[2 * number + 1], curve.points[2 * number + 2],
                 node_of(curve, number + 1)} {}

    /// Returns the point of the curve at a knot.
    static Point node_of(const Curve& curve, std::size_t knot) {
        const auto& k = curve.knots;
        if (knot == 0) return curve.points.front();
        if (knot + 1 == k.size()) return curve.points.back();
        const double share = (k[knot] - k[knot - 1]) / (k[knot + 1] - k[knot - 1]);
        return (1.0 - share) * curve.points[2 * knot] + share * curve.points[2 * knot + 1];
    }

    /// Returns the control points of both parts at the share `s`: four each, the middle one common.
    std::array<Point, 7> divided(double s) const {
        const auto between = [s](const Point& a, const Point& b) { return (1.0 - s) * a + s * b; };
        const Point a = between(points[0], points[1]), b = between(points[1], points[2]),
                    c = between(points[2], points[3]);
        const Point ab = between(a, b), bc = between(b, c);
        return {points[0], a, ab, between(ab, bc), bc, c, points[3]};
    }

    std::array<Point, 4> points;
};

/// Returns the number of the piece with the parameter `place`.
template <class Curve>
std::size_t piece_at(const Curve& curve, double place) {
    const auto after = std::ranges::upper_bound(curve.knots, place) - curve.knots.begin();
    return std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, curve.knots.size() - 1) - 1;
}

/// Divides a spline at the parameter `place`, or at a knot that differs from `place` by rounding.
template <class Curve>
std::array<Curve, 2> divided_at(const Curve& curve, double place) {
    const auto& k = curve.knots;
    const auto offset = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    const double near = kRounding * (k.back() - k.front());
    std::array<Curve, 2> halves;
    auto& [first, second] = halves;
    std::size_t i = piece_at(curve, place);
    if (k[i + 1] - place < near && i + 2 < k.size()) ++i;
    if (place - k[i] < near && i > 0) {
        const auto node = SplinePiece<Curve>::node_of(curve, i);
        const auto middle = curve.points.begin() + offset(2 * i + 1);
        first.points.assign(curve.points.begin(), middle);
        first.points.push_back(node);
        first.knots.assign(k.begin(), k.begin() + offset(i + 1));
        second.points.assign(1, node);
        second.points.insert(second.points.end(), middle, curve.points.end());
        second.knots.assign(k.begin() + offset(i), k.end());
        return halves;
    }
    const auto parts = SplinePiece<Curve>(curve, i).divided((place - k[i]) / (k[i + 1] - k[i]));
    first.points.assign(curve.points.begin(), curve.points.begin() + offset(2 * i + 1));
    first.points.insert(first.points.end(), parts.begin() + 1, parts.begin() + 4);
    first.knots.assign(k.begin(), k.begin() + offset(i + 1));
    first.knots.push_back(place);
    second.points.assign(parts.begin() + 3, parts.begin() + 6);
    second.points.insert(second.points.end(), curve.points.begin() + offset(2 * i + 3),
                         curve.points.end());
    second.knots.assign(1, place);
    second.knots.insert(second.knots.end(), k.begin() + offset(i + 1), k.end());
    return halves;
}

}  // namespace ncsim::brep
