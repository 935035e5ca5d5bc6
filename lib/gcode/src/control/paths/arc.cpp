// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3: arcs by centre or radius, helices, several turns, full circles, in every plane.
#include "ncsim/base/angles.h"
#include "ncsim/gcode/print.h"

#include "control/machine.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

/// Largest difference between the radii at start and end that a control accepts: limits of
/// LinuxCNC, in program units.
struct RadiusTolerance {
    double absolute;
    static constexpr double kRelative = 0.001;
    static constexpr double kLargest = 100.0;  // Factor of `absolute`, for any radius.
    bool allows(double r1, double r2) const {
        const double difference = std::abs(r1 - r2);
        if (difference > kLargest * absolute) return false;
        return difference <= absolute || difference <= kRelative * std::max(r1, r2);
    }
};
constexpr RadiusTolerance kMetric{0.0283};
constexpr RadiusTolerance kInch{0.00283};

/// Smallest radius of a circle, and largest excess of half the chord over R: 0.00127 mm = 0.00005
/// inch.
constexpr double kMinArcRadius = 0.00127;

constexpr char centre_letter(std::size_t axis) {
    constexpr char kLetters[] = {'I', 'J', 'K'};
    return kLetters[axis % 3];  // U V W planes use I J K.
}

std::string number(double value) {
    std::string out;
    print_number(out, std::round(value * 1e6) / 1e6);
    return out;
}

}  // namespace

bool Machine::arc(const Command& command, bool clockwise) {
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state_.plane);
    const char c1 = centre_letter(axes.first);
    const char c2 = centre_letter(axes.second);
    const char c3 = centre_letter(axes.third);
    const bool has_centre = command.has(c1) || command.has(c2);
    if (state_.cylinder && command.has("ABC"[state_.cylinder->axis - kA]))
        return arc_on_cylinder(command, clockwise);
    if (!command.axis_words && !has_centre && !command.has('R')) {
        if (!rules_.strict) return true;  // Only sets the mode.
        return fail(Message::AxesMissing, command.span, {name});
    }
    if (command.has(c3) && (command[c3] != 0.0 || rules_.strict)) {
        if (!tolerate(Message::CentreOutsidePlane, span_of(command, c3), {{&c3, 1}, name}))
            return false;
    }
    if (!has_centre && !command.has('R')) {
        return fail(Message::ArcWithoutCentre, command.span, {name, {&c1, 1}, {&c2, 1}});
    }
    if (has_centre && command.has('R') &&
        !tolerate(Message::ArcTwoForms, span_of(command, 'R'), {name})) {
        return false;
    }
    ProgramArc out;
    AxisMask mask = 0;
    if (!find_ends(command, out.end, mask)) return false;
    bool turns_clockwise = clockwise;
    const ProgrammedTransform& t = state_.frames.programmed;
    if (t.scaled && t.scale[axes.first % 3] * t.scale[axes.second % 3] < 0.0) {
        turns_clockwise = !turns_clockwise;  // Mirrored.
    }
    const bool by_radius = command.has('R') && !has_centre;
    if (by_radius ? !arc_by_radius(command, turns_clockwise, out)
                  : !arc_by_centre(command, turns_clockwise, out)) {
        return false;
    }
    int turns = 1;
    if (command.has('P')) {
        const double p = command['P'];
        if (p < 1.0 || p > 1e6 || std::abs(p - std::round(p)) > 1e-4) {
            if (!tolerate(Message::ArcTurns, span_of(command, 'P'))) return false;
        } else {
            turns = static_cast<int>(std::lround(p));
        }
    }
    out.turns = turns_clockwise ? -turns : turns;
    const double radius = hypotenuse(state_.position[axes.first] - out.centre_1,
                                     state_.position[axes.second] - out.centre_2);
    if (radius * state_.unit_mm() < kMinArcRadius) {
        if (!tolerate(Message::ArcTooSmall, command.span, {name})) return false;
        return feed_straight(out.end, MoveKind::Feed, mask);
    }
    if (outline_) return record_outline_move(out.end, &out);
    out.is_open = by_radius;
    if (is_huge(out, radius) && !rules_.is_linuxcnc()) {
        out.is_open = true;
        if (!by_radius) shorten(out, radius, name, command.span);
        if (is_straight(out, radius)) return feed_straight(out.end, MoveKind::Feed, mask);
    }
    const bool is_first = !compensation_.is_on() || rules_.is_linuxcnc();
    if (is_first && state_.just_left_compensation &&
        !tolerate(Message::CompensationExit, command.span))
        return false;
    state_.just_left_compensation = false;
    if (control_.corner) {
        const Axes corner = state_.position;
        if (!cut_corner(out.end, &out)) return false;
        out.is_open = out.is_open || state_.position != corner;
        // The corner consumes the whole arc.
        if (out.is_open && state_.position == out.end && command.corner == 0) return true;
    }
    if (command.corner != 0 && command.corner_size != 0.0)
        return hold_corner(command, out.end, mask, &out);
    return make_arc(out, mask);
}

