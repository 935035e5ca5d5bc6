// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tilted working planes (G68.2, G68.3, G68.4, G268; G69), and the direction of the tool (G53.1,
// G53.3, G53.6, G253, G43.5).
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

PlaneDialect dialect_of(Code code, const Rules& rules) {
    if (code == Code::G268) return PlaneDialect::Haas;
    return rules.linuxcnc_planes ? PlaneDialect::LinuxCnc : PlaneDialect::Fanuc;
}

/// Returns the plane of G68.3, whose Z axis is the direction of the tool.
std::optional<FeatureFrame> plane_of_tool(MachineState& state, const Command& command,
                                          PlaneDialect dialect, Context& context) {
    const SourceSpan span = span_of_g(command, Code::G68_3);
    const bool has_all = command.has('X') && command.has('Y') && command.has('Z');
    const bool has_none = !command.has_any(letters('X', 'Y', 'Z'));
    if (dialect == PlaneDialect::Fanuc && !has_all && !has_none) {
        stop_with(context, Message::PlaneForm, span, {"G68.3", "X, Y and Z, or none of them"});
        return std::nullopt;
    }
    if (state.frames.tilt) {
        stop_with(context, Message::PlaneForbids, span, {"G68.3"});
        return std::nullopt;
    }
    take_coordinates(state, Coordinates::Tip, context);
    if (is_turned(state)) context.facts.requested_tip_positions = true;
    Triple axis = context.options.joints->tip_pose(axis_positions(state), length_mm(state)).axis;
    axis = turn_about(2, -state.frames.rotation).direction_to_parent(axis);
    FeatureFrame frame = plane_across(axis, command.get('R', 0.0));
    const bool here = has_none && dialect == PlaneDialect::Fanuc;
    for (std::size_t i = 0; i < 3; ++i)
        frame.origin[i] = here ? state.position[i] : command.get("XYZ"[i], 0.0);
    return frame;
}

/// Returns the rotary positions that give the tool the direction `axis`, in program coordinates;
/// nullopt after reporting an error.
std::optional<Axes> joints_for_direction(const MachineState& state, const Triple& axis,
                                         JointSolver::Way way, Code code, SourceSpan span,
                                         Context& context) {
    Triple d = state.frames.tilt ? state.frames.tilt->direction_to_parent(axis) : axis;
    d = turn_about(2, state.frames.rotation).direction_to_parent(d);
    const JointSolver::Solution turned =
        context.options.joints->joints_for_direction(d, axis_positions(state), way);
    if (!turned.joints) {
        stop_with(context, Message::Unreachable, span, {name_of(code), turned.why_not});
        return std::nullopt;
    }
    return state.frames.from_machine(from_axis_positions(state, *turned.joints));
}

}  // namespace

bool check_tip_control(const MachineState& state, const Command& command, Context& context) {
    if (state.coordinates != Coordinates::Tip || !command.axis_words || command.axes_are_taken())
        return true;
    const Code now = motion_of(state, command);
    if (state.by_vector && now > Code::G1)
        return fail(context, Message::TipControlForbids, command.span, {name_of(now)});
    // In a tilted plane, cycles, arcs and compensation use X, Y and Z of the plane.
    if (state.frames.tilt) return true;
    bool turns = is_turned(state);
    for (const char letter : {'A', 'B', 'C'})
        turns |= command.has(letter) && command[letter] != 0.0;
    if (!turns) return true;
    std::string_view what;
    if (is_cycle(now)) {
        what = name_of(now);
    } else if (command.group(Group::Pocket) != Code::None) {
        what = name_of(command.group(Group::Pocket));
    } else if (command.group(Group::HolePattern) != Code::None) {
        what = name_of(command.group(Group::HolePattern));
    } else if (state.cutter_side != CutterSide::Off) {
        what = state.cutter_side == CutterSide::Left ? "G41" : "G42";
    } else if (state.frames.programmed.changes_places()) {
        what = state.frames.programmed.rotated ? "G68" : "G51";
    } else if (state.frames.programmed.polar) {
        what = "G16";
    }
    return what.empty() || fail(context, Message::TipControlForbids, command.span, {what});
}

