// SPDX-License-Identifier: GPL-3.0-or-later
//
// ,R and ,C of Fanuc and similar controls: an arc or a chamfer between a line and the next line.
// RND, CHF and CHR of other languages: the same; RND also next to arcs.
// ,A: the direction of a line for which one coordinate of the end is given, or which ends at the
// next line. Each such line is held back because the end depends on the next line.
#include "ncsim/base/angles.h"

#include "control/cycles/fillet.h"
#include "control/machine.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ncsim::gcode {
namespace {

/// Rounding tolerance of lengths, in program units.
constexpr double kCornerRounding = 1e-9;

}  // namespace

/// True for G1 with axis words that no other code of the block uses.
bool Machine::is_line(const Command& command) const {
    const Code named = command.group(Group::Motion);
    if ((named == Code::None ? state_.motion : named) != Code::G1 || !command.axis_words)
        return false;
    for (const Group group : {Group::OneShot, Group::Rotation, Group::Scaling, Group::Mirror,
                              Group::Macro, Group::Pocket, Group::HolePattern}) {
        if (command.group(group) != Code::None) return false;
    }
    return command.group(Group::ToolLength) != Code::G43_1;
}

/// True for a line, and for an arc on controls that round corners at arcs.
bool Machine::is_element(const Command& command) const {
    if (is_line(command)) return true;
    const Code named = command.group(Group::Motion);
    const Code motion = named == Code::None ? state_.motion : named;
    return rules_.rounds_arcs && (motion == Code::G2 || motion == Code::G3) &&
           command.group(Group::OneShot) == Code::None;
}

bool Machine::ends_in_corner(const Command& command) const {
    return is_element(command) && command.group(MGroup::Stop) == kNone;
}

/// True for a line in the coordinate frame of the line before.
bool Machine::continues_from_corner(const Command& command) const {
    for (const Group group :
         {Group::Plane, Group::Units, Group::CutterSide, Group::ToolLength, Group::WorkOffset,
          Group::Polar, Group::TiltedPlane, Group::Orient, Group::PolarInterpolation,
          Group::Cylinder, Group::DynamicOffset, Group::Rotation, Group::Feed, Group::Diameter,
          Group::NotSimulated, Group::Unsupported}) {
        if (command.group(group) != Code::None) return false;
    }
    // On these controls, blocks without a move may be between the two elements of a corner.
    const bool is_neutral =
        rules_.rounds_arcs && !command.axis_words && command.group(Group::OneShot) == Code::None;
    const bool continues =
        is_neutral || (control_.corner->angle ? is_line(command) : is_element(command));
    return continues && command.group(MGroup::Stop) == kNone &&
           command.group(MGroup::ToolChange) == kNone && command.group(MGroup::Kinematics) == kNone;
}

bool Machine::stays_in_plane(const Axes& from, const Axes& to) const {
    const PlaneAxes axes = axes_of(state_.plane);
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (i != axes.first && i != axes.second && std::abs(from[i] - to[i]) > kCornerRounding)
            return false;
    }
    return true;
}

/// Holds back the line to `end`, or the arc `arc`.
bool Machine::hold_corner(const Command& command, const Axes& end, AxisMask mask,
                          const ProgramArc* arc) {
    const std::string_view name = corner_name(command.corner);
    if (command.corner_size < 0.0) return fail(Message::NegativeValue, command.corner_span, {name});
    if (state_.feed_mode == FeedMode::InverseTime) {
        return fail(Message::CycleInverseTime, command.corner_span, {name});
    }
    if (!stays_in_plane(state_.position, end)) {
        if (!command.corner_is_modal)
            log_.add(Severity::Error, Message::CornerForm, command.corner_span,
                     {name, "a line in the plane (G17, G18, G19)"});
        return arc ? make_arc(*arc, mask) : feed_straight(end, MoveKind::Feed, mask);
    }
    double size = command.corner_size;
    if (state_.frames.programmed.scaled) {
        size *= std::abs(state_.frames.programmed.scale[axes_of(state_.plane).first % 3]);
    }
    HeldCorner held;
    held.state = state_;
    held.end = end;
    held.mask = mask;
    held.letter = command.corner;
    held.size = size;
    held.is_modal = command.corner_is_modal;
    held.feed = command.corner_feed;
    held.span = span_;
    held.word = command.corner_span;
    held.file = file_;
    if (arc) held.arc = *arc;
    control_.corner = held;
    record_move(state_, mask, false);
    state_.position = end;
    return true;
}

