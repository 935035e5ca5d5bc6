// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meaning of X, Y and Z: positions of the axes, of the tip (M428, G43.4, G43.5), of the tip in a
// tilted working plane (G68.2, G68.3, G68.4, G268; G53.1, G53.3, G53.6, G253; G69).
#include "control/machine.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

constexpr KnownAxes kNothing{false, false, false};

PlaneDialect dialect_of(Code code, const Rules& rules) {
    if (code == Code::G268) return PlaneDialect::Haas;
    return rules.linuxcnc_planes ? PlaneDialect::LinuxCnc : PlaneDialect::Fanuc;
}

}  // namespace

// --- Places of joints and of the tip ---

/// Returns the axis positions in the convention of JointSolver: mm, without the tool length.
Axes Machine::axis_positions() const {
    Axes at = machine_position();
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] -= state_.frames.tool_offset[i];
        if (!is_rotary(i)) at[i] *= state_.unit_mm();
    }
    return at;
}

/// Converts axis positions of JointSolver to machine_position() coordinates.
Axes Machine::from_axis_positions(const Axes& axis_positions) const {
    Axes at = axis_positions;
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!is_rotary(i)) at[i] /= state_.unit_mm();
        at[i] += state_.frames.tool_offset[i];
    }
    return at;
}

double Machine::length_mm() const {
    return state_.frames.tool_offset[kZ] * state_.unit_mm();
}

/// Updates the knowledge of X, Y and Z after a rotation: each new coordinate depends on all three
/// old coordinates.
void Machine::update_knowledge() {
    if (!state_.known.all()) return set_knowledge(state_, Knowledge{kNothing, kNothing, kNothing});
    const auto all_or_none = [](const KnownAxes& axes) {
        return axes.any() ? KnownAxes{} : kNothing;
    };
    set_knowledge(state_,
                  Knowledge{{}, all_or_none(state_.relative), all_or_none(state_.of_machine)});
}

/// Changes the meaning of X, Y and Z without a motion. With all rotary axes at 0, tip and linear
/// axes have equal positions; otherwise the positions depend on the kinematics of the machine.
void Machine::take_coordinates(Coordinates coordinates) {
    if (coordinates == state_.coordinates) return;
    state_.coordinates = coordinates;
    if (!is_turned()) return;
    if (!options_.joints) return set_knowledge(state_, Knowledge{kNothing, kNothing, kNothing});
    requested_tip_positions_ = true;
    Axes at = axis_positions();
    // Positions of the tip refer to the table at 0; so does the zero that moves with the table.
    const bool has_dynamic_offset = state_.table_offset != 0;
    if (has_dynamic_offset && coordinates == Coordinates::Tip)
        state_.frames.dynamic_offset = state_.frames.dynamic_offset_home;
    if (has_dynamic_offset && coordinates != Coordinates::Tip)
        state_.frames.dynamic_offset = dynamic_offset_at(at);
    if (coordinates == Coordinates::Tip) {
        const JointSolver::TipPose found = options_.joints->tip_pose(at, length_mm());
        std::ranges::copy(found.tip, at.begin());
        update_knowledge();
    } else {
        const auto joints = options_.joints->joints_for({at[kX], at[kY], at[kZ]}, at, length_mm());
        if (joints) at = *joints;
        update_knowledge();
        if (!joints) set_knowledge(state_, Knowledge{kNothing, kNothing, kNothing});
    }
    recompute_position(from_axis_positions(at));
    ++state_.length_changes;
}

void Machine::choose(Coordinates coordinates) {
    state_.chosen = coordinates;
    take_coordinates(state_.frames.tilt ? Coordinates::Tip : coordinates);
}

/// Sets the tilted plane. The machine position stays; the program coordinates change.
void Machine::set_plane_frame(const std::optional<FeatureFrame>& frame) {
    if (frame == state_.frames.tilt) return;
    const auto is_turned_plane = [](const auto& f) { return f && f->is_turned(); };
    const bool mixes = is_turned_plane(frame) || is_turned_plane(state_.frames.tilt);
    const Axes machine = machine_position();
    state_.frames.set_tilt(frame);
    recompute_position(machine);
    state_.cycle = {};
    if (mixes) update_knowledge();
}

