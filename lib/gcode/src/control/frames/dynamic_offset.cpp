// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic work offsets, whose zero moves with the table: G254 of Haas, for the present table
// position; G54.2 and G54.4 of Fanuc, for every table position.
#include "ncsim/gcode/print.h"

#include "control/frames/frame_steps.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

const TableOffsets& table_offsets(const MachineState& state, const Setup& setup) {
    return state.is_setting_error ? setup.options.setting_errors : setup.options.fixture_offsets;
}

/// Accepts a part that is rotated on the table, if the tool stays normal to the part: positions on
/// the part are as programmed.
bool take_setting(const TableOffsets::One& one, const TableOffsets& all, std::string_view name,
                  SourceSpan span, Context& context) {
    const auto& [about_x, about_y, about_z] = one.turns;
    const double askew = std::abs(about_x) + std::abs(about_y) + std::abs(about_z);
    if (askew == 0.0) return true;
    if ((about_x != 0.0 || about_y != 0.0) && !all.axes_take_turns)
        return stop_with(context, Message::SettingErrorLeans, span, {name});
    std::string degrees;
    print_number(degrees, askew);
    warn(context, Message::SettingErrorTurns, span, {name, degrees});
    context.facts.setting_askew = std::max(context.facts.setting_askew, askew);
    return true;
}

/// G54.2 Pn, G54.4 Pn: the vector n of the control moves with the table, and its end is the zero.
/// P0 ends the mode.
bool offset_table(MachineState& state, const Command& command, Code code, Context& context) {
    const SourceSpan span = span_of_g(command, code);
    const bool is_setting_error = code == Code::G54_4;
    const TableOffsets& specified =
        is_setting_error ? context.options.setting_errors : context.options.fixture_offsets;
    if (!has_rotary_axes(name_of(code), span, context)) return false;
    const double p = command.get('P', -1.0);
    if (!(p >= 0.0 && p == std::floor(p) && p < 1e9))
        return stop_with(context, Message::PlaneForm, span,
                         {name_of(code), "the number of an offset (P)"});
    const int number = static_cast<int>(p);
    const std::string name = std::to_string(number);
    if (!specified.moves || (number != 0 && !specified.by_number.contains(number))) {
        return stop_with(
            context,
            is_setting_error ? Message::SettingErrorUnspecified : Message::FixtureOffsetUnspecified,
            span, {name});
    }
    if (state.frames.tilt || state.coordinates == Coordinates::Tip)
        return stop_with(context, Message::CarriedUnderTip, span, {name_of(code)});
    if (state.cutter_side != CutterSide::Off)
        return stop_with(context, Message::ForbiddenWithCompensation, span, {name_of(code)});
    if (state.frames.dynamic_offset &&
        (state.table_offset == 0 || state.is_setting_error != is_setting_error))
        return stop_with(context, Message::TwoCarried, span, {name_of(code)});
    if (number != 0 &&
        !take_setting(specified.by_number.at(number), specified, name, span, context))
        return false;
    const Axes machine = state.machine_position();
    state.table_offset = number;
    state.is_setting_error = is_setting_error;
    state.frames.dynamic_offset.reset();
    state.frames.dynamic_offset_home = {};
    if (number != 0) {
        state.frames.dynamic_offset = dynamic_offset_at(state, axis_positions(state), context);
        state.frames.dynamic_offset_home = dynamic_offset_at(state, {}, context);
    }
    if (!*specified.moves) {
        keep_machine_position(state, machine);
    } else if (!command.axis_words || command.axes_are_taken()) {
        // Moves by the displacement of the zero; no axis counts as named.
        const bool feeds = state.feed > 0.0 && state.motion == Code::G1;
        if (state.machine_position() != machine)
            context.path.linear_move(state, state.position,
                                     feeds ? MoveKind::Feed : MoveKind::Rapid, 0);
    }
    return true;
}

}  // namespace

void set_dynamic_offset(MachineState& state, const std::optional<std::array<double, 3>>& shift) {
    if (shift == state.frames.dynamic_offset) return;
    const Axes machine = state.machine_position();
    state.frames.dynamic_offset = shift;
    keep_machine_position(state, machine);
}

