// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/pose.h"

namespace ncsim::toolpath {

using cda::Vec3;

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

}  // namespace ncsim::toolpath
