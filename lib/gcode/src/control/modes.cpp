// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes: feed, spindle, tools, coolant, units, G90 and G91; dwells, stops, and the end of the
// program.
#include "control/block_steps.h"
#include "control/cycles/cycle_steps.h"
#include "control/frames/frame_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace ncsim::gcode {
namespace {

/// Converts all lengths of `state`; `factor` = new value / old value.
void convert_units(MachineState& state, double factor) {
    scale_lengths(state.position, factor);
    scale_lengths(state.uncancelled, factor);
    state.frames.scale_lengths(factor);
    state.cutter_radius *= factor;
    if (state.feed_mode != FeedMode::InverseTime) state.feed *= factor;
    if (state.cylinder) state.cylinder->radius *= factor;
    state.inches = !state.inches;
}

void set_coolant(MachineState& state, const Command& command) {
    const int spindle = command.group(MGroup::Spindle);
    if (spindle == 13 || spindle == 14) state.coolant.flood = true;
    switch (command.group(MGroup::Coolant)) {
        case 7: state.coolant.mist = true; break;
        case 8: state.coolant.flood = true; break;
        case 9: state.coolant = {}; break;
        default: break;
    }
    if (command.mist_and_flood) state.coolant = {.mist = true, .flood = true};
}

}  // namespace

std::optional<Plane> plane_of(const Command& command) {
    switch (command.group(Group::Plane)) {
        case Code::G17: return Plane::XY;
        case Code::G18: return Plane::ZX;
        case Code::G19: return Plane::YZ;
        case Code::G17_1: return Plane::UV;
        case Code::G18_1: return Plane::WU;
        case Code::G19_1: return Plane::VW;
        default: return std::nullopt;
    }
}

bool set_feed(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code mode = command.group(Group::Feed);
    if (mode != Code::None) {
        const FeedMode before = state.feed_mode;
        state.feed_mode = mode == Code::G93   ? FeedMode::InverseTime
                          : mode == Code::G94 ? FeedMode::PerMinute
                                              : FeedMode::PerRevolution;
        // A feed in the unit of a different mode is not a valid feed.
        if (before != state.feed_mode || context.rules.strict) {
            state.feed = 0.0;
            // G93 of LinuxCNC keeps the number of the last F.
            if (mode != Code::G93) control.feed_word = 0.0;
        }
    }
    if (command.has('F') && letter_of_dwell(command, context) != 'F') {
        if (command['F'] < 0.0)
            return fail(context, Message::NegativeValue, span_of(command, 'F'), {"F"});
        state.feed = command['F'];
        control.feed_word = state.feed;
    }
    return true;
}

void set_speeds_and_tools(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    if (const Code mode = command.group(Group::SpindleSpeed); mode != Code::None) {
        state.constant_surface_speed = mode == Code::G96;
    }
    if (command.has('S') && letter_of_dwell(command, context) != 'S')
        state.spindle_rpm = std::abs(command['S']);
    if (command.has('T')) {
        state.selected_tool = static_cast<int>(std::clamp(command['T'], -1.0, 1e9));
    }
    const int change = command.group(MGroup::ToolChange);
    if (change == 6 && state.selected_tool >= 0) {
        state.tool = state.selected_tool;
        if (command.next_tool >= 0.0) {
            state.selected_tool = static_cast<int>(std::min(command.next_tool, 1e9));
        }
        state.spindle = SpindleTurning::Stopped;
        state.tool_length = gauge_length(control, context);
        context.path.tool_change(state);
    } else if (change == 61 && command.has('Q')) {
        state.tool = static_cast<int>(std::clamp(command['Q'], 0.0, 1e9));
        state.tool_length = gauge_length(control, context);
        context.path.tool_change(state);
    }
    if (const int spindle = command.group(MGroup::Spindle); spindle != kNone) {
        state.spindle_in_doubt = false;
        state.spindle_oriented = spindle == 19;
    }
    switch (command.group(MGroup::Spindle)) {
        case 3:
        case 13: state.spindle = SpindleTurning::Clockwise; break;
        case 4:
        case 14: state.spindle = SpindleTurning::Counterclockwise; break;
        case 5:
        // M19 holds the spindle in a direction.
        case 19: state.spindle = SpindleTurning::Stopped; break;
        default: break;
    }
    if (command.rigid_tapping) {  // M29 stops the spindle until G84 turns it.
        state.rigid_tapping = true;
        state.spindle = SpindleTurning::Stopped;
    }
    set_coolant(state, command);
    for (const int code : command.clamps) {
        for (const RotaryClamp& clamp : context.options.clamps) {
            const auto axis = static_cast<std::size_t>(clamp.letter - 'A');
            if (clamp.clamp == code) state.clamped[axis] = true;
            if (clamp.release == code) state.clamped[axis] = false;
        }
    }
    if (const int code = command.group(MGroup::Kinematics); code != kNone) {
        const auto specified = context.options.tip_control.m_codes.find(code);
        const bool is_specified = specified != context.options.tip_control.m_codes.end();
        state.kinematics = is_specified ? 0 : code;
        state.tip_by_length = false;
        if (is_specified) choose_coordinates(state, specified->second, context);
    }
}

