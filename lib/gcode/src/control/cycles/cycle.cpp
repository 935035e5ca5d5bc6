// SPDX-License-Identifier: GPL-3.0-or-later
//
// Canned cycles, expanded into moves.
// Source: RS274/NGC version 3, section 3.5.16.
#include "control/machine.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

constexpr char kAxisLetters9[] = {'X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'};

}  // namespace

/// Updates the modal words of the cycle. Reports words that the cycle cannot use.
bool Machine::cycle_words(const Command& command, Code motion) {
    CycleState& cycle = state_.cycle;
    const PlaneAxes axes = axes_of(state_.plane);
    const char depth = kAxisLetters9[axes.third];
    if (!cycle.running || cycle.code != motion) {
        const double initial = cycle.running ? cycle.initial : state_.position[axes.third];
        if (!cycle.running || rules_.strict) {
            // G74 and G84 of LinuxCNC dwell for the P of the last cycle with a P.
            const double p = cycle.p;
            cycle = {};
            if (rules_.is_linuxcnc()) cycle.p = p;
        }
        cycle.initial = initial;
        cycle.running = true;
        cycle.code = motion;
    }
    if (command.has('R')) cycle.r = command['R'], cycle.has_r = true;
    if (command.has(depth)) cycle.z = command[depth], cycle.has_z = true;
    if (rules_.macro_b && state_.incremental) {
        // Fanuc and Haas store the data of holes as heights, independent of later G90 and G91.
        if (command.has('R')) cycle.r += cycle.initial;
        if (command.has(depth)) cycle.z += cycle.r;
    }
    if (command.has('P')) cycle.p = seconds_of(command, 'P'), cycle.has_p = true;
    if (command.has('Q')) cycle.q = std::abs(command['Q']);
    if (command.has('Q') && command['Q'] < 0.0 && (motion == Code::G83 || motion == Code::G73) &&
        !tolerate(Message::NegativeValue, span_of(command, 'Q'), {"Q"})) {
        return false;
    }

    const std::string_view name = name_of(motion);
    if (rules_.strict) {
        if (!check_spindle(command, motion)) return false;
        if (command.has_any(letters('A', 'B', 'C'))) {
            return fail(Message::CycleRotary, command.span, {name});
        }
        if (state_.cutter_side != CutterSide::Off) {
            return fail(Message::ForbiddenWithCompensation, command.span, {name});
        }
        if (state_.feed_mode == FeedMode::InverseTime) {
            return fail(Message::CycleInverseTime, command.span, {name});
        }
        if ((motion == Code::G82 || motion == Code::G86 || motion == Code::G88 ||
             motion == Code::G89) &&
            !cycle.has_p) {
            return fail(Message::CycleWordMissing, command.span, {name, "P"});
        }
    }
    if (!cycle.has_z) return fail(Message::CycleWordMissing, command.span, {name, {&depth, 1}});
    if (!cycle.has_r) {
        if (!tolerate(Message::CycleWordMissing, command.span, {name, "R"})) return false;
        cycle.r = state_.incremental && !rules_.macro_b ? 0.0 : state_.position[axes.third];
        cycle.has_r = true;
    }
    const bool pecks = motion == Code::G83 || motion == Code::G73;
    if (pecks && command.has('Q')) cycle.first_peck = 0.0;
    if (pecks && rules_.pecks_shrink && command.has('I')) {
        cycle.first_peck = std::abs(command['I']);
        cycle.peck_reduction = std::abs(command.get('J', 0.0));
        cycle.least_peck = std::abs(command.get('K', 0.0));
    }
    if (pecks && cycle.q <= 0.0 && cycle.first_peck <= 0.0 &&
        !tolerate(Message::CycleWordMissing, command.span, {name, "Q"})) {
        return false;
    }
    return true;
}

/// Ends the cycle. LinuxCNC keeps the dwell.
void Machine::end_cycle() {
    const double p = state_.cycle.p;
    state_.cycle = {};
    if (rules_.is_linuxcnc()) state_.cycle.p = p;
}

/// Checks the spindle as LinuxCNC does: taps need the right direction, and cycles that stop the
/// spindle need a turning spindle.
bool Machine::check_spindle(const Command& command, Code motion) {
    using enum SpindleTurning;
    const SpindleTurning turning = state_.spindle;
    std::string_view wanted;
    if (motion == Code::G84 && turning != Clockwise) wanted = "M3";
    if (motion == Code::G74 && turning != Counterclockwise) wanted = "M4";
    const bool stops = motion == Code::G86 || motion == Code::G87 || motion == Code::G88;
    if (stops && turning == Stopped) wanted = "M3 or M4";
    return wanted.empty() || fail(Message::CycleSpindle, command.span, {name_of(motion), wanted});
}

