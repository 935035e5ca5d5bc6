// SPDX-License-Identifier: GPL-3.0-or-later
//
// APPR and DEP: the tool approaches the first element of a contour, or departs from the last
// element, on a line or an arc. All points are computed on the path of the tool centre.
// Source: HEIDENHAIN TNC 640, User's Manual for Klartext Programming, 34059x, "Approaching and
// departing a contour"; TNC7, 81762x-16 (direction of the arc).
#include "ncsim/base/angles.h"
#include "ncsim/base/ascii.h"

#include "klartext/control.h"
#include "text/message.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode::klartext {
namespace {

/// True for "APPR PLT", "DEP PLCT" and their likes; any blanks separate the words.
bool is_polar_form(std::string_view name) {
    const std::size_t last = name.find_last_of(" \t") + 1;
    return last < name.size() && upper(name[last]) == 'P';
}

using Point = Vec2;

/// Shape of an approach or a departure.
enum class Form : std::uint8_t { Tangent, Normal, Arc, LineAndArc };

Form form_of(const Block& block) {
    const std::string name = upper_of(block.name);
    if (name.ends_with("LCT")) return Form::LineAndArc;
    if (name.ends_with("CT")) return Form::Arc;
    return name.ends_with("LN") ? Form::Normal : Form::Tangent;
}

Point turned_about(Point centre, Point point, double degrees) {
    double x = point[0] - centre[0];
    double y = point[1] - centre[1];
    rotate(x, y, degrees);
    return {centre[0] + x, centre[1] + y};
}

std::optional<Point> unit(double x, double y) {
    const double length = hypotenuse(x, y);
    if (!(length > 0.0)) return std::nullopt;
    return Point{x / length, y / length};
}

/// 1 if `point` is on the left of the line through `base` along `direction`, -1 on the right.
double side_of(Point base, Point direction, Point point, double otherwise) {
    const double side = cross(direction, point - base);
    return side > 0.0 ? 1.0 : side < 0.0 ? -1.0 : otherwise;
}

}  // namespace

Control::Point Control::in_plane() const {
    const PlaneAxes axes = axes_of(plane_);
    return {at_[axes.first], at_[axes.second]};
}

/// Returns the direction in which the block `next` leaves `at`; nullopt after reporting an error.
std::optional<Point> Control::start_direction(const Block& next, const Block* centre,
                                              const Axes& at) {
    const auto refuse = [&](std::string_view what) -> std::optional<Point> {
        fail(Message::KlartextVerb, next.whole(), {what});
        return std::nullopt;
    };
    Words words;
    if (!gather(next, words, true)) return std::nullopt;
    const PlaneAxes axes = axes_of(plane_);
    // The position and the pole are those of the block; both are restored.
    const Axes at_before = at_;
    const auto pole_before = centre_;
    const auto pr_before = pr_;
    const auto pa_before = pa_;
    at_ = at;
    pr_.reset(), pa_.reset();
    const bool has_pole = !centre || this->centre(*centre);
    AxisMask mask = 0;
    Axes end = ends(words, mask);
    const bool is_polar = next.verb == Verb::StraightPolar;
    const bool has_end = has_pole && (!is_polar || polar_end(next, words, end));
    const std::optional<Point> pole = centre_;
    at_ = at_before, centre_ = pole_before, pr_ = pr_before, pa_ = pa_before;
    if (!has_end) return std::nullopt;
    const double x = end[axes.first] - at[axes.first];
    const double y = end[axes.second] - at[axes.second];
    const int direction = words.direction != 0 ? words.direction : last_direction_;
    if (next.verb == Verb::Straight || is_polar) {
        const std::optional<Point> found = unit(x, y);
        return found ? found : refuse("APPR before a block without a move in the plane");
    }
    if (direction == 0 || next.verb == Verb::ArcTangent || next.verb == Verb::ArcTangentPolar)
        return refuse("APPR before an arc without a direction");
    const double turn = direction > 0 ? 1.0 : -1.0;
    std::optional<Point> to_centre;
    if (next.verb != Verb::ArcByRadius) {
        if (pole) to_centre = unit((*pole)[0] - at[axes.first], (*pole)[1] - at[axes.second]);
    } else if (words.radius) {
        const double half = hypotenuse(x, y) / 2.0;
        const double height = std::sqrt(std::max(0.0, *words.radius * *words.radius - half * half));
        const double side = ((turn > 0.0) == (*words.radius >= 0.0) ? height : -height);
        if (half > 0.0)
            to_centre = unit(x / 2.0 - y * side / (2.0 * half), y / 2.0 + x * side / (2.0 * half));
    }
    if (!to_centre) return refuse("APPR before an arc without a centre");
    return Point{turn * (*to_centre)[1], -turn * (*to_centre)[0]};
}

