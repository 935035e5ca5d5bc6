// SPDX-License-Identifier: GPL-3.0-or-later
//
// Canned cycles, expanded into moves.
// Source: RS274/NGC version 3, section 3.5.16.
#include "control/cycles/cycle_steps.h"
#include "control/paths/path_steps.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {
namespace {

/// Checks the spindle as LinuxCNC does: taps need the right direction, and cycles that stop the
/// spindle need a turning spindle.
bool check_spindle(const MachineState& state, const Command& command, Code motion,
                   Context& context) {
    using enum SpindleTurning;
    const SpindleTurning turning = state.spindle;
    std::string_view wanted;
    if (motion == Code::G84 && turning != Clockwise) wanted = "M3";
    if (motion == Code::G74 && turning != Counterclockwise) wanted = "M4";
    const bool stops = motion == Code::G86 || motion == Code::G87 || motion == Code::G88;
    if (stops && turning == Stopped) wanted = "M3 or M4";
    return wanted.empty() ||
           fail(context, Message::CycleSpindle, command.span, {name_of(motion), wanted});
}

/// Stops the spindle in a fixed direction, with the tool aside by Q.
void orient_in_cycle(MachineState& state) {
    state.spindle = SpindleTurning::Stopped;
    state.spindle_oriented = true;
    state.steps_aside = state.cycle.q > 0.0;
}

void restart_spindle(MachineState& state, SpindleTurning turning) {
    state.spindle = turning;
    state.spindle_oriented = false;
    state.steps_aside.reset();
}

/// Returns the depths of the pecks above the bottom; nullopt if there are too many.
std::optional<std::vector<double>> peck_depths(const MachineState& state, double r, double bottom) {
    constexpr double kMostPecks = 100'000.0;
    constexpr double kPeckRounding = 1e-9;  // A last peck of this size is a rounding error.
    const CycleState& cycle = state.cycle;
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
bool drill(MachineState& state, const Drilling& drilling, const Axes& above, Context& context) {
    const Code motion = drilling.motion;
    const std::size_t depth_axis = drilling.depth_axis;
    const double r = drilling.r;
    const double bottom = drilling.bottom;
    const double clear = drilling.clear;
    const AxisMask mask = 1U << depth_axis;
    const auto to = [&](double height, MoveKind kind) {
        Axes end = above;
        end[drilling.depth_axis] = height;
        context.path.linear_move(state, end, kind, mask);
    };
    const CycleState& cycle = state.cycle;
    const SpindleTurning turning = state.spindle;
    const double seconds = cycle.p;
    // LinuxCNC feeds back to the clear height in G74, G84 and G89; Fanuc and Haas feed to R.
    const double fed_back = context.rules.macro_b ? r : clear;

    if (motion == Code::G73 || motion == Code::G83) {
        const double clearance = context.options.peck_clearance.value_or(0.254 / state.unit_mm());
        const double highest = context.options.peck_clearance ? bottom + 1e12 : r;
        const std::optional<std::vector<double>> depths = peck_depths(state, r, bottom);
        if (!depths) return fail(context, Message::CycleRepeats, SourceSpan{});
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
        if (cycle.p > 0.0 && !context.rules.is_linuxcnc()) context.path.dwell(state, seconds);
        to(clear, MoveKind::Rapid);
        return true;
    }
    const bool taps = motion == Code::G74 || motion == Code::G84;
    // Rigid tapping starts the spindle, and stops it at the end. Taps of Haas are always rigid.
    const bool is_rigid = turning == SpindleTurning::Stopped || state.rigid_tapping ||
                          context.rules.dialect == Dialect::Haas;
    if (taps && is_rigid && !context.rules.is_linuxcnc()) {
        state.spindle =
            motion == Code::G84 ? SpindleTurning::Clockwise : SpindleTurning::Counterclockwise;
    }
    to(bottom, MoveKind::Feed);
    switch (motion) {
        case Code::G81: to(clear, MoveKind::Rapid); break;
        case Code::G82:
            context.path.dwell(state, seconds);
            to(clear, MoveKind::Rapid);
            break;
        case Code::G74:
        case Code::G84:
            state.spindle =
                motion == Code::G84 ? SpindleTurning::Counterclockwise : SpindleTurning::Clockwise;
            context.path.dwell(state, seconds);
            to(fed_back, MoveKind::Feed);
            state.spindle = state.rigid_tapping ? SpindleTurning::Stopped : turning;
            if (fed_back != clear) to(clear, MoveKind::Rapid);
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
            if (cycle.has_p) context.path.dwell(state, seconds);
            state.spindle = SpindleTurning::Stopped;
            if (motion == Code::G76 || (motion == Code::G87 && bottom > r)) orient_in_cycle(state);
            to(clear, MoveKind::Rapid);
            restart_spindle(state, turning);
            break;
        case Code::G89:
            context.path.dwell(state, seconds);
            to(fed_back, MoveKind::Feed);
            if (fed_back != clear) to(clear, MoveKind::Rapid);
            break;
        default: break;
    }
    return true;
}

}  // namespace

double seconds_of(const Command& command, char letter, const Setup& setup) {
    const double value = command[letter];
    if (!setup.rules.dwell_milliseconds || letter != 'P') return value;
    const Word* word = find_word(*command.block, letter);
    const bool has_point =
        word && command.block->text.substr(word->span.column - 1, word->span.length).find('.') !=
                    std::string_view::npos;
    return has_point ? value : value / 1000.0;
}

bool cycle_words(MachineState& state, const Command& command, Code motion, Context& context) {
    CycleState& cycle = state.cycle;
    const PlaneAxes axes = axes_of(state.plane);
    const char depth = kAxisNames[axes.third];
    if (!cycle.running || cycle.code != motion) {
        const double initial = cycle.running ? cycle.initial : state.position[axes.third];
        if (!cycle.running || context.rules.strict) {
            // G74 and G84 of LinuxCNC dwell for the P of the last cycle with a P.
            const double p = cycle.p;
            cycle = {};
            if (context.rules.is_linuxcnc()) cycle.p = p;
        }
        cycle.initial = initial;
        cycle.running = true;
        cycle.code = motion;
    }
    if (command.has('R')) cycle.r = command['R'], cycle.has_r = true;
    if (command.has(depth)) cycle.z = command[depth], cycle.has_z = true;
    if (context.rules.macro_b && state.incremental) {
        // Fanuc and Haas store the data of holes as heights, independent of later G90 and G91.
        if (command.has('R')) cycle.r += cycle.initial;
        if (command.has(depth)) cycle.z += cycle.r;
    }
    if (command.has('P')) cycle.p = seconds_of(command, 'P', context), cycle.has_p = true;
    if (command.has('Q')) cycle.q = std::abs(command['Q']);
    if (command.has('Q') && command['Q'] < 0.0 && (motion == Code::G83 || motion == Code::G73) &&
        !tolerate(context, Message::NegativeValue, span_of(command, 'Q'), {"Q"})) {
        return false;
    }

    const std::string_view name = name_of(motion);
    if (context.rules.strict) {
        if (!check_spindle(state, command, motion, context)) return false;
        if (command.has_any(letters('A', 'B', 'C'))) {
            return fail(context, Message::CycleRotary, command.span, {name});
        }
        if (state.cutter_side != CutterSide::Off) {
            return fail(context, Message::ForbiddenWithCompensation, command.span, {name});
        }
        if (state.feed_mode == FeedMode::InverseTime) {
            return fail(context, Message::CycleInverseTime, command.span, {name});
        }
        if ((motion == Code::G82 || motion == Code::G86 || motion == Code::G88 ||
             motion == Code::G89) &&
            !cycle.has_p) {
            return fail(context, Message::CycleWordMissing, command.span, {name, "P"});
        }
    }
    if (!cycle.has_z)
        return fail(context, Message::CycleWordMissing, command.span, {name, {&depth, 1}});
    if (!cycle.has_r) {
        if (!tolerate(context, Message::CycleWordMissing, command.span, {name, "R"})) return false;
        cycle.r = state.incremental && !context.rules.macro_b ? 0.0 : state.position[axes.third];
        cycle.has_r = true;
    }
    const bool pecks = motion == Code::G83 || motion == Code::G73;
    if (pecks && command.has('Q')) cycle.first_peck = 0.0;
    if (pecks && context.rules.pecks_shrink && command.has('I')) {
        cycle.first_peck = std::abs(command['I']);
        cycle.peck_reduction = std::abs(command.get('J', 0.0));
        cycle.least_peck = std::abs(command.get('K', 0.0));
    }
    if (pecks && cycle.q <= 0.0 && cycle.first_peck <= 0.0 &&
        !tolerate(context, Message::CycleWordMissing, command.span, {name, "Q"})) {
        return false;
    }
    return true;
}

void end_cycle(MachineState& state, const Setup& setup) {
    const double p = state.cycle.p;
    state.cycle = {};
    state.rigid_tapping = false;
    if (setup.rules.is_linuxcnc()) state.cycle.p = p;
}

bool drills_again(const MachineState& state, const Command& command, const Setup& setup) {
    return setup.rules.drills_by_r && state.cycle.running && is_cycle(state.motion) &&
           command.group(Group::Motion) == Code::None && command.has('R') &&
           !command.axes_are_taken() && command.group(MGroup::Call) == kNone;
}

namespace {

/// Stores words of a block without a hole for the next block. Fanuc drops them.
bool keep_cycle_words(MachineState& state, const Command& command, std::string_view name,
                      Context& context) {
    if (context.rules.strict) return fail(context, Message::AxesMissing, command.span, {name});
    if (context.rules.drills_by_r) {
        for (const char letter : {'Q', 'P'}) {
            if (command.has(letter))
                warn(context, Message::CycleWordsLost, span_of(command, letter), {{&letter, 1}});
        }
        return true;
    }
    CycleState& cycle = state.cycle;
    if (!cycle.running) {
        cycle = {};
        cycle.running = true;
        cycle.initial = state.position[axes_of(state.plane).third];
    }
    cycle.code = state.motion;
    if (command.has('R')) cycle.r = command['R'], cycle.has_r = true;
    if (command.has('Q')) cycle.q = std::abs(command['Q']);
    if (command.has('P')) cycle.p = seconds_of(command, 'P', context), cycle.has_p = true;
    return true;
}

/// Reports a block of a modal cycle without a word of the plane, in which the manual of Haas has no
/// hole.
void note_cycle_without_place(const MachineState& state, const Command& command, Code motion,
                              Context& context) {
    if (!context.rules.holes_need_place || command.group(Group::Motion) != Code::None) return;
    const PlaneAxes axes = axes_of(state.plane);
    const bool has_place =
        command.has(kAxisNames[axes.first]) || command.has(kAxisNames[axes.second]);
    const bool turns = command.has_any(letters('A', 'B', 'C'));
    if (!has_place && !turns)
        warn(context, Message::CycleWithoutPlace, command.span, {name_of(motion)});
}

}  // namespace

bool drill_cycle(MachineState& state, const Command& command, Code motion, Context& context) {
    const std::string_view name = name_of(motion);
    if (motion == Code::G76 && (context.rules.strict || command.has('K'))) {
        context.stopped = true;
        return fail(context, Message::LatheCycle, command.span, {name});
    }
    const bool by_r = context.rules.drills_by_r && command.has('R');
    if (!command.axis_words && !by_r) return keep_cycle_words(state, command, name, context);
    note_cycle_without_place(state, command, motion, context);
    if (!needs_feed(state, command, name, context) || !cycle_words(state, command, motion, context))
        return false;

    const bool pecks = motion == Code::G83 || motion == Code::G73;
    if (command.has('K') && !context.rules.k_repeats && !(context.rules.pecks_shrink && pecks) &&
        !tolerate(context, Message::WordUnused, span_of(command, 'K'), {"K"}))
        return false;
    double repeats = 1.0;
    if (command.has('L')) {
        repeats = command['L'];
    } else if (context.rules.k_repeats && command.has('K')) {
        repeats = command['K'];
    }
    if (repeats < 1.0 && context.rules.strict)
        return fail(context, Message::CycleRepeats, span_of(command, 'L'));
    if (repeats < 1.0) return true;  // L0, K0 define the cycle only.
    if (repeats > 100'000.0) return fail(context, Message::CycleRepeats, span_of(command, 'L'));

    Axes hole{};
    AxisMask mask = 0;
    if (!hole_place(state, command, hole, mask, context)) return false;
    Axes step{};
    for (std::size_t i = 0; i < step.size(); ++i) {
        step[i] = state.incremental ? hole[i] - state.position[i] : 0.0;
    }
    std::optional<Drilling> drilling = begin_drilling(state, command, motion, context);
    if (!drilling) return false;
    for (int i = 0; i < static_cast<int>(repeats); ++i) {
        if (!hole_at(state, *drilling, hole, mask, context)) return false;
        const bool has_next = i + 1 < static_cast<int>(repeats);
        if (state.frames.programmed.polar) {  // A step of the angle is no fixed distance.
            if (has_next && !hole_place(state, command, hole, mask, context)) return false;
            continue;
        }
        for (std::size_t a = 0; a < hole.size(); ++a)
            hole[a] += step[a];
    }
    return true;
}

bool hole_place(MachineState& state, const Command& command, Axes& hole, AxisMask& mask,
                Context& context) {
    const std::size_t depth_axis = axes_of(state.plane).third;
    Command in_plane = command;
    in_plane.present &= ~(1U << letter_index(kAxisNames[depth_axis]));
    in_plane.axis_words = in_plane.has_any(kAxisLetters);
    return find_ends(state, in_plane, hole, mask, context);
}

/// Applies G51 to the heights of a cycle, and warns, because controls differ.
void scale_heights(const MachineState& state, const Command& command, Code motion, double& r,
                   double& bottom, Context& context) {
    const ProgrammedTransform& t = state.frames.programmed;
    const std::size_t axis = axes_of(state.plane).third;
    if (!t.scaled || axis >= t.scale.size() || t.scale[axis] == 1.0) return;
    const bool scales = context.rules.dialect != Dialect::Haas;
    warn(context, Message::CycleScaled, command.span,
         {name_of(motion), scales ? "they are scaled" : "they are not scaled"});
    if (!scales) return;
    for (double* const height : {&r, &bottom})
        *height = t.scale_centre[axis] + t.scale[axis] * (*height - t.scale_centre[axis]);
}

std::optional<Drilling> begin_drilling(MachineState& state, const Command& command, Code motion,
                                       Context& context) {
    const std::size_t depth_axis = axes_of(state.plane).third;
    const CycleState& cycle = state.cycle;
    const double height = state.position[depth_axis];
    double r = cycle.r;
    double bottom = cycle.z;
    if (state.incremental && !context.rules.macro_b) {
        r += cycle.initial;
        bottom += r;
    }
    scale_heights(state, command, motion, r, bottom, context);
    // Back boring of Fanuc cuts upwards, from R to Z, and always goes back to the first height.
    const bool cuts_upwards = motion == Code::G87 && bottom > r && !context.rules.is_linuxcnc();
    if (bottom > r && !cuts_upwards &&
        !tolerate(context, Message::CycleUpsideDown, command.span, {name_of(motion)})) {
        return std::nullopt;
    }
    if (bottom == r) warn(context, Message::CycleDrillsNothing, command.span, {name_of(motion)});
    const bool to_r = state.retract_to_r && !cuts_upwards;
    const double clear = to_r ? r : std::max(cycle.initial, r);
    // If the initial plane is above R and the tool is below R, LinuxCNC moves to the next hole and
    // up to R in a single move. Fanuc moves across first; a different reading would hide obstacles.
    const bool slants = !context.rules.macro_b;
    if (slants ? cycle.initial < r && (context.rules.strict || height != r) : height < r) {
        Axes up = state.position;
        up[depth_axis] = r;
        context.path.linear_move(state, up, MoveKind::Rapid, 1U << depth_axis);
    }
    const double now = state.position[depth_axis];
    const double across = slants && !(now > r) ? clear : now;
    return Drilling{motion, depth_axis, r, bottom, clear, across};
}

bool hole_at(MachineState& state, Drilling& drilling, const Axes& hole, AxisMask mask,
             Context& context) {
    const std::size_t depth_axis = drilling.depth_axis;
    Axes above = hole;
    above[depth_axis] = drilling.height;
    const bool rises = drilling.height != state.position[depth_axis];
    context.path.linear_move(state, above, MoveKind::Rapid, rises ? mask | 1U << depth_axis : mask);
    drilling.height = drilling.clear;
    if (above[depth_axis] != drilling.r) {
        above[depth_axis] = drilling.r;
        const SpindleTurning turning = state.spindle;
        if (drilling.motion == Code::G87 && drilling.bottom > drilling.r) orient_in_cycle(state);
        context.path.linear_move(state, above, MoveKind::Rapid, 1U << depth_axis);
        restart_spindle(state, turning);
    }
    return drill(state, drilling, above, context);
}

}  // namespace ncsim::gcode
