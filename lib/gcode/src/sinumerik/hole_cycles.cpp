// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hole cycles CYCLE81 … CYCLE89, CYCLE840, and patterns of holes.
// Source: SINUMERIK 840D sl, Programming Manual Cycles, 2007, and the parameters of 06/2019.
#include "ncsim/base/angles.h"

#include "sinumerik/sinumerik_control.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ncsim::gcode::sinumerik {
namespace {

constexpr double kMostHoles = 10'000.0;

constexpr auto kHoleCycles =
    std::to_array<std::string_view>({"CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84", "CYCLE840",
                                     "CYCLE85", "CYCLE86", "CYCLE87", "CYCLE88", "CYCLE89"});

/// Pitches of metric threads, coarse series. Source: ISO 261.
struct Thread {
    double size, pitch;
};
constexpr auto kThreads = std::to_array<Thread>(
    {{3, 0.5},  {4, 0.7},   {5, 0.8},  {6, 1.0},  {7, 1.0},  {8, 1.25}, {9, 1.25}, {10, 1.5},
     {11, 1.5}, {12, 1.75}, {14, 2.0}, {16, 2.0}, {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3.0},
     {27, 3.0}, {30, 3.5},  {33, 3.5}, {36, 4.0}, {39, 4.0}, {42, 4.5}, {45, 4.5}, {48, 5.0}});

}  // namespace

bool Control::is_hole_cycle(std::string_view name) {
    return std::ranges::find(kHoleCycles, name) != kHoleCycles.end();
}

bool Control::is_pattern(std::string_view name) {
    return name == "HOLES1" || name == "HOLES2" || name == "CYCLE801";
}

std::optional<double> Control::argument(const CycleCall& call, std::size_t index) const {
    if (index >= call.arguments.size() || !call.arguments[index]) return std::nullopt;
    return call.arguments[index]->number;
}

/// Reports the argument `index`, unless it is omitted or 0.
bool Control::refuses(const CycleCall& call, std::size_t index, std::string_view what) {
    if (argument(call, index, 0.0) == 0.0) return false;
    fail(Message::NotRead, call.span, {call.name + " with " + std::string(what)});
    return true;
}

/// Refuses a tool axis (_AXN) other than the third axis of the plane.
bool Control::refuses_axis(const CycleCall& call, std::size_t index) {
    const double axis = argument(call, index, 0.0);
    if (axis != 1.0 && axis != 2.0) return false;
    fail(Message::NotRead, call.span, {call.name + " along another axis (_AXN)"});
    return true;
}

/// Returns seconds; a negative value counts turns of the spindle.
double Control::dwell_time(double value) const {
    if (value >= 0.0) return value;
    const double rpm = machine_.state().spindle_rpm;
    return rpm > 0.0 ? -value * 60.0 / rpm : 0.0;
}

/// Reads RTP, RFP, SDIS, DP, DPR.
bool Control::read_hole(const CycleCall& call, Hole& hole) {
    if (call.arguments.size() < 4 || !argument(call, 0) || !argument(call, 1))
        return fail(Message::BlockNeeds, call.span, {call.name, "RTP, RFP and a depth"});
    hole.retract = argument(call, 0, 0.0);
    hole.surface = argument(call, 1, 0.0);
    hole.clear = hole.surface + std::abs(argument(call, 2, 0.0));
    const std::optional<double> relative = argument(call, 4);
    const std::optional<double> absolute = argument(call, 3);
    if (relative && (*relative != 0.0 || !absolute)) {
        hole.bottom = hole.surface - std::abs(*relative);
    } else if (absolute) {
        hole.bottom = *absolute;
    } else {
        return fail(Message::BlockNeeds, call.span, {call.name, "a depth (DP or DPR)"});
    }
    hole.feed = machine_.state().feed;
    if (hole.retract < hole.surface)
        return fail(Message::BlockNeeds, call.span,
                    {call.name, "a retraction plane (RTP) not below the reference plane (RFP)"});
    if (hole.bottom > hole.surface) return fail(Message::HoleUpwards, call.span, {call.name});
    return true;
}

