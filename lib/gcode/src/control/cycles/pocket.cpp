// SPDX-License-Identifier: GPL-3.0-or-later
//
// G12 and G13 of Haas: a circular pocket, clockwise and counter-clockwise, including cutter
// compensation. Each code acts in its block only.
#include "control/machine.h"

#include <cmath>
#include <string>

namespace ncsim::gcode {
namespace {

/// Limit above any real program; a larger number is a wrong word.
constexpr double kMostCircles = 100'000.0;

/// Smallest radius of a circle, mm.
constexpr double kMinCircleRadius = 0.00127;

}  // namespace

/// Mills a circular pocket about X Y of the block, or about the position of the tool. Each of the L
/// passes: down to the depth; a half circle to the first circle; around the circle; half circles to
/// the next circles, around each; a half circle back to the centre. The manual gives the circles
/// and only draws the connections; every connection is inside the next circle.
bool Machine::pocket(const Command& command, Code code, bool words_taken) {
    const SourceSpan span = span_of_g(command, code);
    const std::string_view name = name_of(code);
    const auto needs = [&](std::string_view what) {
        return fail(Message::PocketWord, span, {name, what});
    };
    if (compensation_.is_on() || state_.cutter_side != CutterSide::Off) {
        return fail(Message::ForbiddenWithCompensation, span, {name});
    }
    const Code motion = command.group(Group::Motion);
    const bool plain =
        motion == Code::None || motion == Code::G0 || motion == Code::G1 || motion == Code::G80;
    if (words_taken || !plain || command.group(Group::OneShot) != Code::None) {
        return needs("a block of its own");
    }
    if (state_.feed_mode == FeedMode::InverseTime) {
        return fail(Message::CycleInverseTime, span, {name});
    }
    if (state_.cycle.running && motion == Code::None)
        return needs("the drilling cycle ended (G80)");
    if (state_.plane != Plane::XY) return needs("the XY plane (G17)");
    if (state_.frames.programmed.scaled) return needs("scaling and mirroring off (G50)");
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
    if (!needs_feed(command, name)) return false;

    const double cutter = std::abs(radius_of_register(command, span));
    const double tiny = kMinCircleRadius / state_.unit_mm();
    if (first - cutter < tiny) return fail(Message::CompensationArc, span);
    std::vector<double> radii;
    // Computed by multiplication, not by repeated addition; a last step of rounding errors is no
    // circle.
    for (int i = 0; first + i * step < last - tiny; ++i)
        radii.push_back(first + i * step - cutter);
    radii.push_back(last - cutter);

    Axes end{};
    AxisMask mask = 0;
    if (!find_ends(command, end, mask)) return false;
    if (motion != Code::None) state_.motion = motion, state_.cycle = {};
    if (motion == Code::G0 || motion == Code::G1) state_.last_straight = motion;
    if (!state_.first_length_seen) {
        state_.first_length_seen = true;
        state_.first_length_in_inches = state_.inches;
    }
    constexpr AxisMask kDepth = 1U << kZ;
    const double down = end[kZ] - state_.position[kZ];
    Axes centre = end;
    centre[kZ] = state_.position[kZ];
    if ((mask & ~kDepth) != 0) path_.linear_move(state_, centre, MoveKind::Rapid, mask & ~kDepth);
    // An axis with an unknown position stays unknown after the circles.
    AxisMask plane = 0;
    for (const std::size_t axis : {kX, kY}) {
        if (is_known(axis)) plane |= 1U << axis;
    }
    for (int pass = 0; pass < static_cast<int>(passes); ++pass) {
        if ((mask & kDepth) != 0) {
            centre[kZ] = state_.incremental ? state_.position[kZ] + down : end[kZ];
            path_.linear_move(state_, centre, MoveKind::Feed, kDepth);
        }
        mill_circles(centre, radii, code == Code::G12, plane);
    }
    return true;
}

/// Mills the circles `radii` in the plane of `centre`, where the tool is before and after. Half
/// circles lead from the centre to a side, and between circles to the opposite side, always in the
/// same sense.
void Machine::mill_circles(const Axes& centre, const std::vector<double>& radii, bool clockwise,
                           AxisMask mask) {
    const int turns = clockwise ? -1 : 1;
    const Axes origin = to_programmed(centre);
    const auto offset_point = [&](double x) {
        Axes p = origin;
        p[kX] += x;
        p = from_programmed(p);
        p[kZ] = centre[kZ];
        return p;
    };
    const auto around = [&](const Axes& end, double about) {
        const Axes c = offset_point(about);
        path_.arc(state_, {end, c[kX], c[kY], turns}, mask);
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

}  // namespace ncsim::gcode
