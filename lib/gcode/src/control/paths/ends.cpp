// SPDX-License-Identifier: GPL-3.0-or-later
//
// End positions from the words of a block; threads and probing.
#include "ncsim/base/angles.h"

#include "control/paths/path_steps.h"

#include <cmath>

namespace ncsim::gcode {
namespace {

/// Returns the end of a rotary move from `at` to `value`: `value` itself (RotaryWay::Linear), or
/// plus whole turns as the rotary way of the axis requires. A repeated value gives the same end, so
/// no move.
double rotary_end(std::size_t axis, double value, double at, const Setup& setup) {
    constexpr double kTurn = 360.0;
    const RotaryWay way = setup.options.rotary_ways[axis - kA];
    const double place = way == RotaryWay::Sign ? std::abs(value) : value;
    const auto after = [place](double turns) { return place + kTurn * turns; };
    // The first candidate that is not below `at`.
    double turns = std::ceil((at - place) / kTurn);
    if (after(turns - 1) >= at) turns -= 1;
    if (after(turns) < at) turns += 1;
    switch (way) {
        case RotaryWay::Linear: break;
        case RotaryWay::Shortest: return after(after(turns) - at > kTurn / 2 ? turns - 1 : turns);
        case RotaryWay::Sign:
            return after(std::signbit(value) && after(turns) != at ? turns - 1 : turns);
        case RotaryWay::Positive: return after(turns);
    }
    return value;
}

/// Returns the radius and the angle of the tool about the pole of G16: those of the last words if
/// the tool is still there.
MachineState::PolarWords polar_place(const MachineState& state, double x, double y) {
    constexpr double kSame = 1e-6;
    if (const auto& words = state.polar_words) {
        const SinCos direction = sin_cos(words->angle);
        if (std::abs(words->radius * direction.cos - x) < kSame &&
            std::abs(words->radius * direction.sin - y) < kSame)
            return *words;
    }
    return {hypotenuse(x, y), angle_of(x, y)};
}

/// Converts "@" (radius) and "^" (angle) of RS274/NGC, about the origin.
void polar_letters(const MachineState& state, const Command& command, const Axes& at, Axes& end,
                   AxisMask& mask) {
    const PlaneAxes axes = axes_of(state.plane);
    double radius = hypotenuse(at[axes.first], at[axes.second]);
    double angle = angle_of(at[axes.first], at[axes.second]);
    if (command.has('@')) radius = state.incremental ? radius + command['@'] : command['@'];
    if (command.has('^')) angle = state.incremental ? angle + command['^'] : command['^'];
    const SinCos direction = sin_cos(angle);
    end[axes.first] = radius * direction.cos;
    end[axes.second] = radius * direction.sin;
    mask |= 1U << axes.first | 1U << axes.second;
}

/// Converts polar words under G16: the first axis word of the plane is a radius, the second an
/// angle. A missing word keeps its last value. An incremental radius begins at the tool.
void polar_ends(MachineState& state, const Command& command, const Axes& at, Axes& end,
                AxisMask& mask, Context& context) {
    const PlaneAxes axes = axes_of(state.plane);
    const AxisMask both = 1U << axes.first | 1U << axes.second;
    if ((mask & both) == 0) return;
    const ProgrammedTransform& frame = state.frames.programmed;
    const bool has_radius = (mask & 1U << axes.first) != 0;
    const bool has_angle = (mask & 1U << axes.second) != 0;
    double pole_1 = frame.pole_1;
    double pole_2 = frame.pole_2;
    MachineState::PolarWords place =
        polar_place(state, at[axes.first] - pole_1, at[axes.second] - pole_2);
    if (has_angle) {
        const double angle = command[kAxisNames[axes.second]];
        place.angle = state.incremental ? place.angle + angle : angle;
    }
    if (has_radius) {
        place.radius = command[kAxisNames[axes.first]];
        if (state.incremental) {
            pole_1 = at[axes.first];
            pole_2 = at[axes.second];
        }
        if (state.incremental && has_angle) warn(context, Message::PolarIncrement, command.span);
    }
    const SinCos direction = sin_cos(place.angle);
    end[axes.first] = pole_1 + place.radius * direction.cos;
    end[axes.second] = pole_2 + place.radius * direction.sin;
    mask |= both;
    if (has_radius && state.incremental) {
        state.polar_words.reset();
    } else {
        state.polar_words = place;
    }
}

}  // namespace

void mark_known(MachineState& state, std::size_t axis) {
    state.place_frame[axis] = state.frame[axis];
    state.known[axis] = true;
}

void note_length(MachineState& state) {
    if (state.first_length_seen) return;
    state.first_length_seen = true;
    state.first_length_in_inches = state.inches;
}

bool is_modal_arc(const MachineState& state, const Command& command) {
    return (state.motion == Code::G2 || state.motion == Code::G3) &&
           command.has_any(letters('I', 'J', 'K')) && command.group(Group::OneShot) == Code::None;
}

bool needs_feed(const MachineState& state, const Command& command, std::string_view what,
                Context& context) {
    if (state.feed_mode == FeedMode::InverseTime) {
        if (command.has('F')) return true;
        return fail(context, Message::InverseTimeFeed, command.span, {what});
    }
    if (context.rules.strict && state.feed_mode == FeedMode::PerRevolution &&
        state.spindle_rpm == 0.0) {
        return lacks(context, command, "a feed per revolution", "a spindle speed (S)");
    }
    if (state.feed > 0.0) return true;
    return tolerate(context, Message::FeedMissing, command.span, {what});
}

bool find_ends(MachineState& state, const Command& command, Axes& end, AxisMask& mask,
               Context& context) {
    mask = 0;
    const bool machine = command.group(Group::OneShot) == Code::G53;
    if (machine && state.incremental && !tolerate(context, Message::G53Incremental, command.span)) {
        return false;
    }
    constexpr std::uint32_t kPolarLetters = letters('@', '^');
    const bool transformed = state.frames.programmed.changes_places();
    const bool incremental = state.incremental && !machine;
    Axes at = machine ? state.machine_position() : state.position;
    if (transformed && !machine) at = state.frames.programmed.remove(at);
    end = at;
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        if (!command.has(kAxisNames[i])) continue;
        double value = command[kAxisNames[i]];
        if (state.polar_interpolation && i == kC && !machine) {  // A length, normal to X.
            mask |= 1U << kY;
            end[kY] = incremental ? at[kY] + value : value;
            continue;
        }
        mask |= 1U << i;
        if (i == kX && state.lathe_diameter) value /= 2.0;
        end[i] = incremental ? at[i] + value : value;
        if (is_rotary(i) && !incremental) end[i] = rotary_end(i, value, at[i], context);
    }
    if (!machine && command.has_any(kPolarLetters)) {
        polar_letters(state, command, at, end, mask);
    } else if (!machine && state.frames.programmed.polar) {
        polar_ends(state, command, at, end, mask, context);
    }
    if (machine) {
        end = state.frames.from_machine(end);
    } else if (transformed) {
        end = state.frames.programmed.apply(end);
    }
    return true;
}

