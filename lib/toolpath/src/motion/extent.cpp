// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes around the path of a motion: extremes of arcs and spirals, control points of splines,
// sampled joints.
#include "ncsim/toolpath/extent.h"

#include "ncsim/base/angles.h"
#include "ncsim/machine/inverse.h"
#include "ncsim/toolpath/kinematics.h"

#include "motion/axis_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::toolpath {

using gcode::Position;

namespace {

// Returns by how many degrees beyond 90 a coordinate of a spiral is farthest out, relative to its
// axis. `radius` is the radius at 90 degrees, `growth` the growth of the radius per radian.
double spiral_lead(double radius, double growth) {
    // r' cos d = r sin d, thus cot d = radius / growth + d =: x + d, for d up to a quarter turn.
    // The cotangent is convex: Newton's steps from below stay below.
    constexpr double kRadian = 180.0 / std::numbers::pi;
    const double x = radius / std::abs(growth);
    const double least = x + std::numbers::pi / 2;
    if (growth == 0.0 || !(least > 0.0)) return 0.0;
    double d = angle_of(least, 1.0) / kRadian;
    for (int i = 0; i < 8 && d > 0.0; ++i) {
        const SinCos at = sin_cos(d * kRadian);
        d += (at.cos * at.sin - (x + d) * at.sin * at.sin) / (1.0 + at.sin * at.sin);
    }
    return std::copysign(d * kRadian, growth);
}

// Adds the points of an arc at which a coordinate is farthest out: at right angles to the
// coordinate's axis, on a spiral close to there.
void add_extremes(Box& box, const gcode::Arc& arc, const PolarArc& p) {
    const double low = std::min(p.start_degrees, p.start_degrees + p.sweep_degrees);
    const double high = std::max(p.start_degrees, p.start_degrees + p.sweep_degrees);
    const double growth = (p.end_radius - p.start_radius) / p.sweep_degrees;  // mm a degree
    const double beyond = growth == 0.0 ? 0.0 : 90.0;
    // Multiples of 90 degrees are exact.
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter)
    for (double q = std::ceil((low - beyond) / 90.0) * 90.0; q <= high + beyond; q += 90.0) {
        // Radii grow or shrink monotonically, so the first and the last turn are farthest out.
        if (q > low + 450.0 && q < high - 450.0) q = std::floor((high - 450.0) / 90.0) * 90.0;
        const double radius = p.start_radius + (q - p.start_degrees) * growth;
        const double at = q + spiral_lead(radius, growth * 180.0 / std::numbers::pi);
        if (at < low || at > high) continue;
        box.add(linear_axes(arc_position(arc, p, (at - p.start_degrees) / p.sweep_degrees)));
    }
}

// Adds balls about the centre of an arc in a tilted plane, at its start and its end; the balls
// contain the arc.
void add_balls(Box& box, const gcode::Arc& arc) {
    const gcode::Arc own = gcode::in_own_frame(arc);
    const PolarArc p = polar(own);
    const double radius = std::max(p.start_radius, p.end_radius);
    for (const Position& end : {own.from, own.to}) {
        const gcode::Arc circle{end, end, own.plane, own.centre_1, own.centre_2, 1, {}};
        const Position middle =
            arc_position(circle, {p.centre_1, p.centre_2, 0.0, 0.0, 0.0, 0.0}, 0.5);
        const Vec3 at = linear_axes(gcode::to_parent(*arc.tilted, middle));
        const Vec3 reach{radius, radius, radius};
        box.add(at - reach);
        box.add(at + reach);
    }
}

}  // namespace

Box extent_of_joints(const gcode::Motion& motion, const Kinematics& machine) {
    Box box;
    const Position* from = start_of(motion);
    const Position* to = end_of(motion);
    if (!from || !to) return box;
    const Poses poses(&machine, motion);
    const auto* arc = std::get_if<gcode::Arc>(&motion.action);
    const PolarArc p = arc ? polar(*arc) : PolarArc{};
    const auto degrees = [](gcode::Angle a, gcode::Angle b) { return std::abs((b - a).degrees()); };
    constexpr double kStep = 0.25;
    constexpr double kMost = 100'000;
    const double turn = degrees(from->a, to->a) + degrees(from->b, to->b) +
                        degrees(from->c, to->c) + std::abs(p.sweep_degrees);
    const double steps = std::clamp(std::ceil(turn / kStep), 1.0, kMost);
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        const Position at =
            arc ? arc_position(*arc, p, i / steps) : interpolate(*from, *to, i / steps);
        machine::Values now = values_of(at);
        for (const machine::Joint& joint : poses.chain()->joints) {
            const std::size_t letter = *machine::index_of(joint.letter);
            if (letter >= 6) now[letter] = 0.0;  // X, Y and Z make the motion of U, V and W
        }
        const auto values = machine::values_for(*poses.chain(), poses.at(at).translation, now);
        if (!values) return {};
        box.add(Vec3{(*values)[0], (*values)[1], (*values)[2]});
    }
    return box;
}

namespace {

Box extent_of_axes(const gcode::Motion& motion) {
    Box box;
    const Position* from = start_of(motion);
    const Position* to = end_of(motion);
    box.add(linear_axes(*from));
    box.add(linear_axes(*to));
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        if (arc->tilted) {
            add_balls(box, *arc);
        } else {
            add_extremes(box, *arc, polar(*arc));
        }
    } else if (const auto* spline = std::get_if<gcode::Spline>(&motion.action)) {
        for (const auto& point : spline->control_points) {
            Position p = *from;
            p.x = point.x, p.y = point.y;
            box.add(linear_axes(p));
        }
    }
    return box;
}

// Returns the motion with U, V and W at 0; an arc of U, V or W becomes a line.
gcode::Motion remove_second_axes(const gcode::Motion& motion) {
    gcode::Motion first = motion;
    const auto still = [](Position& p) { p.u = p.v = p.w = gcode::Length(); };
    if (auto* linear = std::get_if<gcode::Linear>(&first.action)) {
        still(linear->from), still(linear->to);
    } else if (auto* arc = std::get_if<gcode::Arc>(&first.action)) {
        still(arc->from), still(arc->to);
        if (arc->plane >= gcode::Plane::UV) first.action = gcode::Linear{arc->from, arc->to};
    } else if (auto* spline = std::get_if<gcode::Spline>(&first.action)) {
        still(spline->from), still(spline->to);
    }
    return first;
}

}  // namespace

Box extent_of_path(const gcode::Motion& motion, const Poses& poses) {
    const Position* from = start_of(motion);
    const Position* to = end_of(motion);
    if (!from || !to) return {};
    const double reach =
        poses.has_tip_control() ? second_axes(*poses.chain(), motion).reach_mm : 0.0;
    if (reach == 0.0) return extent_of_axes(motion);
    const bool turns = from->a != to->a || from->b != to->b || from->c != to->c;
    if (std::holds_alternative<gcode::Linear>(motion.action) && !turns) {
        Box box;
        box.add(poses.place(*from));
        box.add(poses.place(*to));
        return box;
    }
    Box box = extent_of_axes(remove_second_axes(motion));
    const Vec3 margin{reach, reach, reach};
    return {box.min - margin, box.max + margin};
}

}  // namespace ncsim::toolpath
