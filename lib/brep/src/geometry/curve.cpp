// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and derivatives on lines, circles, ellipses and splines.
#include "ncsim/brep/curve.h"

#include "ncsim/base/angles.h"

#include "geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::brep {

namespace {

// Returns the angle in (0, 360]; 0 except for rounding counts as a whole turn.
double as_sweep(double degrees) {
    while (degrees <= kRounding)
        degrees += 360.0;
    while (degrees > 360.0 + kRounding)
        degrees -= 360.0;
    return degrees;
}

// Piece of a spline, width of the piece, and position in the piece from 0 to 1.
struct Place {
    std::size_t piece;
    double width, s;
};

Place place_in(const Spline& spline, double t) {
    const auto& k = spline.knots;
    const double at = k.front() + t * (k.back() - k.front());
    const auto above = std::upper_bound(k.begin(), k.end(), at);
    const auto piece = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - k.begin() - 1, 0, std::ptrdiff_t(k.size()) - 2));
    const double width = k[piece + 1] - k[piece];
    return {piece, width, (at - k[piece]) / width};
}

// Ends of a piece and the derivatives there, by s. At an inner knot, the spline divides the segment
// between two control points in the ratio of the adjacent pieces.
struct Hermite {
    Vec3 p0, p1, d0, d1;
};

Hermite hermite(const Spline& spline, const Place& place) {
    const auto& p = spline.points;
    const auto& k = spline.knots;
    const auto at_knot = [&](std::size_t i) {
        if (i == 0) return p.front();
        if (i + 1 == k.size()) return p.back();
        const double before = k[i] - k[i - 1], after = k[i + 1] - k[i];
        return (1.0 / (before + after)) * (after * p[2 * i] + before * p[2 * i + 1]);
    };
    const std::size_t i = place.piece;
    const Vec3 p0 = at_knot(i), p1 = at_knot(i + 1);
    return {p0, p1, 3.0 * (p[2 * i + 1] - p0), 3.0 * (p1 - p[2 * i + 2])};
}

}  // namespace

Track::Track(const Curve& curve, Vec3 from, Vec3 to) : curve_(&curve), from_(from), to_(to) {
    if (const auto* c = std::get_if<Circle>(curve_)) {
        // The track has the distance of the start from the axis, even if the start is off the
        // circle.
        centre_ = c->centre + dot(from - c->centre, c->axis) * c->axis;
        x_ = from - centre_;
        y_ = cross(c->axis, x_);
        const Vec3 end = to - centre_;
        sweep_ = as_sweep(from == to ? 360.0 : angle_of(dot(end, x_), dot(end, y_)));
    } else if (const auto* e = std::get_if<Ellipse>(curve_)) {
        centre_ = e->centre;
        const Vec3 minor = cross(e->axis, e->major);
        x_ = e->major_radius * e->major;
        y_ = e->minor_radius * minor;
        const auto angle = [&](Vec3 p) {
            return angle_of(dot(p - centre_, e->major) / e->major_radius,
                            dot(p - centre_, minor) / e->minor_radius);
        };
        start_ = angle(from);
        sweep_ = as_sweep(from == to ? 360.0 : angle(to) - start_);
    }
}

Track::Step Track::step(double t) const {
    if (is_straight()) return {from_ + t * (to_ - from_), to_ - from_};
    if (const auto* spline = std::get_if<Spline>(curve_)) {
        const Place place = place_in(*spline, t);
        const Hermite h = hermite(*spline, place);
        const double s = place.s, r = 1.0 - s;
        const Vec3 by_s = (6.0 * s * r) * (h.p1 - h.p0) + (r * r - 2.0 * s * r) * h.d0 +
                          (s * s - 2.0 * s * r) * h.d1;
        return {(r * r * (1.0 + 2.0 * s)) * h.p0 + (s * r * r) * h.d0 +
                    (s * s * (3.0 - 2.0 * s)) * h.p1 + (-s * s * r) * h.d1,
                ((spline->knots.back() - spline->knots.front()) / place.width) * by_s};
    }
    const auto angle = sin_cos(start_ + t * sweep_);
    const double turn = sweep_ * kRadiansPerDegree;
    return {centre_ + angle.cos * x_ + angle.sin * y_, turn * (angle.cos * y_ - angle.sin * x_)};
}

std::size_t Track::pieces() const {
    if (is_straight()) return 1;
    if (const auto* spline = std::get_if<Spline>(curve_)) return spline->knots.size() - 1;
    return static_cast<std::size_t>(sweep_ / 15.0) + 1;
}

double Track::start_of(std::size_t i) const {
    if (const auto* spline = std::get_if<Spline>(curve_)) {
        const auto& k = spline->knots;
        return (k[i] - k.front()) / (k.back() - k.front());
    }
    return static_cast<double>(i) / static_cast<double>(pieces());
}

}  // namespace ncsim::brep