/// True if `arc` is not a full circle and the radius exceeds the travel of any machine.
bool Machine::is_huge(const ProgramArc& arc, double radius) const {
    constexpr double kHuge = 1e4;  // mm
    const PlaneAxes axes = axes_of(state_.plane);
    return radius * state_.unit_mm() > kHuge && std::abs(arc.turns) == 1 &&
           (arc.end[axes.first] != state_.position[axes.first] ||
            arc.end[axes.second] != state_.position[axes.second]);
}

/// True if the angle of the short way is within the rounding of angles.
bool Machine::is_straight(const ProgramArc& arc, double radius) const {
    constexpr double kLeastTurn = 1e-9;  // Radians; the chord deviates by at most length × angle.
    const PlaneAxes axes = axes_of(state_.plane);
    const double chord = hypotenuse(arc.end[axes.first] - state_.position[axes.first],
                                    arc.end[axes.second] - state_.position[axes.second]);
    return chord < kLeastTurn * radius && !takes_long_way(arc);
}

/// True if `arc` turns by more than half a circle.
bool Machine::takes_long_way(const ProgramArc& arc) const {
    const PlaneAxes axes = axes_of(state_.plane);
    const double dx = arc.end[axes.first] - state_.position[axes.first];
    const double dy = arc.end[axes.second] - state_.position[axes.second];
    const double cx = arc.centre_1 - state_.position[axes.first];
    const double cy = arc.centre_2 - state_.position[axes.second];
    // The centre is left of the chord if the short way is counter-clockwise.
    const double side = dx * cy - dy * cx;
    return arc.turns > 0 ? side < 0.0 : side > 0.0;
}

/// Makes `arc` take the short way. Rounding in a CAM system can put the centre on the wrong side of
/// a chord, and controls execute such arcs differently.
void Machine::shorten(ProgramArc& arc, double radius, std::string_view name, SourceSpan span) {
    if (!takes_long_way(arc)) return;
    warn(Message::ArcLongWay, span, {name, number(radius)});
    arc.turns = -arc.turns;
}

bool Machine::arc_by_radius(const Command& command, bool clockwise, ProgramArc& arc) {
    const PlaneAxes axes = axes_of(state_.plane);
    const double x0 = state_.position[axes.first];
    const double y0 = state_.position[axes.second];
    const double dx = arc.end[axes.first] - x0;
    const double dy = arc.end[axes.second] - y0;
    const double chord = hypotenuse(dx, dy);
    double r = command['R'];
    if (state_.frames.programmed.scaled)
        r *= std::abs(state_.frames.programmed.scale[axes.first % 3]);
    if (chord * state_.unit_mm() < 1e-9) {
        return fail(Message::ArcRadiusNoChord, span_of(command, 'R'));
    }
    const double half = chord / 2.0;
    const double limit = kMinArcRadius / state_.unit_mm();
    double height = 0.0;  // Distance of the centre from the chord.
    if (half > std::abs(r) + limit) {
        // CAM systems round R; non-strict controls use a semicircle.
        const double excess = (half - std::abs(r)) * state_.unit_mm();
        if (rules_.strict || excess > 0.05) {
            return fail(Message::ArcRadiusTooSmall, span_of(command, 'R'),
                        {number(r), number(half)});
        }
        warn(Message::ArcRadiusTooSmall, span_of(command, 'R'), {number(r), number(half)});
    } else if (half / std::abs(r) < 1.0 - 1e-12) {
        height = std::sqrt((std::abs(r) - half) * (std::abs(r) + half));
    }
    // The centre is left of the chord if the shorter way is counter-clockwise.
    const bool left = clockwise == (r < 0.0);
    const double side = left ? height / chord : -height / chord;
    arc.centre_1 = x0 + dx / 2.0 - dy * side;
    arc.centre_2 = y0 + dy / 2.0 + dx * side;
    return true;
}

