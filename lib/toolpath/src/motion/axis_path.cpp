// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs in polar coordinates, shifts by U, V and W, and B-splines.
#include "motion/axis_path.h"

#include "ncsim/base/angles.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

namespace {

// The two axes of an arc's plane, as members of Position.
struct ArcAxes {
    Length Position::*first;
    Length Position::*second;
};

ArcAxes axes_of(gcode::Plane plane) {
    switch (plane) {
        case gcode::Plane::XY: return {&Position::x, &Position::y};
        case gcode::Plane::ZX: return {&Position::z, &Position::x};
        case gcode::Plane::YZ: return {&Position::y, &Position::z};
        case gcode::Plane::UV: return {&Position::u, &Position::v};
        case gcode::Plane::WU: return {&Position::w, &Position::u};
        case gcode::Plane::VW: return {&Position::v, &Position::w};
    }
    return {&Position::x, &Position::y};
}

}  // namespace

Position interpolate(const Position& a, const Position& b, double t) {
    if (t <= 0.0) return a;
    if (t >= 1.0) return b;
    const auto length = [t](Length p, Length q) {
        return Length::from_mm(lerp(p.mm(), q.mm(), t));
    };
    const auto angle = [t](Angle p, Angle q) {
        return Angle::from_degrees(lerp(p.degrees(), q.degrees(), t));
    };
    return {length(a.x, b.x), length(a.y, b.y), length(a.z, b.z), angle(a.a, b.a), angle(a.b, b.b),
            angle(a.c, b.c),  length(a.u, b.u), length(a.v, b.v), length(a.w, b.w)};
}

PolarArc polar(const gcode::Arc& specified) {
    const gcode::Arc arc = gcode::in_own_frame(specified);
    const ArcAxes axes = axes_of(arc.plane);
    PolarArc p;
    p.centre_1 = arc.centre_1.mm();
    p.centre_2 = arc.centre_2.mm();
    const double x0 = (arc.from.*axes.first).mm() - p.centre_1;
    const double y0 = (arc.from.*axes.second).mm() - p.centre_2;
    const double x1 = (arc.to.*axes.first).mm() - p.centre_1;
    const double y1 = (arc.to.*axes.second).mm() - p.centre_2;
    p.start_radius = std::sqrt(x0 * x0 + y0 * y0);
    p.end_radius = std::sqrt(x1 * x1 + y1 * y1);
    p.start_degrees = angle_of(x0, y0);
    // Equal ends are a full circle. Angles that differ by less than this are equal except for
    // rounding.
    constexpr double kNoAngle = 1e-10;
    double sweep = angle_of(x1, y1) - p.start_degrees;
    if (arc.turns >= 0) {
        while (sweep <= kNoAngle)
            sweep += 360.0;
        sweep += 360.0 * std::max(0, arc.turns - 1);
    } else {
        while (sweep >= -kNoAngle)
            sweep -= 360.0;
        sweep -= 360.0 * (-arc.turns - 1);
    }
    p.sweep_degrees = sweep;
    return p;
}

Position arc_position(const gcode::Arc& arc, const PolarArc& p, double t) {
    if (arc.tilted && t > 0.0 && t < 1.0)
        return gcode::to_parent(*arc.tilted, arc_position(gcode::in_own_frame(arc), p, t));
    Position at = interpolate(arc.from, arc.to, t);
    if (t <= 0.0 || t >= 1.0) return at;
    const ArcAxes axes = axes_of(arc.plane);
    const double radius = lerp(p.start_radius, p.end_radius, t);
    const SinCos angle = sin_cos(p.start_degrees + t * p.sweep_degrees);
    at.*axes.first = Length::from_mm(p.centre_1 + radius * angle.cos);
    at.*axes.second = Length::from_mm(p.centre_2 + radius * angle.sin);
    return at;
}

SecondAxes second_axes(const machine::Chain& chain, const gcode::Motion& motion) {
    SecondAxes second;
    const Position* from = gcode::start_of(motion);
    const Position* to = gcode::end_of(motion);
    if (!from || !to) return second;
    const auto* arc = std::get_if<gcode::Arc>(&motion.action);
    const bool arc_position = arc && arc->plane >= gcode::Plane::UV;
    // Rotary axes between U, V and W may rotate them, so their directions are not perpendicular in
    // general.
    bool is_along = !arc_position;
    for (const auto axis : {&Position::u, &Position::v, &Position::w}) {
        const double a = (from->*axis).mm(), b = (to->*axis).mm();
        second.reach_mm += std::max(std::abs(a), std::abs(b));
        second.way_mm += std::abs(b - a);
        is_along &= axis == &Position::w || (a == 0.0 && b == 0.0);
    }
    if (second.reach_mm > 0.0)
        second.along_tool = is_along && (chain.find('W') || !chain.has_head());
    if (!arc_position) return second;
    const PolarArc p = polar(*arc);
    const double radius = std::max(p.start_radius, p.end_radius);
    second.reach_mm += 4.0 * radius;
    second.way_mm += 2.0 * (radius * kRadiansPerDegree * std::abs(p.sweep_degrees) +
                            std::abs(p.end_radius - p.start_radius));
    return second;
}

bool SplineCurve::is_sound() const {
    const std::size_t n = m_.control_points.size();
    return degree_ >= 1 && n > static_cast<std::size_t>(degree_) &&
           m_.knots.size() == n + static_cast<std::size_t>(m_.order) &&
           std::is_sorted(m_.knots.begin(), m_.knots.end()) && first() < last();
}

std::vector<double> SplineCurve::breaks() const {
    std::vector<double> all;
    for (const double k : m_.knots) {
        if (k >= first() && k <= last() && (all.empty() || all.back() < k)) all.push_back(k);
    }
    return all;
}

// Evaluates the curve with De Boor's algorithm in homogeneous coordinates. Source: Piegl and
// Tiller, The NURBS Book, 2nd ed. 1997, algorithm A4.1.
Position SplineCurve::at(double u) const {
    if (u <= first()) return m_.from;
    if (u >= last()) return m_.to;
    const auto p = static_cast<std::size_t>(degree_);
    std::size_t span = p;
    while (span + 1 < m_.control_points.size() && m_.knots[span + 1] <= u)
        ++span;
    struct Homogeneous {
        double x, y, w;
    };
    std::vector<Homogeneous> d;
    for (std::size_t j = 0; j <= p; ++j) {
        const auto& c = m_.control_points[span - p + j];
        d.push_back({c.x.mm() * c.weight, c.y.mm() * c.weight, c.weight});
    }
    for (std::size_t r = 1; r <= p; ++r) {
        for (std::size_t j = p; j >= r; --j) {
            const double low = m_.knots[span - p + j];
            const double high = m_.knots[span + 1 + j - r];
            const double a = high > low ? (u - low) / (high - low) : 0.0;
            d[j] = {lerp(d[j - 1].x, d[j].x, a), lerp(d[j - 1].y, d[j].y, a),
                    lerp(d[j - 1].w, d[j].w, a)};
        }
    }
    Position result = interpolate(m_.from, m_.to, (u - first()) / (last() - first()));
    if (d[p].w != 0.0) {
        result.x = Length::from_mm(d[p].x / d[p].w);
        result.y = Length::from_mm(d[p].y / d[p].w);
    }
    return result;
}

}  // namespace ncsim::toolpath