bool apply_dynamic_offset(MachineState& state, const Command& command, Context& context) {
    const Code code = command.group(Group::DynamicOffset);
    if (code == Code::None) return true;
    if (code == Code::G54_2 || code == Code::G54_4)
        return offset_table(state, command, code, context);
    if (state.table_offset != 0)
        return stop_with(context, Message::TwoCarried, span_of_g(command, code), {name_of(code)});
    set_dynamic_offset(state, std::nullopt);
    if (code == Code::G255) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!has_rotary_axes(name_of(code), span, context)) return false;
    if (state.frames.tilt || state.coordinates == Coordinates::Tip)
        return stop_with(context, Message::PlaneForbids, span, {name_of(code)});
    if (!is_turned(state)) return true;
    context.facts.requested_tip_positions = true;
    Axes zero = axis_positions(state);
    for (std::size_t i = 0; i < 3; ++i)
        zero[i] = state.frames.work_offset[i] * state.unit_mm();
    const auto there =
        context.options.joints->joints_for({zero[kX], zero[kY], zero[kZ]}, zero, length_mm(state));
    if (!there) return stop_with(context, Message::OutOfReach, span, {"the zero"});
    std::array<double, 3> shift{};
    for (std::size_t i = 0; i < 3; ++i)
        shift[i] = ((*there)[i] - zero[i]) / state.unit_mm();
    set_dynamic_offset(state, shift);
    return true;
}

std::array<double, 3> dynamic_offset_at(const MachineState& state, const Axes& axis_positions,
                                        const Setup& setup) {
    const TableOffsets::One& specified =
        table_offsets(state, setup).by_number.at(state.table_offset);
    Axes from{};
    for (std::size_t i = 0; i < 3; ++i)
        from[kA + i] = specified.at[i];
    std::array<double, 3> shift =
        setup.options.joints->rotate_with_table(specified.offset, from, axis_positions);
    for (double& component : shift)
        component /= state.unit_mm();
    return shift;
}

void follow_table(MachineState& state, Axes& end, AxisMask mask, const Setup& setup) {
    if (state.table_offset == 0 || (mask & kRotaryAxes) == 0) return;
    if (state.frames.tilt || state.coordinates == Coordinates::Tip) return;
    const Axes machine = state.machine_position(), before = state.position;
    Axes turned = axis_positions(state);
    for (std::size_t i = kA; i <= kC; ++i)
        turned[i] = end[i] + state.frames.offset_92[i] + state.frames.work_offset[i];
    state.frames.dynamic_offset = dynamic_offset_at(state, turned, setup);
    keep_machine_position(state, machine);
    if (*table_offsets(state, setup).moves) return;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((mask & 1U << i) == 0 || state.incremental) end[i] += state.position[i] - before[i];
    }
}

bool check_dynamic_offset(const MachineState& state, const Command& command, Context& context) {
    if (!state.frames.dynamic_offset) return true;
    const bool turns = command.has_any(letters('A', 'B', 'C')) && !command.axes_are_taken();
    const Code one_shot = command.group(Group::OneShot);
    if (state.table_offset == 0)
        return !turns || one_shot == Code::G53 ||
               fail(context, Message::CarriedTurns, command.span);
    const std::string_view own = state.is_setting_error ? "G54.4" : "G54.2";
    const auto forbid = [&](Code code) {
        return fail(context, Message::CarriedForbids, span_of_g(command, code),
                    {name_of(code), own});
    };
    for (const Group group : {Group::PolarInterpolation, Group::Cylinder}) {
        if (const Code code = command.group(group); code != Code::None) return forbid(code);
    }
    // Under G54.4 planes refer to the rotated part.
    for (const Group group : {Group::TiltedPlane, Group::Orient}) {
        const Code code = command.group(group);
        if (code != Code::None && !state.is_setting_error) return forbid(code);
    }
    if (const Code code = command.group(Group::ToolLength);
        !state.is_setting_error &&
        (code == Code::G43_4 || code == Code::G43_5 || code == Code::G234)) {
        return forbid(code);
    }
    if (const int code = command.group(MGroup::Kinematics);
        code != kNone && !state.is_setting_error) {
        return fail(context, Message::CarriedForbids, command.span,
                    {std::string("M").append(std::to_string(code)), own});
    }
    const bool goes_home =
        one_shot == Code::G28 || one_shot == Code::G30 || one_shot == Code::G28_2;
    const bool homes_turn =
        goes_home && (!command.axis_words || command.has_any(letters('A', 'B', 'C')));
    if (homes_turn || one_shot == Code::G29 || (one_shot == Code::G53 && turns))
        return forbid(one_shot);
    if (!turns || state.frames.tilt || state.coordinates == Coordinates::Tip) return true;
    const Code now = motion_of(state, command);
    if (now > Code::G1)
        return fail(context, Message::CarriedForbids, command.span, {name_of(now), own});
    if (state.cutter_side != CutterSide::Off)
        return fail(context, Message::ForbiddenWithCompensation, command.span, {"a rotary axis"});
    return true;
}

}  // namespace ncsim::gcode