/// Makes the held line up to the corner, and the corner itself. `next`: end of the next element,
/// which is a line or the arc `arc`.
bool Machine::cut_corner(const Axes& next, const ProgramArc* arc) {
    const PlaneAxes axes = axes_of(state_.plane);
    const HeldCorner held = *control_.corner;
    if (arc || held.arc) return round_at_arc(next, arc);
    const auto refuse = [&](std::string_view what) {
        log_.add(Severity::Error, Message::CornerForm, held.word, {corner_name(held.letter), what});
        return make_held_line(held.end, nullptr, nullptr);
    };
    if (held.size == 0.0) return make_held_line(held.end, nullptr, nullptr);
    const bool is_flat = stays_in_plane(held.end, next);
    if (!is_flat && held.is_modal) return make_held_line(held.end, nullptr, nullptr);
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
        return make_held_line(held.end, nullptr, nullptr);  // Collinear lines have no corner.
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
    if (held.letter != 'R') return make_held_line(first, &second, nullptr);
    // A left turn has the arc's centre on the left.
    const double side = cross > 0.0 ? held.size : -held.size;
    const ProgramArc round{second, first[axes.first] - side * (y1 / length_1),
                           first[axes.second] + side * (x1 / length_1), cross > 0.0 ? 1 : -1};
    return make_held_line(first, nullptr, &round);
}

/// Rounds the corner between the held line or arc and the next line or arc.
bool Machine::round_at_arc(const Axes& next, const ProgramArc* arc) {
    const PlaneAxes axes = axes_of(state_.plane);
    const HeldCorner held = *control_.corner;
    const auto refuse = [&](std::string_view what) {
        log_.add(Severity::Error, Message::CornerForm, held.word, {corner_name(held.letter), what});
        return make_held_line(held.end, nullptr, nullptr);
    };
    if (held.size == 0.0) return make_held_line(held.end, nullptr, nullptr);
    if (held.letter != 'R') return refuse("two lines");
    const bool is_flat = stays_in_plane(held.end, next);
    if (!is_flat && held.is_modal) return make_held_line(held.end, nullptr, nullptr);
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
        return make_held_line(held.end, nullptr, nullptr);
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
    return make_held_line(begin, nullptr, &round);
}

/// Makes an arc with the present state: of an outline, under cutter compensation, or plain.
bool Machine::make_arc(const ProgramArc& arc, AxisMask mask) {
    if (outline_) return record_outline_move(arc.end, &arc);
    if (compensation_.is_on()) return compensation_.arc(state_, arc, mask, span_, file_);
    path_.arc(state_, arc, mask);
    state_.just_left_compensation = false;
    return true;
}

/// Makes the held line or arc to `end`, then the chamfer to `second` or the arc, with the state and
/// the origin of the held block. Sets `state_.position` to the end.
bool Machine::make_held_line(const Axes& end, const Axes* second, const ProgramArc* arc) {
    const HeldCorner held = *control_.corner;
    control_.corner.reset();
    const SourceSpan span = span_;
    const std::uint32_t file = file_;
    MachineState now = state_;
    state_ = held.state;
    set_origin(held.span, held.file);
    bool made = true;
    if (held.arc) {
        ProgramArc own = *held.arc;
        own.is_open = own.is_open || end != held.end;
        own.end = end;
        made = (own.is_open && end == state_.position) || make_arc(own, held.mask);
    } else {
        made = end == state_.position || feed_straight(end, MoveKind::Feed, held.mask);
    }
    if (held.feed) state_.feed = *held.feed;
    if (made && second) made = feed_straight(*second, MoveKind::Feed, held.mask);
    if (made && arc) made = make_arc(*arc, held.mask);
    set_origin(span, file);
    now.position = state_.position;
    now.just_left_compensation = state_.just_left_compensation;
    state_ = now;
    return made;
}