bool Control::cycle(const CycleCall& call) {
    if (side_ != CutterSide::Off)
        return fail(Message::NotRead, call.span, {call.name + " under G41 or G42"});
    Hole hole;
    if (!read_hole(call, hole)) return false;
    cycle_span_ = call.span;
    const double feed = machine_.state().feed;
    const FeedMode mode = machine_.state().feed_mode;
    if (mode == FeedMode::InverseTime)
        return fail(Message::NotRead, call.span, {call.name + " under G93"});
    const std::string_view name = call.name;
    bool done = move_to(hole.clear, std::nullopt);
    if (!done) return false;
    if (name == "CYCLE81" || name == "CYCLE82") {
        if (refuses(call, 6, "_GMODE")) return false;
        done = move_to(hole.bottom, hole.feed) && dwell(dwell_time(argument(call, 5, 0.0)));
    } else if (name == "CYCLE83") {
        done = deep_hole(call, hole);
    } else if (name == "CYCLE84" || name == "CYCLE840") {
        done = tap_hole(call, hole);
    } else if (name == "CYCLE85" || name == "CYCLE89") {
        const bool has_feeds = name == "CYCLE85";
        const double in = has_feeds ? feed_of(argument(call, 6, 0.0)) : 0.0;
        const double out = has_feeds ? feed_of(argument(call, 7, 0.0)) : 0.0;
        const double down = in > 0.0 ? in : hole.feed;
        done = move_to(hole.bottom, down) && dwell(dwell_time(argument(call, 5, 0.0))) &&
               move_to(hole.clear, out > 0.0 ? out : down);
    } else if (name == "CYCLE86") {
        done = bore_hole(call, hole);
    } else {
        done = stop_spindle_at_bottom(call, hole);
    }
    if (machine_.state().feed_mode == mode) machine_.state().feed = feed;
    return done && move_to(hole.retract, std::nullopt);
}

/// CYCLE83: infeeds with retraction (VARI 1) or chip breaking (VARI 0).
bool Control::deep_hole(const CycleCall& call, const Hole& hole) {
    if (refuses(call, 17, "_GMODE") || refuses_axis(call, 12)) return false;
    // Digits of _AMODE from the right; the sixth chooses amount or percentage for DAM.
    const auto amode = static_cast<long>(std::clamp(argument(call, 19, 0.0), 0.0, 1e9));
    const bool by_percentage = amode / 100'000 % 10 == 2;
    double decrement = argument(call, 7, 0.0);
    const double total = hole.surface - hole.bottom;
    double first = total;
    if (const std::optional<double> relative = argument(call, 6); relative && *relative != 0.0) {
        first = std::abs(*relative);
    } else if (const std::optional<double> absolute = argument(call, 5);
               absolute && (*absolute != 0.0 || !relative)) {
        first = hole.surface - *absolute;
    }
    if (by_percentage) {
        if (decrement != 100.0 && decrement != 0.0)
            return fail(Message::NotRead, call.span, {"CYCLE83 with a percentage for DAM"});
        decrement = 0.0;
    }
    if (decrement < 0.0)
        return fail(Message::NotRead, call.span, {"CYCLE83 with a factor for DAM"});
    double factor = argument(call, 10, 1.0);
    if (factor > 1.0) factor /= 100.0;  // A percentage.
    const double least = std::abs(argument(call, 13, 0.0));
    const bool clears_chips = argument(call, 11, 0.0) != 0.0;
    const double unit = machine_.state().unit_mm();
    // Without a value the cycle computes the distance from the depth. Source: manual, "CYCLE83".
    const double computed = total * unit <= 30.0 ? 0.6 : std::min(total * unit / 50.0, 7.0);
    const double ahead = argument(call, 16, 0.0);
    const double retraction = argument(call, 14, 0.0);
    language::Pecks pecks;
    pecks.surface = pecks.from = hole.surface;
    pecks.bottom = hole.bottom;
    pecks.clear = hole.clear;
    pecks.infeed = first;
    pecks.decrement = decrement;
    pecks.least = least > 0.0 ? std::min(least, first) : 0.0;
    pecks.halves_last = decrement > 0.0 && least == 0.0;
    pecks.ahead = ahead > 0.0 ? ahead : computed / unit;
    pecks.feed = hole.feed;
    if (factor > 0.0 && factor != 1.0) pecks.first_feed = hole.feed * factor;
    if (!clears_chips) {
        pecks.breaking = retraction > 0.0 ? retraction : 1.0 / unit;
        pecks.breaks = kMostHoles * 100.0;
    }
    const double each = argument(call, 8, 0.0);
    const double last = argument(call, 15, 0.0);
    pecks.dwell_below = dwell_time(last != 0.0 ? last : each);
    pecks.dwell_between = clears_chips ? 0.0 : dwell_time(each);
    pecks.dwell_above = dwell_time(argument(call, 9, 0.0));
    return peck(pecks, Message::CycleRepeats);
}