/// Makes X, Y and Z positions of the joints until resume().
Machine::SavedCoordinates Machine::as_joints() {
    const SavedCoordinates before{state_.frames.tilt, state_.coordinates, state_.frames.offset_92};
    set_plane_frame(std::nullopt);
    take_coordinates(Coordinates::Axes);
    return before;
}

void Machine::resume(const SavedCoordinates& before) {
    take_coordinates(before.coordinates);
    set_plane_frame(before.frame);
    const Axes machine = machine_position();
    state_.frames.offset_92 = before.offset_92;
    recompute_position(machine);
}

/// True if positions of the joints differ from positions of the tip.
bool Machine::hides_joints() const {
    return options_.joints && state_.coordinates == Coordinates::Tip &&
           (is_turned() || state_.frames.tilt);
}

/// Makes a move with rotary words in a tilted plane: all axes move linearly to the joint positions
/// that bring the tip to `end`.
bool Machine::linear_move_of_joints(const Axes& end, MoveKind kind, AxisMask mask) {
    const Axes start = state_.position;
    const bool has_lengths = (mask & ~kRotaryAxes) != 0;
    Axes target;
    if (has_lengths) {
        state_.position = end;
        target = axis_positions();
        state_.position = start;
        requested_tip_positions_ = true;
        const auto joints =
            options_.joints->joints_for({target[kX], target[kY], target[kZ]}, target, length_mm());
        if (!joints) return fail(Message::OutOfReach, span_, {"the place"});
        target = *joints;
    }
    Axes turned{};
    for (std::size_t i = kA; i <= kC; ++i)
        turned[i] = end[i];
    const SavedCoordinates before = as_joints();
    Axes goal = state_.position;
    if (has_lengths) goal = from_machine(from_axis_positions(target));
    for (std::size_t i = kA; i <= kC; ++i)
        goal[i] = turned[i];
    path_.linear_move(state_, goal, kind, has_lengths ? kAllAxes : mask);
    resume(before);
    return true;
}

// --- Planes ---

bool Machine::stop_with(const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    stopped_ = true;
    return fail(message, span, arguments);
}

/// Reports codes that would move incorrectly in a tilted plane.
bool Machine::check_plane(const Command& command) {
    if (!state_.frames.tilt) return true;
    const Code one_shot = command.group(Group::OneShot);
    std::string_view what;
    if (const Code code = command.group(Group::WorkOffset);
        code != Code::None && (system_of(code) != state_.system || command.has('P'))) {
        what = name_of(code);
    } else if (one_shot == Code::G92_1 || one_shot == Code::G92_2 || one_shot == Code::G92_3 ||
               one_shot == Code::G10) {
        what = name_of(one_shot);
    }
    const Code motion = command.group(Group::Motion);
    const Code now = motion == Code::None ? state_.motion : motion;
    if (now == Code::G5 || now == Code::G5_1 || now == Code::G5_2 || now == Code::G6_2) {
        if (command.axis_words && !command.axes_are_taken()) what = name_of(now);
    }
    const bool is_arc = now == Code::G2 || now == Code::G3;
    if (is_arc && state_.plane >= Plane::UV) what = name_of(now);
    return what.empty() || fail(Message::PlaneForbids, command.span, {what});
}

bool Machine::set_plane(const Command& command) {
    const Code rotation = command.group(Group::Rotation);
    if (rotation == Code::G69 || rotation == Code::G269) end_plane();
    const Code code = command.group(Group::TiltedPlane);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!options_.joints || !options_.joints->turns())
        return stop_with(Message::RotaryUnspecified, span, {name_of(code)});
    if (state_.cutter_side != CutterSide::Off)
        return stop_with(Message::ForbiddenWithCompensation, span, {name_of(code)});
    const PlaneDialect dialect = dialect_of(code, rules_);
    const bool waits = dialect == PlaneDialect::LinuxCnc;  // LinuxCNC activates the plane at G53.1.
    const auto& specified = control_.store->specified_plane;
    std::optional<FeatureFrame> frame;
    if (code == Code::G68_3) {
        frame = plane_of_tool(command, dialect);
        if (!frame) return false;
    } else {
        PlaneParts parts = control_.store->plane_parts;
        const PlaneRead read = read_plane(command, dialect, parts);
        if (!(parts == control_.store->plane_parts)) control_.store.change().plane_parts = parts;
        if (!read.wants.empty())
            return stop_with(Message::PlaneForm, span, {name_of(code), read.wants});
        if (!read.frame) return true;  // Further blocks of the definition follow.
        frame = read.frame;
        if (code == Code::G68_4) {
            const auto& base = waits && specified ? specified : state_.frames.tilt;
            if (!base) return stop_with(Message::NoPlane, span, {name_of(code)});
            frame = *base * *frame;
        }
    }
    if (waits) {
        control_.store.change().specified_plane = frame;
        return true;
    }
    take_coordinates(Coordinates::Tip);
    set_plane_frame(frame);
    return true;
}

