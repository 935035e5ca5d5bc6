// SPDX-License-Identifier: GPL-3.0-or-later
//
// Codes that controls refuse or execute differently while cutter compensation is on.
#include "control/block_steps.h"
#include "control/frames/frame_steps.h"

#include <optional>
#include <string_view>

namespace ncsim::gcode {
namespace {

/// Returns the code of `command` that interrupts cutter compensation without ending the mode;
/// empty: none. Controls react differently, from an alarm to a move without offset.
std::string_view interrupts_compensation(const ControlState& control, const Command& command,
                                         const Setup& setup) {
    const MachineState& state = control.machine;
    if (state.cutter_side == CutterSide::Off) return {};
    if (command.group(MGroup::ToolChange) != kNone) return "a tool change";
    if (const std::optional<Plane> plane = plane_of(command); plane && *plane != state.plane)
        return "another plane";
    if (command.group(Group::CutterSide) == Code::G40) return {};
    if (!keeps_frame(control, command, setup)) return "another coordinate system or tool length";
    switch (const Code one_shot = command.group(Group::OneShot)) {
        case Code::None:
        case Code::G4: break;
        case Code::G10:
            if (sets_active_data(state, command, setup)) return "G10 of the active system or tool";
            break;
        case Code::G92_1:
        case Code::G92_2:
        case Code::G92_3:
            if (setup.rules.is_linuxcnc()) break;
            [[fallthrough]];
        case Code::G53:  // LinuxCNC asks whether there is a radius.
            if (setup.rules.is_linuxcnc() && !control.compensation.is_on()) break;
            [[fallthrough]];
        default: return name_of(one_shot);
    }
    const Code motion = command.group(Group::Motion);
    const bool probes = motion == Code::G31 || (motion >= Code::G38_2 && motion <= Code::G38_5);
    if (probes || is_cycle(motion)) return name_of(motion);
    return {};
}

}  // namespace

bool keeps_frame(const ControlState& control, const Command& command, const Setup& setup) {
    const MachineState& state = control.machine;
    const Code system = command.group(Group::WorkOffset);
    const bool by_number = system == Code::G54_1 || system == Code::G154 ||
                           (command.has('P') && !has_other_use(state, command, 'P'));
    if (system != Code::None && (by_number || system_of(system) != state.system)) return false;
    if (const std::optional<Plane> plane = plane_of(command); plane && *plane != state.plane)
        return false;
    switch (command.group(Group::ToolLength)) {
        case Code::None: return true;
        case Code::G49:
            return state.length_register == kNoLength && state.frames.tool_offset == Axes{};
        case Code::G43: return is_length_active(control, command, setup);
        default: return false;
    }
}

std::string_view forbidden_with_compensation(const ControlState& control, const Command& command) {
    const MachineState& state = control.machine;
    const Code side = command.group(Group::CutterSide);
    const bool is_on = state.cutter_side != CutterSide::Off;
    if (is_on) {
        if (command.group(MGroup::ToolChange) == 6) return "M6";
        if (command.group(MGroup::Override) != kNone) return "M48 … M53";
        if (command.group(MGroup::Io) != kNone) return "M62 … M68";
        const std::optional<Plane> plane = plane_of(command);
        if (plane && *plane != state.plane) return "another plane";
    }
    if (side == Code::G40 || (!is_on && side == Code::None)) return {};
    const Code length = command.group(Group::ToolLength);
    if (length != Code::None) return name_of(length);
    if (command.group(Group::WorkOffset) != Code::None) return "G54 … G59.3";
    if (command.group(Group::PathMode) != Code::None) return "G61, G61.1 or G64";
    if (command.group(Group::Retract) != Code::None) return "G98 or G99";
    switch (const Code one_shot = command.group(Group::OneShot)) {
        case Code::None:
        case Code::G4:
        case Code::G92_1:
        case Code::G92_2:
        case Code::G92_3: break;
        case Code::G53:
            if (control.compensation.is_on()) return "G53";
            break;
        case Code::G10: {
            const double p = command.get('P', 0.0);
            const bool sets_system = command.get('L', 0.0) == 2.0 || command.get('L', 0.0) == 20.0;
            if (sets_system && (p == 0.0 || p == state.system)) return "G10 of the active system";
            break;
        }
        default: return name_of(one_shot);
    }
    const Code motion = command.group(Group::Motion);
    const bool threads = motion == Code::G33 || motion == Code::G33_1;
    const bool curves = motion == Code::G5 || motion == Code::G5_1;
    const bool probes = motion >= Code::G38_2 && motion <= Code::G38_5;
    if (curves || probes || (threads && control.compensation.is_on())) return name_of(motion);
    return {};
}

bool sets_active_data(const MachineState& state, const Command& command, const Setup& setup) {
    const double l = command.get('L', 0.0);
    const double p = command.get('P', 0.0);
    if (l != 2.0 && l != 20.0) return p == state.length_register || p == state.tool;
    const bool is_extended = l == 20.0 && setup.rules.macro_b;
    return p == 0.0 || (is_extended ? kExtended + p : p) == state.system;
}

bool check_compensation(const ControlState& control, const Command& command, Context& context) {
    const std::string_view code = interrupts_compensation(control, command, context);
    if (code.empty()) return true;
    const bool is_plane = code == "another plane";
    if (context.rules.is_linuxcnc() || (context.rules.macro_b && is_plane))
        return fail(context, Message::ForbiddenWithCompensation, command.span, {code});
    context.log.add(Message::CompensationInterrupted, command.span, {code});
    return true;
}

}  // namespace ncsim::gcode
