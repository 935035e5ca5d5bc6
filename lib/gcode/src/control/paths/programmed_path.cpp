// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines and arcs of the programmed path: made, offset by cutter compensation, or recorded as an
// outline.
#include "control/paths/path_steps.h"

#include <cstdlib>

namespace ncsim::gcode {
namespace {

/// Returns `end` plus the offset that remains after G40: the first move in the plane after G40 ends
/// at the programmed point along both axes of the plane.
Axes with_cancelled_offset(MachineState& state, const Axes& end, AxisMask mask) {
    const PlaneAxes axes = axes_of(state.plane);
    const auto moves = [mask](std::size_t axis) { return (mask >> axis & 1U) != 0; };
    if (!moves(axes.first) && !moves(axes.second)) return end;
    Axes target = end;
    for (const std::size_t axis : {axes.first, axes.second}) {
        if (!moves(axis) || state.incremental) target[axis] += state.uncancelled[axis];
    }
    state.uncancelled = {};
    return target;
}

}  // namespace

bool feed_straight(ControlState& control, const Axes& end, MoveKind kind, AxisMask mask,
                   Context& context) {
    MachineState& state = control.machine;
    if (context.outline.is_recording()) {
        context.outline.is_foreign |= kind != MoveKind::Feed;
        return record_outline_move(state, end, nullptr, context);
    }
    if (control.compensation.is_entering() && context.rules.is_linuxcnc()) {
        const PlaneAxes axes = axes_of(state.plane);
        if (end[axes.first] == state.position[axes.first] &&
            end[axes.second] == state.position[axes.second])
            return fail(context, Message::CompensationEntry, context.span);
    }
    state.just_left_compensation = false;
    if (control.compensation.is_on())
        return compensation_of(control, context)
            .linear_move(state, end, kind, mask, context.span, context.file);
    context.path.linear_move(state, with_cancelled_offset(state, end, mask), kind, mask);
    return true;
}

bool make_arc(ControlState& control, const ProgramArc& arc, AxisMask mask, Context& context) {
    MachineState& state = control.machine;
    if (context.outline.is_recording()) return record_outline_move(state, arc.end, &arc, context);
    if (control.compensation.is_on())
        return compensation_of(control, context).arc(state, arc, mask, context.span, context.file);
    context.path.arc(state, arc, mask);
    state.just_left_compensation = false;
    return true;
}

bool record_outline_move(MachineState& state, const Axes& end, const ProgramArc* arc,
                         Context& context) {
    const Axes& from = state.position;
    OutlineMove move;
    move.from = {from[kX], from[kY]};
    move.to = {end[kX], end[kY]};
    if (arc) move.centre = {arc->centre_1, arc->centre_2}, move.turns = arc->turns;
    for (std::size_t i = 0; i < end.size(); ++i)
        context.outline.is_foreign |= i != kX && i != kY && end[i] != from[i];
    context.outline.is_foreign |= state.plane != Plane::XY || std::abs(move.turns) > 1;
    const bool moves = arc || move.from.x != move.to.x || move.from.y != move.to.y;
    if (moves) context.outline.moves.push_back(move);
    state.position = end;
    return true;
}

}  // namespace ncsim::gcode
