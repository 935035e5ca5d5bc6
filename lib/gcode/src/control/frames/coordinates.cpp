// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meaning of X, Y and Z: positions of the axes, of the tip (M428, G43.4, G43.5), of the tip in a
// tilted working plane.
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <algorithm>

namespace ncsim::gcode {
namespace {

constexpr KnownAxes kNothing{false, false, false};

/// Updates the knowledge of X, Y and Z after a rotation: each new coordinate depends on all three
/// old coordinates.
void update_knowledge(MachineState& state) {
    if (!state.known.all()) return set_knowledge(state, Knowledge{kNothing, kNothing, kNothing});
    const auto all_or_none = [](const KnownAxes& axes) {
        return axes.any() ? KnownAxes{} : kNothing;
    };
    set_knowledge(state, Knowledge{{}, all_or_none(state.relative), all_or_none(state.of_machine)});
}

}  // namespace

bool has_rotary_axes(std::string_view name, SourceSpan span, Context& context) {
    const bool are_specified = context.options.joints && context.options.joints->turns();
    return are_specified || stop_with(context, Message::RotaryUnspecified, span, {name});
}

bool is_turned(const MachineState& state) {
    const Axes at = state.machine_position();
    return at[kA] != 0.0 || at[kB] != 0.0 || at[kC] != 0.0;
}

Axes axis_positions(const MachineState& state) {
    Axes at = state.machine_position();
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] -= state.frames.tool_offset[i];
        if (!is_rotary(i)) at[i] *= state.unit_mm();
    }
    return at;
}

Axes from_axis_positions(const MachineState& state, const Axes& axis_positions) {
    Axes at = axis_positions;
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!is_rotary(i)) at[i] /= state.unit_mm();
        at[i] += state.frames.tool_offset[i];
    }
    return at;
}

double length_mm(const MachineState& state) {
    return state.frames.tool_offset[kZ] * state.unit_mm();
}

void take_coordinates(MachineState& state, Coordinates coordinates, Context& context) {
    if (coordinates == state.coordinates) return;
    state.coordinates = coordinates;
    if (!is_turned(state)) return;
    if (!context.options.joints)
        return set_knowledge(state, Knowledge{kNothing, kNothing, kNothing});
    context.facts.requested_tip_positions = true;
    Axes at = axis_positions(state);
    // Positions of the tip refer to the table at 0; so does the zero that moves with the table.
    const bool has_dynamic_offset = state.table_offset != 0;
    if (has_dynamic_offset && coordinates == Coordinates::Tip)
        state.frames.dynamic_offset = state.frames.dynamic_offset_home;
    if (has_dynamic_offset && coordinates != Coordinates::Tip)
        state.frames.dynamic_offset = dynamic_offset_at(state, at, context);
    if (coordinates == Coordinates::Tip) {
        const JointSolver::TipPose found = context.options.joints->tip_pose(at, length_mm(state));
        std::ranges::copy(found.tip, at.begin());
        update_knowledge(state);
    } else {
        const auto joints =
            context.options.joints->joints_for({at[kX], at[kY], at[kZ]}, at, length_mm(state));
        if (joints) at = *joints;
        update_knowledge(state);
        if (!joints) set_knowledge(state, Knowledge{kNothing, kNothing, kNothing});
    }
    keep_machine_position(state, from_axis_positions(state, at));
    ++state.length_changes;
}

void choose_coordinates(MachineState& state, Coordinates coordinates, Context& context) {
    state.chosen = coordinates;
    take_coordinates(state, state.frames.tilt ? Coordinates::Tip : coordinates, context);
}

void set_tilt_frame(MachineState& state, const std::optional<FeatureFrame>& frame) {
    if (frame == state.frames.tilt) return;
    const auto is_turned_plane = [](const auto& f) { return f && f->is_turned(); };
    const bool mixes = is_turned_plane(frame) || is_turned_plane(state.frames.tilt);
    const Axes machine = state.machine_position();
    state.frames.set_tilt(frame);
    keep_machine_position(state, machine);
    state.cycle = {};
    if (mixes) update_knowledge(state);
}

void enter_tilt(MachineState& state, const std::optional<FeatureFrame>& frame, Context& context) {
    take_coordinates(state, Coordinates::Tip, context);
    set_tilt_frame(state, frame);
}

SavedCoordinates as_joints(MachineState& state, Context& context) {
    const SavedCoordinates before{state.frames.tilt, state.coordinates, state.frames.offset_92};
    set_tilt_frame(state, std::nullopt);
    take_coordinates(state, Coordinates::Axes, context);
    return before;
}

void resume(MachineState& state, const SavedCoordinates& before, Context& context) {
    take_coordinates(state, before.coordinates, context);
    set_tilt_frame(state, before.frame);
    const Axes machine = state.machine_position();
    state.frames.offset_92 = before.offset_92;
    keep_machine_position(state, machine);
}

bool hides_joints(const MachineState& state, const Setup& setup) {
    return setup.options.joints && state.coordinates == Coordinates::Tip &&
           (is_turned(state) || state.frames.tilt);
}

bool linear_move_of_joints(MachineState& state, const Axes& end, MoveKind kind, AxisMask mask,
                           Context& context) {
    const Axes start = state.position;
    const bool has_lengths = (mask & ~kRotaryAxes) != 0;
    Axes target;
    if (has_lengths) {
        state.position = end;
        target = axis_positions(state);
        state.position = start;
        context.facts.requested_tip_positions = true;
        const auto joints = context.options.joints->joints_for({target[kX], target[kY], target[kZ]},
                                                               target, length_mm(state));
        if (!joints) return fail(context, Message::OutOfReach, context.span, {"the place"});
        target = *joints;
    }
    const SavedCoordinates before = as_joints(state, context);
    Axes goal = state.position;
    if (has_lengths) goal = state.frames.from_machine(from_axis_positions(state, target));
    goal = with_rotary(goal, end);
    context.path.linear_move(state, goal, kind, has_lengths ? kAllAxes : mask);
    resume(state, before, context);
    return true;
}

}  // namespace ncsim::gcode
