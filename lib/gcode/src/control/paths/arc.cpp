// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3: arcs by centre or radius, helices, several turns, full circles, in every plane.
#include "ncsim/base/angles.h"
#include "ncsim/gcode/print.h"

#include "control/paths/path_steps.h"

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

constexpr char centre_letter(std::size_t axis) {
    constexpr char kLetters[] = {'I', 'J', 'K'};
    return kLetters[axis % 3];  // U V W planes use I J K.
}

std::string number(double value) {
    std::string out;
    print_number(out, std::round(value * 1e6) / 1e6);
    return out;
}

/// True if `arc` turns by more than half a circle.
bool takes_long_way(const MachineState& state, const ProgramArc& arc) {
    const PlaneAxes axes = axes_of(state.plane);
    const double dx = arc.end[axes.first] - state.position[axes.first];
    const double dy = arc.end[axes.second] - state.position[axes.second];
    const double cx = arc.centre_1 - state.position[axes.first];
    const double cy = arc.centre_2 - state.position[axes.second];
    // The centre is left of the chord if the short way is counter-clockwise.
    const double side = dx * cy - dy * cx;
    return arc.turns > 0 ? side < 0.0 : side > 0.0;
}

/// Decides whether I, J, K of the program are absolute or incremental. Old post processors write
/// absolute values without G90.1.
void settle_centres(MachineState& state, bool fits_incremental, bool fits_absolute, bool are_equal,
                    SourceSpan span, Context& context) {
    if (fits_incremental != fits_absolute)
        ++(fits_absolute ? context.centres.absolute : context.centres.incremental);
    // Arcs that fit only incremental centres, the default of all controls, need no second pass.
    if (context.centres.counts_only || !fits_absolute || are_equal) return;
    context.centres.is_settled = true;
    if (!context.centres.are_absolute || !context.centres.are_absolute()) return;
    state.absolute_centres = true;
    warn(context, Message::ArcCentreMode, span);
}

bool arc_by_radius(const MachineState& state, const Command& command, bool clockwise,
                   ProgramArc& arc, Context& context) {
    const PlaneAxes axes = axes_of(state.plane);
    const double x0 = state.position[axes.first];
    const double y0 = state.position[axes.second];
    const double dx = arc.end[axes.first] - x0;
    const double dy = arc.end[axes.second] - y0;
    const double chord = hypotenuse(dx, dy);
    double r = command['R'];
    if (state.frames.programmed.scaled)
        r *= std::abs(state.frames.programmed.scale[axes.first % 3]);
    if (chord * state.unit_mm() < 1e-9) {
        return fail(context, Message::ArcRadiusNoChord, span_of(command, 'R'));
    }
    const double half = chord / 2.0;
    const double limit = kMinArcRadius / state.unit_mm();
    double height = 0.0;  // Distance of the centre from the chord.
    if (half > std::abs(r) + limit) {
        // CAM systems round R; non-strict controls use a semicircle.
        const double excess = (half - std::abs(r)) * state.unit_mm();
        if (context.rules.strict || excess > 0.05) {
            return fail(context, Message::ArcRadiusTooSmall, span_of(command, 'R'),
                        {number(r), number(half)});
        }
        warn(context, Message::ArcRadiusTooSmall, span_of(command, 'R'), {number(r), number(half)});
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

bool arc_by_centre(MachineState& state, const Command& command, bool clockwise, ProgramArc& arc,
                   Context& context) {
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state.plane);
    const char c1 = centre_letter(axes.first);
    const char c2 = centre_letter(axes.second);
    const double x0 = state.position[axes.first];
    const double y0 = state.position[axes.second];
    const double x1 = arc.end[axes.first];
    const double y1 = arc.end[axes.second];
    const Axes start = state.frames.programmed.remove(state.position);
    const bool transformed = state.frames.programmed.changes_places();

    const auto centre = [&](bool absolute) {
        double cx = command.get(c1, absolute ? start[axes.first] : 0.0);
        double cy = command.get(c2, absolute ? start[axes.second] : 0.0);
        if (state.lathe_diameter && axes.first == kX && absolute) cx /= 2.0;
        if (!absolute) {
            cx += start[axes.first];
            cy += start[axes.second];
        }
        if (transformed) {
            Axes c = start;
            c[axes.first] = cx;
            c[axes.second] = cy;
            c = state.frames.programmed.apply(c);
            cx = c[axes.first];
            cy = c[axes.second];
        }
        arc.centre_1 = cx;
        arc.centre_2 = cy;
    };
    const RadiusTolerance& tolerance = state.inches ? kInch : kMetric;
    const auto fits = [&] {
        return tolerance.allows(hypotenuse(x0 - arc.centre_1, y0 - arc.centre_2),
                                hypotenuse(x1 - arc.centre_1, y1 - arc.centre_2));
    };
    if (state.absolute_centres && context.rules.strict && (!command.has(c1) || !command.has(c2))) {
        return fail(context, Message::ArcWithoutCentre, command.span, {name, {&c1, 1}, {&c2, 1}});
    }
    // The start of an arc after an error may be wrong, so the arc is no evidence.
    if (!context.rules.strict && !context.centres.is_settled && context.log.errors() == 0) {
        centre(true);
        const Vec2 absolute{arc.centre_1, arc.centre_2};
        const bool fits_absolute = fits();
        centre(false);
        settle_centres(state, fits(), fits_absolute,
                       absolute.x == arc.centre_1 && absolute.y == arc.centre_2, command.span,
                       context);
        if (context.centres.counts_only) return true;
    }
    centre(state.absolute_centres);
    if (fits()) return true;
    const double r0 = hypotenuse(x0 - arc.centre_1, y0 - arc.centre_2);
    const double r1 = hypotenuse(x1 - arc.centre_1, y1 - arc.centre_2);
    if (!context.rules.strict) {
        // grbl and most controls accept the difference and make a spiral.
        const double difference = std::abs(r0 - r1);
        const double mm = difference * state.unit_mm();
        if (mm <= 0.1 || (mm <= 0.5 && difference <= 0.05 * std::max(r0, r1))) {
            warn(context, Message::ArcSpiral, command.span, {name, number(r0), number(r1)});
            return true;
        }
    }
    return fail(context, Message::ArcRadiusMismatch, command.span, {name, number(r0), number(r1)});
}

}  // namespace

