// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polar interpolation (G12.1, G112): X and C are positions in the plane normal to the axis of C.
// Cylindrical interpolation (G7.1, G107): arcs on an unrolled cylinder.
#include "ncsim/base/angles.h"

#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ncsim::gcode {
namespace {

// Returns the linear axis about which the rotary axis turns (A about X …).
std::size_t parallel_axis(std::size_t rotary) {
    return rotary - kA + kX;
}

void turn(double& x, double& y, double degrees) {
    const Triple turned = turn_about(2, degrees).direction_to_parent({x, y, 0.0});
    x = turned[0];
    y = turned[1];
}

/// G12.1 of LinuxCNC chooses a kinematics of the machine by number (P); G13.1 chooses axis
/// positions.
bool choose_kinematics(MachineState& state, const Command& command, bool by_number, SourceSpan span,
                       Context& context) {
    const auto& known = context.options.tip_control.kinematics;
    const double p = by_number ? command.get('P', 0.0) : 0.0;
    if (!by_number) {
        choose_coordinates(state, Coordinates::Axes, context);
        return true;
    }
    if (p != std::floor(p) || p < 0.0 || p >= static_cast<double>(known.size()))
        return stop_with(context, Message::KinematicsUnspecified, span, {"G12.1"});
    choose_coordinates(state, known[static_cast<std::size_t>(p)], context);
    return true;
}

/// Converts the feed on the cylinder to the feed of a motion, which is the feed of X, Y and Z, or
/// of the angle if only the angle moves.
double feed_on_cylinder(const MachineState& state, const Axes& end) {
    const MachineState::Cylinder& c = *state.cylinder;
    const double degree = c.radius * std::numbers::pi / 180.0;  // Arc length per degree.
    const double turned = (end[c.axis] - state.position[c.axis]) * degree;
    double squares = 0.0;
    for (std::size_t i = kX; i <= kZ; ++i) {
        const double way = end[i] - state.position[i];
        squares += way * way;
    }
    const double whole = std::sqrt(squares + turned * turned);
    if (turned == 0.0 || whole == 0.0) return state.feed;
    return squares == 0.0 ? state.feed / degree : state.feed * std::sqrt(squares) / whole;
}

}  // namespace

bool set_polar_interpolation(MachineState& state, const Command& command, Context& context) {
    const Code code = command.group(Group::PolarInterpolation);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    const bool begins = code == Code::G12_1 || code == Code::G112;
    if (context.rules.linuxcnc_planes && (code == Code::G12_1 || code == Code::G13_1))
        return choose_kinematics(state, command, begins, span, context);
    if (!begins) {
        end_polar_interpolation(state, context);
        return true;
    }
    if (state.polar_interpolation) return true;
    const Axes at = state.machine_position();
    if (at[kA] != 0.0 || at[kB] != 0.0)
        return stop_with(context, Message::PlaneForm, span, {name_of(code), "A and B at 0"});
    if (state.frames.tilt || state.coordinates == Coordinates::Tip)
        return stop_with(context, Message::PlaneForbids, span, {name_of(code)});
    if (state.cutter_side != CutterSide::Off)
        return stop_with(context, Message::ForbiddenWithCompensation, span, {name_of(code)});
    MachineState::PolarInterpolation polar_interpolation;
    polar_interpolation.plane = state.plane;
    polar_interpolation.start = state.position[kC];
    if (context.options.joints && context.options.joints->turns()) {
        // Computes the direction of the machine's X axis on the part, and the sense of C.
        const auto direction = [&](double c) {
            Axes from = axis_positions(state), to = axis_positions(state);
            from[kC] = to[kC] = c;
            to[kX] += 1.0;
            const Triple a = context.options.joints->tip_pose(from, length_mm(state)).tip;
            const Triple b = context.options.joints->tip_pose(to, length_mm(state)).tip;
            return angle_of(b[kX] - a[kX], b[kY] - a[kY]);
        };
        constexpr double kQuarter = 90.0;
        polar_interpolation.angle = direction(axis_positions(state)[kC]);
        const double turned =
            direction(axis_positions(state)[kC] + kQuarter) - polar_interpolation.angle;
        polar_interpolation.sign =
            std::abs(turned - kQuarter) < 1.0 || std::abs(turned + 3 * kQuarter) < 1.0 ? 1.0 : -1.0;
        take_coordinates(state, Coordinates::Tip, context);
    } else {
        // C turns the tool about the program zero.
        polar_interpolation.angle = polar_interpolation.start;
        turn(state.position[kX], state.position[kY], polar_interpolation.angle);
        state.coordinates = Coordinates::Tip;
        ++state.length_changes;
    }
    state.polar_interpolation = polar_interpolation;
    state.plane = Plane::XY;
    set_tilt_frame(state, turn_about(2, polar_interpolation.angle));
    return true;
}