bool check_tilted_plane(const MachineState& state, const Command& command, Context& context) {
    if (!state.frames.tilt) return true;
    const Code one_shot = command.group(Group::OneShot);
    std::string_view what;
    if (const Code code = command.group(Group::WorkOffset);
        code != Code::None && (system_of(code) != state.system || command.has('P'))) {
        what = name_of(code);
    } else if (one_shot == Code::G92_1 || one_shot == Code::G92_2 || one_shot == Code::G92_3 ||
               one_shot == Code::G10) {
        what = name_of(one_shot);
    }
    const Code now = motion_of(state, command);
    if (now == Code::G5 || now == Code::G5_1 || now == Code::G5_2 || now == Code::G6_2) {
        if (command.axis_words && !command.axes_are_taken()) what = name_of(now);
    }
    const bool is_arc = now == Code::G2 || now == Code::G3;
    if (is_arc && state.plane >= Plane::UV) what = name_of(now);
    return what.empty() || fail(context, Message::PlaneForbids, command.span, {what});
}

bool set_tilted_plane(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code rotation = command.group(Group::Rotation);
    if (rotation == Code::G69 || rotation == Code::G269) end_plane(control, context);
    const Code code = command.group(Group::TiltedPlane);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!has_rotary_axes(name_of(code), span, context)) return false;
    if (state.cutter_side != CutterSide::Off)
        return stop_with(context, Message::ForbiddenWithCompensation, span, {name_of(code)});
    const PlaneDialect dialect = dialect_of(code, context.rules);
    const bool waits = dialect == PlaneDialect::LinuxCnc;  // LinuxCNC activates the plane at G53.1.
    const auto& specified = control.store->specified_plane;
    std::optional<FeatureFrame> frame;
    if (code == Code::G68_3) {
        frame = plane_of_tool(state, command, dialect, context);
        if (!frame) return false;
    } else {
        PlaneParts parts = control.store->plane_parts;
        const PlaneRead read = read_plane(command, dialect, parts);
        if (!(parts == control.store->plane_parts)) control.store.change().plane_parts = parts;
        if (!read.wants.empty())
            return stop_with(context, Message::PlaneForm, span, {name_of(code), read.wants});
        if (!read.frame) return true;  // Further blocks of the definition follow.
        frame = read.frame;
        if (code == Code::G68_4) {
            const auto& base = waits && specified ? specified : state.frames.tilt;
            if (!base) return stop_with(context, Message::NoPlane, span, {name_of(code)});
            frame = *base * *frame;
        }
    }
    if (waits) {
        control.store.change().specified_plane = frame;
        return true;
    }
    enter_tilt(state, frame, context);
    return true;
}

void end_plane(ControlState& control, Context& context) {
    MachineState& state = control.machine;
    if (control.store->specified_plane || !(control.store->plane_parts == PlaneParts{})) {
        Store& store = control.store.change();
        store.specified_plane.reset();
        store.plane_parts = {};
    }
    if (!state.frames.tilt) return;
    set_tilt_frame(state, std::nullopt);
    take_coordinates(state, state.chosen, context);
}

bool orient_tool(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code code = command.group(Group::Orient);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!has_rotary_axes(name_of(code), span, context)) return false;
    if (!state.frames.tilt && !control.store->specified_plane)
        return stop_with(context, Message::NoPlane, span, {name_of(code)});
    const bool linuxcnc = context.rules.linuxcnc_planes;
    JointSolver::Way way = JointSolver::Way::Specified;
    if (linuxcnc) {
        const double p = command.get('P', 0.0);
        if (p != 0.0 && p != 1.0 && p != 2.0)
            return stop_with(context, Message::PlaneForm, span, {name_of(code), "P0, P1 or P2"});
        if (p != 0.0) way = p == 1.0 ? JointSolver::Way::Up : JointSolver::Way::Down;
    }
    if (const auto specified = control.store->specified_plane) {
        enter_tilt(state, specified, context);
        control.store.change().specified_plane.reset();
    }
    const auto turned = joints_for_direction(state, {0, 0, 1}, way, code, span, context);
    if (!turned) return false;
    const bool feeds =
        !linuxcnc && state.feed > 0.0 &&
        (state.motion == Code::G1 || state.motion == Code::G2 || state.motion == Code::G3);
    const MoveKind kind = feeds ? MoveKind::Feed : MoveKind::Rapid;
    // The tip stays (G53.6), or moves in a straight line (G53.3).
    if (code == Code::G53_6 || code == Code::G53_3) {
        Axes end = state.position;
        AxisMask mask = kRotaryAxes;
        if (code == Code::G53_3) {
            Command in_plane = command;
            in_plane.present &= ~letters('A', 'B', 'C', 'U', 'V', 'W');
            AxisMask moved = 0;
            if (!find_ends(state, in_plane, end, moved, context)) return false;
            mask |= moved;
        }
        context.path.linear_move(state, with_rotary(end, *turned), kind, mask);
        return true;
    }
    turn_axes(state, *turned, kind, false, context);
    return true;
}

