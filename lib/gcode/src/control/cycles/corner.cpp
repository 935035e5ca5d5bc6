// SPDX-License-Identifier: GPL-3.0-or-later
//
// ,R and ,C of Fanuc and similar controls: an arc or a chamfer between a line and the next line.
// RND, CHF and CHR of other languages: the same; RND also next to arcs.
// ,A: the direction of a line for which one coordinate of the end is given, or which ends at the
// next line. Each such line is held back because the end depends on the next line.
#include "ncsim/base/angles.h"

#include "control/cycles/cycle_steps.h"
#include "control/cycles/fillet.h"
#include "control/paths/path_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ncsim::gcode {
namespace {

/// Rounding tolerance of lengths, in program units.
constexpr double kCornerRounding = 1e-9;

/// True for a line, and for an arc on controls that round corners at arcs.
bool is_element(const MachineState& state, const Command& command, const Setup& setup) {
    if (is_line(state, command)) return true;
    const Code motion = motion_of(state, command);
    return setup.rules.rounds_arcs && (motion == Code::G2 || motion == Code::G3) &&
           command.group(Group::OneShot) == Code::None;
}

bool stays_in_plane(const MachineState& state, const Axes& from, const Axes& to) {
    const PlaneAxes axes = axes_of(state.plane);
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (i != axes.first && i != axes.second && std::abs(from[i] - to[i]) > kCornerRounding)
            return false;
    }
    return true;
}

/// Returns the line of `command` to `end`, held back with its corner.
HeldCorner held_line(const MachineState& state, const Command& command, const Axes& end,
                     AxisMask mask, const Context& context) {
    HeldCorner held;
    held.state = state;
    held.end = end;
    held.mask = mask;
    held.letter = command.corner;
    held.size = command.corner_size;
    if (const ProgrammedTransform& t = state.frames.programmed; t.scaled)
        held.size *= std::abs(t.scale[axes_of(state.plane).first % 3]);
    held.is_modal = command.corner_is_modal;
    held.feed = command.corner_feed;
    held.span = context.span;
    held.word = command.corner_span;
    held.file = context.file;
    return held;
}

/// Makes the held line or arc to `end`, then the chamfer to `second` or the arc, with the state and
/// the origin of the held block. Sets the position to the end.
bool make_held_line(ControlState& control, const Axes& end, const Axes* second,
                    const ProgramArc* arc, Context& context) {
    MachineState& state = control.machine;
    const HeldCorner held = *control.corner;
    control.corner.reset();
    const SourceSpan span = context.span;
    const std::uint32_t file = context.file;
    MachineState now = state;
    state = held.state;
    set_origin(held.span, held.file, context);
    bool made = true;
    if (held.arc) {
        ProgramArc own = *held.arc;
        own.is_open = own.is_open || end != held.end;
        own.end = end;
        made = (own.is_open && end == state.position) || make_arc(control, own, held.mask, context);
    } else {
        made = end == state.position ||
               feed_straight(control, end, MoveKind::Feed, held.mask, context);
    }
    if (held.feed) state.feed = *held.feed;
    if (made && second) made = feed_straight(control, *second, MoveKind::Feed, held.mask, context);
    if (made && arc) made = make_arc(control, *arc, held.mask, context);
    set_origin(span, file, context);
    now.position = state.position;
    now.just_left_compensation = state.just_left_compensation;
    state = now;
    return made;
}