bool is_huge(const MachineState& state, const ProgramArc& arc, double radius) {
    constexpr double kHuge = 1e4;  // mm
    const PlaneAxes axes = axes_of(state.plane);
    return radius * state.unit_mm() > kHuge && std::abs(arc.turns) == 1 &&
           (arc.end[axes.first] != state.position[axes.first] ||
            arc.end[axes.second] != state.position[axes.second]);
}

bool is_straight(const MachineState& state, const ProgramArc& arc, double radius) {
    constexpr double kLeastTurn = 1e-9;  // Radians; the chord deviates by at most length × angle.
    const PlaneAxes axes = axes_of(state.plane);
    const double chord = hypotenuse(arc.end[axes.first] - state.position[axes.first],
                                    arc.end[axes.second] - state.position[axes.second]);
    return chord < kLeastTurn * radius && !takes_long_way(state, arc);
}

void shorten(const MachineState& state, ProgramArc& arc, double radius, std::string_view name,
             SourceSpan span, Context& context) {
    if (!takes_long_way(state, arc)) return;
    warn(context, Message::ArcLongWay, span, {name, number(radius)});
    arc.turns = -arc.turns;
}

bool has_centre_words(const MachineState& state, const Command& command) {
    const PlaneAxes axes = axes_of(state.plane);
    return command.has(centre_letter(axes.first)) || command.has(centre_letter(axes.second));
}

bool read_arc(MachineState& state, const Command& command, bool clockwise, ProgramArc& out,
              AxisMask& mask, Context& context) {
    const std::string_view name = clockwise ? "G2" : "G3";
    const PlaneAxes axes = axes_of(state.plane);
    const char c1 = centre_letter(axes.first);
    const char c2 = centre_letter(axes.second);
    const char c3 = centre_letter(axes.third);
    const bool has_centre = has_centre_words(state, command);
    if (!command.axis_words && !has_centre && !command.has('R'))
        return fail(context, Message::AxesMissing, command.span, {name});
    if (command.has(c3) && (command[c3] != 0.0 || context.rules.strict)) {
        if (!tolerate(context, Message::CentreOutsidePlane, span_of(command, c3), {{&c3, 1}, name}))
            return false;
    }
    if (!has_centre && !command.has('R')) {
        return fail(context, Message::ArcWithoutCentre, command.span, {name, {&c1, 1}, {&c2, 1}});
    }
    // R takes precedence over I, J and K on Fanuc controls.
    const bool radius_counts = context.rules.dialect == Dialect::Fanuc && !context.rules.strict;
    if (has_centre && command.has('R') &&
        !tolerate(context, Message::ArcTwoForms, span_of(command, 'R'),
                  {name, radius_counts ? "radius" : "centre"})) {
        return false;
    }
    if (!find_ends(state, command, out.end, mask, context)) return false;
    bool turns_clockwise = clockwise;
    const ProgrammedTransform& t = state.frames.programmed;
    if (t.scaled && t.scale[axes.first % 3] * t.scale[axes.second % 3] < 0.0) {
        turns_clockwise = !turns_clockwise;  // Mirrored.
    }
    const bool by_radius = command.has('R') && (!has_centre || radius_counts);
    if (by_radius ? !arc_by_radius(state, command, turns_clockwise, out, context)
                  : !arc_by_centre(state, command, turns_clockwise, out, context)) {
        return false;
    }
    int turns = 1;
    if (command.has('P')) {
        const double p = command['P'];
        if (p < 1.0 || p > 1e6 || std::abs(p - std::round(p)) > 1e-4) {
            if (!tolerate(context, Message::ArcTurns, span_of(command, 'P'))) return false;
        } else {
            turns = static_cast<int>(std::lround(p));
        }
    }
    out.turns = turns_clockwise ? -turns : turns;
    out.is_open = by_radius;
    return true;
}

}  // namespace ncsim::gcode