/// Returns the pitch in active units, with the sign of the thread; 0: none; nullopt after an error.
std::optional<double> Control::pitch(const CycleCall& call, std::size_t metric, std::size_t pitch,
                                     std::optional<std::size_t> unit) {
    const double unit_mm = machine_.state().unit_mm();
    const double given = argument(call, pitch, 0.0);
    if (given != 0.0) {
        const double kind = unit ? argument(call, *unit, 0.0) : 0.0;
        const double size = std::abs(given);
        // _PTAB 0: units of the program.
        const double mm = kind == 0.0   ? size * unit_mm
                          : kind == 1.0 ? size
                          : kind == 2.0 ? 25.4 / size
                          : kind == 3.0 ? 25.4 * size
                                        : 0.0;
        if (mm == 0.0) {
            fail(Message::NotRead, call.span, {call.name + " with a pitch by module"});
            return std::nullopt;
        }
        return std::copysign(mm / unit_mm, given);
    }
    const double size = argument(call, metric, 0.0);
    if (size == 0.0) return 0.0;
    const auto* const thread = std::ranges::find(kThreads, std::abs(size), &Thread::size);
    if (thread == kThreads.end()) {
        fail(Message::BlockNeeds, call.span, {call.name, "a thread from M3 to M48, or a pitch"});
        return std::nullopt;
    }
    return std::copysign(thread->pitch / unit_mm, size);
}

/// CYCLE84: rigid tapping. CYCLE840: tapping with a compensating chuck.
bool Control::tap_hole(const CycleCall& call, const Hole& hole) {
    const bool is_rigid = call.name == "CYCLE84";
    if (refuses_axis(call, is_rigid ? 12 : 11)) return false;
    const std::optional<double> found = is_rigid ? pitch(call, 7, 8, 13) : pitch(call, 9, 10, {});
    if (!found) return false;
    MachineState& state = machine_.state();
    language::Tapping tapping;
    tapping.surface = hole.surface;
    tapping.bottom = hole.bottom;
    tapping.clear = hole.clear;
    tapping.dwell = dwell_time(argument(call, 5, 0.0));
    const double speed =
        is_rigid && argument(call, 10, 0.0) > 0.0 ? argument(call, 10, 0.0) : state.spindle_rpm;
    const double speed_out =
        is_rigid && argument(call, 11, 0.0) > 0.0 ? argument(call, 11, 0.0) : speed;
    const double size = std::abs(*found);
    if (size == 0.0) {
        if (is_rigid)
            return fail(Message::BlockNeeds, call.span, {call.name, "a pitch (MPIT or PIT)"});
        tapping.feed = tapping.feed_out = hole.feed;
    } else {
        const bool per_turn = state.feed_mode == FeedMode::PerRevolution;
        tapping.feed = per_turn ? size : size * speed;
        tapping.feed_out = per_turn ? size : size * speed_out;
    }
    const double rpm = state.spindle_rpm;
    const SpindleTurning turning = state.spindle;
    using enum SpindleTurning;
    tapping.in = turning;
    if (is_rigid) {
        state.spindle_rpm = speed;
        tapping.in = *found < 0.0 ? Counterclockwise : Clockwise;
    } else if (argument(call, 6, 0.0) == 3.0 || argument(call, 6, 0.0) == 4.0) {
        // SDR: the direction of the retraction.
        tapping.in = argument(call, 6, 0.0) == 3.0 ? Counterclockwise : Clockwise;
    }
    const double after = argument(call, is_rigid ? 6 : 7, 0.0);
    tapping.after = after == 3.0   ? Clockwise
                    : after == 4.0 ? Counterclockwise
                    : after == 5.0 ? Stopped
                                   : turning;
    if (is_rigid && argument(call, 15, 0.0) != 0.0) {
        const double variant = argument(call, 15, 0.0);
        if (variant != 1.0 && variant != 2.0)
            return fail(Message::NotRead, call.span, {"CYCLE84 with this _VARI"});
        tapping.step = std::abs(argument(call, 16, 0.0));
        const double retraction = std::abs(argument(call, 17, 0.0));
        if (variant == 1.0)
            tapping.breaking = retraction > 0.0 ? retraction : 1.0 / state.unit_mm();
    }
    const bool done = tap(tapping, Message::CycleRepeats);
    machine_.state().spindle_rpm = rpm;
    return done;
}

