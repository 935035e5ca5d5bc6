// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thread milling: 262 (in a hole), 263 (with a countersink), 264 (with drilling), 265 (along one
// helix downwards), 267 (outside). Source: HEIDENHAIN TNC 426, TNC 430, User's Manual, "Thread
// milling"; TNC 640, User's Manual for Cycle Programming, 892903.
#include "klartext/control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {

bool Control::is_thread_cycle(int number) {
    return (number >= 262 && number <= 265) || number == 267;
}

/// Returns the feed `q`; without a number a rapid.
std::optional<double> Control::feed_or_rapid(std::uint32_t q) const {
    const std::optional<double> feed = feed_value(q);
    return feed ? std::optional(feed_of(*feed)) : std::nullopt;
}

/// Reads diameter, pitch, direction and feeds of a thread.
/// Requires: the radius of the tool is known.
bool Control::read_thread(SourceSpan span, double surface, language::ThreadMilling& m) {
    if (!needs({335, 239, 207}, span)) return false;
    const int number = cycle_.number;
    const std::string name = "cycle " + std::to_string(number);
    const double pitch = value(239, 0.0);
    const double tool_radius = *radius_of_tool();
    m.is_internal = number != 267;
    m.centre = {in_plane()[0], in_plane()[1]};
    m.radius = value(335, 0.0) / 2.0 + (m.is_internal ? -tool_radius : tool_radius);
    m.pitch = std::abs(pitch);
    m.entry = m.radius + m.pitch;
    if (!(value(335, 0.0) > 0.0))
        return fail(Message::BlockNeeds, span, {name, "a diameter (Q335) above 0"});
    if (!(m.radius > 0.0))
        return fail(Message::BlockNeeds, span, {name, "a diameter larger than the tool"});
    if (pitch == 0.0) return fail(Message::BlockNeeds, span, {name, "a pitch (Q239)"});
    m.turns_per_step = number == 262 || number == 267 ? std::round(value(355, 0.0)) : 0.0;
    if (m.turns_per_step < 0.0) return fail(Message::NegativeValue, span, {"Q355"});
    m.top = surface;
    m.bottom = surface + value(201, 0.0);
    m.clear = surface + value(200, 0.0);
    m.feed = feed_of(feed_value(207).value_or(0.0));
    m.approach_feed = feed_or_rapid(253);
    if (number == 265) {
        // Downwards along one helix: a right-hand thread clockwise.
        m.turns_per_step = 1.0;
        m.is_clockwise = pitch > 0.0;
        return true;
    }
    const bool is_climb = value(351, 1.0) >= 0.0;
    const bool turns_left = machine_.state().spindle == SpindleTurning::Counterclockwise;
    // Climb milling: counter-clockwise in a hole, clockwise around a stud.
    m.is_clockwise = (is_climb == turns_left) == m.is_internal;
    // A right-hand thread rises counter-clockwise.
    m.goes_up = m.is_clockwise == (pitch < 0.0);
    return true;
}

/// Countersinks with the front of the tool (Q358, Q359): a circle about the centre.
bool Control::countersink_front(const language::ThreadMilling& m, double surface) {
    const double radius = std::abs(value(359, 0.0));
    const double height = surface + value(358, 0.0);
    if (value(358, 0.0) == 0.0) return true;
    const double own = feed_of(feed_value(cycle_.number == 264 ? 206 : 254).value_or(0.0));
    const double feed = own > 0.0 ? own : m.feed;
    const Vec2 out = m.is_internal ? m.centre : Vec2{m.centre.x + m.entry, m.centre.y};
    if (!move_in_plane(out, std::nullopt) || !move_to(height, feed_or_rapid(253))) return false;
    if (radius == 0.0) return !m.is_internal || move_to(m.clear, std::nullopt);
    const int turn = m.is_clockwise ? -1 : 1;
    const Vec2 edge{m.centre.x + radius, m.centre.y};
    const Vec2 between{(out.x + edge.x) / 2.0, m.centre.y};
    const int aside = m.is_internal ? turn : -turn;
    return cut({out, edge, between, aside}, height, feed) &&
           cut({edge, edge, m.centre, turn}, height, feed) &&
           cut({edge, out, between, aside}, height, feed) && move_to(m.clear, std::nullopt);
}

/// 263: goes down to the countersinking depth (Q356). 264: drills the hole (Q356).
bool Control::prepare_thread(SourceSpan span, const language::ThreadMilling& m, double surface) {
    const double depth = value(356, 0.0);
    if (depth == 0.0) return true;
    const double bottom = surface + depth;
    if (cycle_.number == 264) {
        if (!needs({202, 206}, span)) return false;
        language::Pecks pecks;
        pecks.surface = pecks.from = surface;
        pecks.bottom = bottom;
        pecks.clear = m.clear;
        pecks.infeed = std::abs(value(202, 0.0));
        pecks.ahead = std::abs(value(258, 0.0));
        pecks.break_depth = std::abs(value(257, 0.0));
        pecks.breaking = std::abs(value(256, 0.0));
        pecks.feed = feed_of(feed_value(206).value_or(0.0));
        return peck(pecks, Message::CycleRepeats);
    }
    log_.add(Message::Countersink, span, {"cycle 263"});
    return move_to(std::min(m.clear, bottom + value(200, 0.0)), m.approach_feed) &&
           move_to(bottom, feed_of(feed_value(254).value_or(0.0))) &&
           move_to(m.clear, std::nullopt);
}

/// 262 … 265, 267.
/// Requires: the radius of the tool is known.
bool Control::thread_cycle(SourceSpan span) {
    const std::string name = std::to_string(cycle_.number);
    if (!needs({200, 201}, span)) return false;
    bool is_empty = true;
    for (const std::uint32_t q : {201U, 356U, 358U}) {
        if (value(q, 0.0) > 0.0) {
            log_.add(Message::KlartextDepthPositive, span, {name});
            return true;
        }
        is_empty = is_empty && value(q, 0.0) == 0.0;
    }
    if (is_empty) {
        log_.add(Message::KlartextDepthZero, span, {name});
        return true;
    }
    if (!(radius_of_tool().value_or(0.0) > 0.0)) {
        report_unknown_radius("cycle " + name);
        return true;
    }
    const double surface = value(203, 0.0) + surface_shift_;
    language::ThreadMilling m;
    if (!read_thread(span, surface, m) || !move_to(m.clear, std::nullopt)) return false;
    const bool has_thread = value(201, 0.0) != 0.0;
    const bool sinks_last = cycle_.number == 265 && value(360, 0.0) == 1.0;
    if ((cycle_.number == 263 || cycle_.number == 264) && !prepare_thread(span, m, surface))
        return false;
    if (cycle_.number != 262 && !sinks_last && !countersink_front(m, surface)) return false;
    if (has_thread && !mill_thread(m)) return false;
    if (sinks_last && !countersink_front(m, surface)) return false;
    const double second = surface + value(204, 0.0);
    return second <= m.clear || move_to(second, std::nullopt);
}

}  // namespace ncsim::gcode::klartext
