// SPDX-License-Identifier: GPL-3.0-or-later
//
// G70, G71, G72 of Haas: the active cycle drills holes on a circle, an arc or a line. Each code
// acts in its block only.
#include "ncsim/base/angles.h"

#include "control/machine.h"

#include <cmath>

namespace ncsim::gcode {
namespace {

/// Limit above any real program; a larger number is a wrong word.
constexpr double kMostHoles = 9999.0;

}  // namespace

/// Drills the holes of a pattern about the position of X and Y in the block, or about the position
/// of the tool: the centre of G70 and G71, the first hole of G72. Angles count from the first axis
/// of the plane to the second. A negative radius or distance reverses the direction.
bool Machine::hole_pattern(const Command& command, Code code, bool words_taken) {
    const SourceSpan span = span_of_g(command, code);
    const std::string_view name = name_of(code);
    const auto needs = [&](std::string_view what) {
        return fail(Message::HolePatternWord, span, {name, what});
    };
    if (compensation_.is_on()) {
        return fail(Message::ForbiddenWithCompensation, span, {name});
    }
    words_taken = words_taken || command.group(Group::OneShot) != Code::None;
    Code motion = command.group(Group::Motion);
    if (motion == Code::None) motion = state_.motion;
    if (!is_cycle(motion) || words_taken) return needs("a drilling cycle that is on, such as G81");
    if (state_.plane != Plane::XY) return needs("the XY plane (G17)");
    if (!command.has('I')) return needs(code == Code::G72 ? "a distance (I)" : "a radius (I)");
    if (!command.has('J')) return needs("an angle (J)");
    if (code == Code::G71 && !command.has('K')) return needs("the angle between two holes (K)");
    const double holes = command.get('L', 0.0);
    if (holes < 1.0 || holes > kMostHoles || holes != std::round(holes)) {
        return needs("a number of holes (L), whole, 1 to 9999");
    }
    const bool one = holes == 1.0;
    if (command['I'] == 0.0 && !(one && code == Code::G72)) return needs("an I that is not 0");
    if (code == Code::G71 && command['K'] == 0.0 && !one) return needs("a K that is not 0");

    state_.motion = motion;
    if (!state_.first_length_seen) {
        state_.first_length_seen = true;
        state_.first_length_in_inches = state_.inches;
    }
    if (!needs_feed(command, name_of(motion)) || !cycle_words(command, motion)) return false;
    Axes at{};
    AxisMask mask = 0;
    if (!hole_place(command, at, mask)) return false;
    std::optional<Drilling> drilling = begin_drilling(command, motion);
    if (!drilling) return false;

    const Axes centre = to_programmed(at);
    const double sense = command['I'] < 0.0 ? -1.0 : 1.0;
    // An axis with an unknown position stays unknown after the holes.
    for (const std::size_t axis : {kX, kY}) {
        if (is_known(axis)) mask |= 1U << axis;
    }
    for (int i = 0; i < static_cast<int>(holes); ++i) {
        const bool on_line = code == Code::G72;
        const double turn = code == Code::G70 ? i * 360.0 / holes : i * command.get('K', 0.0);
        const double angle = on_line ? command['J'] : command['J'] + sense * turn;
        const double distance = on_line ? i * command['I'] : std::abs(command['I']);
        const SinCos direction = sin_cos(angle);
        Axes hole = centre;
        hole[kX] += distance * direction.cos;
        hole[kY] += distance * direction.sin;
        if (!hole_at(*drilling, from_programmed(hole), mask)) return false;
    }
    return true;
}

}  // namespace ncsim::gcode
