// SPDX-License-Identifier: GPL-3.0-or-later
//
// G70, G71, G72 of Haas: the active cycle drills holes on a circle, an arc or a line. Each code
// acts in its block only.
#include "ncsim/base/angles.h"

#include "control/cycles/cycle_steps.h"
#include "control/paths/path_steps.h"

#include <cmath>

namespace ncsim::gcode {
namespace {

/// Limit above any real program; a larger number is a wrong word.
constexpr double kMostHoles = 9999.0;

}  // namespace

bool drill_pattern(ControlState& control, const Command& command, Code code, bool words_taken,
                   Context& context) {
    MachineState& state = control.machine;
    const SourceSpan span = span_of_g(command, code);
    const std::string_view name = name_of(code);
    const auto needs = [&](std::string_view what) {
        return fail(context, Message::HolePatternWord, span, {name, what});
    };
    if (control.compensation.is_on())
        return fail(context, Message::ForbiddenWithCompensation, span, {name});
    words_taken = words_taken || command.group(Group::OneShot) != Code::None;
    const Code motion = motion_of(state, command);
    if (!is_cycle(motion) || words_taken) return needs("a drilling cycle that is on, such as G81");
    if (state.plane != Plane::XY) return needs("the XY plane (G17)");
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

    state.motion = motion;
    note_length(state);
    if (!needs_feed(state, command, name_of(motion), context) ||
        !cycle_words(state, command, motion, context))
        return false;
    Axes at{};
    AxisMask mask = 0;
    if (!hole_place(state, command, at, mask, context)) return false;
    std::optional<Drilling> drilling = begin_drilling(state, command, motion, context);
    if (!drilling) return false;

    const Axes centre = state.frames.programmed.remove(at);
    const double sense = command['I'] < 0.0 ? -1.0 : 1.0;
    // An axis with an unknown position stays unknown after the holes.
    for (const std::size_t axis : {kX, kY}) {
        if (state.is_known(axis)) mask |= 1U << axis;
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
        if (!hole_at(state, *drilling, state.frames.programmed.apply(hole), mask, context))
            return false;
    }
    return true;
}

}  // namespace ncsim::gcode