/// Completes the end of a line with a direction: "X50. ,A30.". If both coordinates are given, both
/// must agree with the direction within the rounding of three decimals.
bool Machine::end_by_angle(const Command& command, Axes& end, AxisMask& mask) {
    const auto refuse = [&](std::string_view what) {
        return fail(Message::AngleForm, command.angle_span, {what});
    };
    const PlaneAxes axes = axes_of(state_.plane);
    const Axes from = to_programmed(state_.position);
    Axes to = to_programmed(end);
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
        if (is_known(axes.second)) mask |= 1U << axes.second;
    } else {
        to[axes.first] = from[axes.first] + y * (d.cos / d.sin);
        if (is_known(axes.first)) mask |= 1U << axes.first;
    }
    end = from_programmed(to);
    return true;
}

/// Holds back a line without coordinates, "G1 ,A30.", which ends at the next line.
bool Machine::hold_angle(const Command& command, const Axes& end, AxisMask mask) {
    if (mask != 0)
        return fail(Message::AngleForm, command.angle_span,
                    {"a line in the plane (G17, G18, G19)"});
    if (state_.feed_mode == FeedMode::InverseTime)
        return fail(Message::CycleInverseTime, command.angle_span, {",A"});
    const PlaneAxes axes = axes_of(state_.plane);
    AxisMask plane = 0;
    for (const std::size_t axis : {axes.first, axes.second}) {
        if (is_known(axis)) plane |= 1U << axis;
    }
    const bool has_corner = command.corner != 0 && command.corner_size != 0.0;
    if (has_corner && command.corner_size < 0.0) {
        return fail(Message::NegativeValue, command.corner_span, {corner_name(command.corner)});
    }
    double size = has_corner ? command.corner_size : 0.0;
    if (state_.frames.programmed.scaled)
        size *= std::abs(state_.frames.programmed.scale[axes.first % 3]);
    const char letter = has_corner ? command.corner : 'A';
    HeldCorner held;
    held.state = state_;
    held.end = end;
    held.mask = plane;
    held.letter = letter;
    held.size = size;
    held.angle = command.angle;
    held.is_modal = has_corner && command.corner_is_modal;
    held.feed = command.corner_feed;
    held.span = span_;
    held.word = has_corner ? command.corner_span : command.angle_span;
    held.file = file_;
    control_.corner = held;
    return true;
}

/// Computes where the held line meets the next line, whose end `next` and direction are given.
bool Machine::find_corner(const Command& command, const Axes& next) {
    HeldCorner& held = *control_.corner;
    const auto refuse = [&](std::string_view what) {
        const SourceSpan span = held.word;
        control_.corner.reset();
        return fail(Message::AngleForm, span, {what});
    };
    const PlaneAxes axes = axes_of(state_.plane);
    if (!command.has_angle || !command.has("XYZABCUVW"[axes.first]) ||
        !command.has("XYZABCUVW"[axes.second]) || state_.incremental) {
        return refuse("one coordinate of its end, or a next line with both and its own ,A (G90)");
    }
    if (!stays_in_plane(state_.position, next)) return refuse("a next line in the plane");
    const Axes from = to_programmed(state_.position);
    const Axes to = to_programmed(next);
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
    held.end = from_programmed(corner);
    held.angle.reset();
    record_move(state_, held.mask, false);
    state_.position = held.end;
    return true;
}

/// Reports that the next block is no line. Makes the held line to the programmed corner; a line
/// with unknown end is discarded.
void Machine::settle_corner() {
    if (control_.corner->angle) {
        const SourceSpan span = control_.corner->word;
        control_.corner.reset();
        fail(Message::AngleForm, span, {"one coordinate of its end, or a next line that it meets"});
        return;
    }
    if (!control_.corner->is_modal)
        log_.add(Severity::Error, Message::CornerForm, control_.corner->word,
                 {corner_name(control_.corner->letter), rules_.rounds_arcs
                                                            ? "a line or an arc in the next block"
                                                            : "a line (G1) in the next block"});
    make_held_line(Axes(control_.corner->end), nullptr, nullptr);
}

}  // namespace ncsim::gcode
