// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transforms positions between the levels of a control.
#include "ncsim/base/angles.h"
#include "ncsim/gcode/frame_stack.h"

#include "control/paths/path.h"

#include <algorithm>
#include <cstddef>

namespace ncsim::gcode {
namespace {

/// Rotates the coordinates of `p` in the plane of `t` about the centre of `t`.
void turn(const ProgrammedTransform& t, Axes& p, double degrees) {
    const PlaneAxes axes = axes_of(t.plane);
    double x = p[axes.first] - t.centre_1;
    double y = p[axes.second] - t.centre_2;
    rotate(x, y, degrees);
    p[axes.first] = t.centre_1 + x;
    p[axes.second] = t.centre_2 + y;
}

}  // namespace

void scale_lengths(Axes& axes, double factor) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (!is_rotary(i)) axes[i] *= factor;
    }
}

// --- ProgrammedTransform ---

void ProgrammedTransform::set(Plane in_plane, double degrees, const std::array<double, 3>& factors,
                              const std::array<double, 3>& about) {
    rotated = degrees != 0.0;
    plane = in_plane;
    angle = degrees;
    centre_1 = centre_2 = 0.0;
    scaled = factors != std::array<double, 3>{1.0, 1.0, 1.0};
    scale = factors;
    scale_centre = about;
}

Axes ProgrammedTransform::apply(const Axes& words) const {
    Axes p = words;
    for (std::size_t i = 0; scaled && i < 3; ++i)
        p[i] = scale_centre[i] + scale[i] * (p[i] - scale_centre[i]);
    if (rotated) turn(*this, p, angle);
    return p;
}

Axes ProgrammedTransform::remove(const Axes& position) const {
    Axes p = position;
    if (rotated) turn(*this, p, -angle);
    for (std::size_t i = 0; scaled && i < 3; ++i)
        p[i] = scale_centre[i] + (p[i] - scale_centre[i]) / scale[i];
    return p;
}

// --- FrameStack ---

Axes FrameStack::to_system(const Axes& position) const {
    Axes p = position;
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] += offset_92[i];
    if (tilt) {
        const Triple parent = tilt->to_parent({p[kX], p[kY], p[kZ]});
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = parent[i] + outer_92[i];
    }
    rotate(p[kX], p[kY], rotation);
    return p;
}

Axes FrameStack::to_machine(const Axes& position) const {
    Axes m = to_system(position);
    for (std::size_t i = 0; i < m.size(); ++i)
        m[i] += work_offset[i] + tool_offset[i];
    for (std::size_t i = 0; dynamic_offset && i < 3; ++i)
        m[i] += (*dynamic_offset)[i];
    return m;
}

Axes FrameStack::from_machine(const Axes& machine) const {
    Axes p = machine;
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= work_offset[i] + tool_offset[i];
    for (std::size_t i = 0; dynamic_offset && i < 3; ++i)
        p[i] -= (*dynamic_offset)[i];
    rotate(p[kX], p[kY], -rotation);
    if (tilt) {
        std::ranges::copy(
            tilt->from_parent({p[kX] - outer_92[kX], p[kY] - outer_92[kY], p[kZ] - outer_92[kZ]}),
            p.begin());
    }
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] -= offset_92[i];
    return p;
}

void FrameStack::set_tilt(const std::optional<FeatureFrame>& frame) {
    if (frame && !tilt) std::copy_n(offset_92.begin(), 3, outer_92.begin());
    const std::array<double, 3> shift = frame ? std::array<double, 3>{} : outer_92;
    std::ranges::copy(shift, offset_92.begin());
    if (!frame) outer_92 = {};
    tilt = frame;
}

void FrameStack::scale_lengths(double factor) {
    const auto scale = [factor](std::array<double, 3>& lengths) {
        for (double& length : lengths)
            length *= factor;
    };
    for (Axes* const axes : {&work_offset, &offset_92, &tool_offset, &zero_92})
        gcode::scale_lengths(*axes, factor);
    programmed.centre_1 *= factor;
    programmed.centre_2 *= factor;
    programmed.pole_1 *= factor;
    programmed.pole_2 *= factor;
    scale(programmed.scale_centre);
    if (tilt) scale(tilt->origin);
    scale(outer_92);
    if (dynamic_offset) scale(*dynamic_offset);
    scale(dynamic_offset_home);
}

}  // namespace ncsim::gcode
