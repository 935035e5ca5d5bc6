// SPDX-License-Identifier: GPL-3.0-or-later
//
// ,R and ,C of Fanuc and similar controls: an arc or a chamfer between a line and the next line.
// ,A: the direction of a line for which one coordinate of the end is given, or which ends at the
// next line. Each such line is held back because the end depends on the next line.
#include "ncsim/trig/angles.h"

#include "control/machine.h"

#include <algorithm>
#include <cmath>

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

bool Machine::ends_in_corner(const Command& command) const {
    return is_line(command) && command.group(MGroup::Stop) == kNone;
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
    return is_line(command) && command.group(MGroup::Stop) == kNone &&
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

bool Machine::hold_corner(const Command& command, const Axes& end, AxisMask mask) {
    const std::string_view name = corner_name(command.corner);
    if (command.corner_size < 0.0) return fail(Message::NegativeValue, command.corner_span, {name});
    if (state_.feed_mode == FeedMode::InverseTime) {
        return fail(Message::CycleInverseTime, command.corner_span, {name});
    }
    if (!stays_in_plane(state_.position, end)) {
        log_.add(Severity::Error, Message::CornerForm, command.corner_span,
                 {name, "a line in the plane (G17, G18, G19)"});
        return feed_straight(end, MoveKind::Feed, mask);
    }
    double size = command.corner_size;
    if (state_.programmed.scaled) {
        size *= std::abs(state_.programmed.scale[axes_of(state_.plane).first % 3]);
    }
    control_.corner =
        HeldCorner{state_, end, mask, command.corner, size, {}, span_, command.corner_span, file_};
    record_move(state_, mask, false);
    state_.position = end;
    return true;
}

/// Makes the held line up to the corner, and the corner itself. `next`: end of the next line.
bool Machine::cut_corner(const Axes& next) {
    const PlaneAxes axes = axes_of(state_.plane);
    const HeldCorner held = *control_.corner;
    const auto refuse = [&](std::string_view what) {
        log_.add(Severity::Error, Message::CornerForm, held.word, {corner_name(held.letter), what});
        return make_held_line(held.end, nullptr, nullptr);
    };
    if (held.size == 0.0) return make_held_line(held.end, nullptr, nullptr);
    if (!stays_in_plane(held.end, next)) return refuse("a line in the plane after it");
    const Axes& from = held.state.position;
    const double x1 = held.end[axes.first] - from[axes.first];
    const double y1 = held.end[axes.second] - from[axes.second];
    const double x2 = next[axes.first] - held.end[axes.first];
    const double y2 = next[axes.second] - held.end[axes.second];
    const double length_1 = trig::length_of(x1, y1);
    const double length_2 = trig::length_of(x2, y2);
    if (std::min(length_1, length_2) <= kCornerRounding)
        return refuse("two lines that have a length");
    const double dot = (x1 * x2 + y1 * y2) / (length_1 * length_2);
    const double cross = (x1 * y2 - y1 * x2) / (length_1 * length_2);
    if (std::abs(cross) <= kCornerRounding) {
        if (dot < 0.0) return refuse("a next line that does not turn back");
        return make_held_line(held.end, nullptr, nullptr);  // Collinear lines have no corner.
    }
    // Length that the corner removes from each line.
    const double cut = held.letter == 'R' ? held.size * std::abs(cross) / (1.0 + dot) : held.size;
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
    if (held.letter == 'C') return make_held_line(first, &second, nullptr);
    // A left turn has the arc's centre on the left.
    const double side = cross > 0.0 ? held.size : -held.size;
    const ProgramArc arc{second, first[axes.first] - side * (y1 / length_1),
                         first[axes.second] + side * (x1 / length_1), cross > 0.0 ? 1 : -1};
    return make_held_line(first, nullptr, &arc);
}

/// Makes the held line to `end`, then the chamfer to `second` or the arc, with the state and the
/// origin of the held block. Sets `state_.position` to the end.
bool Machine::make_held_line(const Axes& end, const Axes* second, const ProgramArc* arc) {
    const HeldCorner held = *control_.corner;
    control_.corner.reset();
    const SourceSpan span = span_;
    const std::uint32_t file = file_;
    MachineState now = state_;
    state_ = held.state;
    set_origin(held.span, held.file);
    bool made = end == state_.position || feed_straight(end, MoveKind::Feed, held.mask);
    if (made && second) made = feed_straight(*second, MoveKind::Feed, held.mask);
    if (made && arc) {
        if (outline_) {
            made = record_outline_move(arc->end, arc);
        } else if (compensation_.is_on()) {
            made = compensation_.arc(state_, *arc, held.mask, span_, file_);
        } else {
            path_.arc(state_, *arc, held.mask);
            state_.just_left_compensation = false;
        }
    }
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
    const trig::SinCos d = trig::sin_cos(command.angle);
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
    if (state_.programmed.scaled) size *= std::abs(state_.programmed.scale[axes.first % 3]);
    const char letter = has_corner ? command.corner : 'A';
    control_.corner = HeldCorner{
        state_, end,           plane, letter,
        size,   command.angle, span_, has_corner ? command.corner_span : command.angle_span,
        file_};
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
    const trig::SinCos a = trig::sin_cos(*held.angle);
    const trig::SinCos b = trig::sin_cos(command.angle);
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
    log_.add(Severity::Error, Message::CornerForm, control_.corner->word,
             {corner_name(control_.corner->letter), "a line (G1) in the next block"});
    make_held_line(Axes(control_.corner->end), nullptr, nullptr);
}

}  // namespace ncsim::gcode
