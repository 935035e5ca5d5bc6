// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joint positions and speeds along straight moves and arcs, and division of motions into these.
#include "ncsim/toolpath/joint_path.h"

#include "ncsim/base/angles.h"
#include "ncsim/machine/inverse.h"

#include "motion/axis_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ncsim::toolpath {

using gcode::Position;
using machine::Ball;
using machine::Chain;
using machine::JointMotion;
using machine::Values;

struct JointPath::Course {
    Course(const Kinematics& kinematics, const gcode::Motion& motion)
        : machine(&kinematics), poses(&kinematics, motion) {}

    const Kinematics* machine;
    Poses poses;          // contains the chain in W
    bool solves = false;  // whether X, Y and Z follow from the tip
    double length_mm = 0.0;
    Position from, to;
    const gcode::Arc* arc = nullptr;
    PolarArc polar;
    // Bounds on derivatives over the whole motion: of the tip under tip control, otherwise of X, Y
    // and Z.
    double speed = 0.0, bend = 0.0;
    // Rotary joints of the chain next to the part and next to the tool.
    Chain part_side, tool_side;
    bool is_simple = true;  // no rotary joint between X, Y and Z

    Position at(double t) const {
        return arc ? arc_position(*arc, polar, t) : interpolate(from, to, t);
    }
};

namespace {

double size_of(gcode::Length from, gcode::Length to) {
    return std::abs((to - from).mm());
}

// Sums the ways of all linear axes, as if each were a direction of its own.
double linear_axes_distance(const Position& from, const Position& to) {
    return size_of(from.x, to.x) + size_of(from.y, to.y) + size_of(from.z, to.z) +
           size_of(from.u, to.u) + size_of(from.v, to.v) + size_of(from.w, to.w);
}

}  // namespace

JointPath::JointPath(const Kinematics& machine, const gcode::Motion& motion) {
    auto course = std::make_unique<Course>(machine, motion);
    Course& c = *course;
    const Chain& chain = *c.poses.chain();
    c.solves = c.poses.has_tip_control() || chain.has_second_axes();
    c.length_mm = motion.length.mm();
    c.from = *gcode::start_of(motion);
    c.to = *gcode::end_of(motion);
    c.arc = std::get_if<gcode::Arc>(&motion.action);
    if (c.arc) {
        c.polar = polar(*c.arc);
        const double sweep = kRadiansPerDegree * std::abs(c.polar.sweep_degrees);
        const double radius = std::max(c.polar.start_radius, c.polar.end_radius);
        const double change = std::abs(c.polar.end_radius - c.polar.start_radius);
        const gcode::Arc own = gcode::in_own_frame(*c.arc);
        c.speed = sweep * radius + change + linear_axes_distance(own.from, own.to);
        c.bend = sweep * sweep * radius + 2.0 * sweep * change;
    } else {
        c.speed = norm(c.poses.unrotated_place(c.to) - c.poses.unrotated_place(c.from));
    }
    if (c.solves) {
        // The shift of the tip by U, V and W rotates with the axes.
        const SecondAxes second = second_axes(chain, motion);
        const auto turn = [](gcode::Angle a, gcode::Angle b) {
            return kRadiansPerDegree * std::abs((b - a).degrees());
        };
        const double turns =
            turn(c.from.a, c.to.a) + turn(c.from.b, c.to.b) + turn(c.from.c, c.to.c);
        c.speed += second.way_mm + turns * second.reach_mm;
        c.bend += turns * (turns * second.reach_mm + 2.0 * second.way_mm);
    }
    bool has_moved = false, has_turned = false;
    for (const machine::Joint& joint : chain.joints) {
        if (*machine::index_of(joint.letter) >= 6) continue;  // U, V and W
        if (!joint.turns) {
            c.is_simple &= !has_turned;
            has_moved = true;
            continue;
        }
        has_turned = has_moved;
        (has_moved ? c.tool_side : c.part_side).joints.push_back(joint);
    }
    course_ = std::move(course);
}

JointPath::~JointPath() = default;
JointPath::JointPath(JointPath&&) noexcept = default;

std::optional<Values> JointPath::at(double t) const {
    const Course& c = *course_;
    const Position position = c.at(t);
    Values values = values_of(position);
    for (std::size_t i = 6; i < values.size(); ++i)
        values[i] = 0.0;
    if (c.solves) {
        const Vec3 tip = c.poses.at(position).translation;
        const auto found = machine::values_for(*c.poses.chain(), tip, values);
        if (!found) return std::nullopt;
        values = *found;
    } else {
        const Vec3 axes = linear_axes(position);
        for (int i = 0; i < 3; ++i)
            values[static_cast<std::size_t>(i)] = axes[i];
    }
    for (int i = 0; i < 3; ++i)
        values[static_cast<std::size_t>(i)] += c.machine->zero[i];
    values[2] += c.length_mm;
    return values;
}