/// Returns the plane of G68.3, whose Z axis is the direction of the tool.
std::optional<FeatureFrame> Machine::plane_of_tool(const Command& command, PlaneDialect dialect) {
    const SourceSpan span = span_of_g(command, Code::G68_3);
    const bool has_all = command.has('X') && command.has('Y') && command.has('Z');
    const bool has_none = !command.has_any(letters('X', 'Y', 'Z'));
    if (dialect == PlaneDialect::Fanuc && !has_all && !has_none) {
        stop_with(Message::PlaneForm, span, {"G68.3", "X, Y and Z, or none of them"});
        return std::nullopt;
    }
    if (state_.frames.tilt) {
        stop_with(Message::PlaneForbids, span, {"G68.3"});
        return std::nullopt;
    }
    take_coordinates(Coordinates::Tip);
    if (is_turned()) requested_tip_positions_ = true;
    Triple axis = options_.joints->tip_pose(axis_positions(), length_mm()).axis;
    axis = turn_about(2, -state_.frames.rotation).direction_to_parent(axis);
    FeatureFrame frame = plane_across(axis, command.get('R', 0.0));
    const bool here = has_none && dialect == PlaneDialect::Fanuc;
    for (std::size_t i = 0; i < 3; ++i)
        frame.origin[i] = here ? state_.position[i] : command.get("XYZ"[i], 0.0);
    return frame;
}

void Machine::end_plane() {
    if (control_.store->specified_plane || !(control_.store->plane_parts == PlaneParts{})) {
        Store& store = control_.store.change();
        store.specified_plane.reset();
        store.plane_parts = {};
    }
    if (!state_.frames.tilt) return;
    set_plane_frame(std::nullopt);
    take_coordinates(state_.chosen);
}

// --- The direction of the tool ---

/// Returns the rotary positions that give the tool the direction `axis`, in program coordinates;
/// nullopt after reporting an error.
std::optional<Axes> Machine::joints_for_direction(const Triple& axis, JointSolver::Way way,
                                                  Code code, SourceSpan span) {
    Triple d = state_.frames.tilt ? state_.frames.tilt->direction_to_parent(axis) : axis;
    d = turn_about(2, state_.frames.rotation).direction_to_parent(d);
    const JointSolver::Solution turned =
        options_.joints->joints_for_direction(d, axis_positions(), way);
    if (!turned.joints) {
        stop_with(Message::Unreachable, span, {name_of(code), turned.why_not});
        return std::nullopt;
    }
    return from_machine(from_axis_positions(*turned.joints));
}

/// G53.1 and similar codes: turn the tool normal to the plane.
bool Machine::orient(const Command& command) {
    const Code code = command.group(Group::Orient);
    if (code == Code::None) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!options_.joints || !options_.joints->turns())
        return stop_with(Message::RotaryUnspecified, span, {name_of(code)});
    if (!state_.frames.tilt && !control_.store->specified_plane)
        return stop_with(Message::NoPlane, span, {name_of(code)});
    const bool linuxcnc = rules_.linuxcnc_planes;
    JointSolver::Way way = JointSolver::Way::Specified;
    if (linuxcnc) {
        const double p = command.get('P', 0.0);
        if (p != 0.0 && p != 1.0 && p != 2.0)
            return stop_with(Message::PlaneForm, span, {name_of(code), "P0, P1 or P2"});
        if (p != 0.0) way = p == 1.0 ? JointSolver::Way::Up : JointSolver::Way::Down;
    }
    if (const auto specified = control_.store->specified_plane) {
        take_coordinates(Coordinates::Tip);
        set_plane_frame(specified);
        control_.store.change().specified_plane.reset();
    }
    const auto turned = joints_for_direction({0, 0, 1}, way, code, span);
    if (!turned) return false;
    const bool feeds =
        !linuxcnc && state_.feed > 0.0 &&
        (state_.motion == Code::G1 || state_.motion == Code::G2 || state_.motion == Code::G3);
    const MoveKind kind = feeds ? MoveKind::Feed : MoveKind::Rapid;
    AxisMask mask = kRotaryAxes;
    const auto turn = [&](Axes end) {
        for (std::size_t i = kA; i <= kC; ++i)
            end[i] = (*turned)[i];
        return end;
    };
    // The tip stays (G53.6), or moves in a straight line (G53.3).
    if (code == Code::G53_6 || code == Code::G53_3) {
        Axes end = state_.position;
        if (code == Code::G53_3) {
            Command in_plane = command;
            in_plane.present &= ~letters('A', 'B', 'C', 'U', 'V', 'W');
            AxisMask moved = 0;
            if (!find_ends(in_plane, end, moved)) return false;
            mask |= moved;
        }
        path_.linear_move(state_, turn(end), kind, mask);
        return true;
    }
    // The linear axes stay.
    const SavedCoordinates before = as_joints();
    const Axes end = turn(state_.position);
    if (end != state_.position) path_.linear_move(state_, end, kind, mask);
    resume(before);
    return true;
}

