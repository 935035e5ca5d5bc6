// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coordinate systems: G54 … G59.3, G92 and G52, G10 of an origin.
#include "ncsim/base/angles.h"

#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ncsim::gcode {
namespace {

double mm_of(double value, std::size_t axis, double unit) {
    return is_rotary(axis) ? value : value * unit;
}

/// Adds `distance_mm` to the origins with the reference `frame` along `axis`.
void shift_frame(ControlState& control, std::size_t axis, int frame, double distance_mm) {
    Store& store = control.store.change();
    for (WorkOffset& offset : store.work_offsets) {
        if (offset.frame[axis] == frame) offset.origin[axis] += distance_mm;
    }
    for (auto& [number, offset] : store.extended) {
        if (offset.frame[axis] == frame) offset.origin[axis] += distance_mm;
    }
}

/// Returns the P of G54.1 Pn and similar codes; nullopt if P is invalid.
std::optional<int> extended_number(const Command& command) {
    constexpr double kMost = 300.0;
    const double p = command.get('P', 0.0);
    if (!(p >= 1.0 && p <= kMost) || p != std::floor(p)) return std::nullopt;
    return static_cast<int>(p);
}

bool set_work_data(ControlState& control, const Command& command, int index, bool from_position,
                   Context& context) {
    MachineState& state = control.machine;
    WorkOffset& offset = offset_of(control, index);
    const double unit = state.unit_mm();
    Axes machine = state.machine_position();
    context.path.record_offset(index);
    if (command.has('R') && from_position && context.rules.strict)
        return fail(context, Message::WordUnused, span_of(command, 'R'), {"R"});
    if (command.has('R') && !from_position) {
        const bool has_g92 = state.frames.offset_92[kX] != 0.0 || state.frames.offset_92[kY] != 0.0;
        if (context.rules.is_linuxcnc() && index == state.system && has_g92 &&
            offset.rotation != command['R'])
            warn(context, Message::RotationUnderG92, span_of(command, 'R'));
        offset.rotation = command['R'];
    }
    // L20: the present position gets the coordinates of the block.
    double x = machine[kX] - state.frames.tool_offset[kX] - offset.origin[kX] / unit;
    double y = machine[kY] - state.frames.tool_offset[kY] - offset.origin[kY] / unit;
    rotate(x, y, -offset.rotation);
    double wanted_x = x;
    double wanted_y = y;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = command[kAxisNames[i]];
        if (!from_position) {
            const double before = state.incremental && !context.rules.is_linuxcnc()
                                      ? offset.origin[i]
                                      : control.store->external[i];
            offset.origin[i] = before + mm_of(value, i, unit);
            if (i <= kZ && (!state.incremental || context.rules.is_linuxcnc())) offset.frame[i] = 0;
        } else if (i == kX) {
            wanted_x = value + state.frames.offset_92[kX];
        } else if (i == kY) {
            wanted_y = value + state.frames.offset_92[kY];
        } else {
            offset.origin[i] =
                mm_of(machine[i] - state.frames.tool_offset[i] - state.frames.offset_92[i] - value,
                      i, unit);
        }
    }
    if (from_position && command.has_any(letters('X', 'Y'))) {
        rotate(wanted_x, wanted_y, offset.rotation);
        offset.origin[kX] = unit * (machine[kX] - state.frames.tool_offset[kX] - wanted_x);
        offset.origin[kY] = unit * (machine[kY] - state.frames.tool_offset[kY] - wanted_y);
    }
    for (std::size_t i = kX; from_position && i <= kZ; ++i) {
        if (!command.has(kAxisNames[i])) continue;
        if (state.is_known(i)) {
            const int frame = state.place_frame[i];
            offset.frame[i] = frame == kMachinePlace ? 0 : frame;
        } else {
            offset.frame[i] = index;  // An unknown position.
            // The computed origin is arbitrary; the position gets the number of the block.
            control.store.change().used_frames[i].insert(index);
        }
    }
    if (from_position) state.is_at_start = false;
    if (state.is_at_start && place_at_start(control, context)) return true;
    if (index != state.system) return true;
    assume_same_zero(control, machine, context);
    use_system(control, machine);
    for (std::size_t i = kX; from_position && i <= kZ; ++i) {
        if (command.has(kAxisNames[i]) && !state.is_known(i)) mark_known(state, i);
    }
    return true;
}

/// G10 L2 P0 of Fanuc and Haas: sets the external offset, which is part of all origins.
bool set_external(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    Axes external = control.store->external;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = mm_of(command[kAxisNames[i]], i, state.unit_mm());
        external[i] = state.incremental ? external[i] + value : value;
    }
    move_external(control, external, context);
    return true;
}

}  // namespace

void keep_machine_position(MachineState& state, const Axes& machine) {
    state.position = state.frames.from_machine(machine);
}

