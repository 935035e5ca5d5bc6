// SPDX-License-Identifier: GPL-3.0-or-later
//
// G68 (rotation), G51 (scale), G51.1 (mirror image), G16 (polar words).
#include "control/frames/frame_steps.h"

#include <array>
#include <cmath>

namespace ncsim::gcode {

bool set_programmed(MachineState& state, const Command& command, Context& context) {
    ProgrammedTransform& t = state.frames.programmed;
    if (const Code code = command.group(Group::Polar); code != Code::None) {
        t.polar = code == Code::G16;
        t.pole_1 = t.pole_2 = 0.0;
        state.polar_words.reset();
        if (t.polar && context.rules.pole_is_position) {
            const Axes at = t.remove(state.position);
            const PlaneAxes axes = axes_of(state.plane);
            t.pole_1 = at[axes.first];
            t.pole_2 = at[axes.second];
        }
    }
    const Code rotation = command.group(Group::Rotation);
    if (rotation == Code::G69) t.rotated = false;
    if (rotation == Code::G68) {
        if (!command.has('R'))
            return fail(context, Message::RotationWithoutAngle, span_of_g(command, Code::G68));
        const Axes at = state.frames.programmed.remove(state.position);
        t.plane = state.plane;
        const PlaneAxes axes = axes_of(t.plane);
        t.centre_1 = command.get(kAxisNames[axes.first], at[axes.first]);
        t.centre_2 = command.get(kAxisNames[axes.second], at[axes.second]);
        t.angle = state.incremental && t.rotated ? t.angle + command['R'] : command['R'];
        t.rotated = true;
    }
    const Code scaling = command.group(Group::Scaling);
    if (scaling == Code::G50) t.scaled = false;
    if (scaling == Code::G51) {
        const Axes at = state.frames.programmed.remove(state.position);
        double all = command.get('P', 1.0);
        if (all >= 100.0 && all == std::floor(all)) all /= 1000.0;  // P2000 is 2.0 on Fanuc.
        const char factors[] = {'I', 'J', 'K'};
        for (std::size_t i = 0; i < 3; ++i) {
            double factor = command.get(factors[i], all);
            if (std::abs(factor) >= 100.0) factor /= 1000.0;
            if (factor == 0.0)
                return fail(context, Message::ScaleZero, span_of_g(command, Code::G51));
            t.scale[i] = factor;
            t.scale_centre[i] = command.get(kAxisNames[i], at[i]);
        }
        t.scaled = true;
    }
    if (const Code mirror = command.group(Group::Mirror); mirror != Code::None) {
        const bool on = mirror == Code::G51_1;
        if (!t.scaled) t.scale = {1.0, 1.0, 1.0};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!on && (command.has(kAxisNames[i]) || !command.axis_words))
                t.scale[i] = std::abs(t.scale[i]);
            if (!on || !command.has(kAxisNames[i])) continue;
            t.scale[i] = -std::abs(t.scale[i]);
            t.scale_centre[i] = command[kAxisNames[i]];
        }
        t.scaled = t.scale != std::array<double, 3>{1.0, 1.0, 1.0};
    }
    return true;
}

}  // namespace ncsim::gcode
