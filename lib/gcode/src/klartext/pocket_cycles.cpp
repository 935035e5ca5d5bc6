// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pocket, slot and stud cycles: 251 … 254, 256 … 258. Source: HEIDENHAIN TNC 640, User's Manual for
// Cycle Programming, 892903.
#include "ncsim/base/angles.h"

#include "klartext/control.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode::klartext {
namespace {

constexpr double kMostRepeats = 10'000.0;
/// Range of the path overlap (Q370): the distance of passes in radii of the tool.
constexpr double kLeastOverlap = 0.1;
constexpr double kMostOverlap = 1.9999;

}  // namespace

bool Control::is_area_cycle(int number) {
    return (number >= 251 && number <= 254) || (number >= 256 && number <= 258);
}

/// Reads what the cycles of areas share: levels, allowances, feeds, direction.
/// Requires: the radius of the tool is known.
bool Control::read_milling(SourceSpan span, double bottom, double clear, language::Milling& m) {
    const int number = cycle_.number;
    m.is_stud = number >= 256;
    if (!needs({202, 206, 207}, span)) return false;
    const std::string name = "cycle " + std::to_string(number);
    m.tool_radius = *radius_of_tool();
    m.surface = clear - value(200, 0.0);
    m.bottom = bottom;
    m.clear = clear;
    m.infeed = std::abs(value(202, 0.0));
    m.side_allowance = value(368, 0.0);
    m.floor_allowance = value(369, 0.0);
    if (m.side_allowance < 0.0 || m.floor_allowance < 0.0)
        return fail(Message::NegativeValue, span, {"the allowance"});
    const double overlap = value(370, 1.0);
    if (!(overlap >= kLeastOverlap && overlap <= kMostOverlap))
        return fail(Message::BlockNeeds, span, {name, "a path overlap (Q370) from 0.1 to 1.9999"});
    m.step = overlap * m.tool_radius;
    m.feed = feed_of(feed_value(207).value_or(0.0));
    m.plunge_feed = feed_of(feed_value(206).value_or(0.0));
    m.finishing_feed =
        feed_value(385) && *feed_value(385) > 0.0 ? feed_of(*feed_value(385)) : m.feed;
    m.finishing_infeed = std::abs(value(338, 0.0));
    // Without Q215 a stud keeps the allowance.
    const double operation = value(215, m.is_stud ? 1.0 : 0.0);
    if (operation != 0.0 && operation != 1.0 && operation != 2.0)
        return fail(Message::BlockNeeds, span, {name, "a machining operation (Q215) of 0, 1 or 2"});
    m.roughs = operation != 2.0;
    m.finishes_side = operation != 1.0 && m.side_allowance > 0.0;
    m.finishes_floor = operation != 1.0 && m.floor_allowance > 0.0;
    if (!m.roughs && !m.finishes_side && !m.finishes_floor)
        return fail(Message::BlockNeeds, span, {name, "an allowance (Q368, Q369) to finish"});
    const bool is_climb = value(351, 1.0) >= 0.0;
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    // Climb milling: counter-clockwise in a pocket, clockwise around a stud.
    m.is_clockwise = (is_climb != turns_left) == m.is_stud;
    const double plunging = value(366, m.is_stud ? 0.0 : 1.0);
    const bool is_slot = number == 253 || number == 254;
    if (plunging == 1.0 || plunging == 2.0) {
        m.plunge = plunging == 2.0 || is_slot ? language::Plunge::Ramp : language::Plunge::Helix;
    }
    return true;
}

/// 251 … 254, 256 … 258: mills an area at the position of the tool, where the tool is after the
/// cycle.
bool Control::mill_area(SourceSpan span, double bottom, double clear) {
    language::Milling m;
    const int number = cycle_.number;
    if (!read_milling(span, bottom, clear, m)) return false;
    if (number == 254) return mill_circular_slots(span, m);
    if (number == 258) return mill_polygon(span, m);
    const bool is_round = number == 252 || number == 257;
    const bool is_slot = number == 253;
    if (!(is_round ? needs({223}, span) : needs({218, 219}, span))) return false;
    language::MilledArea& area = m.area;
    area.length = is_round ? value(223, 0.0) : value(218, 0.0);
    area.width = is_round ? area.length : value(219, 0.0);
    const std::string name = "cycle " + std::to_string(number);
    if (!(area.length > 0.0 && area.width > 0.0))
        return fail(Message::BlockNeeds, span, {name, "a length and a width above 0"});
    if (is_slot && area.length < area.width)
        return fail(Message::BlockNeeds, span,
                    {name, "a length (Q218) of at least the width (Q219)"});
    area.corner = is_round || is_slot ? area.width / 2.0 : std::abs(value(220, 0.0));
    area.corner = std::min(area.corner, area.half_width());
    area.angle = value(is_slot ? 374 : 224, 0.0);
    const Point start = in_plane();
    area.centre = {start[0], start[1]};
    const std::optional<Vec2> middle = middle_of_area(area);
    if (!middle) return fail(Message::BlockNeeds, span, {name, "a position (Q367) from 0 to 4"});
    area.centre = language::point_in(area, (*middle)[0], (*middle)[1]);
    if (m.is_stud && !read_blank(span, m)) return false;
    return mill(m, name) && go_to(start, true, span);
}