bool Machine::cycle(const Command& command, Code motion) {
    const std::string_view name = name_of(motion);
    if (motion == Code::G76 && (rules_.strict || command.has('K'))) {
        stopped_ = true;
        return fail(Message::LatheCycle, command.span, {name});
    }
    if (!command.axis_words) {
        // Words without a hole position are stored for the next block.
        if (rules_.strict) return fail(Message::AxesMissing, command.span, {name});
        if (command.has('R')) state_.cycle.r = command['R'], state_.cycle.has_r = true;
        if (command.has('Q')) state_.cycle.q = std::abs(command['Q']);
        return true;
    }
    if (!needs_feed(command, name) || !cycle_words(command, motion)) return false;

    const bool pecks = motion == Code::G83 || motion == Code::G73;
    if (command.has('K') && !rules_.k_repeats && !(rules_.pecks_shrink && pecks) &&
        !tolerate(Message::WordUnused, span_of(command, 'K'), {"K"}))
        return false;
    double repeats = 1.0;
    if (command.has('L')) {
        repeats = command['L'];
    } else if (rules_.k_repeats && command.has('K')) {
        repeats = command['K'];
    }
    if (repeats < 1.0 && rules_.strict) return fail(Message::CycleRepeats, span_of(command, 'L'));
    if (repeats < 1.0) return true;  // L0, K0 define the cycle only.
    if (repeats > 100'000.0) return fail(Message::CycleRepeats, span_of(command, 'L'));

    Axes hole{};
    AxisMask mask = 0;
    if (!hole_place(command, hole, mask)) return false;
    Axes step{};
    for (std::size_t i = 0; i < step.size(); ++i) {
        step[i] = state_.incremental ? hole[i] - state_.position[i] : 0.0;
    }
    std::optional<Drilling> drilling = begin_drilling(command, motion);
    if (!drilling) return false;
    for (int i = 0; i < static_cast<int>(repeats); ++i) {
        if (!hole_at(*drilling, hole, mask)) return false;
        for (std::size_t a = 0; a < hole.size(); ++a)
            hole[a] += step[a];
    }
    return true;
}

/// Computes the position of the first hole, excluding the depth word.
bool Machine::hole_place(const Command& command, Axes& hole, AxisMask& mask) {
    const std::size_t depth_axis = axes_of(state_.plane).third;
    Command in_plane = command;
    in_plane.present &= ~(1U << letter_index(kAxisLetters9[depth_axis]));
    in_plane.axis_words = in_plane.has_any(kAxisLetters);
    return find_ends(in_plane, hole, mask);
}

/// Computes the heights, and moves up to R if the tool is below R.
std::optional<Machine::Drilling> Machine::begin_drilling(const Command& command, Code motion) {
    const std::size_t depth_axis = axes_of(state_.plane).third;
    const CycleState& cycle = state_.cycle;
    const double height = state_.position[depth_axis];
    double r = cycle.r;
    double bottom = cycle.z;
    if (state_.incremental && !rules_.macro_b) {
        r += cycle.initial;
        bottom += r;
    }
    // Back boring of Fanuc cuts upwards, from R to Z, and always goes back to the first height.
    const bool cuts_upwards = motion == Code::G87 && bottom > r && !rules_.is_linuxcnc();
    if (bottom > r && !cuts_upwards &&
        !tolerate(Message::CycleUpsideDown, command.span, {name_of(motion)})) {
        return std::nullopt;
    }
    if (bottom == r) warn(Message::CycleDrillsNothing, command.span, {name_of(motion)});
    const bool to_r = state_.retract_to_r && !cuts_upwards;
    const double clear = to_r ? r : std::max(cycle.initial, r);
    // If the initial plane is above R and the tool is below R, LinuxCNC moves to the next hole and
    // up to R in a single move. Fanuc moves across first; a different reading would hide obstacles.
    const bool slants = !rules_.macro_b;
    if (slants ? cycle.initial < r && (rules_.strict || height != r) : height < r) {
        Axes up = state_.position;
        up[depth_axis] = r;
        path_.linear_move(state_, up, MoveKind::Rapid, 1U << depth_axis);
    }
    const double now = state_.position[depth_axis];
    const double across = slants && !(now > r) ? clear : now;
    return Drilling{motion, depth_axis, r, bottom, clear, across};
}

/// Moves over the hole at the height of `drilling`, down to R, and drills the hole.
bool Machine::hole_at(Drilling& drilling, const Axes& hole, AxisMask mask) {
    const std::size_t depth_axis = drilling.depth_axis;
    Axes above = hole;
    above[depth_axis] = drilling.height;
    const bool rises = drilling.height != state_.position[depth_axis];
    path_.linear_move(state_, above, MoveKind::Rapid, rises ? mask | 1U << depth_axis : mask);
    drilling.height = drilling.clear;
    if (above[depth_axis] != drilling.r) {
        above[depth_axis] = drilling.r;
        const SpindleTurning turning = state_.spindle;
        if (drilling.motion == Code::G87 && drilling.bottom > drilling.r) orient_in_cycle();
        path_.linear_move(state_, above, MoveKind::Rapid, 1U << depth_axis);
        restart_spindle(turning);
    }
    return drill(drilling, above);
}

/// Stops the spindle in a fixed direction, with the tool aside by Q.
void Machine::orient_in_cycle() {
    state_.spindle = SpindleTurning::Stopped;
    state_.spindle_oriented = true;
    state_.steps_aside = state_.cycle.q > 0.0;
}

void Machine::restart_spindle(SpindleTurning turning) {
    state_.spindle = turning;
    state_.spindle_oriented = false;
    state_.steps_aside.reset();
}

/// Returns the depths of the pecks above the bottom; nullopt if there are too many.
std::optional<std::vector<double>> Machine::peck_depths(double r, double bottom) const {
    constexpr double kMostPecks = 100'000.0;
    constexpr double kPeckRounding = 1e-9;  // A last peck of this size is a rounding error.
    const CycleState& cycle = state_.cycle;
    std::vector<double> depths;
    if (cycle.first_peck > 0.0) {
        double peck = cycle.first_peck;
        const double least = cycle.least_peck > 0.0 ? cycle.least_peck : cycle.first_peck;
        if ((r - bottom) / least > kMostPecks) return std::nullopt;
        double depth = r - peck;
        while (depth > bottom + kPeckRounding) {
            depths.push_back(depth);
            peck = std::max(peck - cycle.peck_reduction, std::min(least, cycle.first_peck));
            depth -= peck;
        }
        return depths;
    }
    const double q = cycle.q > 0.0 ? cycle.q : r - bottom;
    if (q > 0.0 && (r - bottom) / q > kMostPecks) return std::nullopt;
    for (int i = 1; q > 0.0 && r - i * q > bottom + kPeckRounding; ++i)
        depths.push_back(r - i * q);
    return depths;
}

/// Drills from R above the hole to the bottom and retracts to the clear height.
bool Machine::drill(const Drilling& drilling, const Axes& above) {
    const Code motion = drilling.motion;
    const std::size_t depth_axis = drilling.depth_axis;
    const double r = drilling.r;
    const double bottom = drilling.bottom;
    const double clear = drilling.clear;
    const AxisMask mask = 1U << depth_axis;
    const auto to = [&](double height, MoveKind kind) {
        Axes end = above;
        end[drilling.depth_axis] = height;
        path_.linear_move(state_, end, kind, mask);
    };
    const CycleState& cycle = state_.cycle;
    const SpindleTurning turning = state_.spindle;
    const double seconds = cycle.p;

    if (motion == Code::G73 || motion == Code::G83) {
        const double clearance = options_.peck_clearance.value_or(0.254 / state_.unit_mm());
        const double highest = options_.peck_clearance ? bottom + 1e12 : r;
        const std::optional<std::vector<double>> depths = peck_depths(r, bottom);
        if (!depths) return fail(Message::CycleRepeats, SourceSpan{});
        for (const double depth : *depths) {
            to(depth, MoveKind::Feed);
            if (motion == Code::G83) {
                to(r, MoveKind::Rapid);
                to(std::min(depth + clearance, highest), MoveKind::Rapid);
            } else {
                to(std::min(depth + clearance, highest), MoveKind::Rapid);
            }
        }
        to(bottom, MoveKind::Feed);
        if (cycle.p > 0.0 && !rules_.is_linuxcnc()) path_.dwell(state_, seconds);
        to(clear, MoveKind::Rapid);
        return true;
    }
    to(bottom, MoveKind::Feed);
    switch (motion) {
        case Code::G81: to(clear, MoveKind::Rapid); break;
        case Code::G82:
            path_.dwell(state_, seconds);
            to(clear, MoveKind::Rapid);
            break;
        case Code::G74:
        case Code::G84:
            state_.spindle =
                motion == Code::G84 ? SpindleTurning::Counterclockwise : SpindleTurning::Clockwise;
            path_.dwell(state_, seconds);
            to(clear, MoveKind::Feed);
            state_.spindle = turning;
            break;
        case Code::G85:
            to(r, MoveKind::Feed);
            if (clear != r) to(clear, MoveKind::Rapid);
            break;
        case Code::G76:
        case Code::G86:
        case Code::G87:
        case Code::G88:
            // The spindle stops (G76: also orients, then moves aside by Q), and the tool retracts.
            if (cycle.has_p) path_.dwell(state_, seconds);
            state_.spindle = SpindleTurning::Stopped;
            if (motion == Code::G76 || (motion == Code::G87 && bottom > r)) orient_in_cycle();
            to(clear, MoveKind::Rapid);
            restart_spindle(turning);
            break;
        case Code::G89:
            path_.dwell(state_, seconds);
            to(clear, MoveKind::Feed);
            break;
        default: break;
    }
    return true;
}

}  // namespace ncsim::gcode
