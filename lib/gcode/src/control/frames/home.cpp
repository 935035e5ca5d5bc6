// SPDX-License-Identifier: GPL-3.0-or-later
//
// G28 and G30: via the intermediate point to a position of the machine. G29: back via the
// intermediate point. G28.2: to the home switches.
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <initializer_list>
#include <optional>

namespace ncsim::gcode {
namespace {

/// Moves to the machine position `home`, mm: the axes of each mask of `masks`, in order.
void move_to_machine(MachineState& state, const Axes& home, std::initializer_list<AxisMask> masks,
                     Context& context) {
    std::optional<SavedCoordinates> before;
    if (hides_joints(state, context)) before = as_joints(state, context);
    context.path.set_machine_coordinates(true);
    for (const AxisMask mask : masks) {
        if (mask == 0) continue;
        Axes target = state.machine_position();
        for (std::size_t i = 0; i < target.size(); ++i) {
            if ((mask & 1U << i) != 0)
                target[i] = is_rotary(i) ? home[i] : home[i] / state.unit_mm();
        }
        context.path.linear_move(state, state.frames.from_machine(target), MoveKind::Rapid, mask);
    }
    context.path.set_machine_coordinates(false);
    if (before) resume(state, *before, context);
}

}  // namespace

bool move_home(ControlState& control, const Command& command, bool second, Context& context) {
    MachineState& state = control.machine;
    Axes via = state.position;
    AxisMask mask = 0;
    if (command.axis_words && !find_ends(state, command, via, mask, context)) return false;
    if (mask == 0) mask = kAllAxes;
    // G91 G28 Z0, the usual homing block, has no intermediate point, so no position becomes known
    // there.
    AxisMask moved = command.axis_words ? mask : 0;
    for (std::size_t i = 0; i < via.size(); ++i) {
        if (state.incremental && via[i] == state.position[i]) moved &= ~(1U << i);
    }
    context.path.linear_move(state, via, MoveKind::Rapid, moved);
    Store& store = control.store.change();
    store.via = via;
    store.has_via = command.axis_words;

    move_to_machine(state, store.homes[second ? 1 : 0], {mask}, context);
    if (context.rules.home_cancels_length) state.length_register = kNoLength;
    if (context.rules.home_cancels_length && state.frames.tool_offset != Axes{}) {
        const Axes machine = state.machine_position();
        state.frames.tool_offset = {};
        keep_machine_position(state, machine);
        ++state.length_changes;
    }
    return true;
}

bool seek_home(ControlState& control, const Command& command, Context& context) {
    AxisMask named = 0;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (command.has(kAxisNames[i])) named |= 1U << i;
    }
    if (named == 0) named = 1U << kX | 1U << kY | 1U << kZ;
    constexpr AxisMask kUp = 1U << kZ;
    move_to_machine(control.machine, control.store->homes[0], {named & kUp, named & ~kUp}, context);
    return true;
}

bool return_from_home(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    if (!command.axis_words) return fail(context, Message::AxesMissing, command.span, {"G29"});
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(state, command, end, mask, context)) return false;
    if (control.store->has_via)
        context.path.linear_move(state, control.store->via, MoveKind::Rapid, mask);
    context.path.linear_move(state, end, MoveKind::Rapid, mask);
    return true;
}

void set_home(ControlState& control, bool second) {
    Axes& home = control.store.change().homes[second ? 1 : 0];
    home = control.machine.machine_position();
    scale_lengths(home, control.machine.unit_mm());
}

}  // namespace ncsim::gcode
