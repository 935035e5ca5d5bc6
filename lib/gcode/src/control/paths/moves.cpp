// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves of a block: end positions from the words, and the motion to the end.
#include "ncsim/base/angles.h"

#include "control/machine.h"

#include <algorithm>
#include <cmath>

namespace ncsim::gcode {

bool Machine::move(const Command& command, Code motion) {
    const Code one_shot = command.group(Group::OneShot);
    // The time of G4 is P, or otherwise the first of X, U, F and S. With P, X belongs to the
    // motion.
    const bool dwells = one_shot == Code::G4 && !rules_.strict && letter_of_dwell(command) != 'P';
    const bool words_taken =
        (command.axes_are_taken() && !moves_by_new_length(command, motion)) || dwells;
    if (is_speed_mode(command, motion)) return true;
    if (const Code code = command.group(Group::HolePattern); code != Code::None) {
        return hole_pattern(command, code, words_taken);
    }
    if (const Code code = command.group(Group::Pocket); code != Code::None) {
        if (code == Code::G150)
            return area_pocket(command, command.group(Group::CutterSide), words_taken);
        return pocket(command, code, words_taken);
    }
    // G5 and G5.1 are no motion mode of LinuxCNC: the next block without a code moves as before.
    const bool is_modal =
        (motion != Code::G5 && motion != Code::G5_1) || rules_.dialect == Dialect::Grbl;
    if (!is_modal) {
        if (words_taken) return true;
    } else if (motion != Code::None) {
        state_.motion = motion;
        if (motion == Code::G0 || motion == Code::G1) state_.last_straight = motion;
        if (!is_cycle(motion)) end_cycle();
        if (motion == Code::G80) {
            if (!command.axis_words || words_taken) return true;
            if (rules_.strict) return fail(Message::AxesWithoutMotion, command.span);
            // Other controls continue with the last G0 or G1: "G80 Z50."
            motion = state_.last_straight;
            note_move_after_cycle(command, motion);
        } else if (words_taken) {
            return true;  // "G0 G28 Z0": the words belong to G28
        }
    } else {
        const bool knot = control_.curve.by_knots && command.has('K');  // Knot of G6.2.
        const bool by_vector = state_.by_vector && command.has_any(letters('I', 'J', 'K'));
        if ((!command.axis_words && !by_vector && !is_modal_arc(command) && !knot) || words_taken)
            return true;
        motion = state_.motion;
        if (motion == Code::None || motion == Code::G80) {
            if (rules_.strict) return fail(Message::AxesWithoutMotion, command.span);
            const bool start = motion == Code::None;
            motion = start ? Code::G0 : state_.last_straight;
            if (start) {
                state_.motion = Code::G0;
                warn(Message::AxesBeforeMotion, command.span, {name_of(motion)});
            } else {
                note_move_after_cycle(command, motion);
            }
        }
    }
    if (!distance_is_stated_) distance_.take(command, state_, {file_, command.span});
    if (!state_.first_length_seen && command.axis_words) {
        state_.first_length_seen = true;
        state_.first_length_in_inches = state_.inches;
    }
    state_.previous_was_spline = state_.previous_was_spline && motion == Code::G5;
    if (one_shot == Code::G53 && motion != Code::G0 && motion != Code::G1) {
        if (rules_.strict) return fail(Message::G53Motion, span_of_g(command, Code::G53));
        warn(Message::G53Motion, span_of_g(command, Code::G53));
        motion = Code::G0;
    }
    if (control_.curve.by_knots && motion != Code::G6_2) {
        curve_fails_ = true;
        return fail(Message::SplineKnots, command.span);
    }
    switch (motion) {
        case Code::G0: return linear_move(command, MoveKind::Rapid);
        case Code::G1: return needs_feed(command, "G1") && linear_move(command, MoveKind::Feed);
        case Code::G2: return needs_feed(command, "G2") && arc(command, true);
        case Code::G3: return needs_feed(command, "G3") && arc(command, false);
        case Code::G5:
        case Code::G5_1: return spline(command, motion);
        case Code::G5_2:
        case Code::G5_3: return nurbs(command, motion);
        case Code::G6_2: return nurbs_with_knots(command);
        case Code::G31:
        case Code::G38_2:
        case Code::G38_3:
        case Code::G38_4:
        case Code::G38_5: return probe(command, motion);
        case Code::G33:
        case Code::G33_1: return threading(command, motion);
        default: return cycle(command, motion);
    }
}

/// True for "G0 G43.1 Z5" on LinuxCNC, where Z is both the tool length and the target of G0.
bool Machine::moves_by_new_length(const Command& command, Code motion) const {
    return rules_.is_linuxcnc() && command.group(Group::ToolLength) == Code::G43_1 &&
           motion != Code::None && motion != Code::G80 &&
           command.group(Group::OneShot) == Code::None;
}

/// Reports axis words after G80, which move in the mode `motion`. G80 of Fanuc and Haas keeps G0 or
/// G1; for other controls G0 is the strictest reading. Only LinuxCNC refuses the words. A feed on a
/// control that may use G0 is a guess.
void Machine::note_move_after_cycle(const Command& command, Code motion) {
    const bool is_certain = rules_.macro_b || (motion == Code::G0 && !rules_.linuxcnc_planes);
    log_.add(is_certain ? Severity::Note : Severity::Warning, Message::AxesAfterG80, command.span,
             {name_of(motion)});
}

/// True for G5 P10000 and G5.1 Q1, modes of Fanuc and similar controls for high-speed machining,
/// which are no curves; the motion mode stays.
bool Machine::is_speed_mode(const Command& command, Code motion) const {
    if (rules_.strict || command.has_any(letters('I', 'J'))) return false;
    return (motion == Code::G5 && !command.axis_words) ||
           (motion == Code::G5_1 && (command.has('Q') || !command.axis_words));
}

/// True for "I-7.5 J0" alone: a full circle while G2 or G3 is active.
bool Machine::is_modal_arc(const Command& command) const {
    return (state_.motion == Code::G2 || state_.motion == Code::G3) &&
           command.has_any(letters('I', 'J', 'K')) && command.group(Group::OneShot) == Code::None;
}

bool Machine::needs_feed(const Command& command, std::string_view what) {
    if (state_.feed_mode == FeedMode::InverseTime) {
        if (command.has('F')) return true;
        return fail(Message::InverseTimeFeed, command.span, {what});
    }
    if (rules_.strict && state_.feed_mode == FeedMode::PerRevolution && state_.spindle_rpm == 0.0) {
        return lacks(command, "a feed per revolution", "a spindle speed (S)");
    }
    if (state_.feed > 0.0) return true;
    return tolerate(Message::FeedMissing, command.span, {what});
}

bool Machine::find_ends(const Command& command, Axes& end, AxisMask& mask) {
    mask = 0;
    const bool machine = command.group(Group::OneShot) == Code::G53;
    if (machine && state_.incremental && !tolerate(Message::G53Incremental, command.span)) {
        return false;
    }
    constexpr std::string_view kLetters = "XYZABCUVW";
    constexpr std::uint32_t kPolarLetters = letters('@', '^');
    const bool polar = state_.frames.programmed.polar || command.has_any(kPolarLetters);
    const bool transformed = state_.frames.programmed.changes_places();
    const bool incremental = state_.incremental && !machine;
    Axes at = machine ? machine_position() : state_.position;
    if (transformed && !machine) at = to_programmed(at);
    end = at;
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
        if (!command.has(kLetters[i])) continue;
        double value = command[kLetters[i]];
        if (state_.polar_interpolation && i == kC && !machine) {  // A length, normal to X.
            mask |= 1U << kY;
            end[kY] = incremental ? at[kY] + value : value;
            continue;
        }
        mask |= 1U << i;
        if (i == kX && state_.lathe_diameter) value /= 2.0;
        end[i] = incremental ? at[i] + value : value;
        if (is_rotary(i) && !incremental) end[i] = rotary_end(i, value, at[i]);
    }
    if (polar && !machine && !polar_ends(command, end, mask)) return false;
    if (machine) {
        end = from_machine(end);
    } else if (transformed) {
        end = from_programmed(end);
    }
    return true;
}

