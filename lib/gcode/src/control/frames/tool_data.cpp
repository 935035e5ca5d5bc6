// SPDX-License-Identifier: GPL-3.0-or-later
//
// Registers of tools: G10 of a tool, the length of G43, the radius of G41.
#include "control/frames/frame_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

/// True if `mm` is a diameter. Haas controls use diameters by default, radii by setting 40. If the
/// tool's diameter is specified, the nearer of diameter and radius decides. Wear counts as a
/// diameter.
bool is_diameter(const ToolTableEntry& entry, double mm, bool is_wear, const Setup& setup) {
    const auto& specified = setup.options.tools;
    const auto tool = std::ranges::find(specified, entry.number, &ToolTableEntry::number);
    if (is_wear || tool == specified.end() || !tool->diameter) return true;
    const double diameter = tool->diameter->mm();
    return std::abs(mm - diameter) <= std::abs(mm - diameter / 2.0);
}

/// Returns the specified length of `tool`, mm; nullopt if unspecified.
std::optional<double> specified_length(const ControlState& control, int tool) {
    const auto entry = std::ranges::find(control.store->tools, tool, &ToolTableEntry::number);
    if (entry == control.store->tools.end() || !entry->length_specified) return std::nullopt;
    return entry->offset[2].mm();
}

/// Returns the register of G43. H0 is no offset, except on LinuxCNC, where H0 is the tool in the
/// spindle.
int length_number(const MachineState& state, const Command& command, const Setup& setup) {
    const int h = static_cast<int>(std::clamp(command.get('H', state.tool), 0.0, 1e9));
    return h == 0 && setup.rules.is_linuxcnc() ? state.tool : h;
}

}  // namespace

bool is_length_active(const ControlState& control, const Command& command, const Setup& setup) {
    const MachineState& state = control.machine;
    const int h = length_number(state, command, setup);
    if (state.length_register != h || state.tip_by_length) return false;
    Axes offset{};
    const auto entry = std::ranges::find(control.store->tools, h, &ToolTableEntry::number);
    for (std::size_t i = 0; entry != control.store->tools.end() && i < 3; ++i)
        offset[i] = entry->offset[i].mm() / state.unit_mm();
    return offset == state.frames.tool_offset;
}

ToolTableEntry* register_of(ControlState& control, int index) {
    std::vector<ToolTableEntry>& tools = control.store.change().tools;
    auto entry = std::ranges::find(tools, index, &ToolTableEntry::number);
    if (entry == tools.end()) {
        if (tools.size() > 10'000) return nullptr;
        tools.push_back({.number = index, .offset = {}, .length_specified = false, .diameter = {}});
        entry = tools.end() - 1;
    }
    return &*entry;
}

bool is_register(const Command& command, int l, const Setup& setup) {
    if (setup.rules.strict || !command.has('R') || command.has_any(letters('X', 'Y', 'Z')))
        return false;
    // L1 is wear on Haas, a tool table on other controls.
    return l != 1 || setup.rules.dialect == Dialect::Haas;
}

bool set_register(ControlState& control, const Command& command, int index, int l,
                  Context& context) {
    MachineState& state = control.machine;
    ToolTableEntry* entry = register_of(control, index);
    if (!entry) return fail(context, Message::G10Form, command.span);
    const bool of_length = l <= 11;
    const bool is_wear = l == 1 || l == 11 || l == 13;
    const std::array<char, 4> name{'L', static_cast<char>('0' + l / 10),
                                   static_cast<char>('0' + l % 10), '\0'};
    double value = command['R'] * state.unit_mm();
    if (!of_length && context.rules.dialect == Dialect::Haas &&
        is_diameter(*entry, value, is_wear, context)) {
        context.log.add(Message::G10Diameter, span_of(command, 'R'),
                        {std::string_view(name.data(), 3)});
        value /= 2.0;
    }
    set_register_value(control, *entry, of_length, is_wear, value, state.incremental, context);
    return true;
}

void set_register_value(ControlState& control, ToolTableEntry& entry, bool of_length, bool is_wear,
                        double mm, bool adds, const Setup& setup) {
    MachineState& state = control.machine;
    Wear& wear = control.store.change().wear[entry.number];
    double& worn = of_length ? wear.length_mm : wear.radius_mm;
    const double sum =
        of_length ? entry.offset[2].mm() : entry.diameter.value_or(Length()).mm() / 2.0;
    double whole = sum - worn;  // Value without the wear.
    double& specified = is_wear ? worn : whole;
    specified = adds ? specified + mm : mm;
    if (of_length) {
        entry.offset[2] = Length::from_mm(whole + worn);
        entry.length_specified = true;
        if (entry.number == state.tool) state.tool_length = gauge_length(control, setup);
    } else {
        entry.diameter = Length::from_mm(2.0 * (whole + worn));
    }
}

bool set_tool_data(ControlState& control, const Command& command, int index, Context& context) {
    MachineState& state = control.machine;
    ToolTableEntry* entry = register_of(control, index);
    if (!entry) return fail(context, Message::G10Form, command.span);
    const long l = std::lround(command['L']);
    const double unit = state.unit_mm();
    const Axes machine = state.machine_position();
    Axes zero = state.frames.work_offset;
    if (l == 11 && control.store->work_offsets[8].origin != Axes{})
        zero = from_mm(control.store->work_offsets[8].origin, unit);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!command.has(kAxisNames[i])) continue;
        const double value = command[kAxisNames[i]];
        // L10 and L11: with the new offset the present position has the coordinates of the block.
        const double offset =
            l == 1 ? value
                   : machine[i] - zero[i] - value - (l == 10 ? state.frames.offset_92[i] : 0.0);
        entry->offset[i] = Length::from_mm(unit * offset);
    }
    entry->length_specified |= command.has('Z');
    if (command.has('R')) entry->diameter = Length::from_mm(2.0 * unit * command['R']);
    if (index == state.tool) state.tool_length = gauge_length(control, context);
    return true;
}