/// Decides whether I, J, K of the program are absolute or incremental. Old post processors write
/// absolute values without G90.1.
void Machine::settle_centres(bool fits_incremental, bool fits_absolute, bool are_equal,
                             SourceSpan span) {
    if (fits_incremental != fits_absolute)
        ++(fits_absolute ? centres_.absolute : centres_.incremental);
    // Arcs that fit only incremental centres, the default of all controls, need no second pass.
    if (centres_.counts_only || !fits_absolute || are_equal) return;
    centres_.is_settled = true;
    if (!centres_.are_absolute || !centres_.are_absolute()) return;
    state_.absolute_centres = true;
    warn(Message::ArcCentreMode, span);
}

bool Machine::arc_by_centre(const Command& command, bool clockwise, ProgramArc& arc) {
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state_.plane);
    const char c1 = centre_letter(axes.first);
    const char c2 = centre_letter(axes.second);
    const double x0 = state_.position[axes.first];
    const double y0 = state_.position[axes.second];
    const double x1 = arc.end[axes.first];
    const double y1 = arc.end[axes.second];
    const Axes start = to_programmed(state_.position);
    const bool transformed = state_.frames.programmed.changes_places();

    const auto centre = [&](bool absolute) {
        double cx = command.get(c1, absolute ? start[axes.first] : 0.0);
        double cy = command.get(c2, absolute ? start[axes.second] : 0.0);
        if (state_.lathe_diameter && axes.first == kX && absolute) cx /= 2.0;
        if (!absolute) {
            cx += start[axes.first];
            cy += start[axes.second];
        }
        if (transformed) {
            Axes c = start;
            c[axes.first] = cx;
            c[axes.second] = cy;
            c = from_programmed(c);
            cx = c[axes.first];
            cy = c[axes.second];
        }
        arc.centre_1 = cx;
        arc.centre_2 = cy;
    };
    const RadiusTolerance& tolerance = state_.inches ? kInch : kMetric;
    const auto fits = [&] {
        return tolerance.allows(hypotenuse(x0 - arc.centre_1, y0 - arc.centre_2),
                                hypotenuse(x1 - arc.centre_1, y1 - arc.centre_2));
    };
    if (state_.absolute_centres && rules_.strict && (!command.has(c1) || !command.has(c2))) {
        return fail(Message::ArcWithoutCentre, command.span, {name, {&c1, 1}, {&c2, 1}});
    }
    // The start of an arc after an error may be wrong, so the arc is no evidence.
    if (!rules_.strict && !centres_.is_settled && log_.errors() == 0) {
        centre(true);
        const Vec2 absolute{arc.centre_1, arc.centre_2};
        const bool fits_absolute = fits();
        centre(false);
        settle_centres(fits(), fits_absolute,
                       absolute.x == arc.centre_1 && absolute.y == arc.centre_2, command.span);
        if (centres_.counts_only) return true;
    }
    centre(state_.absolute_centres);
    if (fits()) return true;
    const double r0 = hypotenuse(x0 - arc.centre_1, y0 - arc.centre_2);
    const double r1 = hypotenuse(x1 - arc.centre_1, y1 - arc.centre_2);
    if (!rules_.strict) {
        // grbl and most controls accept the difference and make a spiral.
        const double difference = std::abs(r0 - r1);
        const double mm = difference * state_.unit_mm();
        if (mm <= 0.1 || (mm <= 0.5 && difference <= 0.05 * std::max(r0, r1))) {
            warn(Message::ArcSpiral, command.span, {name, number(r0), number(r1)});
            return true;
        }
    }
    return fail(Message::ArcRadiusMismatch, command.span, {name, number(r0), number(r1)});
}

}  // namespace ncsim::gcode
