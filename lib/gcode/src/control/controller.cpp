// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order of execution.
#include "control/controller.h"

#include "control/block_steps.h"
#include "control/cycles/cycle_steps.h"
#include "control/paths/path_steps.h"

#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

Axes to_axes(const Position& p) {
    return {p.x.mm(),      p.y.mm(), p.z.mm(), p.a.degrees(), p.b.degrees(),
            p.c.degrees(), p.u.mm(), p.v.mm(), p.w.mm()};
}

/// Sets origins, tools and homes as specified.
void fill_store(Store& store, const InterpreterOptions& options) {
    store.tools = options.tools;
    for (std::size_t i = 0; i < store.work_offsets.size(); ++i) {
        store.work_offsets[i].origin = to_axes(options.work_offsets[i]);
        const bool known = options.work_offsets_specified[i];
        store.work_offsets[i].frame.fill(known ? 0 : static_cast<int>(i) + 1);
    }
    for (const auto& [number, origin] : options.extended_offsets)
        store.extended[number].origin = to_axes(origin);
    for (std::size_t i = 0; i < store.homes.size(); ++i)
        store.homes[i] = to_axes(options.homes[i]);
}

/// Returns the first move before G90 and G91 if neither the control nor the values determine the
/// mode.
std::optional<ProgramPlace> distance_guess(const Context& context) {
    const Dialect dialect = context.rules.dialect;
    const bool starts_absolute = context.rules.is_linuxcnc() || dialect == Dialect::Grbl ||
                                 dialect == Dialect::Haas || dialect == Dialect::Heidenhain ||
                                 dialect == Dialect::Sinumerik;
    const DistanceEvidence& distance = context.facts.distance;
    if (starts_absolute || distance.is_certain || distance.are_places()) return std::nullopt;
    return distance.first;
}

bool one_shot(ControlState& control, const Command& command, Context& context) {
    const Code code = command.group(Group::OneShot);
    switch (code) {
        case Code::None:
        case Code::G4:
        case Code::G53: return true;
        case Code::G10: return set_data(control, command, context);
        case Code::G28: return move_home(control, command, false, context);
        case Code::G29: return return_from_home(control, command, context);
        case Code::G30: return move_home(control, command, true, context);
        case Code::G28_1: return set_home(control, false), true;
        case Code::G28_2: return seek_home(control, command, context);
        case Code::G30_1: return set_home(control, true), true;
        default: return set_offset_92(control, command, code, context);
    }
}

/// Makes the steps of `command` in the order of execution.
/// Returns: false after reporting an error.
bool act(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    if (const Code code = command.group(Group::Unsupported); code != Code::None) {
        const bool of_tip = code == Code::G43_4 || code == Code::G43_5 || code == Code::G234;
        const bool lathe = code >= Code::G70 && code < Code::G73;
        return stop_with(
            context,
            of_tip  ? context.options.joints ? Message::TipFrameMissing : Message::RotaryUnspecified
            : lathe ? Message::LatheCycle
                    : Message::TiltedPlane,
            command.span, {name_of(code)});
    }
    if (const Code code = command.group(Group::NotSimulated); code != Code::None)
        return fail(context, Message::NotSimulated, span_of_g(command, code), {name_of(code)});
    if (!check_block(control, command, context) || !check_tilted_plane(state, command, context) ||
        !check_dynamic_offset(state, command, context))
        return false;
    if (command.corner != 0 && !ends_in_corner(state, command, context)) {
        return fail(context, Message::CornerWord, command.corner_span,
                    {corner_name(command.corner, context)});
    }
    if (command.has_angle && !ends_in_corner(state, command, context))
        return fail(context, Message::CornerWord, command.angle_span, {",A"});
    // On most controls G20 F10 is 10 inches per minute; RS274/NGC reads F before G20.
    const Code units = command.group(Group::Units);
    const auto switch_units = [&] {
        if (units != Code::None) set_units(control, units == Code::G20 || units == Code::G70);
    };
    if (!context.rules.is_linuxcnc()) switch_units();
    if (!set_feed(control, command, context)) return false;
    set_speeds_and_tools(control, command, context);
    if (needs_kinematics(state, command)) {
        return stop_with(context, Message::KinematicsUnspecified, command.span,
                         {std::string("M").append(std::to_string(state.kinematics))});
    }
    if (command.group(Group::OneShot) == Code::G4 && !make_dwell(control, command, context))
        return false;
    if (const std::optional<Plane> plane = plane_of(command)) state.plane = *plane;
    if (context.rules.is_linuxcnc()) switch_units();
    // G41 in the block of G150 applies to the pocket only.
    const bool for_pocket = command.group(Group::Pocket) == Code::G150;
    if ((!for_pocket && !set_cutter_side(control, command, context)) ||
        !set_tool_length(control, command, context) ||
        !set_work_offset(control, command, context)) {
        return false;
    }
    set_modes(state, command, context);
    if (!set_programmed(state, command, context) || !set_tilted_plane(control, command, context) ||
        !apply_dynamic_offset(state, command, context) ||
        !set_polar_interpolation(state, command, context) ||
        !set_cylinder(state, command, context) || !orient_tool(control, command, context) ||
        !check_tip_control(state, command, context) || !one_shot(control, command, context)) {
        return false;
    }
    if (!make_move(control, command, command.group(Group::Motion), context)) return false;
    if (command.group(MGroup::Stop) != kNone) execute_stop(control, command, context);
    return true;
}

}  // namespace

