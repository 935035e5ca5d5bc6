// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves of hole cycles: infeeds, chip breaking, tapping, boring.
#include "language/block_control.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode::language {
namespace {

constexpr double kMostPecks = 100'000.0;
constexpr double kPeckRounding = 1e-9;  // A last peck of this size is a rounding error.

}  // namespace

/// Moves the tool axis to `height`; without `feed`: rapid.
bool BlockControl::move_to(double height, std::optional<double> feed) {
    const std::size_t axis = axes_of(plane_).third;
    if (machine_.state().is_known(axis) && at_[axis] == height) return true;
    Command command = make(cycle_span_);
    put(command, feed ? Code::G1 : Code::G0);
    if (feed) put(command, 'F', *feed);
    put(command, kAxisNames[axis], height);
    command.axis_words = true;
    if (!run(command)) return false;
    at_[axis] = height;
    return true;
}

bool BlockControl::dwell(double seconds) {
    if (!(seconds > 0.0)) return true;
    Command command = make(cycle_span_);
    put(command, Code::G4);
    put(command, 'P', seconds);
    return run(command);
}

namespace {

/// Returns the infeed after `step`.
double next_infeed(const Pecks& pecks, double step) {
    if (pecks.decrement <= 0.0) return step;
    const double least = pecks.least > 0.0 ? pecks.least : pecks.decrement;
    return std::max(step - pecks.decrement, least);
}

/// Returns the change of `Pecks::ahead` from one infeed to the next one.
double step_of_ahead(const Pecks& pecks) {
    if (!pecks.last_ahead) return 0.0;
    double returns = 0.0;  // Ways back to the last depth.
    double step = pecks.infeed;
    for (double depth = pecks.from - step;
         step > 0.0 && depth > pecks.bottom + kPeckRounding && returns < kMostPecks;
         depth -= step) {
        ++returns;
        step = next_infeed(pecks, step);
    }
    return returns > 1.0 ? (*pecks.last_ahead - pecks.ahead) / (returns - 1.0) : 0.0;
}

}  // namespace

/// Drills in infeeds, with retraction or chip breaking. The tool is at `pecks.clear` before and
/// after. `too_many`: the message if the infeeds are too small.
bool BlockControl::peck(const Pecks& pecks, const MessageText& too_many) {
    const SourceSpan span = cycle_span_;
    const double total = pecks.surface - pecks.bottom;
    const bool in_one = pecks.infeed <= 0.0 || pecks.infeed >= total;
    if (!in_one && pecks.decrement > 0.0 && pecks.least <= 0.0 &&
        total / pecks.decrement > kMostPecks)
        return fail(too_many, span);
    const double smallest =
        pecks.decrement > 0.0 ? (pecks.least > 0.0 ? pecks.least : pecks.decrement) : pecks.infeed;
    if (!in_one && total / smallest > kMostPecks) return fail(too_many, span);
    double step = in_one ? total : pecks.infeed;
    double ahead = pecks.ahead;
    const double ahead_step = step_of_ahead(pecks);
    double depth = pecks.from;
    double breaks_left = pecks.breaks;
    double feed = pecks.first_feed.value_or(pecks.feed);
    double count = 0.0;  // Bounds the loops if an infeed is below the rounding of the heights.
    const auto break_chips = [&](double end) {
        double at = pecks.break_depth > 0.0 ? depth - pecks.break_depth : end;
        while (at > end + kPeckRounding) {
            if (++count > kMostPecks) return fail(too_many, span);
            if (!move_to(at, feed) ||
                (pecks.breaking > 0.0 && !move_to(at + pecks.breaking, std::nullopt)))
                return false;
            at -= pecks.break_depth;
        }
        return true;
    };
    while (!in_one && depth - step > pecks.bottom + kPeckRounding) {
        const double rest = depth - pecks.bottom;
        const bool is_last_but_one =
            pecks.halves_last && depth != pecks.from && rest < 2.0 * step - kPeckRounding;
        if (is_last_but_one) step = rest / 2.0;
        const double target = depth - step;
        if (++count > kMostPecks) return fail(too_many, span);
        if (!break_chips(target)) return false;
        if (!move_to(target, feed) || !dwell(pecks.dwell_between)) return false;
        feed = pecks.feed;
        if (breaks_left >= 1.0 && pecks.breaking > 0.0) {
            breaks_left -= 1.0;
            if (!move_to(std::min(target + pecks.breaking, pecks.clear), pecks.up)) return false;
        } else {
            breaks_left = pecks.breaks;
            if (!move_to(pecks.clear, pecks.up) || !dwell(pecks.dwell_above) ||
                !move_to(std::min(target + ahead, pecks.clear), std::nullopt))
                return false;
            ahead += ahead_step;
        }
        depth = target;
        if (is_last_but_one) break;
        step = next_infeed(pecks, step);
    }
    return break_chips(pecks.bottom) && move_to(pecks.bottom, feed) && dwell(pecks.dwell_below) &&
           move_to(pecks.clear, pecks.up);
}

/// Taps: the spindle turns back at the bottom.
bool BlockControl::tap(const Tapping& t, const MessageText& too_many) {
    const auto turn = [&](SpindleTurning sense) { machine_.state().spindle = sense; };
    using enum SpindleTurning;
    const SpindleTurning out = t.in == Clockwise          ? Counterclockwise
                               : t.in == Counterclockwise ? Clockwise
                                                          : t.in;
    turn(t.in);
    bool done = true;
    double count = 0.0;
    for (double at = t.surface - t.step; t.step > 0.0 && done && at > t.bottom + kPeckRounding;
         at -= t.step) {
        if (++count > kMostPecks) return fail(too_many, cycle_span_);
        done = move_to(at, t.feed);
        turn(out);
        done = done &&
               move_to(t.breaking > 0.0 ? std::min(at + t.breaking, t.clear) : t.clear, t.feed_out);
        turn(t.in);
    }
    done = done && move_to(t.bottom, t.feed) && dwell(t.dwell);
    turn(out);
    done = done && move_to(t.clear, t.feed_out);
    turn(t.after);
    return done;
}

bool BlockControl::bore_out(double clear, std::optional<double> feed, bool steps_aside) {
    MachineState& state = machine_.state();
    const SpindleTurning turning = state.spindle;
    state.spindle = SpindleTurning::Stopped;
    state.spindle_oriented = true;
    state.steps_aside = steps_aside;
    const bool done = move_to(clear, feed);
    machine_.state().spindle = turning;
    machine_.state().spindle_oriented = false;
    machine_.state().steps_aside.reset();
    return done;
}

}  // namespace ncsim::gcode::language