/// Rounds the corner between the held line or arc and the next line or arc.
bool round_at_arc(ControlState& control, const Axes& next, const ProgramArc* arc,
                  Context& context) {
    MachineState& state = control.machine;
    const PlaneAxes axes = axes_of(state.plane);
    const HeldCorner held = *control.corner;
    const auto leave_corner = [&] {
        return make_held_line(control, held.end, nullptr, nullptr, context);
    };
    const auto refuse = [&](std::string_view what) {
        fail(context, Message::CornerForm, held.word, {corner_name(held.letter, context), what});
        return leave_corner();
    };
    if (held.size == 0.0) return leave_corner();
    if (held.letter != 'R') return refuse("two lines");
    const bool is_flat = stays_in_plane(state, held.end, next);
    if (!is_flat && held.is_modal) return leave_corner();
    if (!is_flat) return refuse("a line or an arc in the plane after it");
    const auto point = [&](const Axes& p) { return Vec2{p[axes.first], p[axes.second]}; };
    PlaneElement first{point(held.state.position), point(held.end), false, {}, 1.0};
    PlaneElement second{point(held.end), point(next), false, {}, 1.0};
    for (const ProgramArc* const element : {held.arc ? &*held.arc : nullptr, arc}) {
        if (!element) continue;
        if (std::abs(element->turns) != 1) return refuse("arcs of one turn");
        PlaneElement& target = element == arc ? second : first;
        target.is_arc = true;
        target.centre = {element->centre_1, element->centre_2};
        target.turn = element->turns > 0 ? 1.0 : -1.0;
    }
    if (std::min(first.length(), second.length()) <= kCornerRounding)
        return refuse("two elements that have a length");
    const Vec2 a = first.direction_at(first.to);
    const Vec2 b = second.direction_at(second.from);
    const double dot = a.x * b.x + a.y * b.y;
    const double cross = a.x * b.y - a.y * b.x;
    constexpr double kTangent = 1e-6;  // Centres of tangential arcs are rounded by programmers.
    if (std::abs(cross) <= kTangent) {
        if (dot < 0.0) return refuse("a next element that does not turn back");
        return leave_corner();
    }
    const double side = cross > 0.0 ? 1.0 : -1.0;
    const std::optional<Fillet> found = fillet(first, second, held.size, side);
    if (!found) return refuse("elements that are long enough for it");
    const auto axes_at = [&](Vec2 p, Vec2 limit, const Axes& end) {
        if (hypotenuse(p.x - limit.x, p.y - limit.y) <= kCornerRounding) return end;
        Axes out = held.end;
        out[axes.first] = p.x;
        out[axes.second] = p.y;
        return out;
    };
    const Axes begin = axes_at(found->begin, first.from, held.state.position);
    const ProgramArc round{axes_at(found->end, second.to, next), found->centre.x, found->centre.y,
                           cross > 0.0 ? 1 : -1, true};
    return make_held_line(control, begin, nullptr, &round, context);
}

}  // namespace

std::string_view corner_name(char letter, const Setup& setup) {
    if (setup.rules.dialect == Dialect::Heidenhain) return letter == 'R' ? "RND" : "CHF";
    if (setup.rules.dialect == Dialect::Sinumerik)
        return letter == 'R' ? "RND" : letter == 'C' ? "CHR" : letter == 'L' ? "CHF" : "ANG";
    return letter == 'R' ? ",R" : letter == 'C' ? ",C" : ",A";
}

bool is_line(const MachineState& state, const Command& command) {
    if (motion_of(state, command) != Code::G1 || !command.axis_words) return false;
    for (const Group group : {Group::OneShot, Group::Rotation, Group::Scaling, Group::Mirror,
                              Group::Macro, Group::Pocket, Group::HolePattern}) {
        if (command.group(group) != Code::None) return false;
    }
    return command.group(Group::ToolLength) != Code::G43_1;
}

bool ends_in_corner(const MachineState& state, const Command& command, const Setup& setup) {
    return is_element(state, command, setup) && command.group(MGroup::Stop) == kNone;
}

bool continues_from_corner(const ControlState& control, const Command& command,
                           const Setup& setup) {
    const MachineState& state = control.machine;
    for (const Group group :
         {Group::Plane, Group::Units, Group::CutterSide, Group::ToolLength, Group::WorkOffset,
          Group::Polar, Group::TiltedPlane, Group::Orient, Group::PolarInterpolation,
          Group::Cylinder, Group::DynamicOffset, Group::Rotation, Group::Feed, Group::Diameter,
          Group::NotSimulated, Group::Unsupported}) {
        if (command.group(group) != Code::None) return false;
    }
    // On these controls, blocks without a move may be between the two elements of a corner.
    const bool is_neutral = setup.rules.rounds_arcs && !command.axis_words &&
                            command.group(Group::OneShot) == Code::None;
    const bool continues =
        is_neutral ||
        (control.corner->angle ? is_line(state, command) : is_element(state, command, setup));
    return continues && command.group(MGroup::Stop) == kNone &&
           command.group(MGroup::ToolChange) == kNone && command.group(MGroup::Kinematics) == kNone;
}

