// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic work offsets, whose zero moves with the table: G254 of Haas, for the present table
// position; G54.2 and G54.4 of Fanuc, for every table position.
#include "ncsim/gcode/print.h"

#include "control/machine.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ncsim::gcode {

/// Sets the displacement of the zero. The machine position stays; the program coordinates change.
void Machine::set_dynamic_offset(const std::optional<std::array<double, 3>>& shift) {
    if (shift == state_.frames.dynamic_offset) return;
    const Axes machine = machine_position();
    state_.frames.dynamic_offset = shift;
    recompute_position(machine);
}

/// G254: the zero moves with the table to the present rotary positions; X, Y and Z keep the
/// directions of the machine. G255 ends the mode.
bool Machine::apply_dynamic_offset(const Command& command) {
    const Code code = command.group(Group::DynamicOffset);
    if (code == Code::None) return true;
    if (code == Code::G54_2 || code == Code::G54_4) return offset_table(command, code);
    if (state_.table_offset != 0)
        return stop_with(Message::TwoCarried, span_of_g(command, code), {name_of(code)});
    set_dynamic_offset(std::nullopt);
    if (code == Code::G255) return true;
    const SourceSpan span = span_of_g(command, code);
    if (!options_.joints || !options_.joints->turns())
        return stop_with(Message::RotaryUnspecified, span, {name_of(code)});
    if (state_.frames.tilt || state_.coordinates == Coordinates::Tip)
        return stop_with(Message::PlaneForbids, span, {name_of(code)});
    if (!is_turned()) return true;
    requested_tip_positions_ = true;
    Axes zero = axis_positions();
    for (std::size_t i = 0; i < 3; ++i)
        zero[i] = state_.frames.work_offset[i] * state_.unit_mm();
    const auto there =
        options_.joints->joints_for({zero[kX], zero[kY], zero[kZ]}, zero, length_mm());
    if (!there) return stop_with(Message::OutOfReach, span, {"the zero"});
    std::array<double, 3> shift{};
    for (std::size_t i = 0; i < 3; ++i)
        shift[i] = ((*there)[i] - zero[i]) / state_.unit_mm();
    set_dynamic_offset(shift);
    return true;
}

// --- G54.2 and G54.4 ---

const TableOffsets& Machine::table_offsets() const {
    return state_.is_setting_error ? options_.setting_errors : options_.fixture_offsets;
}

/// Returns the displacement of the zero with the rotary axes of `axis_positions`, in machine
/// coordinates, active units.
std::array<double, 3> Machine::dynamic_offset_at(const Axes& axis_positions) const {
    const TableOffsets::One& specified = table_offsets().by_number.at(state_.table_offset);
    Axes from{};
    for (std::size_t i = 0; i < 3; ++i)
        from[kA + i] = specified.at[i];
    std::array<double, 3> shift =
        options_.joints->rotate_with_table(specified.offset, from, axis_positions);
    for (double& component : shift)
        component /= state_.unit_mm();
    return shift;
}

/// G54.2 Pn, G54.4 Pn: the vector n of the control moves with the table, and its end is the zero.
/// P0 ends the mode.
bool Machine::offset_table(const Command& command, Code code) {
    const SourceSpan span = span_of_g(command, code);
    const bool is_setting_error = code == Code::G54_4;
    const TableOffsets& specified =
        is_setting_error ? options_.setting_errors : options_.fixture_offsets;
    if (!options_.joints || !options_.joints->turns())
        return stop_with(Message::RotaryUnspecified, span, {name_of(code)});
    const double p = command.get('P', -1.0);
    if (!(p >= 0.0 && p == std::floor(p) && p < 1e9))
        return stop_with(Message::PlaneForm, span, {name_of(code), "the number of an offset (P)"});
    const int number = static_cast<int>(p);
    const std::string name = std::to_string(number);
    if (!specified.moves || (number != 0 && !specified.by_number.contains(number))) {
        return stop_with(
            is_setting_error ? Message::SettingErrorUnspecified : Message::FixtureOffsetUnspecified,
            span, {name});
    }
    if (state_.frames.tilt || state_.coordinates == Coordinates::Tip)
        return stop_with(Message::CarriedUnderTip, span, {name_of(code)});
    if (state_.cutter_side != CutterSide::Off)
        return stop_with(Message::ForbiddenWithCompensation, span, {name_of(code)});
    if (state_.frames.dynamic_offset &&
        (state_.table_offset == 0 || state_.is_setting_error != is_setting_error))
        return stop_with(Message::TwoCarried, span, {name_of(code)});
    if (number != 0 && !take_setting(specified.by_number.at(number), specified, name, span))
        return false;
    const Axes machine = machine_position();
    state_.table_offset = number;
    state_.is_setting_error = is_setting_error;
    state_.frames.dynamic_offset.reset();
    state_.frames.dynamic_offset_home = {};
    if (number != 0) {
        state_.frames.dynamic_offset = dynamic_offset_at(axis_positions());
        state_.frames.dynamic_offset_home = dynamic_offset_at({});
    }
    if (!*specified.moves) {
        recompute_position(machine);
    } else if (!command.axis_words || command.axes_are_taken()) {
        // Moves by the displacement of the zero; no axis counts as named.
        const bool feeds = state_.feed > 0.0 && state_.motion == Code::G1;
        if (machine_position() != machine)
            path_.linear_move(state_, state_.position, feeds ? MoveKind::Feed : MoveKind::Rapid, 0);
    }
    return true;
}

