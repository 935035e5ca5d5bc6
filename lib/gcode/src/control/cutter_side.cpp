// SPDX-License-Identifier: GPL-3.0-or-later
//
// G40, G41, G42: begin and end of cutter compensation.
#include "control/block_steps.h"
#include "control/frames/frame_steps.h"

#include <cmath>
#include <optional>

namespace ncsim::gcode {
namespace {

/// Refuses words as LinuxCNC does: a tool missing in the table, G41.1 without D, an orientation (L)
/// outside G18.
bool check_compensation_words(const ControlState& control, const Command& command, bool stated,
                              Context& context) {
    if (stated) {
        if (!command.has('D'))
            return fail(context, Message::CycleWordMissing, command.span, {"G41.1 or G42.1", "D"});
        return !command.has('L') || control.machine.plane == Plane::ZX ||
               fail(context, Message::WordUnused, span_of(command, 'L'), {"L outside G18"});
    }
    return !command.has('D') || check_tool(control, command, 'D', context);
}

}  // namespace

void flush_held(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    if (!control.compensation.is_on()) return;
    const Code one_shot = command.group(Group::OneShot);
    const int stop = command.group(MGroup::Stop);
    const bool changes_nothing =
        one_shot == Code::None || one_shot == Code::G4 ||
        (one_shot == Code::G10 && !sets_active_data(state, command, context));
    if (!changes_nothing || !keeps_frame(control, command, context) ||
        command.group(Group::TiltedPlane) != Code::None ||
        command.group(Group::PolarInterpolation) != Code::None ||
        command.group(Group::Orient) != Code::None ||
        command.group(Group::DynamicOffset) != Code::None ||
        command.group(MGroup::ToolChange) != kNone || command.group(MGroup::Kinematics) != kNone ||
        stop == 2 || stop == 30) {
        compensation_of(control, context).flush(state);
        context.path.set_origin(context.span, context.file);
    } else if (command.group(Group::CutterSide) == Code::G40) {
        compensation_of(control, context).finish_held();
        context.path.set_origin(context.span, context.file);
    }
}

bool set_cutter_side(ControlState& control, const Command& command, Context& context) {
    MachineState& state = control.machine;
    const Code code = command.group(Group::CutterSide);
    if (code == Code::None) return true;
    if (code == Code::G40) {
        if (control.compensation.is_on()) {
            // On LinuxCNC the next move begins at the programmed point: axes of the plane that the
            // next move does not name also move there.
            const std::optional<Axes> programmed = control.compensation.programmed;
            compensation_of(control, context).end(state);
            if (programmed && context.rules.is_linuxcnc()) {
                state.position = *programmed;
            } else if (programmed &&
                       context.rules.compensation_start == CompensationStart::SquareToNext) {
                const PlaneAxes axes = axes_of(state.plane);
                for (const std::size_t axis : {axes.first, axes.second})
                    state.uncancelled[axis] = (*programmed)[axis] - state.position[axis];
            }
            context.path.set_origin(context.span, context.file);
            state.just_left_compensation |= !context.rules.strict || programmed.has_value();
        }
        state.cutter_side = CutterSide::Off;
        return true;
    }
    const SourceSpan span = span_of_g(command, code);
    if (state.cutter_side != CutterSide::Off &&
        !tolerate(context, Message::CompensationTwice, span)) {
        return false;
    }
    if (state.plane != Plane::XY && state.plane != Plane::ZX) {
        return fail(context, Message::CompensationPlane, span);
    }
    const bool stated =
        code == Code::G41_1 || code == Code::G42_1;  // G41.1 D3.5: D is the diameter itself.
    if (context.rules.strict && !check_compensation_words(control, command, stated, context))
        return false;
    double radius = 0.0;
    if (stated) {
        radius = command.get('D', 0.0) / 2.0;
    } else {
        radius = radius_of_register(control, command, span, context);
    }
    const bool is_41 = code == Code::G41 || code == Code::G41_1;
    const bool left = is_41 == (radius >= 0.0);  // A negative radius means the opposite side.
    const CutterSide side = left ? CutterSide::Left : CutterSide::Right;
    if (control.compensation.is_on() && side == state.cutter_side &&
        std::abs(radius) == state.cutter_radius)
        return true;
    if (control.compensation.is_on()) compensation_of(control, context).end(state);
    state.cutter_side = side;
    state.cutter_radius = std::abs(radius);
    if (radius != 0.0)
        compensation_of(control, context)
            .begin(state.cutter_side, std::abs(radius), context.rules.compensation_start);
    return true;
}

void begin_compensation_at(ControlState& control, CutterSide side, double radius,
                           const Axes& contour, Context& context) {
    MachineState& state = control.machine;
    if (control.compensation.is_on()) compensation_of(control, context).end(state);
    state.cutter_side = side;
    state.cutter_radius = radius;
    const Axes at = state.position;
    const PlaneAxes axes = axes_of(state.plane);
    const Axes from = state.frames.programmed.apply(contour);
    if (radius > 0.0) compensation_of(control, context).begin_at_offset(side, radius, at);
    state.position[axes.first] = from[axes.first];
    state.position[axes.second] = from[axes.second];
}

}  // namespace ncsim::gcode