WorkOffset& offset_of(ControlState& control, int system) {
    Store& store = control.store.change();
    if (system <= kExtended) return store.work_offsets[static_cast<std::size_t>(system - 1)];
    const auto [entry, is_new] = store.extended.try_emplace(system - kExtended);
    if (is_new) {
        entry->second = store.work_offsets.front();
        entry->second.frame.fill(system);
    }
    return entry->second;
}

void select_system(ControlState& control, int system, Context& context) {
    MachineState& state = control.machine;
    Axes machine = state.machine_position();
    state.system = system;
    if (state.is_at_start && place_at_start(control, context)) return;
    assume_same_zero(control, machine, context);
    use_system(control, machine);
}

void use_system(ControlState& control, const Axes& machine) {
    MachineState& state = control.machine;
    const WorkOffset& offset = offset_of(control, state.system);
    state.frames.work_offset = from_mm(offset.origin, state.unit_mm());
    state.frames.rotation = offset.rotation;
    state.frame = offset.frame;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!state.is_known(i)) state.place_frame[i] = state.frame[i];
        // Reference 0 is the machine, so a machine position is known in a system with reference 0.
        state.of_machine[i] = state.of_machine[i] && state.frame[i] != 0;
    }
    keep_machine_position(state, machine);
}

void assume_same_zero(ControlState& control, Axes& machine, Context& context) {
    MachineState& state = control.machine;
    const double unit = state.unit_mm();
    for (std::size_t i = 0; i < 3; ++i) {
        std::set<int>& used = control.store.change().used_frames[i];
        used.insert(state.frame[i]);
        const int frame = offset_of(control, state.system).frame[i];
        if (!used.insert(frame).second) continue;
        const double distance =
            state.frames.work_offset[i] * unit - offset_of(control, state.system).origin[i];
        if (frame != 0) {
            shift_frame(control, i, frame, distance);
            continue;
        }
        for (const int other : used) {
            if (other != 0) shift_frame(control, i, other, -distance);
        }
        context.path.shift_unspecified(i, -distance);
        state.frame_shift[i] -= distance;
        if (state.is_known(i) && state.place_frame[i] != kMachinePlace)
            machine[i] -= distance / unit;
    }
}

bool place_at_start(ControlState& control, Context& context) {
    MachineState& state = control.machine;
    if (state.frames.tilt || state.frames.dynamic_offset || state.coordinates != Coordinates::Axes)
        return false;
    const double unit = state.unit_mm();
    Axes machine = state.machine_position();
    Axes start{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (context.options.start[i]) start[i] = context.options.start[i]->mm() / unit;
    }
    Store& store = control.store.change();
    const WorkOffset& g54 = store.work_offsets.front();
    rotate(start[kX], start[kY], g54.rotation);
    for (std::size_t i = 0; i < 3; ++i) {
        // An axis without a start counts as at home.
        machine[i] = context.options.start[i] ? start[i] + g54.origin[i] / unit : 0.0;
        store.used_frames[i] = {g54.frame[i]};
    }
    state.frames.work_offset = from_mm(g54.origin, unit);
    state.frame = state.place_frame = g54.frame;
    assume_same_zero(control, machine, context);
    use_system(control, machine);
    // If the origin of G54 is unspecified, the start refers to the system of the first move.
    for (std::size_t i = 0; i < 3; ++i) {
        if (state.place_frame[i] != 0) state.place_frame[i] = state.frame[i];
    }
    ++state.length_changes;
    return true;
}

int system_of(Code code) {
    const auto* const named = std::ranges::find(kSystemCodes, code);
    if (named != kSystemCodes.end()) return static_cast<int>(named - kSystemCodes.begin()) + 1;
    // Haas: G110 is G154 P1.
    if (code >= Code::G110 && code <= Code::G129) {
        return kExtended + (tenths_of(code) - tenths_of(Code::G110)) / 10 + 1;
    }
    return 1;
}

bool has_other_use(const MachineState& state, const Command& command, char letter) {
    Code motion = command.group(Group::Motion);
    if (motion == Code::None && command.axis_words) motion = state.motion;
    const auto uses = [letter](Code code) {
        return code != Code::None && entry_of(code).group != Group::WorkOffset &&
               (entry_of(code).letters >> letter_index(letter) & 1U) != 0;
    };
    return command.group(Group::PathMode) != Code::None || uses(motion) ||
           std::ranges::any_of(command.g, uses);
}

bool set_work_offset(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code code = command.group(Group::WorkOffset);
    if (code == Code::None) return true;
    int system = system_of(code);
    if (code == Code::G54_1 || code == Code::G154 ||
        (code == Code::G54 && command.has('P') && !context.rules.strict &&
         !has_other_use(state, command, 'P'))) {
        const std::optional<int> number = extended_number(command);
        if (!number)
            return fail(context, Message::ExtendedNumber, span_of_g(command, code),
                        {name_of(code)});
        system = kExtended + *number;
    }
    // LinuxCNC ignores the selection of the active system; values written as variables take effect
    // with the selection of another system.
    const bool stays = context.rules.dialect == Dialect::Rs274 && system == state.system;
    if (!stays) select_system(control, system, context);
    return true;
}