/// Returns the point where a line from `from` becomes tangent to the circle about `centre`, which
/// the tool follows in the direction `turn` (1: counter-clockwise); nullopt inside the circle.
std::optional<Point> Control::tangent_point(Point from, Point centre, double radius,
                                            double turn) const {
    const double x = from[0] - centre[0];
    const double y = from[1] - centre[1];
    const double distance = hypotenuse(x, y);
    if (!(distance > radius)) return std::nullopt;
    const double angle = angle_of(radius, std::sqrt(distance * distance - radius * radius));
    const Point nearest = centre + radius * Point{x / distance, y / distance};
    return turned_about(centre, nearest, turn * angle);
}

bool Control::go_to(Point to, bool is_rapid, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    if (in_plane() == to && !is_unknown(1U << axes.first | 1U << axes.second)) return true;
    Command command = make(span);
    put(command, is_rapid ? Code::G0 : Code::G1);
    Axes end = at_;
    end[axes.first] = to[0];
    end[axes.second] = to[1];
    put(command, kAxisNames[axes.first], to[0]);
    put(command, kAxisNames[axes.second], to[1]);
    command.axis_words = true;
    if (!run(command)) return false;
    arrive(end);
    return true;
}

bool Control::turn_to(Point to, Point centre, double turn, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    ProgramArc arc;
    arc.end = at_;
    arc.end[axes.first] = to[0];
    arc.end[axes.second] = to[1];
    arc.centre_1 = centre[0];
    arc.centre_2 = centre[1];
    arc.turns = turn > 0.0 ? 1 : -1;
    return BlockControl::make_arc(arc, 0, std::nullopt, make(span));
}

/// Moves the tool axis to its word in the block.
bool Control::move_height(const Words& words, SourceSpan span) {
    const std::size_t axis = axes_of(plane_).third;
    if (!words.axis[axis]) return true;
    AxisMask mask = 0;
    const Axes end = ends(words, mask);
    Command command = make(span);
    put(command, words.is_rapid ? Code::G0 : Code::G1);
    put(command, kAxisNames[axis], end[axis]);
    command.axis_words = true;
    if (!run(command)) return false;
    at_[axis] = end[axis];
    return true;
}

bool Control::approach(const Block& block, const Block& next, const Block* centre) {
    const SourceSpan span = block.whole();
    if (records_contour_)
        return fail(Message::KlartextVerb, span, {std::string(block.name) + " in a contour"});
    const auto needs = [&](std::string_view what) {
        return fail(Message::BlockNeeds, span, {block.name, what});
    };
    Words words;
    if (!gather(block, words)) return false;
    if (side_ != CutterSide::Off) return fail(Message::KlartextVerb, span, {"APPR under RL or RR"});
    const PlaneAxes axes = axes_of(plane_);
    const Form form = form_of(block);
    AxisMask mask = 0;
    Axes contour = ends(words, mask);
    if (is_polar_form(block.name)) {
        if (!polar_end(block, words, contour)) return false;
    } else if ((mask & (1U << axes.first | 1U << axes.second)) == 0) {
        return needs("the first point of the contour");
    }
    const std::optional<Point> direction = start_direction(next, centre, contour);
    if (!direction) return false;
    const CutterSide side = words.side.value_or(CutterSide::Off);
    const double sign = side == CutterSide::Left ? 1.0 : side == CutterSide::Right ? -1.0 : 0.0;
    const double radius = sign == 0.0 ? 0.0 : radius_of_tool().value_or(0.0);
    const Point left = left_normal(*direction);
    const Point first = Point{contour[axes.first], contour[axes.second]} + sign * radius * left;
    const bool by_arc = form == Form::Arc || form == Form::LineAndArc;
    const bool has_size = by_arc ? words.radius && *words.radius != 0.0 : words.length.has_value();
    if (!has_size) return needs(by_arc ? "a radius (R)" : "a length (LEN)");
    if (sign == 0.0 && (form == Form::Normal || form == Form::Arc)) return needs("RL or RR");

    Point auxiliary = first;
    Point middle{};
    double turn = 0.0;
    if (form == Form::Tangent) {
        auxiliary = first + -*words.length * *direction;
    } else if (form == Form::Normal) {
        auxiliary = first + sign * *words.length * left;
    } else if (form == Form::Arc) {
        if (!words.opening || !(*words.opening > 0.0 && *words.opening <= 360.0))
            return needs("a centre angle (CCA) up to 360");
        turn = *words.radius > 0.0 ? sign : -sign;
        middle = first + turn * std::abs(*words.radius) * left;
        auxiliary = turned_about(middle, first, -turn * *words.opening);
    } else {
        turn = side_of(first, *direction, in_plane(), sign == 0.0 ? 1.0 : sign);
        const double size = std::abs(*words.radius);
        middle = first + turn * size * left;
        const std::optional<Point> found = tangent_point(in_plane(), middle, size, turn);
        if (!found) return needs("a start outside the arc");
        auxiliary = *found;
    }

    // The last feed, or rapid, acts up to the auxiliary point; then the feed of the block.
    Words others = words;
    others.side.reset();
    others.feed.reset();
    Command command = make(span);
    if (!act_before(block, others, command) || !run(command)) return false;
    const bool uses_own_feed = form == Form::LineAndArc;
    if (!uses_own_feed && !go_to(auxiliary, was_rapid_, span)) return false;
    others.feed = words.feed;
    others.speed.reset();
    others.m.clear();
    command = make(span);
    if (!act_before(block, others, command) || !run(command)) return false;
    if (uses_own_feed && !go_to(auxiliary, words.is_rapid, span)) return false;
    if (!move_height(words, span)) return false;
    const bool done =
        turn == 0.0 ? go_to(first, words.is_rapid, span) : turn_to(first, middle, turn, span);
    if (!done) return false;
    was_rapid_ = words.is_rapid;
    if (sign != 0.0) {
        side_ = side;
        const Transformation& t = transformation_;
        const bool is_mirrored = t.is_mirrored[axes.first] != t.is_mirrored[axes.second];
        if (!radius_of_tool()) {
            command = make(span);
            put(command, (sign > 0.0) != is_mirrored ? Code::G41 : Code::G42);
            put(command, 'D', tool_);  // Reports the unknown radius.
            if (!run(command)) return false;
        } else {
            machine_.begin_compensation_at(
                (sign > 0.0) != is_mirrored ? CutterSide::Left : CutterSide::Right, radius,
                contour);
        }
        at_[axes.first] = contour[axes.first];
        at_[axes.second] = contour[axes.second];
    }
    tangent_ = direction;
    return act_after(block, words);
}