bool cut_thread(MachineState& state, const Command& command, Code motion, Context& context) {
    if (!command.has('K') &&
        !tolerate(context, Message::PitchMissing, command.span, {name_of(motion)})) {
        return false;
    }
    Axes end{};
    AxisMask mask = 0;
    const Axes start = state.position;
    if (!find_ends(state, command, end, mask, context)) return false;
    if (mask == 0) return fail(context, Message::AxesMissing, command.span, {name_of(motion)});
    const double feed = state.feed;
    const FeedMode mode = state.feed_mode;
    state.feed = command.get('K', 0.0);
    state.feed_mode = FeedMode::PerRevolution;
    context.path.linear_move(state, end, MoveKind::Feed, mask);
    if (motion == Code::G33_1) {
        // The spindle reverses at the bottom, and again at the start.
        const SpindleTurning turning = state.spindle;
        if (turning != SpindleTurning::Stopped) {
            state.spindle = turning == SpindleTurning::Clockwise ? SpindleTurning::Counterclockwise
                                                                 : SpindleTurning::Clockwise;
        }
        context.path.linear_move(state, start, MoveKind::Feed, mask);
        state.spindle = turning;
    }
    state.feed = feed;
    state.feed_mode = mode;
    return true;
}

bool probe_move(ControlState& control, const Command& command, Code motion, Context& context) {
    MachineState& state = control.machine;
    if (!command.axis_words) {
        return fail(context, Message::AxesMissing, command.span, {name_of(motion)});
    }
    if (!needs_feed(state, command, name_of(motion), context)) return false;
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(state, command, end, mask, context)) return false;
    if (context.rules.strict && end == state.position) {
        return lacks(context, command, name_of(motion), "a target other than its start");
    }
    warn(context, Message::ProbeAssumed, command.span, {name_of(motion)});
    context.path.linear_move(state, end, MoveKind::Probe, mask);
    control.store.change().probed = state.position;
    control.store.change().has_probed = true;
    return true;
}

}  // namespace ncsim::gcode
