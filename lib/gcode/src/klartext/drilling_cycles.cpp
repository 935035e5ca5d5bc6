// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hole cycles: drilling, reaming, boring, tapping, bore milling, centring.
// Source: HEIDENHAIN TNC 640, User's Manual for Cycle Programming, 892903.
#include "klartext/control.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::klartext {

bool Control::drill(SourceSpan span) {
    const int number = cycle_.number;
    if (number == 204) return back_bore(span);
    if (number >= 22 && number <= 24) return mill_contours(span);
    if (number == 25) return mill_contour_train(span);
    if (is_thread_cycle(number)) return thread_cycle(span);
    if (!needs({200, 201}, span)) return false;
    const std::string name = std::to_string(number);
    const double depth = value(201, 0.0);
    const bool by_diameter = number == 240 && value(343, 0.0) == 1.0;
    if (by_diameter)
        return fail(Message::KlartextVerb, span, {"cycle 240 by the diameter (Q343=1)"});
    if (depth > 0.0) {
        log_.add(Message::KlartextDepthPositive, span, {name});
        return true;
    }
    if (depth == 0.0) {
        log_.add(Message::KlartextDepthZero, span, {name});
        return true;
    }
    const bool needs_radius = number == 208 || is_area_cycle(number);
    if (needs_radius && !(radius_of_tool().value_or(0.0) > 0.0)) {
        report_unknown_radius("cycle " + name);
        return true;
    }
    const std::size_t axis = axes_of(plane_).third;
    // The old cycles begin at the clearance above the surface.
    const bool is_old = number < 100;
    const double clearance = value(200, 0.0);
    const double surface = is_old ? at_[axis] - clearance : value(203, 0.0) + surface_shift_;
    const double clear = surface + clearance;
    const double bottom = surface + depth;
    if (!move_to(clear, std::nullopt)) return false;
    const double down = feed_of(feed_value(206).value_or(0.0));
    bool done = true;
    switch (number) {
        case 240:
            done = needs({206}, span) && move_to(bottom, down) && dwell(value(211, 0.0)) &&
                   move_to(clear, std::nullopt);
            break;
        case 201:
            done = needs({206}, span) && move_to(bottom, down) && dwell(value(211, 0.0)) &&
                   move_to(clear, feed_out(down));
            break;
        case 202: done = needs({206}, span) && bore(bottom, clear); break;
        case 2:
        case 17:
        case 206:
        case 207:
        case 209: done = tap(span, surface, bottom, clear); break;
        case 208: done = bore_mill(span, bottom, clear); break;
        case 251:
        case 252:
        case 253:
        case 254:
        case 256:
        case 257:
        case 258: done = mill_area(span, bottom, clear); break;
        case 241: done = single_lip_drill(span, surface, bottom, clear); break;
        default: done = peck(span, surface, bottom, clear); break;
    }
    if (!done) return false;
    // The second clearance is a height above the surface; never down.
    const double second = surface + value(204, 0.0);
    return second <= clear || move_to(second, std::nullopt);
}

