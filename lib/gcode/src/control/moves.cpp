// SPDX-License-Identifier: GPL-3.0-or-later
//
// The move of a block: which motion mode, along which path.
#include "ncsim/base/angles.h"

#include "control/block_steps.h"
#include "control/cycles/cycle_steps.h"
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <cmath>
#include <optional>

namespace ncsim::gcode {
namespace {

/// True for "G0 G43.1 Z5" on LinuxCNC, where Z is both the tool length and the target of G0.
bool moves_by_new_length(const Command& command, Code motion, const Setup& setup) {
    return setup.rules.is_linuxcnc() && command.group(Group::ToolLength) == Code::G43_1 &&
           motion != Code::None && motion != Code::G80 &&
           command.group(Group::OneShot) == Code::None;
}

/// Reports axis words after G80, which move in the mode `motion`. G80 of Fanuc and Haas keeps G0 or
/// G1; for other controls G0 is the strictest reading. Only LinuxCNC refuses the words. A feed on a
/// control that may use G0 is a guess.
void note_move_after_cycle(const Command& command, Code motion, Context& context) {
    const bool is_certain =
        context.rules.macro_b || (motion == Code::G0 && !context.rules.linuxcnc_planes);
    context.log.add(is_certain ? Severity::Note : Severity::Warning, Message::AxesAfterG80,
                    command.span, {name_of(motion)});
}

/// True for G5 P10000 and G5.1 Q1, modes of Fanuc and similar controls for high-speed machining,
/// which are no curves; the motion mode stays.
bool is_speed_mode(const Command& command, Code motion, const Setup& setup) {
    if (setup.rules.strict || command.has_any(letters('I', 'J'))) return false;
    return (motion == Code::G5 && !command.axis_words) ||
           (motion == Code::G5_1 && (command.has('Q') || !command.axis_words));
}

/// Returns the motion of a G60 without a motion code: G0 on Fanuc and Haas, whatever the mode is.
std::optional<Code> motion_from_one_side(const MachineState& state, const Command& command,
                                         Context& context) {
    if (!command.from_one_side || !command.axis_words || is_cycle(state.motion))
        return std::nullopt;
    if (context.rules.macro_b) {
        context.log.add(Message::OneSidedMove, command.span);
        return Code::G0;
    }
    const bool is_rapid = state.motion == Code::None || state.motion == Code::G0;
    if (!is_rapid) warn(context, Message::OneSidedFeed, command.span, {name_of(state.motion)});
    return std::nullopt;
}

bool linear_move_as_specified(ControlState& control, const Command& command, MoveKind kind,
                              Context& context) {
    MachineState& state = control.machine;
    Axes end{};
    AxisMask mask = 0;
    const bool by_vector = state.by_vector && command.has_any(letters('I', 'J', 'K'));
    if (!command.axis_words && !by_vector) {
        // "G1" or "G1 F100" alone: the mode is already set.
        if (context.rules.strict) context.path.linear_move(state, state.position, kind, 0);
        return true;
    }
    if (!find_ends(state, command, end, mask, context)) return false;
    if (by_vector && !turn_to_vector(state, command, end, mask, context)) return false;
    const bool machine = command.group(Group::OneShot) == Code::G53;
    if (command.has_angle) {
        const PlaneAxes axes = axes_of(state.plane);
        const bool named = (mask & (1U << axes.first | 1U << axes.second)) != 0;
        if (!named && !control.corner) return hold_angle(control, command, end, mask, context);
        // The line before ends at the intersection.
        const bool meets = control.corner && control.corner->angle;
        if (!meets && !end_by_angle(state, command, end, mask, context)) return false;
    }
    if (control.corner) {
        // Without the line before, this line begins at the tool.
        const bool meets = !control.corner->angle || find_corner(control, command, end, context);
        if (meets && !cut_corner(control, end, nullptr, context)) return false;
        // The line ends at the intersection.
        if (meets && end == state.position && command.corner == 0) return true;
    }
    if (command.corner != 0 && command.corner_size != 0.0)
        return hold_corner(control, command, end, mask, nullptr, context);
    if (!machine) follow_table(state, end, mask, context);
    if (state.polar_interpolation && (mask & kRotaryAxes) != 0 && !machine)
        return fail(context, Message::PlaneForbids, command.span, {"a rotary axis"});
    if (state.cylinder && !machine && (mask & 1U << state.cylinder->axis) != 0) {
        if (control.compensation.is_on())
            return fail(context, Message::ForbiddenWithCompensation, command.span,
                        {"a cylinder (G7.1)"});
        return linear_move_on_cylinder(state, end, kind, mask, context);
    }
    const bool by_joints =
        state.frames.tilt && state.chosen == Coordinates::Axes && (mask & kRotaryAxes) != 0;
    if (by_joints && !machine) {
        if (control.compensation.is_on())
            return fail(context, Message::ForbiddenWithCompensation, command.span,
                        {"a rotary axis"});
        return linear_move_of_joints(state, end, kind, mask, context);
    }
    if (!machine) return feed_straight(control, end, kind, mask, context);
    context.path.set_machine_coordinates(true);
    context.path.linear_move(state, end, kind, mask);
    context.path.set_machine_coordinates(false);
    return true;
}

bool linear_move(ControlState& control, const Command& command, MoveKind kind, Context& context) {
    MachineState& state = control.machine;
    if (command.group(Group::OneShot) != Code::G53 || !hides_joints(state, context))
        return linear_move_as_specified(control, command, kind, context);
    const SavedCoordinates before = as_joints(state, context);
    const bool done = linear_move_as_specified(control, command, kind, context);
    resume(state, before, context);
    return done;
}

bool arc_move(ControlState& control, const Command& command, bool clockwise, Context& context) {
    MachineState& state = control.machine;
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state.plane);
    if (state.cylinder && command.has("ABC"[state.cylinder->axis - kA]))
        return arc_on_cylinder(state, command, clockwise, context);
    const bool has_words =
        command.axis_words || command.has('R') || has_centre_words(state, command);
    if (!has_words && !context.rules.strict) return true;  // Only sets the mode.
    ProgramArc out;
    AxisMask mask = 0;
    if (!read_arc(state, command, clockwise, out, mask, context)) return false;
    const bool by_radius = out.is_open;
    const double radius = hypotenuse(state.position[axes.first] - out.centre_1,
                                     state.position[axes.second] - out.centre_2);
    if (radius * state.unit_mm() < kMinArcRadius) {
        if (!tolerate(context, Message::ArcTooSmall, command.span, {name})) return false;
        return feed_straight(control, out.end, MoveKind::Feed, mask, context);
    }
    if (context.outline.is_recording()) return record_outline_move(state, out.end, &out, context);
    if (is_huge(state, out, radius) && !context.rules.is_linuxcnc()) {
        out.is_open = true;
        if (!by_radius) shorten(state, out, radius, name, command.span, context);
        if (is_straight(state, out, radius))
            return feed_straight(control, out.end, MoveKind::Feed, mask, context);
    }
    const bool is_first = !control.compensation.is_on() || context.rules.is_linuxcnc();
    if (is_first && state.just_left_compensation &&
        !tolerate(context, Message::CompensationExit, command.span))
        return false;
    state.just_left_compensation = false;
    if (control.corner) {
        const Axes corner = state.position;
        if (!cut_corner(control, out.end, &out, context)) return false;
        out.is_open = out.is_open || state.position != corner;
        // The corner consumes the whole arc.
        if (out.is_open && state.position == out.end && command.corner == 0) return true;
    }
    if (command.corner != 0 && command.corner_size != 0.0)
        return hold_corner(control, command, out.end, mask, &out, context);
    return make_arc(control, out, mask, context);
}

}  // namespace