bool needs_kinematics(const MachineState& state, const Command& command) {
    if (state.kinematics == 0) return false;
    return command.has_any(letters('A', 'B', 'C')) || is_turned(state);
}

void set_units(ControlState& control, bool inches) {
    MachineState& state = control.machine;
    if (!state.first_length_seen) state.units_stated = true;
    if (inches == state.inches) return;
    const double factor = inches ? 1.0 / 25.4 : 25.4;
    convert_units(state, factor);
    control.compensation.convert_units(
        factor, [factor](MachineState& s) { gcode::convert_units(s, factor); });
    Store& store = control.store.change();
    scale_lengths(store.probed, factor);
    scale_lengths(store.via, factor);
    for (std::size_t i = 0; store.specified_plane && i < 3; ++i)
        store.specified_plane->origin[i] *= factor;
}

void set_modes(MachineState& state, const Command& command, Context& context) {
    if (const Code g = command.group(Group::Distance); g != Code::None) {
        state.incremental = g == Code::G91;
        if (!context.facts.distance_is_stated && g == Code::G91)
            context.facts.distance.is_certain = true;
        context.facts.distance_is_stated = true;
    }
    if (const Code g = command.group(Group::Centre); g != Code::None) {
        state.absolute_centres = g == Code::G90_1;
        context.centres.is_settled = true;
    }
    if (const Code g = command.group(Group::Retract); g != Code::None)
        state.retract_to_r = g == Code::G99;
    if (const Code g = command.group(Group::Diameter); g != Code::None)
        state.lathe_diameter = g == Code::G7;
}

char letter_of_dwell(const Command& command, const Setup& setup) {
    if (command.group(Group::OneShot) != Code::G4) return ' ';
    for (const char letter : {'P', 'X', 'U', 'F', 'S'}) {
        if (command.has(letter) && (letter == 'P' || !setup.rules.strict)) return letter;
    }
    return ' ';
}

bool make_dwell(ControlState& control, const Command& command, Context& context) {
    const char letter = letter_of_dwell(command, context);
    if (letter == ' ')
        return tolerate(context, Message::DwellWithoutTime, span_of_g(command, Code::G4));
    const double seconds = seconds_of(command, letter, context);
    if (seconds < 0.0)
        return fail(context, Message::NegativeValue, span_of(command, letter), {{&letter, 1}});
    compensation_of(control, context).dwell(control.machine, seconds, context.span, context.file);
    return true;
}

void execute_stop(ControlState& control, const Command& command, Context& context) {
    const int code = command.group(MGroup::Stop);
    if (code == 2 || code == 30) return finish_program(control, context);
    if (context.rules.is_linuxcnc()) compensation_of(control, context).finish_held();
    stop_at(control.machine, code, context);
}

void stop_at(MachineState& state, int code, const Setup& setup) {
    // M0, M1, M60. LinuxCNC and grbl keep the spindle on; other controls stop the spindle,
    // including Haas and most Fanuc machines.
    if (setup.rules.strict || setup.rules.dialect == Dialect::Grbl) return;
    const bool stops_it =
        setup.rules.dialect == Dialect::Fanuc || setup.rules.dialect == Dialect::Haas;
    if (stops_it && code != 1) {
        state.spindle = SpindleTurning::Stopped;
    } else {
        // M1 stops only if the operator enabled M1.
        state.spindle_in_doubt = state.spindle != SpindleTurning::Stopped;
    }
}

void finish_program(ControlState& control, Context& context) {
    MachineState& state = control.machine;
    context.ended = true;
    compensation_of(control, context).end(state);
    end_polar_interpolation(state, context);
    end_plane(control, context);
    set_dynamic_offset(state, std::nullopt);
    state.frames.dynamic_offset_home = {};
    state.table_offset = 0;
    state.cylinder.reset();
    select_system(control, 1, context);
    state.plane = Plane::XY;
    state.incremental = false;
    state.feed_mode = FeedMode::PerMinute;
    state.feed = control.feed_word = 0.0;
    state.cutter_side = CutterSide::Off;
    state.uncancelled = {};
    state.spindle = SpindleTurning::Stopped;
    state.coolant = {};
    state.spindle_in_doubt = false;
    state.spindle_oriented = false;
    state.rigid_tapping = false;
    state.motion = Code::G1;
    state.frames.programmed = {};
}

}  // namespace ncsim::gcode