/// Starts the spindle in the direction SDIR of a boring cycle: 3 or 4, as M3 and M4.
void Control::start_spindle(double direction) {
    using enum SpindleTurning;
    if (direction == 3.0) machine_.state().spindle = Clockwise;
    if (direction == 4.0) machine_.state().spindle = Counterclockwise;
}

/// CYCLE86: the spindle is oriented at the bottom, and the tool steps away from the wall.
bool Control::bore_hole(const CycleCall& call, const Hole& hole) {
    start_spindle(argument(call, 6, 0.0));
    const bool steps_aside = argument(call, 7, 0.0) != 0.0 || argument(call, 8, 0.0) != 0.0;
    return move_to(hole.bottom, hole.feed) && dwell(dwell_time(argument(call, 5, 0.0))) &&
           bore_out(std::max(hole.clear, hole.retract), std::nullopt, steps_aside);
}

/// CYCLE87, CYCLE88: spindle and program stop at the bottom.
bool Control::stop_spindle_at_bottom(const CycleCall& call, const Hole& hole) {
    const bool dwells = call.name == "CYCLE88";
    start_spindle(argument(call, dwells ? 6 : 5, 0.0));
    if (!move_to(hole.bottom, hole.feed) || (dwells && !dwell(dwell_time(argument(call, 5, 0.0)))))
        return false;
    const SpindleTurning turning = machine_.state().spindle;
    Command command = make(call.span);
    put(command, MGroup::Spindle, 5);
    if (!run(command) || !move_to(hole.retract, std::nullopt)) return false;
    machine_.state().spindle = turning;
    return true;
}

// --- Patterns ---

std::optional<std::vector<HolePlace>> Control::pattern(const CycleCall& call) {
    const auto at = [&](std::size_t i) { return argument(call, i, 0.0); };
    const bool is_grid = call.name == "CYCLE801";
    const double columns = std::round(at(5));
    const double rows = is_grid ? std::round(at(6)) : 1.0;
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= kMostHoles)) {
        fail(Message::BlockNeeds, call.span, {call.name, "a number of holes from 1 to 10000"});
        return std::nullopt;
    }
    std::vector<HolePlace> places;
    const auto count = static_cast<int>(columns);
    if (call.name == "HOLES2") {
        // CPA, CPO, RAD, STA1, INDA, NUM. INDA 0: the holes share the circle.
        const double step = at(4) != 0.0 ? at(4) : 360.0 / columns;
        for (int i = 0; i < count; ++i) {
            const SinCos direction = sin_cos(at(3) + i * step);
            places.push_back({at(0) + at(2) * direction.cos, at(1) + at(2) * direction.sin});
        }
        return places;
    }
    // HOLES1: SPCA, SPCO, STA1, FDIS, DBH, NUM. CYCLE801: SPCA, SPCO, STA, DIS1, DIS2, NUM1, NUM2.
    const SinCos direction = sin_cos(at(2));
    for (int row = 0; row < static_cast<int>(rows); ++row) {
        for (int i = 0; i < count; ++i) {
            const int column = is_grid && row % 2 == 1 ? count - 1 - i : i;
            const double along = is_grid ? column * at(3) : at(3) + column * at(4);
            const double across = is_grid ? row * at(4) : 0.0;
            places.push_back({at(0) + along * direction.cos - across * direction.sin,
                              at(1) + along * direction.sin + across * direction.cos});
        }
    }
    return places;
}

bool Control::move_over(const HolePlace& place, SourceSpan span) {
    const PlaneAxes axes = axes_of(plane_);
    Command command = make(span);
    put(command, Code::G0);
    put(command, kAxisNames[axes.first], place.first);
    put(command, kAxisNames[axes.second], place.second);
    command.axis_words = true;
    if (!run(command)) return false;
    Axes end = at_;
    end[axes.first] = place.first;
    end[axes.second] = place.second;
    arrive(end);
    return true;
}

}  // namespace ncsim::gcode::sinumerik