bool make_move(ControlState& control, const Command& command, Code motion, Context& context) {
    MachineState& state = control.machine;
    const Code one_shot = command.group(Group::OneShot);
    // The time of G4 is P, or otherwise the first of X, U, F and S. With P, X belongs to the
    // motion.
    const bool dwells =
        one_shot == Code::G4 && !context.rules.strict && letter_of_dwell(command, context) != 'P';
    const bool words_taken =
        (command.axes_are_taken() && !moves_by_new_length(command, motion, context)) || dwells;
    if (is_speed_mode(command, motion, context)) return true;
    if (const Code code = command.group(Group::HolePattern); code != Code::None) {
        return drill_pattern(control, command, code, words_taken, context);
    }
    if (const Code code = command.group(Group::Pocket); code != Code::None) {
        if (code == Code::G150)
            return mill_area_pocket(control, command, command.group(Group::CutterSide), words_taken,
                                    context);
        return mill_pocket(control, command, code, words_taken, context);
    }
    // G5 and G5.1 are no motion mode of LinuxCNC: the next block without a code moves as before.
    const bool is_modal =
        (motion != Code::G5 && motion != Code::G5_1) || context.rules.dialect == Dialect::Grbl;
    if (!is_modal) {
        if (words_taken) return true;
    } else if (motion != Code::None) {
        state.motion = motion;
        if (motion == Code::G0 || motion == Code::G1) state.last_straight = motion;
        if (!is_cycle(motion)) end_cycle(state, context);
        if (motion == Code::G80) {
            if (!command.axis_words || words_taken) return true;
            if (context.rules.strict)
                return fail(context, Message::AxesWithoutMotion, command.span);
            // Other controls continue with the last G0 or G1: "G80 Z50."
            motion = state.last_straight;
            note_move_after_cycle(command, motion, context);
        } else if (words_taken) {
            return true;  // "G0 G28 Z0": the words belong to G28
        }
    } else {
        const bool knot = control.curve.by_knots && command.has('K');  // Knot of G6.2.
        const bool by_vector = state.by_vector && command.has_any(letters('I', 'J', 'K'));
        if ((!command.axis_words && !by_vector && !is_modal_arc(state, command) && !knot &&
             !drills_again(state, command, context)) ||
            words_taken)
            return true;
        motion = motion_from_one_side(state, command, context).value_or(state.motion);
        if (motion == Code::None || motion == Code::G80) {
            if (context.rules.strict)
                return fail(context, Message::AxesWithoutMotion, command.span);
            const bool start = motion == Code::None;
            motion = start ? Code::G0 : state.last_straight;
            if (start) {
                state.motion = Code::G0;
                warn(context, Message::AxesBeforeMotion, command.span, {name_of(motion)});
            } else {
                note_move_after_cycle(command, motion, context);
            }
        }
    }
    if (!context.facts.distance_is_stated)
        context.facts.distance.take(command, state, {context.file, command.span});
    if (command.axis_words) note_length(state);
    state.previous_was_spline = state.previous_was_spline && motion == Code::G5;
    if (one_shot == Code::G53 && motion != Code::G0 && motion != Code::G1) {
        if (context.rules.strict)
            return fail(context, Message::G53Motion, span_of_g(command, Code::G53));
        warn(context, Message::G53Motion, span_of_g(command, Code::G53));
        motion = Code::G0;
    }
    if (control.curve.by_knots && motion != Code::G6_2) {
        context.curve_fails = true;
        return fail(context, Message::SplineKnots, command.span);
    }
    switch (motion) {
        case Code::G0: return linear_move(control, command, MoveKind::Rapid, context);
        case Code::G1:
            return needs_feed(state, command, "G1", context) &&
                   linear_move(control, command, MoveKind::Feed, context);
        case Code::G2:
            return needs_feed(state, command, "G2", context) &&
                   arc_move(control, command, true, context);
        case Code::G3:
            return needs_feed(state, command, "G3", context) &&
                   arc_move(control, command, false, context);
        case Code::G5:
        case Code::G5_1: return spline_move(state, command, motion, context);
        case Code::G5_2:
        case Code::G5_3: return nurbs_move(control, command, motion, context);
        case Code::G6_2: return nurbs_move_with_knots(control, command, context);
        case Code::G31:
        case Code::G38_2:
        case Code::G38_3:
        case Code::G38_4:
        case Code::G38_5: return probe_move(control, command, motion, context);
        case Code::G33:
        case Code::G33_1: return cut_thread(state, command, motion, context);
        default: return drill_cycle(state, command, motion, context);
    }
}

}  // namespace ncsim::gcode
