// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/brep/patch.h"

#include "ncsim/trig/angles.h"

#include "around.h"

#include <algorithm>

namespace ncsim::brep {

namespace {

using cda::cross;
using cda::dot;

// The arc from x to y about `centre`, both of its radius and at right angles; in cubics that have
// the ends and directions of the arc, and meet it in the middle (Goldapp, Approximation of Circular
// Arcs by Cubic Polynomials, 1991).
Spline spline_of_arc(Vec3 centre, Vec3 x, Vec3 y, double begin, double end) {
    constexpr double kPiece = 7.5;  // degrees
    const int pieces = std::max(1, static_cast<int>((end - begin) / kPiece) + 1);
    const double width = (end - begin) / pieces;
    const double handle = 4.0 / 3.0 * trig::tangent(0.25 * width);
    Spline spline;
    for (int i = 0; i <= pieces; ++i) {
        const auto t = trig::sin_cos(begin + i * width);
        const Vec3 at = centre + t.cos * x + t.sin * y;
        const Vec3 on = handle * (t.cos * y - t.sin * x);
        spline.points.push_back(i == 0 ? at : at - on);
        spline.points.push_back(i == pieces ? at : at + on);
        spline.knots.push_back(i);
    }
    return spline;
}

}  // namespace

Patch patch_of(const Part& part, const Face& face) {
    const auto& dome = std::get<Dome>(face.surface.form);
    const Vec3 x = face.frame.x, y = cross(dome.axis, x);
    double first = 360.0, last = 0.0, low = 90.0, high = -90.0;
    for (const auto& points : points_along(part, face)) {
        for (const Vec3& p : points) {
            const DomePlace place = place_on(dome, p);
            double angle = trig::angle_of(dot(place.out, x), dot(place.out, y));
            if (angle < 0.0) angle += 360.0;
            first = std::min(first, angle);
            last = std::max(last, angle);
            low = std::min(low, place.degrees());
            high = std::max(high, place.degrees());
        }
    }
    constexpr double kBeyond = 4.0;  // degrees
    first = std::max(0.0, first - kBeyond);
    last = std::min(360.0, last + kBeyond);
    return {spline_of_arc({}, dome.radius * x, dome.radius * y, first, last),
            spline_of_arc(dome.centre, dome.reach * dome.ahead, dome.reach * dome.axis,
                          low - kBeyond, high + kBeyond)};
}

}  // namespace ncsim::brep
