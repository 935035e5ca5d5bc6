// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transforms positions between the coordinates of a control.
#include "ncsim/gcode/positions.h"

#include "ncsim/base/angles.h"

#include "control/paths/path.h"

#include <algorithm>
#include <cstddef>

namespace ncsim::gcode {

Axes machine_position(const MachineState& state) {
    Axes m = to_untilted(state, state.position);
    rotate(m[kX], m[kY], state.rotation);
    for (std::size_t i = 0; i < m.size(); ++i)
        m[i] += state.work_offset[i] + state.tool_offset[i];
    for (std::size_t i = 0; state.dynamic_offset && i < 3; ++i)
        m[i] += (*state.dynamic_offset)[i];
    return m;
}

Axes from_machine(const MachineState& state, const Axes& machine) {
    Axes p = machine;
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= state.work_offset[i] + state.tool_offset[i];
    for (std::size_t i = 0; state.dynamic_offset && i < 3; ++i)
        p[i] -= (*state.dynamic_offset)[i];
    rotate(p[kX], p[kY], -state.rotation);
    if (state.plane_frame) {
        const auto& outer = state.outer_92;
        std::ranges::copy(state.plane_frame->from_parent(
                              {p[kX] - outer[kX], p[kY] - outer[kY], p[kZ] - outer[kZ]}),
                          p.begin());
    }
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= state.offset_92[i];
    return p;
}

Axes from_programmed(const ProgrammedTransform& t, const Axes& programmed) {
    Axes p = programmed;
    if (t.scaled) {
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = t.scale_centre[i] + t.scale[i] * (p[i] - t.scale_centre[i]);
        }
    }
    if (t.rotated) {
        const PlaneAxes axes = axes_of(t.plane);
        double x = p[axes.first] - t.centre_1;
        double y = p[axes.second] - t.centre_2;
        rotate(x, y, t.angle);
        p[axes.first] = t.centre_1 + x;
        p[axes.second] = t.centre_2 + y;
    }
    return p;
}

Axes to_programmed(const ProgrammedTransform& t, const Axes& position) {
    Axes p = position;
    if (t.rotated) {
        const PlaneAxes axes = axes_of(t.plane);
        double x = p[axes.first] - t.centre_1;
        double y = p[axes.second] - t.centre_2;
        rotate(x, y, -t.angle);
        p[axes.first] = t.centre_1 + x;
        p[axes.second] = t.centre_2 + y;
    }
    if (t.scaled) {
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = t.scale_centre[i] + (p[i] - t.scale_centre[i]) / t.scale[i];
        }
    }
    return p;
}

}  // namespace ncsim::gcode
