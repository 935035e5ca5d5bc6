// SPDX-License-Identifier: GPL-3.0-or-later
//
// Products of poses, and the least rotation to a direction.
#include "ncsim/machine/pose.h"

namespace ncsim::machine {

namespace {

Vec3 rotate(const Pose& pose, Vec3 v) {
    return {dot(pose.rows[0], v), dot(pose.rows[1], v), dot(pose.rows[2], v)};
}

}  // namespace

Vec3 operator*(const Pose& X_AB, Vec3 p_B) {
    return rotate(X_AB, p_B) + X_AB.translation;
}

Pose operator*(const Pose& X_AB, const Pose& X_BC) {
    Pose X_AC;
    for (int column = 0; column < 3; ++column) {
        const Vec3 c{X_BC.rows[0][column], X_BC.rows[1][column], X_BC.rows[2][column]};
        const Vec3 rotated = rotate(X_AB, c);
        for (int row = 0; row < 3; ++row)
            X_AC.rows[static_cast<std::size_t>(row)][column] = rotated[row];
    }
    X_AC.translation = X_AB * X_BC.translation;
    return X_AC;
}

Vec3 axis_of(const Pose& X_WT) {
    return {X_WT.rows[0].z, X_WT.rows[1].z, X_WT.rows[2].z};
}

std::array<Vec3, 3> least_rotation_to(Vec3 axis) {
    const double x = axis.x + 0.0, y = axis.y + 0.0, z = axis.z + 0.0;
    const double aside = x * x + y * y;
    if (aside == 0.0 && z < 0.0) return {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    // 1 / (1 + z), without cancellation for z near -1.
    const double k = z < 0.0 ? (1 - z) / aside : 1 / (1 + z);
    const double xy = 0.0 - x * y * k;
    return {{{1 - x * x * k, xy, x}, {xy, 1 - y * y * k, y}, {0.0 - x, 0.0 - y, z}}};
}

}  // namespace ncsim::machine