std::optional<double> gauge_length(const ControlState& control, const Setup& setup) {
    const MachineState& state = control.machine;
    const auto& specified = setup.options.tools;
    const auto entry = std::ranges::find(specified, state.tool, &ToolTableEntry::number);
    if (entry != specified.end() && entry->length_specified) return entry->offset[2].mm();
    return specified_length(control, state.tool);
}

bool set_tool_length(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code code = command.group(Group::ToolLength);
    if (code == Code::None) return true;
    state.by_vector = false;
    if (context.rules.strict && command.has('H') && !check_tool(control, command, 'H', context))
        return false;
    if (code == Code::G43_5 && !context.options.joints) {
        return stop_with(context, Message::RotaryUnspecified, span_of_g(command, code),
                         {name_of(code)});
    }
    if (code == Code::G43_4 || code == Code::G43_5 || code == Code::G234) {
        // Haas fixes the frame to the table at rotary positions 0.
        if (is_turned(state) && code != Code::G234 && !context.options.tip_control.frame_at_zero) {
            context.stopped = true;
            return fail(context, Message::TipFrameUnspecified, span_of_g(command, code));
        }
        state.tip_by_length = true;
        state.by_vector = code == Code::G43_5;
        choose_coordinates(state, Coordinates::Tip, context);
    } else if (state.tip_by_length) {
        state.tip_by_length = false;
        choose_coordinates(state, Coordinates::Axes, context);
    }
    const double unit = state.unit_mm();
    state.length_register = code == Code::G49 ? kNoLength : kStatedLength;
    state.length_specified = code == Code::G43_1;
    Axes offset{};
    if (code == Code::G43_1) {
        offset = state.frames.tool_offset;  // Axes without a word keep the offset.
        for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
            if (command.has(kAxisNames[i])) offset[i] = command[kAxisNames[i]];
        }
    } else if (code != Code::G49) {
        const int h = length_number(state, command, context);
        if (code == Code::G43_2) {
            offset = state.frames.tool_offset;
        } else {
            state.length_register = code == Code::G44 && h != 0 ? kNegatedLength : h;
            state.length_specified = specified_length(control, h).has_value();
        }
        const auto entry = std::ranges::find(control.store->tools, h, &ToolTableEntry::number);
        if (entry != control.store->tools.end()) {
            const double sign = code == Code::G44 ? -1.0 : 1.0;
            for (std::size_t i = 0; i < 3; ++i)
                offset[i] += sign * entry->offset[i].mm() / unit;
        }
    }
    context.facts.uses_length_offsets |= state.length_register != kNoLength;
    if (offset == state.frames.tool_offset) return true;
    const Axes machine = state.machine_position();
    state.frames.tool_offset = offset;
    keep_machine_position(state, machine);
    ++state.length_changes;
    return true;
}

double radius_of_register(const ControlState& control, const Command& command, SourceSpan span,
                          Context& context) {
    const MachineState& state = control.machine;
    int d = static_cast<int>(std::clamp(command.get('D', state.tool), 0.0, 1e9));
    if (d == 0 && context.rules.is_linuxcnc()) d = state.tool;
    context.facts.unread_registers.erase(d);
    const auto entry = std::ranges::find(control.store->tools, d, &ToolTableEntry::number);
    if (entry != control.store->tools.end() && entry->diameter) {
        return entry->diameter->mm() / 2.0 / state.unit_mm();
    }
    if (!context.rules.strict && d != 0) {
        warn(context, Message::CompensationRadiusUnknown, span,
             {std::string("D").append(std::to_string(d))});
    }
    return 0.0;
}

bool check_tool(const ControlState& control, const Command& command, char letter,
                Context& context) {
    const double value = command[letter];
    if (value < 0.0)
        return fail(context, Message::NegativeValue, span_of(command, letter), {{&letter, 1}});
    const int number = static_cast<int>(std::min(value, 1e9));
    const auto& tools = control.store->tools;
    if (number == 0 || tools.empty()) return true;
    if (std::ranges::find(tools, number, &ToolTableEntry::number) != tools.end()) return true;
    return fail(context, Message::ToolNotInTable, span_of(command, letter),
                {std::to_string(number)});
}

}  // namespace ncsim::gcode