/// Accepts a part that is rotated on the table, if the tool stays normal to the part: positions on
/// the part are as programmed.
bool Machine::take_setting(const TableOffsets::One& one, const TableOffsets& all,
                           std::string_view name, SourceSpan span) {
    const auto& [about_x, about_y, about_z] = one.turns;
    const double askew = std::abs(about_x) + std::abs(about_y) + std::abs(about_z);
    if (askew == 0.0) return true;
    if ((about_x != 0.0 || about_y != 0.0) && !all.axes_take_turns)
        return stop_with(Message::SettingErrorLeans, span, {name});
    std::string degrees;
    print_number(degrees, askew);
    warn(Message::SettingErrorTurns, span, {name, degrees});
    setting_askew_ = std::max(setting_askew_, askew);
    return true;
}

/// For a straight move that turns the table: `end`, with the named axes `mask`, refers to the zero
/// at the end of the move.
void Machine::follow_table(Axes& end, AxisMask mask) {
    if (state_.table_offset == 0 || (mask & kRotaryAxes) == 0) return;
    if (state_.frames.tilt || state_.coordinates == Coordinates::Tip) return;
    const Axes machine = machine_position(), before = state_.position;
    Axes turned = axis_positions();
    for (std::size_t i = kA; i <= kC; ++i)
        turned[i] = end[i] + state_.frames.offset_92[i] + state_.frames.work_offset[i];
    state_.frames.dynamic_offset = dynamic_offset_at(turned);
    recompute_position(machine);
    if (*table_offsets().moves) return;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((mask & 1U << i) == 0 || state_.incremental) end[i] += state_.position[i] - before[i];
    }
}

/// Reports codes that are not simulated with a dynamic work offset.
bool Machine::check_dynamic_offset(const Command& command) {
    if (!state_.frames.dynamic_offset) return true;
    const bool turns = command.has_any(letters('A', 'B', 'C')) && !command.axes_are_taken();
    const Code one_shot = command.group(Group::OneShot);
    if (state_.table_offset == 0)
        return !turns || one_shot == Code::G53 || fail(Message::CarriedTurns, command.span);
    const std::string_view own = state_.is_setting_error ? "G54.4" : "G54.2";
    const auto forbid = [&](Code code) {
        return fail(Message::CarriedForbids, span_of_g(command, code), {name_of(code), own});
    };
    for (const Group group : {Group::PolarInterpolation, Group::Cylinder}) {
        if (const Code code = command.group(group); code != Code::None) return forbid(code);
    }
    // Under G54.4 planes refer to the rotated part.
    for (const Group group : {Group::TiltedPlane, Group::Orient}) {
        const Code code = command.group(group);
        if (code != Code::None && !state_.is_setting_error) return forbid(code);
    }
    if (const Code code = command.group(Group::ToolLength);
        !state_.is_setting_error &&
        (code == Code::G43_4 || code == Code::G43_5 || code == Code::G234)) {
        return forbid(code);
    }
    if (const int code = command.group(MGroup::Kinematics);
        code != kNone && !state_.is_setting_error) {
        return fail(Message::CarriedForbids, command.span,
                    {std::string("M").append(std::to_string(code)), own});
    }
    const bool goes_home =
        one_shot == Code::G28 || one_shot == Code::G30 || one_shot == Code::G28_2;
    const bool homes_turn =
        goes_home && (!command.axis_words || command.has_any(letters('A', 'B', 'C')));
    if (homes_turn || one_shot == Code::G29 || (one_shot == Code::G53 && turns))
        return forbid(one_shot);
    if (!turns || state_.frames.tilt || state_.coordinates == Coordinates::Tip) return true;
    const Code motion = command.group(Group::Motion);
    const Code now = motion == Code::None ? state_.motion : motion;
    if (now > Code::G1) return fail(Message::CarriedForbids, command.span, {name_of(now), own});
    if (state_.cutter_side != CutterSide::Off)
        return fail(Message::ForbiddenWithCompensation, command.span, {"a rotary axis"});
    return true;
}

}  // namespace ncsim::gcode