/// Returns the end of a rotary move from `at` to `value`: `value` itself (RotaryWay::Linear), or
/// plus whole turns as the rotary way of the axis requires. A repeated value gives the same end, so
/// no move.
double Machine::rotary_end(std::size_t axis, double value, double at) const {
    constexpr double kTurn = 360.0;
    const RotaryWay way = options_.rotary_ways[axis - kA];
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

/// Converts polar words. G16: the first axis word of the plane is a radius, the second an angle.
/// "@" and "^" of RS274/NGC have the same meaning without a mode, about the origin.
bool Machine::polar_ends(const Command& command, Axes& end, AxisMask& mask) {
    const PlaneAxes axes = axes_of(state_.plane);
    const Axes at = to_programmed(state_.position);
    const double x = at[axes.first];
    const double y = at[axes.second];
    double radius = hypotenuse(x, y);
    double angle = angle_of(x, y);
    const bool by_letters = command.has('@') || command.has('^');
    const auto take = [&](bool has, double value, double& what) {
        if (has) what = state_.incremental ? what + value : value;
    };
    if (by_letters) {
        take(command.has('@'), command['@'], radius);
        take(command.has('^'), command['^'], angle);
    } else {
        if ((mask & (1U << axes.first | 1U << axes.second)) == 0) return true;
        constexpr std::string_view kLetters = "XYZABCUVW";
        take((mask & 1U << axes.first) != 0, command[kLetters[axes.first]], radius);
        take((mask & 1U << axes.second) != 0, command[kLetters[axes.second]], angle);
    }
    const SinCos direction = sin_cos(angle);
    end[axes.first] = radius * direction.cos;
    end[axes.second] = radius * direction.sin;
    mask |= 1U << axes.first | 1U << axes.second;
    return true;
}

bool Machine::linear_move(const Command& command, MoveKind kind) {
    if (command.group(Group::OneShot) != Code::G53 || !hides_joints())
        return linear_move_as_specified(command, kind);
    const SavedCoordinates before = as_joints();
    const bool done = linear_move_as_specified(command, kind);
    resume(before);
    return done;
}

bool Machine::linear_move_as_specified(const Command& command, MoveKind kind) {
    Axes end{};
    AxisMask mask = 0;
    const bool by_vector = state_.by_vector && command.has_any(letters('I', 'J', 'K'));
    if (!command.axis_words && !by_vector) {
        // "G1" or "G1 F100" alone: the mode is already set.
        if (rules_.strict) path_.linear_move(state_, state_.position, kind, 0);
        return true;
    }
    if (!find_ends(command, end, mask)) return false;
    if (by_vector && !turn_to_vector(command, end, mask)) return false;
    const bool machine = command.group(Group::OneShot) == Code::G53;
    if (command.has_angle) {
        const PlaneAxes axes = axes_of(state_.plane);
        const bool named = (mask & (1U << axes.first | 1U << axes.second)) != 0;
        if (!named && !control_.corner) return hold_angle(command, end, mask);
        // The line before ends at the intersection.
        const bool meets = control_.corner && control_.corner->angle;
        if (!meets && !end_by_angle(command, end, mask)) return false;
    }
    if (control_.corner) {
        // Without the line before, this line begins at the tool.
        const bool meets = !control_.corner->angle || find_corner(command, end);
        if (meets && !cut_corner(end)) return false;
        // The line ends at the intersection.
        if (meets && end == state_.position && command.corner == 0) return true;
    }
    if (command.corner != 0 && command.corner_size != 0.0) return hold_corner(command, end, mask);
    if (!machine) follow_table(end, mask);
    if (state_.polar_interpolation && (mask & kRotaryAxes) != 0 && !machine)
        return fail(Message::PlaneForbids, command.span, {"a rotary axis"});
    if (state_.cylinder && !machine && (mask & 1U << state_.cylinder->axis) != 0) {
        if (compensation_.is_on())
            return fail(Message::ForbiddenWithCompensation, command.span, {"a cylinder (G7.1)"});
        return linear_move_on_cylinder(end, kind, mask);
    }
    const bool by_joints =
        state_.frames.tilt && state_.chosen == Coordinates::Axes && (mask & kRotaryAxes) != 0;
    if (by_joints && !machine) {
        if (compensation_.is_on())
            return fail(Message::ForbiddenWithCompensation, command.span, {"a rotary axis"});
        return linear_move_of_joints(end, kind, mask);
    }
    if (!machine) return feed_straight(end, kind, mask);
    path_.set_machine_coordinates(true);
    path_.linear_move(state_, end, kind, mask);
    path_.set_machine_coordinates(false);
    return true;
}

/// G33 is synchronised with the spindle; G33.1 taps and returns.
bool Machine::threading(const Command& command, Code motion) {
    if (!command.has('K') && !tolerate(Message::PitchMissing, command.span, {name_of(motion)})) {
        return false;
    }
    Axes end{};
    AxisMask mask = 0;
    const Axes start = state_.position;
    if (!find_ends(command, end, mask)) return false;
    if (mask == 0) return fail(Message::AxesMissing, command.span, {name_of(motion)});
    const double feed = state_.feed;
    const FeedMode mode = state_.feed_mode;
    state_.feed = command.get('K', 0.0);
    state_.feed_mode = FeedMode::PerRevolution;
    path_.linear_move(state_, end, MoveKind::Feed, mask);
    if (motion == Code::G33_1) path_.linear_move(state_, start, MoveKind::Feed, mask);
    state_.feed = feed;
    state_.feed_mode = mode;
    return true;
}

bool Machine::probe(const Command& command, Code motion) {
    if (!command.axis_words) {
        return fail(Message::AxesMissing, command.span, {name_of(motion)});
    }
    if (!needs_feed(command, name_of(motion))) return false;
    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(command, end, mask)) return false;
    if (rules_.strict && end == state_.position) {
        return lacks(command, name_of(motion), "a target other than its start");
    }
    warn(Message::ProbeAssumed, command.span, {name_of(motion)});
    path_.linear_move(state_, end, MoveKind::Probe, mask);
    control_.store.change().probed = state_.position;
    control_.store.change().has_probed = true;
    return true;
}

}  // namespace ncsim::gcode