bool set_tilt(MachineState& state, const FeatureFrame& frame, std::string_view name,
              SourceSpan span, Context& context) {
    if (!has_rotary_axes(name, span, context)) return false;
    if (state.cutter_side != CutterSide::Off)
        return stop_with(context, Message::ForbiddenWithCompensation, span, {name});
    enter_tilt(state, frame, context);
    return true;
}

std::optional<Axes> axes_of_tilt(const MachineState& state, LeadingAxis leading,
                                 std::string_view name, SourceSpan span, Context& context) {
    constexpr double kZero = 1e-6;  // Degrees
    if (!state.frames.tilt || !context.options.joints) return state.position;
    const Triple axis = turn_about(2, state.frames.rotation)
                            .direction_to_parent(state.frames.tilt->direction_to_parent({0, 0, 1}));
    std::string why_not = "no position has the sign that SEQ asks for";
    const bool compares = leading == LeadingAxis::Least || leading == LeadingAxis::Greatest;
    std::optional<Axes> best;
    double best_tilt = 0.0;
    for (const JointSolver::Way way :
         {JointSolver::Way::Specified, JointSolver::Way::Up, JointSolver::Way::Down}) {
        const JointSolver::Solution turned =
            context.options.joints->joints_for_direction(axis, axis_positions(state), way);
        if (!turned.joints) {
            if (way == JointSolver::Way::Specified) why_not = turned.why_not;
            continue;
        }
        const Axes axes = state.frames.from_machine(from_axis_positions(state, *turned.joints));
        // A or B tilts the tool; C alone only turns the part.
        const double tilts = std::abs(axes[kA]) > kZero ? axes[kA] : axes[kB];
        if (compares) {
            const bool is_better =
                !best || (leading == LeadingAxis::Least ? tilts < best_tilt : tilts > best_tilt);
            if (is_better) best = axes, best_tilt = tilts;
            continue;
        }
        if (leading == LeadingAxis::Preferred ||
            (leading == LeadingAxis::Positive ? tilts >= -kZero : tilts <= kZero))
            return axes;
    }
    if (best) return best;
    stop_with(context, Message::Unreachable, span, {name, why_not});
    return std::nullopt;
}

void turn_axes(MachineState& state, const Axes& axes, MoveKind kind, bool tip_stays,
               Context& context) {
    if (tip_stays)
        return context.path.linear_move(state, with_rotary(state.position, axes), kind,
                                        kRotaryAxes);
    const SavedCoordinates before = as_joints(state, context);
    const Axes end = with_rotary(state.position, axes);
    if (end != state.position) context.path.linear_move(state, end, kind, kRotaryAxes);
    resume(state, before, context);
}

bool turn_to_vector(const MachineState& state, const Command& command, Axes& end, AxisMask& mask,
                    Context& context) {
    if (!command.has_any(letters('I', 'J', 'K'))) return true;
    const SourceSpan span = command.span;
    if (command.has_any(letters('A', 'B', 'C')))
        return stop_with(context, Message::PlaneForm, span,
                         {"G43.5", "I J K alone, and no A, B or C"});
    Triple axis{command.get('I', 0.0), command.get('J', 0.0), command.get('K', 0.0)};
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (!(length > 1e-9))
        return stop_with(context, Message::PlaneForm, span,
                         {"G43.5", "a direction that has a length"});
    for (double& component : axis)
        component /= length;
    const auto turned =
        joints_for_direction(state, axis, JointSolver::Way::Specified, Code::G43_5, span, context);
    if (!turned) return false;
    end = with_rotary(end, *turned);
    mask |= kRotaryAxes;
    return true;
}

}  // namespace ncsim::gcode