bool Machine::tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span) {
    flush();
    if (!options_.joints || !options_.joints->turns())
        return stop_with(Message::RotaryUnspecified, span, {name});
    if (state_.cutter_side != CutterSide::Off)
        return stop_with(Message::ForbiddenWithCompensation, span, {name});
    take_coordinates(Coordinates::Tip);
    set_plane_frame(frame);
    return true;
}

std::optional<Axes> Machine::axes_of_tilt(LeadingAxis leading, std::string_view name,
                                          SourceSpan span) {
    constexpr double kZero = 1e-6;  // Degrees
    if (!state_.frames.tilt || !options_.joints) return state_.position;
    const Triple axis =
        turn_about(2, state_.frames.rotation)
            .direction_to_parent(state_.frames.tilt->direction_to_parent({0, 0, 1}));
    std::string why_not = "no position has the sign that SEQ asks for";
    const bool compares = leading == LeadingAxis::Least || leading == LeadingAxis::Greatest;
    std::optional<Axes> best;
    double best_tilt = 0.0;
    for (const JointSolver::Way way :
         {JointSolver::Way::Specified, JointSolver::Way::Up, JointSolver::Way::Down}) {
        const JointSolver::Solution turned =
            options_.joints->joints_for_direction(axis, axis_positions(), way);
        if (!turned.joints) {
            if (way == JointSolver::Way::Specified) why_not = turned.why_not;
            continue;
        }
        const Axes axes = from_machine(from_axis_positions(*turned.joints));
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
    stop_with(Message::Unreachable, span, {name, why_not});
    return std::nullopt;
}

void Machine::turn_axes(const Axes& axes, MoveKind kind, bool tip_stays) {
    const auto turn = [&](Axes end) {
        for (std::size_t i = kA; i <= kC; ++i)
            end[i] = axes[i];
        return end;
    };
    if (tip_stays) {
        path_.linear_move(state_, turn(state_.position), kind, kRotaryAxes);
        return;
    }
    const SavedCoordinates before = as_joints();
    const Axes end = turn(state_.position);
    if (end != state_.position) path_.linear_move(state_, end, kind, kRotaryAxes);
    resume(before);
}

/// Applies I, J and K of a straight move under G43.5.
bool Machine::turn_to_vector(const Command& command, Axes& end, AxisMask& mask) {
    if (!command.has_any(letters('I', 'J', 'K'))) return true;
    const SourceSpan span = command.span;
    if (command.has_any(letters('A', 'B', 'C')))
        return stop_with(Message::PlaneForm, span, {"G43.5", "I J K alone, and no A, B or C"});
    Triple axis{command.get('I', 0.0), command.get('J', 0.0), command.get('K', 0.0)};
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (!(length > 1e-9))
        return stop_with(Message::PlaneForm, span, {"G43.5", "a direction that has a length"});
    for (double& component : axis)
        component /= length;
    const auto turned = joints_for_direction(axis, JointSolver::Way::Specified, Code::G43_5, span);
    if (!turned) return false;
    for (std::size_t i = kA; i <= kC; ++i)
        end[i] = (*turned)[i];
    mask |= kRotaryAxes;
    return true;
}

}  // namespace ncsim::gcode