/// Returns the centre of the area of a cycle relative to the tool, along the sides; nullopt for an
/// unknown position (Q367).
std::optional<Control::Point> Control::middle_of_area(const language::MilledArea& area) const {
    const double x = area.length / 2.0;
    const double y = area.width / 2.0;
    const double position = value(367, 0.0);
    if (position == 0.0 || cycle_.number == 252 || cycle_.number == 257) return Point{};
    if (position != std::round(position) || position < 0.0 || position > 4.0) return std::nullopt;
    const auto index = static_cast<std::size_t>(position) - 1;
    // Slot: left end, centre of the left circle, of the right circle, right end.
    if (cycle_.number == 253) return Point{std::array{x, x - y, y - x, -x}[index], 0.0};
    // Corners: lower left, lower right, upper right, upper left.
    return Point{std::array{x, -x, -x, x}[index], std::array{y, y, -y, -y}[index]};
}

/// Reads the blank of a stud. The tool goes down on the right of the blank.
bool Control::read_blank(SourceSpan span, language::Milling& m) {
    const bool is_round = cycle_.number == 257;
    if (!(is_round ? needs({222}, span) : needs({424, 425}, span))) return false;
    const double length = is_round ? value(222, 0.0) : value(424, 0.0);
    const double width = is_round ? length : value(425, 0.0);
    if (length < m.area.length || width < m.area.width)
        return fail(
            Message::BlockNeeds, span,
            {"cycle " + std::to_string(cycle_.number), "a blank of at least the size of the stud"});
    if (!is_round && value(437, 0.0) != 0.0)
        return fail(Message::KlartextVerb, span, {"cycle 256 with an approach at a corner (Q437)"});
    m.blank_length = length;
    log_.add(Message::MillsOutside, span, {"cycle " + std::to_string(cycle_.number)});
    if (is_round) {
        m.blank = (length - m.area.length) / 2.0;
        return true;
    }
    // Distance from the corner of the blank to the round corner of the stud.
    const double x = (length - m.area.length) / 2.0 + m.area.corner;
    const double y = (width - m.area.width) / 2.0 + m.area.corner;
    m.blank = hypotenuse(x, y) - m.area.corner;
    return true;
}

/// 258: mills around a regular polygon.
bool Control::mill_polygon(SourceSpan span, language::Milling& m) {
    constexpr double kMostCorners = 1000.0;
    if (!needs({571, 222, 572}, span)) return false;
    const std::string name = "cycle 258";
    const double sides = value(572, 0.0);
    if (!(sides >= 3.0 && sides <= kMostCorners && sides == std::round(sides)))
        return fail(Message::BlockNeeds, span, {name, "a number of corners (Q572) from 3 to 1000"});
    if (value(220, 0.0) < 0.0)
        return fail(Message::KlartextVerb, span, {name + " with a chamfer (Q220)"});
    const bool is_outer = value(573, 0.0) == 1.0;  // The circle through the corners.
    language::MilledArea& area = m.area;
    area.sides = static_cast<int>(sides);
    const double to_inner = is_outer ? sin_cos(180.0 / sides).cos : 1.0;
    area.length = area.width = value(571, 0.0) * to_inner;
    area.corner = std::min(value(220, 0.0), area.length / 2.0);
    area.angle = value(224, 0.0);
    const double blank = value(222, 0.0);
    if (!(area.length > 0.0 && blank >= 2.0 * area.reach()))
        return fail(Message::BlockNeeds, span,
                    {name, "a blank (Q222) of at least the size of the stud"});
    m.blank = (blank - area.length) / 2.0;
    m.blank_length = blank;
    const Point start = in_plane();
    area.centre = {start[0], start[1]};
    log_.add(Message::MillsOutside, span, {name});
    log_.add(Message::CornerDirection, span, {name});
    return mill(m, name) && go_to(start, true, span);
}

/// 254: slots about arcs, at equal angles.
bool Control::mill_circular_slots(SourceSpan span, language::Milling& m) {
    if (!needs({219, 375, 376, 248}, span)) return false;
    const std::string name = "cycle 254";
    const Point start = in_plane();
    language::MilledArea& area = m.area;
    area.width = value(219, 0.0);
    area.arc_radius = value(375, 0.0) / 2.0;
    area.opening = value(248, 0.0);
    area.angle = value(376, 0.0);
    if (!(area.width > 0.0 && area.arc_radius > 0.0 && area.opening > 0.0))
        return fail(Message::BlockNeeds, span,
                    {name, "a width (Q219), a diameter (Q375) and an angle (Q248) above 0"});
    const double position = value(367, 0.0);
    if (position == 0.0) {
        if (!needs({216, 217}, span)) return false;
        area.centre = {value(216, 0.0), value(217, 0.0)};
    } else if (position == 2.0) {
        // The tool is over the middle of the centre line, at the angle Q376.
        const SinCos direction = sin_cos(area.angle);
        area.centre = {start[0] - area.arc_radius * direction.cos,
                       start[1] - area.arc_radius * direction.sin};
        area.angle -= area.opening / 2.0;
    } else {
        return fail(Message::KlartextVerb, span, {"cycle 254 with the position (Q367) of an end"});
    }
    const double repeats = std::round(value(377, 1.0));
    if (!(repeats >= 1.0 && repeats <= kMostRepeats))
        return fail(Message::BlockNeeds, span, {name, "a number of slots (Q377) from 1 to 10000"});
    m.repeats = repeats;
    const double first = area.angle;
    for (int i = 0; i < static_cast<int>(repeats); ++i) {
        area.angle = first + i * value(378, 0.0);
        if (!mill(m, name)) return false;
    }
    return go_to(start, true, span);
}

}  // namespace ncsim::gcode::klartext
