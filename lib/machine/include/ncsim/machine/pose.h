// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pose of the tool. Frames: W workpiece, T tool (tip at the origin, +z towards the spindle). X_WT
// is the pose of T in W: p_W = X_WT * p_T.
#pragma once

#include "ncsim/base/vec3.h"

#include <array>

namespace ncsim::machine {

/// Rotation followed by a translation, in mm.
struct Pose {
    std::array<Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Vec3 translation;

    bool operator==(const Pose&) const = default;
};

/// Returns p_A.
Vec3 operator*(const Pose& X_AB, Vec3 p_B);
/// Returns X_AC.
Pose operator*(const Pose& X_AB, const Pose& X_BC);

/// Returns the direction of the tool, from the tip to the spindle: the z axis of T in W.
Vec3 axis_of(const Pose& X_WT);

/// Returns the rows of the least rotation that takes z to `axis` (unit), about z × axis. Equal axes
/// give equal bits. No entry is -0.0.
std::array<Vec3, 3> least_rotation_to(Vec3 axis);

}  // namespace ncsim::machine
