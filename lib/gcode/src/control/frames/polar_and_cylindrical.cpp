// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polar interpolation (G12.1, G112): X and C are positions in the plane normal to the axis of C.
// Cylindrical interpolation (G7.1, G107): arcs on an unrolled cylinder.
#include "ncsim/base/angles.h"

#include "control/machine.h"

#include <algorithm>
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

}  // namespace

// --- The face ---

bool Machine::polar_interpolation(const Command& command) {
    const Code code = command.group(Group::PolarInterpolation);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    const bool begins = code == Code::G12_1 || code == Code::G112;
    if (rules_.linuxcnc_planes && (code == Code::G12_1 || code == Code::G13_1))
        return choose_kinematics(command, begins, span);
    if (!begins) {
        end_polar_interpolation();
        return true;
    }
    if (state_.polar_interpolation) return true;
    const Axes at = machine_position();
    if (at[kA] != 0.0 || at[kB] != 0.0)
        return stop_with(Message::PlaneForm, span, {name_of(code), "A and B at 0"});
    if (state_.frames.tilt || state_.coordinates == Coordinates::Tip)
        return stop_with(Message::PlaneForbids, span, {name_of(code)});
    if (state_.cutter_side != CutterSide::Off)
        return stop_with(Message::ForbiddenWithCompensation, span, {name_of(code)});
    MachineState::PolarInterpolation polar_interpolation;
    polar_interpolation.plane = state_.plane;
    polar_interpolation.start = state_.position[kC];
    if (options_.joints && options_.joints->turns()) {
        // Computes the direction of the machine's X axis on the part, and the sense of C.
        const auto direction = [&](double c) {
            Axes from = axis_positions(), to = axis_positions();
            from[kC] = to[kC] = c;
            to[kX] += 1.0;
            const Triple a = options_.joints->tip_pose(from, length_mm()).tip;
            const Triple b = options_.joints->tip_pose(to, length_mm()).tip;
            return angle_of(b[kX] - a[kX], b[kY] - a[kY]);
        };
        constexpr double kQuarter = 90.0;
        polar_interpolation.angle = direction(axis_positions()[kC]);
        const double turned =
            direction(axis_positions()[kC] + kQuarter) - polar_interpolation.angle;
        polar_interpolation.sign =
            std::abs(turned - kQuarter) < 1.0 || std::abs(turned + 3 * kQuarter) < 1.0 ? 1.0 : -1.0;
        take_coordinates(Coordinates::Tip);
    } else {
        // C turns the tool about the program zero.
        polar_interpolation.angle = polar_interpolation.start;
        turn(state_.position[kX], state_.position[kY], polar_interpolation.angle);
        state_.coordinates = Coordinates::Tip;
        ++state_.length_changes;
    }
    state_.polar_interpolation = polar_interpolation;
    state_.plane = Plane::XY;
    set_plane_frame(turn_about(2, polar_interpolation.angle));
    return true;
}

/// Ends polar interpolation: X is the distance from the axis again, and C the angle of the tip.
void Machine::end_polar_interpolation() {
    if (!state_.polar_interpolation) return;
    const MachineState::PolarInterpolation polar_interpolation = *state_.polar_interpolation;
    const double angle = angle_of(state_.position[kX], state_.position[kY]);
    state_.polar_interpolation.reset();
    set_plane_frame(std::nullopt);
    state_.position[kC] = polar_interpolation.start + polar_interpolation.sign * angle;
    state_.plane = polar_interpolation.plane;
    if (options_.joints && options_.joints->turns()) {
        take_coordinates(state_.chosen);
    } else {
        turn(state_.position[kX], state_.position[kY], -state_.position[kC]);
        state_.coordinates = state_.chosen;
    }
    ++state_.length_changes;
}

/// G12.1 of LinuxCNC chooses a kinematics of the machine by number (P); G13.1 chooses axis
/// positions.
bool Machine::choose_kinematics(const Command& command, bool by_number, SourceSpan span) {
    const auto& known = options_.tip_control.kinematics;
    const double p = by_number ? command.get('P', 0.0) : 0.0;
    if (!by_number) {
        choose(Coordinates::Axes);
        return true;
    }
    if (p != std::floor(p) || p < 0.0 || p >= static_cast<double>(known.size()))
        return stop_with(Message::KinematicsUnspecified, span, {"G12.1"});
    choose(known[static_cast<std::size_t>(p)]);
    return true;
}