/// 1, 200, 203 and 205: infeeds with retraction or chip breaking.
bool Control::peck(SourceSpan span, double surface, double bottom, double clear) {
    if (!needs({206, 202}, span)) return false;
    const int number = cycle_.number;
    const double down = feed_of(feed_value(206).value_or(0.0));
    const double infeed = std::abs(value(202, 0.0));
    const double decrement = number == 200 || number == 1 ? 0.0 : std::abs(value(212, 0.0));
    const double least = std::min(infeed, std::abs(value(205, 0.0)));
    std::optional<double> up;  // Retract feed; empty: rapid.
    if (number == 203 || number == 205) {
        if (const std::optional<double> feed = feed_value(208))
            up = feed_of(*feed > 0.0 ? *feed : feed_value(206).value_or(0.0));
    }
    const double breaking = number == 203 || number == 205 ? std::abs(value(256, 0.0)) : 0.0;
    const double breaks = number == 203 ? value(213, 0.0) : 0.0;
    const double broken_depth = number == 205 ? std::abs(value(257, 0.0)) : 0.0;
    const double ahead = number == 205 && value(258)
                             ? std::abs(*value(258))
                             : options_.peck_clearance.value_or(0.2 / machine_.state().unit_mm());
    double from = surface;
    if (number == 205 && value(379, 0.0) != 0.0) {
        // Deepened start: the tool goes there with the feed of pre-positioning.
        from = surface - std::abs(value(379, 0.0));
        if (from <= bottom) from = surface;
        const std::optional<double> feed = feed_value(253);
        if (from < surface && !move_to(from, feed ? std::optional(feed_of(*feed)) : std::nullopt))
            return false;
    }
    language::Pecks pecks;
    pecks.surface = surface;
    pecks.bottom = bottom;
    pecks.clear = clear;
    pecks.from = from;
    pecks.infeed = infeed;
    pecks.decrement = decrement;
    pecks.least = least;
    pecks.ahead = ahead;
    if (number == 205 && value(259)) pecks.last_ahead = std::abs(*value(259));
    pecks.breaking = breaking;
    pecks.breaks = breaks;
    pecks.break_depth = broken_depth;
    pecks.feed = down;
    pecks.up = up;
    pecks.dwell_above = value(210, 0.0);
    pecks.dwell_below = value(211, 0.0);
    return peck(pecks, Message::CycleRepeats);
}

/// 241: drills with a single-lip drill. The tool goes to a deepened start (Q379) and out of the
/// hole with the speed Q427, and drills with the speed Q428.
bool Control::single_lip_drill(SourceSpan span, double surface, double bottom, double clear) {
    if (!needs({206}, span)) return false;
    const double deepened = surface - std::abs(value(379, 0.0));
    const double from = deepened < surface && deepened > bottom ? deepened : surface;
    MachineState& state = machine_.state();
    const double speed = state.spindle_rpm;
    const SpindleTurning turning = state.spindle;
    const auto turn = [&](bool drills) {
        using enum SpindleTurning;
        const double direction = drills ? 3.0 : value(426, 3.0);
        state.spindle = direction == 5.0   ? Stopped
                        : direction == 4.0 ? Counterclockwise
                                           : Clockwise;
        state.spindle_rpm = value(drills ? 428 : 427, speed);
    };
    language::Pecks pecks;
    pecks.surface = surface;
    pecks.from = from;
    pecks.bottom = bottom;
    // Between infeeds the tool stays in its guiding hole.
    pecks.clear = from < surface ? from : clear;
    pecks.infeed = std::abs(value(202, 0.0));
    pecks.decrement = std::abs(value(212, 0.0));
    pecks.least = std::min(pecks.infeed, std::abs(value(205, 0.0)));
    pecks.ahead = options_.peck_clearance.value_or(0.2 / state.unit_mm());
    pecks.feed = feed_of(feed_value(206).value_or(0.0));
    pecks.up = feed_out(pecks.feed);
    pecks.dwell_below = value(211, 0.0);
    turn(false);
    bool done = from == surface || move_to(from, feed_or_rapid(253));
    turn(true);
    done = done && peck(pecks, Message::CycleRepeats);
    turn(false);
    done = done && move_to(clear, pecks.up);
    state.spindle = turning;
    state.spindle_rpm = speed;
    return done;
}

/// 202: the spindle is oriented at the bottom, and the tool steps away from the wall (Q214).
bool Control::bore(double bottom, double clear) {
    const double down = feed_of(feed_value(206).value_or(0.0));
    if (!move_to(bottom, down) || !dwell(value(211, 0.0))) return false;
    return bore_out(clear, feed_out(down), value(214, 0.0) != 0.0);
}