void end_polar_interpolation(MachineState& state, Context& context) {
    if (!state.polar_interpolation) return;
    const MachineState::PolarInterpolation polar_interpolation = *state.polar_interpolation;
    const double angle = angle_of(state.position[kX], state.position[kY]);
    state.polar_interpolation.reset();
    set_tilt_frame(state, std::nullopt);
    state.position[kC] = polar_interpolation.start + polar_interpolation.sign * angle;
    state.plane = polar_interpolation.plane;
    if (context.options.joints && context.options.joints->turns()) {
        take_coordinates(state, state.chosen, context);
    } else {
        turn(state.position[kX], state.position[kY], -state.position[kC]);
        state.coordinates = state.chosen;
    }
    ++state.length_changes;
}

bool set_cylinder(MachineState& state, const Command& command, Context& context) {
    const Code code = command.group(Group::Cylinder);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    std::size_t count = 0;
    MachineState::Cylinder wanted;
    for (std::size_t i = kA; i <= kC; ++i) {
        const char letter = "ABC"[i - kA];
        if (!command.has(letter)) continue;
        ++count;
        wanted = {i, command[letter]};
    }
    constexpr double kThinnest = 1e-3;  // mm
    const bool is_thin = wanted.radius != 0.0 && wanted.radius * state.unit_mm() < kThinnest;
    if (count != 1 || is_thin) {
        return stop_with(context, Message::PlaneForm, span,
                         {name_of(code), "a rotary axis and its radius, such as C25."});
    }
    if (wanted.radius == 0.0) {
        state.cylinder.reset();
    } else {
        state.cylinder = wanted;
    }
    return true;
}

bool linear_move_on_cylinder(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                             Context& context) {
    const double feed = state.feed;
    if (kind == MoveKind::Feed && state.feed_mode == FeedMode::PerMinute)
        state.feed = feed_on_cylinder(state, end);
    context.path.linear_move(state, end, kind, mask);
    state.feed = feed;
    return true;
}

bool arc_on_cylinder(MachineState& state, const Command& command, bool clockwise,
                     Context& context) {
    const MachineState::Cylinder c = *state.cylinder;
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state.plane);
    const std::size_t level = parallel_axis(c.axis);
    if (axes.first != level && axes.second != level)
        return fail(context, Message::CylinderArc, command.span,
                    {name, "a plane with the cylinder's axis"});
    if (!command.has('R') || command.has_any(letters('I', 'J', 'K')))
        return fail(context, Message::CylinderArc, command.span, {name, "a radius (R)"});
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(state, command, end, mask, context)) return false;
    const double degree = c.radius * std::numbers::pi / 180.0;
    const bool level_first = axes.first == level;
    // Unrolled coordinates along the first and second axis of the plane.
    const auto flat = [&](const Axes& p) {
        const double along_axis = p[level], around = p[c.axis] * degree;
        return level_first ? std::array{along_axis, around} : std::array{around, along_axis};
    };
    const auto [u0, v0] = flat(state.position);
    const auto [u1, v1] = flat(end);
    const double r = command['R'];
    const double chord = hypotenuse(u1 - u0, v1 - v0);
    if (!(chord * state.unit_mm() > 1e-9))
        return fail(context, Message::ArcRadiusNoChord, span_of(command, 'R'));
    const double half = chord / 2.0;
    if (half > std::abs(r) * (1.0 + 1e-3))
        return fail(context, Message::CylinderArc, command.span,
                    {name, "a radius that reaches its end"});
    const double height = std::sqrt(std::max(0.0, r * r - half * half));
    const double side = (clockwise == (r < 0.0) ? height : -height) / chord;
    const double cu = (u0 + u1) / 2.0 - (v1 - v0) * side;
    const double cv = (v0 + v1) / 2.0 + (u1 - u0) * side;
    const double start = angle_of(u0 - cu, v0 - cv);
    double sweep = angle_of(u1 - cu, v1 - cv) - start;
    if (clockwise && sweep > 0.0) sweep -= 360.0;
    if (!clockwise && sweep < 0.0) sweep += 360.0;
    // The number of chords keeps the chord tolerance kOff.
    constexpr double kOff = 1e-3;  // Chord tolerance, mm.
    const double radius = std::max(std::abs(r), half);
    const double step =
        std::sqrt(8.0 * kOff / (radius * state.unit_mm())) * 180.0 / std::numbers::pi;
    constexpr double kMostChords = 5'000.0;
    const double count = std::max(std::ceil(std::abs(sweep) / step), 2.0);
    if (!(count <= kMostChords))
        return fail(context, Message::CylinderArc, command.span, {name, "a smaller radius"});
    const Axes from = state.position;
    const auto chords = static_cast<int>(count);
    for (int i = 1; i <= chords; ++i) {
        Axes at = end;
        if (i < chords) {
            const double t = i / count;
            for (std::size_t k = 0; k < at.size(); ++k)
                at[k] = from[k] + t * (end[k] - from[k]);
            const SinCos q = sin_cos(start + t * sweep);
            const double u = cu + radius * q.cos, v = cv + radius * q.sin;
            at[level] = level_first ? u : v;
            at[c.axis] = (level_first ? v : u) / degree;
        }
        linear_move_on_cylinder(state, at, MoveKind::Feed, mask, context);
    }
    return true;
}

}  // namespace ncsim::gcode