bool set_offset_92(ControlState& control, const Command& command, Code code, Context& context) {
    MachineState& state = control.machine;
    const double unit = state.unit_mm();
    const Axes machine = state.machine_position();
    Axes offset = state.frames.offset_92;
    switch (code) {
        case Code::G92:
        // Smoothieware, Carvera: sets the position of the machine axis, as in "A0 is here".
        case Code::G92_4:
        case Code::G28_3:  // TinyG, g2core: same as G92.4.
        case Code::G52:
            if (!command.axis_words) {
                // Fanuc: "G92 S2000" limits the spindle speed.
                if (context.rules.strict)
                    return fail(context, Message::AxesMissing, command.span, {"G92"});
                return true;
            }
            for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
                if (!command.has(kAxisNames[i])) continue;
                const bool is_diameter = i == kX && state.lathe_diameter;
                const double value = command[kAxisNames[i]] / (is_diameter ? 2.0 : 1.0);
                offset[i] = code == Code::G52
                                ? value
                                : state.position[i] + state.frames.offset_92[i] - value;
                // If the position of the axis was unknown, G92 defines the position and the program
                // zero.
                if (code == Code::G52 || i > kZ || state.is_known(i) || state.frames.tilt) continue;
                state.frames.zero_92[i] = offset[i];
                state.frames.is_zero_by_hand[i] = true;
                context.path.record_offset(state.system);
                mark_known(state, i);
            }
            if (code != Code::G52) state.is_at_start = false;
            for (std::size_t i = 0; i < offset.size(); ++i)
                control.store.change().stored_92[i] = mm_of(offset[i], i, unit);
            state.offset_92_active = true;
            break;
        case Code::G92_1: control.store.change().stored_92 = {}; [[fallthrough]];
        case Code::G92_2:
            offset = {};
            state.frames.zero_92 = {};
            state.frames.is_zero_by_hand = {};
            state.offset_92_active = false;
            break;
        case Code::G92_3:
            offset = from_mm(control.store->stored_92, unit);
            state.offset_92_active = true;
            break;
        default: return true;
    }
    state.frames.offset_92 = offset;
    keep_machine_position(state, machine);
    return true;
}

bool set_data(ControlState& control, const Command& command, Context& context) {
    const SourceSpan span = span_of_g(command, Code::G10);
    if (!command.has('L')) return fail(context, Message::G10Form, span);
    const int l = static_cast<int>(std::lround(std::clamp(command['L'], -1e6, 1e6)));
    const int p = static_cast<int>(std::lround(std::clamp(command.get('P', -1.0), -1e6, 1e6)));
    switch (l) {
        case 2:
        case 20:
            if (l == 20 && context.rules.macro_b) {
                // Fanuc and Haas: the origin of G54.1 Pn, not the present position.
                const std::optional<int> number = extended_number(command);
                if (!number) return fail(context, Message::ExtendedNumber, span, {"G10 L20"});
                return set_work_data(control, command, kExtended + *number, false, context);
            }
            if (p < 0 || p > 9) {
                if (context.rules.strict || p < 0)
                    return fail(context, Message::G10System, span_of(command, 'P'));
                return tolerate(context, Message::G10System, span_of(command, 'P'));
            }
            if (p == 0 && context.rules.macro_b) return set_external(control, command, context);
            return set_work_data(control, command, p == 0 ? control.machine.system : p, l == 20,
                                 context);
        case 1:
        case 10:
        case 11:
            if (p < 0) return fail(context, Message::G10Form, span);
            if (is_register(command, l, context))
                return set_register(control, command, p, l, context);
            return set_tool_data(control, command, p, context);
        case 12:
        case 13:
            if (p < 0 || !is_register(command, l, context))
                return fail(context, Message::G10Form, span);
            return set_register(control, command, p, l, context);
        case 3:
        case 50:
        case 51:
        case 52:
            // Runner leaves out the lines of data up to G11.
            if (context.rules.has_data_lines()) return true;
            return fail(context, Message::G10Form, span);
        default: return fail(context, Message::G10Form, span);
    }
}

void move_external(ControlState& control, const Axes& external, Context& context) {
    MachineState& state = control.machine;
    const Axes machine = state.machine_position();
    Store& store = control.store.change();
    const auto shift = [&](WorkOffset& offset) {
        for (std::size_t i = 0; i < external.size(); ++i)
            offset.origin[i] += external[i] - store.external[i];
    };
    std::ranges::for_each(store.work_offsets, shift);
    for (auto& [number, offset] : store.extended)
        shift(offset);
    store.external = external;
    store.has_external = true;
    if (!state.is_at_start || !place_at_start(control, context)) use_system(control, machine);
}

}  // namespace ncsim::gcode