/// 204: bores upwards from below the part. The tool goes through the hole with the spindle
/// oriented, aside by Q251.
bool Control::back_bore(SourceSpan span) {
    if (!needs({200, 249, 250, 252, 253, 254, 203}, span)) return false;
    const double surface = value(203, 0.0) + surface_shift_;
    const double clear = surface + value(200, 0.0);
    const double lower_edge = surface - std::abs(value(250, 0.0));
    const double edge = std::abs(value(252, 0.0));  // Height of the cutting edge above the tip.
    const double below = lower_edge - value(200, 0.0) - edge;
    const double bottom = lower_edge + std::abs(value(249, 0.0)) - edge;
    const SpindleTurning turning = machine_.state().spindle;
    const auto orient = [&](bool on) {
        MachineState& state = machine_.state();
        state.spindle = on ? SpindleTurning::Stopped : turning;
        state.spindle_oriented = on;
        if (on) state.steps_aside = value(251, 0.0) != 0.0;
        if (!on) state.steps_aside.reset();
    };
    bool done = move_to(clear, std::nullopt);
    orient(true);
    done = done && move_to(below, feed_or_rapid(253));
    orient(false);
    done = done && move_to(bottom, feed_or_rapid(254)) && dwell(value(255, 0.0)) &&
           move_to(below, feed_or_rapid(253));
    orient(true);
    done = done && move_to(clear, feed_or_rapid(253));
    orient(false);
    const double second = surface + value(204, 0.0);
    return done && (second <= clear || move_to(second, std::nullopt));
}

/// 2, 17, 206, 207, 209: taps; the spindle turns back at the bottom.
bool Control::tap(SourceSpan span, double surface, double bottom, double clear) {
    MachineState& state = machine_.state();
    const int number = cycle_.number;
    const bool is_rigid = number == 17 || number == 207 || number == 209;
    if (!(is_rigid ? needs({239}, span) : needs({206}, span))) return false;
    language::Tapping tapping;
    tapping.surface = surface;
    tapping.bottom = bottom;
    tapping.clear = clear;
    tapping.feed = feed_of(feed_value(206).value_or(0.0));
    tapping.in = tapping.after = state.spindle;
    if (is_rigid) {
        tapping.feed = std::abs(value(239, 0.0)) * state.spindle_rpm;
        tapping.in =
            value(239, 0.0) < 0.0 ? SpindleTurning::Counterclockwise : SpindleTurning::Clockwise;
    }
    tapping.feed_out = tapping.feed;
    if (number == 209) {
        tapping.step = std::abs(value(257, 0.0));
        tapping.breaking = std::abs(value(256, 0.0));
    }
    tapping.dwell = value(211, 0.0);
    return tap(tapping, Message::CycleRepeats);
}

/// 208: mills a bore along a helix.
/// Requires: the radius of the tool is known.
bool Control::bore_mill(SourceSpan span, double bottom, double clear) {
    if (!needs({206, 334, 335}, span)) return false;
    const double radius = value(335, 0.0) / 2.0 - *radius_of_tool();
    const double infeed = std::abs(value(334, 0.0));
    if (!(radius > 0.0))
        return fail(Message::BlockNeeds, span, {"cycle 208", "a diameter larger than the tool"});
    const double feed = feed_of(feed_value(206).value_or(0.0));
    const bool is_climb = value(351, 1.0) >= 0.0;
    const bool is_clockwise = machine_.state().spindle == SpindleTurning::Counterclockwise;
    const bool is_left = is_climb != is_clockwise;  // Climb milling in a bore: counter-clockwise.
    const Vec2 centre = point_in_plane();
    const Vec2 edge{centre.x + radius, centre.y};
    const Vec2 between{centre.x + radius / 2.0, centre.y};
    const int turn = is_left ? 1 : -1;
    // The helix begins at the clearance; each turn goes down by the infeed.
    return cut({centre, edge, between, turn}, clear, feed) &&
           wind(centre, bottom, infeed, !is_left, feed) &&
           wind(centre, bottom, 0.0, !is_left, feed) &&
           cut({edge, centre, between, turn}, bottom, feed) && move_to(clear, std::nullopt);
}

}  // namespace ncsim::gcode::klartext