Controller::Controller(const InterpreterOptions& options, const Rules& rules, ArcCentres& centres,
                       DiagnosticLog& log, Path& path, Parameters& parameters)
    : context_{{options, rules}, centres, log, path} {
    MachineState& state = control_.machine;
    fill_store(control_.store.change(), options);
    for (const auto& [number, radius] : options.compensation) {
        if (ToolTableEntry* entry = register_of(control_, number))
            entry->diameter = Length::from_mm(2.0 * radius.mm());
        context_.facts.unread_registers.insert(number);
    }
    state.inches = options.default_units == DefaultUnits::Inches;
    state.retract_to_r = options.starts_with_g99.value_or(rules.is_linuxcnc());
    state.chosen = state.coordinates = options.tip_control.at_start;
    use_system(control_, {});  // G54, with the axes at home.
    parameters.view.state = &state;
    parameters.view.store = &control_.store;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!options.start[i]) continue;
        state.position[i] = options.start[i]->mm() / state.unit_mm();
        mark_known(state, i);
    }
    state.is_at_start = !options.start_is_of_machine;
}

/// Restores the control to `before`.
/// Requires: the path has made no motion since `before`.
void restore(ControlState& control, const ControlState& before, Context& context) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double shift = before.machine.frame_shift[i] - control.machine.frame_shift[i];
        if (shift != 0.0) context.path.shift_unspecified(i, shift);
    }
    control = before;
}

bool Controller::execute(const Command& command) {
    if (control_.corner && !continues_from_corner(control_, command, context_))
        settle_corner(control_, context_);
    flush_held(control_, command, context_);
    const ControlState before = control_;
    const std::uint64_t motions = context_.path.count();
    context_.curve_fails = false;
    if (act(control_, command, context_)) return true;
    if (context_.outline.is_recording()) context_.outline.is_foreign = true;
    // Motions that were made cannot be undone.
    if (context_.path.count() == motions) restore(control_, before, context_);
    if (context_.curve_fails) control_.curve = {};
    return false;
}

void Controller::begin_compensation_at(CutterSide side, double radius, const Axes& contour) {
    gcode::begin_compensation_at(control_, side, radius, contour, context_);
}

bool Controller::begin_contour(const Command& command) {
    return gcode::begin_contour(control_, command, context_);
}

void Controller::end_outline() {
    gcode::end_outline(control_, context_);
}

void Controller::flush() {
    if (control_.corner) settle_corner(control_, context_);
    compensation_of(control_, context_).flush(control_.machine);
}

void Controller::set_origin(SourceSpan span, std::uint32_t file) {
    gcode::set_origin(span, file, context_);
}

bool Controller::set_variable(const SystemVariable& variable, double value, bool is_relative,
                              SourceSpan span) {
    const bool is_active =
        variable.effect == SystemVariable::Effect::External ||
        (variable.effect == SystemVariable::Effect::WorkOffset && variable.index == state().system);
    if (is_active && context_.rules.macro_b) flush();
    return set_variable_offset(control_, variable, value, is_relative, span, context_);
}

void Controller::pause() {
    stop_at(control_.machine, 0, context_);
}

bool Controller::tilt(const FeatureFrame& frame, std::string_view name, SourceSpan span) {
    flush();
    return set_tilt(control_.machine, frame, name, span, context_);
}

void Controller::end_tilt() {
    end_plane(control_, context_);
}

std::optional<Axes> Controller::axes_of_tilt(LeadingAxis leading, std::string_view name,
                                             SourceSpan span) {
    return gcode::axes_of_tilt(control_.machine, leading, name, span, context_);
}

void Controller::turn_axes(const Axes& axes, MoveKind kind, bool tip_stays) {
    gcode::turn_axes(control_.machine, axes, kind, tip_stays, context_);
}

void Controller::finish() {
    finish_program(control_, context_);
}

void Controller::report_to(Interpretation& result) const {
    const ProgramEvidence& facts = context_.facts;
    result.uses_length_offsets = facts.uses_length_offsets;
    result.requested_tip_positions = facts.requested_tip_positions;
    result.setting_askew = facts.setting_askew;
    result.unread_registers = facts.unread_registers;
    result.distance_guess = distance_guess(context_);
    result.units_stated = state().units_stated;
    result.uses_inches =
        state().first_length_seen ? state().first_length_in_inches : state().inches;
}

}  // namespace ncsim::gcode