bool hold_corner(ControlState& control, const Command& command, const Axes& end, AxisMask mask,
                 const ProgramArc* arc, Context& context) {
    MachineState& state = control.machine;
    const std::string_view name = corner_name(command.corner, context);
    if (command.corner_size < 0.0)
        return fail(context, Message::NegativeValue, command.corner_span, {name});
    if (state.feed_mode == FeedMode::InverseTime) {
        return fail(context, Message::CycleInverseTime, command.corner_span, {name});
    }
    if (!stays_in_plane(state, state.position, end)) {
        if (!command.corner_is_modal)
            context.log.add(Severity::Error, Message::CornerForm, command.corner_span,
                            {name, "a line in the plane (G17, G18, G19)"});
        return arc ? make_arc(control, *arc, mask, context)
                   : feed_straight(control, end, MoveKind::Feed, mask, context);
    }
    HeldCorner held = held_line(state, command, end, mask, context);
    if (arc) held.arc = *arc;
    control.corner = held;
    record_move(state, mask, false);
    state.position = end;
    return true;
}

bool cut_corner(ControlState& control, const Axes& next, const ProgramArc* arc, Context& context) {
    MachineState& state = control.machine;
    const PlaneAxes axes = axes_of(state.plane);
    const HeldCorner held = *control.corner;
    if (arc || held.arc) return round_at_arc(control, next, arc, context);
    const auto leave_corner = [&] {
        return make_held_line(control, held.end, nullptr, nullptr, context);
    };
    const auto refuse = [&](std::string_view what) {
        fail(context, Message::CornerForm, held.word, {corner_name(held.letter, context), what});
        return leave_corner();
    };
    if (held.size == 0.0) return leave_corner();
    const bool is_flat = stays_in_plane(state, held.end, next);
    if (!is_flat && held.is_modal) return leave_corner();
    if (!is_flat) return refuse("a line in the plane after it");
    const Axes& from = held.state.position;
    const double x1 = held.end[axes.first] - from[axes.first];
    const double y1 = held.end[axes.second] - from[axes.second];
    const double x2 = next[axes.first] - held.end[axes.first];
    const double y2 = next[axes.second] - held.end[axes.second];
    const double length_1 = hypotenuse(x1, y1);
    const double length_2 = hypotenuse(x2, y2);
    if (std::min(length_1, length_2) <= kCornerRounding)
        return refuse("two lines that have a length");
    const double dot = (x1 * x2 + y1 * y2) / (length_1 * length_2);
    const double cross = (x1 * y2 - y1 * x2) / (length_1 * length_2);
    if (std::abs(cross) <= kCornerRounding) {
        if (dot < 0.0) return refuse("a next line that does not turn back");
        return leave_corner();  // Collinear lines have no corner.
    }
    // Length that the corner removes from each line.
    const double cut = held.letter == 'R'   ? held.size * std::abs(cross) / (1.0 + dot)
                       : held.letter == 'L' ? held.size / std::sqrt(2.0 * (1.0 + dot))
                                            : held.size;
    if (cut > std::min(length_1, length_2) + kCornerRounding) {
        return refuse("lines that are long enough for it");
    }
    Axes first = held.end;
    first[axes.first] -= cut * (x1 / length_1);
    first[axes.second] -= cut * (y1 / length_1);
    if (length_1 - cut <= kCornerRounding) first = from;  // The corner consumes the whole line.
    Axes second = held.end;
    second[axes.first] += cut * (x2 / length_2);
    second[axes.second] += cut * (y2 / length_2);
    if (length_2 - cut <= kCornerRounding) second = next;
    if (held.letter != 'R') return make_held_line(control, first, &second, nullptr, context);
    // A left turn has the arc's centre on the left.
    const double side = cross > 0.0 ? held.size : -held.size;
    const ProgramArc round{second, first[axes.first] - side * (y1 / length_1),
                           first[axes.second] + side * (x1 / length_1), cross > 0.0 ? 1 : -1};
    return make_held_line(control, first, nullptr, &round, context);
}