// --- The cylinder ---

/// G7.1 C25: C turns a cylinder with this radius; radius 0 ends the mode.
bool Machine::cylinder(const Command& command) {
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
    const bool is_thin = wanted.radius != 0.0 && wanted.radius * state_.unit_mm() < kThinnest;
    if (count != 1 || is_thin) {
        return stop_with(Message::PlaneForm, span,
                         {name_of(code), "a rotary axis and its radius, such as C25."});
    }
    if (wanted.radius == 0.0) {
        state_.cylinder.reset();
    } else {
        state_.cylinder = wanted;
    }
    return true;
}

/// Converts the feed on the cylinder to the feed of a motion, which is the feed of X, Y and Z, or
/// of the angle if only the angle moves.
double Machine::feed_on_cylinder(const Axes& end) const {
    const MachineState::Cylinder& c = *state_.cylinder;
    const double degree = c.radius * std::numbers::pi / 180.0;  // Arc length per degree.
    const double turned = (end[c.axis] - state_.position[c.axis]) * degree;
    double squares = 0.0;
    for (std::size_t i = kX; i <= kZ; ++i) {
        const double way = end[i] - state_.position[i];
        squares += way * way;
    }
    const double whole = std::sqrt(squares + turned * turned);
    if (turned == 0.0 || whole == 0.0) return state_.feed;
    return squares == 0.0 ? state_.feed / degree : state_.feed * std::sqrt(squares) / whole;
}

bool Machine::linear_move_on_cylinder(const Axes& end, MoveKind kind, AxisMask mask) {
    const double feed = state_.feed;
    if (kind == MoveKind::Feed && state_.feed_mode == FeedMode::PerMinute)
        state_.feed = feed_on_cylinder(end);
    path_.linear_move(state_, end, kind, mask);
    state_.feed = feed;
    return true;
}

/// Makes an arc in the plane of the cylinder's axis and the circumference, by chords.
bool Machine::arc_on_cylinder(const Command& command, bool clockwise) {
    const MachineState::Cylinder c = *state_.cylinder;
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state_.plane);
    const std::size_t level = parallel_axis(c.axis);
    if (axes.first != level && axes.second != level)
        return fail(Message::CylinderArc, command.span, {name, "a plane with the cylinder's axis"});
    if (!command.has('R') || command.has_any(letters('I', 'J', 'K')))
        return fail(Message::CylinderArc, command.span, {name, "a radius (R)"});
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(command, end, mask)) return false;
    const double degree = c.radius * std::numbers::pi / 180.0;
    const bool level_first = axes.first == level;
    // Unrolled coordinates along the first and second axis of the plane.
    const auto flat = [&](const Axes& p) {
        const double along_axis = p[level], around = p[c.axis] * degree;
        return level_first ? std::array{along_axis, around} : std::array{around, along_axis};
    };
    const auto [u0, v0] = flat(state_.position);
    const auto [u1, v1] = flat(end);
    const double r = command['R'];
    const double chord = hypotenuse(u1 - u0, v1 - v0);
    if (!(chord * state_.unit_mm() > 1e-9))
        return fail(Message::ArcRadiusNoChord, span_of(command, 'R'));
    const double half = chord / 2.0;
    if (half > std::abs(r) * (1.0 + 1e-3))
        return fail(Message::CylinderArc, command.span, {name, "a radius that reaches its end"});
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
        std::sqrt(8.0 * kOff / (radius * state_.unit_mm())) * 180.0 / std::numbers::pi;
    constexpr double kMostChords = 5'000.0;
    const double count = std::max(std::ceil(std::abs(sweep) / step), 2.0);
    if (!(count <= kMostChords))
        return fail(Message::CylinderArc, command.span, {name, "a smaller radius"});
    const Axes from = state_.position;
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
        linear_move_on_cylinder(at, MoveKind::Feed, mask);
    }
    return true;
}

}  // namespace ncsim::gcode
