// SPDX-License-Identifier: GPL-3.0-or-later
//
// G12 and G13 of Haas: a circular pocket, clockwise and counter-clockwise, including cutter
// compensation. Each code acts in its block only.
#include "control/cycles/cycle_steps.h"
#include "control/frames/frame_steps.h"
#include "control/paths/path_steps.h"

#include <cmath>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

/// Limit above any real program; a larger number is a wrong word.
constexpr double kMostCircles = 100'000.0;

/// Mills the circles `radii` in the plane of `centre`, where the tool is before and after. Half
/// circles lead from the centre to a side, and between circles to the opposite side, always in the
/// same sense.
void mill_circles(MachineState& state, const Axes& centre, const std::vector<double>& radii,
                  bool clockwise, AxisMask mask, Context& context) {
    const int turns = clockwise ? -1 : 1;
    const Axes origin = state.frames.programmed.remove(centre);
    const auto offset_point = [&](double x) {
        Axes p = origin;
        p[kX] += x;
        p = state.frames.programmed.apply(p);
        p[kZ] = centre[kZ];
        return p;
    };
    const auto around = [&](const Axes& end, double about) {
        const Axes c = offset_point(about);
        context.path.arc(state, {end, c[kX], c[kY], turns}, mask);
    };
    double at = 0.0;
    for (const double radius : radii) {
        const double next = at > 0.0 ? -radius : radius;
        const Axes side = offset_point(next);
        around(side, (at + next) / 2.0);
        around(side, 0.0);
        at = next;
    }
    around(centre, at / 2.0);
}

}  // namespace

bool mill_pocket(ControlState& control, const Command& command, Code code, bool words_taken,
                 Context& context) {
    MachineState& state = control.machine;
    const SourceSpan span = span_of_g(command, code);
    const std::string_view name = name_of(code);
    const auto needs = [&](std::string_view what) {
        return fail(context, Message::PocketWord, span, {name, what});
    };
    if (control.compensation.is_on() || state.cutter_side != CutterSide::Off) {
        return fail(context, Message::ForbiddenWithCompensation, span, {name});
    }
    const Code motion = command.group(Group::Motion);
    const bool plain =
        motion == Code::None || motion == Code::G0 || motion == Code::G1 || motion == Code::G80;
    if (words_taken || !plain || command.group(Group::OneShot) != Code::None) {
        return needs("a block of its own");
    }
    if (state.feed_mode == FeedMode::InverseTime) {
        return fail(context, Message::CycleInverseTime, span, {name});
    }
    if (state.cycle.running && motion == Code::None) return needs("the drilling cycle ended (G80)");
    if (state.plane != Plane::XY) return needs("the XY plane (G17)");
    if (state.frames.programmed.scaled) return needs("scaling and mirroring off (G50)");
    if (!command.has('I')) return needs("the radius of the first circle (I)");
    const double first = command['I'];
    const double last = command.get('K', first);
    const double step = command.get('Q', 0.0);
    const double passes = command.get('L', 1.0);
    if (first <= 0.0) return needs("a radius (I) above 0");
    if (last < first) return needs("a finished radius (K) that is not below the first (I)");
    if (command.has('Q') && !command.has('K'))
        return needs("a finished radius (K) together with Q");
    if (last > first && step <= 0.0) return needs("an increment of the radius (Q) above 0");
    if (passes < 1.0 || passes != std::round(passes)) {
        return needs("a number of passes (L), whole, 1 or more");
    }
    const double circles = last > first ? (last - first) / step + 1.0 : 1.0;
    if (circles * passes > kMostCircles)
        return needs("fewer circles: Q is too small or L too large");
    if (!needs_feed(state, command, name, context)) return false;

    const double cutter = std::abs(radius_of_register(control, command, span, context));
    const double tiny = kMinArcRadius / state.unit_mm();
    if (first - cutter < tiny) return fail(context, Message::CompensationArc, span);
    std::vector<double> radii;
    // Computed by multiplication, not by repeated addition; a last step of rounding errors is no
    // circle.
    for (int i = 0; first + i * step < last - tiny; ++i)
        radii.push_back(first + i * step - cutter);
    radii.push_back(last - cutter);

    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(state, command, end, mask, context)) return false;
    if (motion != Code::None) state.motion = motion, state.cycle = {};
    if (motion == Code::G0 || motion == Code::G1) state.last_straight = motion;
    note_length(state);
    constexpr AxisMask kDepth = 1U << kZ;
    const double down = end[kZ] - state.position[kZ];
    Axes centre = end;
    centre[kZ] = state.position[kZ];
    if ((mask & ~kDepth) != 0)
        context.path.linear_move(state, centre, MoveKind::Rapid, mask & ~kDepth);
    // An axis with an unknown position stays unknown after the circles.
    AxisMask plane = 0;
    for (const std::size_t axis : {kX, kY}) {
        if (state.is_known(axis)) plane |= 1U << axis;
    }
    for (int pass = 0; pass < static_cast<int>(passes); ++pass) {
        if ((mask & kDepth) != 0) {
            centre[kZ] = state.incremental ? state.position[kZ] + down : end[kZ];
            context.path.linear_move(state, centre, MoveKind::Feed, kDepth);
        }
        mill_circles(state, centre, radii, code == Code::G12, plane, context);
    }
    return true;
}

}  // namespace ncsim::gcode