std::optional<Ball> JointPath::tip(double t0, double t1) const {
    const Course& c = *course_;
    if (!c.poses.has_tip_control()) return std::nullopt;
    const Vec3 a = c.poses.place(c.at(t0)), b = c.poses.place(c.at(t1));
    const double part = t1 - t0;
    Ball ball;
    ball.centre = 0.5 * (a + b);
    ball.speed = part * c.speed;
    ball.bend = part * part * c.bend;
    ball.radius = 0.5 * norm(b - a) + ball.bend / 8.0;
    return ball;
}

// Under tip control, with X, Y and Z in a row between L next to the part and R next to the tool,
//
//     L(t) · (x u + y v + z w + R(t) o) = p(t)   so   x u + y v + z w = L(t)⁻¹ p(t) - R(t) o
//
// The directions u, v, w are perpendicular, so the speed of each of x, y and z is at most the sum
// of both terms' speeds.
std::optional<JointMotion> JointPath::joint_motion(double t0, const Values& from, double t1,
                                                   const Values& to) const {
    const Course& c = *course_;
    JointMotion joint_motion;
    joint_motion.from = from;
    joint_motion.to = to;
    const double part = t1 - t0;
    const auto tip = this->tip(t0, t1);
    if (!tip) {
        joint_motion.all_speed = part * c.speed;
        joint_motion.bend = part * part * c.bend;
        for (std::size_t i = 0; i < 3; ++i)
            joint_motion.speed[i] =
                c.arc || c.solves ? joint_motion.all_speed : std::abs(to[i] - from[i]);
        return joint_motion;
    }
    if (!c.is_simple) return std::nullopt;
    // Only angles count here; the angles of the program are the angles of the machine.
    const Ball of_part = move_ball(machine::seen_from(c.part_side, {}), joint_motion, *tip);
    const Ball of_tool = move_ball(c.tool_side, joint_motion, {});
    joint_motion.all_speed = of_part.speed + of_tool.speed;
    joint_motion.bend = of_part.bend + of_tool.bend;
    joint_motion.speed.fill(joint_motion.all_speed);
    return joint_motion;
}

Legs legs_of(const gcode::Motion& motion, const RapidPath& rapid) {
    Legs legs;
    const auto add = [&](const auto& what) {
        legs.motions.push_back(motion);
        legs.motions.back().action = what;
    };
    if (const auto* linear = std::get_if<gcode::Linear>(&motion.action)) {
        const bool of_tip = motion.coordinates == gcode::Coordinates::Tip;
        if (motion.kind != gcode::MoveKind::Rapid || of_tip) {
            add(*linear);
        } else {
            for (const gcode::Linear& leg : legs_of(*linear, rapid))
                add(leg);
        }
    } else if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        add(*arc);
    } else if (const auto* spline = std::get_if<gcode::Spline>(&motion.action)) {
        // Chords as in sample(): tested at sample points, not proved between them.
        constexpr double kChord = 0.005;
        const SplineCurve curve(*spline);
        if (!curve.is_sound()) {
            add(gcode::Linear{spline->from, spline->to});
            return legs;
        }
        legs.missed_mm = kChord;
        const std::vector<double> breaks = curve.breaks();
        Position at = spline->from;
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            const double low = breaks[i - 1], high = breaks[i];
            const auto place = [&](double t) { return curve.at(lerp(low, high, t)); };
            int chords = 4;
            const auto is_near = [&](int n) {
                for (int k = 0; k < n; ++k) {
                    const Vec3 a = linear_axes(place(static_cast<double>(k) / n));
                    const Vec3 b = linear_axes(place(static_cast<double>(k + 1) / n));
                    for (const double t : {0.25, 0.5, 0.75}) {
                        const Vec3 p = linear_axes(place((k + t) / n));
                        if (norm(p - (a + t * (b - a))) > 0.5 * kChord) return false;
                    }
                }
                return true;
            };
            constexpr int kMostChords = 4096;
            while (chords < kMostChords && !is_near(chords))
                chords *= 2;
            for (int k = 1; k <= chords; ++k) {
                const bool is_last = i + 1 == breaks.size() && k == chords;
                const Position next = is_last ? spline->to : place(static_cast<double>(k) / chords);
                add(gcode::Linear{at, next});
                at = next;
            }
        }
    }
    return legs;
}

}  // namespace ncsim::toolpath
