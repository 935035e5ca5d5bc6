// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the tool is. Frames: W workpiece, T tool (tip at the origin, +z towards the
// spindle). X_WT is the pose of T in W: p_W = X_WT * p_T.
#pragma once

#include "ncsim/cda/vec.h"

#include <array>

namespace ncsim::machine {

/// A rotation followed by a translation, in mm.
struct Pose {
    /// Rows of the rotation matrix.
    std::array<cda::Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    cda::Vec3 translation;

    bool operator==(const Pose&) const = default;
};

cda::Vec3 operator*(const Pose& X_AB, cda::Vec3 p_B);
Pose operator*(const Pose& X_AB, const Pose& X_BC);

/// The direction of the tool, from its tip to the spindle: the z axis of T in W.
cda::Vec3 axis_of(const Pose& X_WT);

/// The least rotation that takes z to `axis`, of unit length: about z × axis. Equal axes give equal
/// bits; never -0.0.
std::array<cda::Vec3, 3> least_rotation_to(cda::Vec3 axis);

}  // namespace ncsim::machine