bool Control::depart(const Block& block) {
    if (records_contour_)
        return fail(Message::KlartextVerb, block.whole(),
                    {std::string(block.name) + " in a contour"});
    const SourceSpan span = block.whole();
    const auto needs = [&](std::string_view what) {
        return fail(Message::BlockNeeds, span, {block.name, what});
    };
    Words words;
    if (!gather(block, words)) return false;
    const Form form = form_of(block);
    if (!tangent_) return needs("a move in the plane before");
    const std::optional<Point> direction = unit((*tangent_)[0], (*tangent_)[1]);
    if (!direction) return needs("a move in the plane before");
    const double sign = side_ == CutterSide::Left ? 1.0 : side_ == CutterSide::Right ? -1.0 : 0.0;
    const bool by_arc = form == Form::Arc || form == Form::LineAndArc;
    const bool has_size = by_arc ? words.radius && *words.radius != 0.0 : words.length.has_value();
    if (!has_size) return needs(by_arc ? "a radius (R)" : "a length (LEN)");
    if (sign == 0.0 && (form == Form::Normal || form == Form::Arc))
        return needs("cutter compensation (RL, RR)");
    // The compensation ends where the tool is square to the end of the last element.
    if (!end_compensation(span)) return false;
    refresh();
    MachineState& state = machine_.state();
    state.uncancelled = {};
    state.just_left_compensation = false;
    words.side.reset();
    Command command = make(span);
    if (!act_before(block, words, command) || !run(command)) return false;

    const PlaneAxes axes = axes_of(plane_);
    const Point last = in_plane();
    const Point left = left_normal(*direction);
    bool done = false;
    if (form == Form::Tangent) {
        done = go_to(last + *words.length * *direction, words.is_rapid, span);
    } else if (form == Form::Normal) {
        done = go_to(last + sign * *words.length * left, words.is_rapid, span);
    } else if (form == Form::Arc) {
        if (!words.opening || !(*words.opening > 0.0 && *words.opening <= 360.0))
            return needs("a centre angle (CCA) up to 360");
        const double turn = *words.radius > 0.0 ? sign : -sign;
        const Point middle = last + turn * std::abs(*words.radius) * left;
        done = turn_to(turned_about(middle, last, turn * *words.opening), middle, turn, span);
    } else {
        AxisMask mask = 0;
        Axes end = ends(words, mask);
        if (is_polar_form(block.name)) {
            if (!polar_end(block, words, end)) return false;
        } else if ((mask & (1U << axes.first | 1U << axes.second)) == 0) {
            return needs("the end point");
        }
        const Point target{end[axes.first], end[axes.second]};
        const double turn = side_of(last, *direction, target, sign == 0.0 ? 1.0 : sign);
        const double size = std::abs(*words.radius);
        const Point middle = last + turn * size * left;
        // Backwards from the end, the arc turns the other way.
        const std::optional<Point> found = tangent_point(target, middle, size, -turn);
        if (!found) return needs("an end outside the arc");
        done = turn_to(*found, middle, turn, span) && go_to(target, words.is_rapid, span);
    }
    if (!done || !move_height(words, span)) return false;
    was_rapid_ = words.is_rapid;
    return act_after(block, words);
}

}  // namespace ncsim::gcode::klartext