bool end_by_angle(const MachineState& state, const Command& command, Axes& end, AxisMask& mask,
                  Context& context) {
    const auto refuse = [&](std::string_view what) {
        return fail(context, Message::AngleForm, command.angle_span, {what});
    };
    const PlaneAxes axes = axes_of(state.plane);
    const Axes from = state.frames.programmed.remove(state.position);
    Axes to = state.frames.programmed.remove(end);
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (i != axes.first && i != axes.second && (mask & 1U << i) != 0)
            return refuse("a line in the plane (G17, G18, G19)");
    }
    const SinCos d = sin_cos(command.angle);
    const double x = to[axes.first] - from[axes.first];
    const double y = to[axes.second] - from[axes.second];
    const bool tells_first = (mask & 1U << axes.first) != 0;
    const bool tells_second = (mask & 1U << axes.second) != 0;
    if (tells_first && tells_second) {
        // Tolerance for the rounding of both ends, in program units.
        constexpr double kThousandth = 0.002;
        if (std::abs(x * d.sin - y * d.cos) > kThousandth)
            return refuse("an end that lies in its direction");
        return true;
    }
    if (!tells_first && !tells_second) return refuse("one coordinate of its end");
    const double along = tells_first ? d.cos : d.sin;
    if (std::abs(along) <= kCornerRounding) return refuse("a direction that reaches its end");
    if (tells_first) {
        to[axes.second] = from[axes.second] + x * (d.sin / d.cos);
        if (state.is_known(axes.second)) mask |= 1U << axes.second;
    } else {
        to[axes.first] = from[axes.first] + y * (d.cos / d.sin);
        if (state.is_known(axes.first)) mask |= 1U << axes.first;
    }
    end = state.frames.programmed.apply(to);
    return true;
}

bool hold_angle(ControlState& control, const Command& command, const Axes& end, AxisMask mask,
                Context& context) {
    MachineState& state = control.machine;
    if (mask != 0)
        return fail(context, Message::AngleForm, command.angle_span,
                    {"a line in the plane (G17, G18, G19)"});
    if (state.feed_mode == FeedMode::InverseTime)
        return fail(context, Message::CycleInverseTime, command.angle_span, {",A"});
    const PlaneAxes axes = axes_of(state.plane);
    AxisMask plane = 0;
    for (const std::size_t axis : {axes.first, axes.second}) {
        if (state.is_known(axis)) plane |= 1U << axis;
    }
    const bool has_corner = command.corner != 0 && command.corner_size != 0.0;
    if (has_corner && command.corner_size < 0.0) {
        return fail(context, Message::NegativeValue, command.corner_span,
                    {corner_name(command.corner, context)});
    }
    HeldCorner held = held_line(state, command, end, plane, context);
    held.angle = command.angle;
    if (!has_corner) {
        held.letter = 'A';
        held.size = 0.0;
        held.is_modal = false;
        held.word = command.angle_span;
    }
    control.corner = held;
    return true;
}

bool find_corner(ControlState& control, const Command& command, const Axes& next,
                 Context& context) {
    MachineState& state = control.machine;
    HeldCorner& held = *control.corner;
    const auto refuse = [&](std::string_view what) {
        const SourceSpan span = held.word;
        control.corner.reset();
        return fail(context, Message::AngleForm, span, {what});
    };
    const PlaneAxes axes = axes_of(state.plane);
    if (!command.has_angle || !command.has(kAxisNames[axes.first]) ||
        !command.has(kAxisNames[axes.second]) || state.incremental) {
        return refuse("one coordinate of its end, or a next line with both and its own ,A (G90)");
    }
    if (!stays_in_plane(state, state.position, next)) return refuse("a next line in the plane");
    const Axes from = state.frames.programmed.remove(state.position);
    const Axes to = state.frames.programmed.remove(next);
    const SinCos a = sin_cos(*held.angle);
    const SinCos b = sin_cos(command.angle);
    const double cross = a.cos * b.sin - a.sin * b.cos;
    if (std::abs(cross) <= kCornerRounding) return refuse("a next line that it meets");
    const double x = to[axes.first] - from[axes.first];
    const double y = to[axes.second] - from[axes.second];
    const double length = (x * b.sin - y * b.cos) / cross;
    Axes corner = from;
    corner[axes.first] += length * a.cos;
    corner[axes.second] += length * a.sin;
    held.end = state.frames.programmed.apply(corner);
    held.angle.reset();
    record_move(state, held.mask, false);
    state.position = held.end;
    return true;
}

void settle_corner(ControlState& control, Context& context) {
    if (control.corner->angle) {
        const SourceSpan span = control.corner->word;
        control.corner.reset();
        fail(context, Message::AngleForm, span,
             {"one coordinate of its end, or a next line that it meets"});
        return;
    }
    if (!control.corner->is_modal)
        context.log.add(Severity::Error, Message::CornerForm, control.corner->word,
                        {corner_name(control.corner->letter, context),
                         context.rules.rounds_arcs ? "a line or an arc in the next block"
                                                   : "a line (G1) in the next block"});
    make_held_line(control, Axes(control.corner->end), nullptr, nullptr, context);
}

}  // namespace ncsim::gcode
