// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/machine.h"

#include "ncsim/trig/angles.h"

#include <array>

namespace ncsim::toolpath {

using cda::Vec3;

namespace {

// The least rotation that takes z to `axis`, of unit length: about z × axis. Never -0.0, which
// would make two equal orientations differ in their bits.
std::array<Vec3, 3> least_rotation_to(Vec3 axis) {
    const double x = axis.x + 0.0, y = axis.y + 0.0, z = axis.z + 0.0;
    const double aside = x * x + y * y;
    if (aside == 0.0 && z < 0.0) return {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    // 1/(1 + z), without the loss where z is nearly -1.
    const double k = z < 0.0 ? (1 - z) / aside : 1 / (1 + z);
    const double xy = 0.0 - x * y * k;
    return {{{1 - x * x * k, xy, x}, {xy, 1 - y * y * k, y}, {0.0 - x, 0.0 - y, z}}};
}

}  // namespace

Vec3 linear_axes(const gcode::Position& p) {
    return {(p.x + p.u).mm(), (p.y + p.v).mm(), (p.z + p.w).mm()};
}

Pose pose_at(const gcode::Position& p) {
    Pose X_WT;
    X_WT.translation = linear_axes(p);
    // Turned only about axes that are turned: a product with the identity is exact, but for -0.0.
    if (p.a.degrees() != 0.0) {
        const trig::SinCos a = trig::sin_cos(p.a.degrees());
        X_WT = Pose{{Vec3{1, 0, 0}, Vec3{0, a.cos, -a.sin}, Vec3{0, a.sin, a.cos}}, {}} * X_WT;
    }
    if (p.b.degrees() != 0.0) {
        const trig::SinCos b = trig::sin_cos(p.b.degrees());
        X_WT = Pose{{Vec3{b.cos, 0, b.sin}, Vec3{0, 1, 0}, Vec3{-b.sin, 0, b.cos}}, {}} * X_WT;
    }
    if (p.c.degrees() != 0.0) {
        const trig::SinCos c = trig::sin_cos(p.c.degrees());
        X_WT = Pose{{Vec3{c.cos, -c.sin, 0}, Vec3{c.sin, c.cos, 0}, Vec3{0, 0, 1}}, {}} * X_WT;
    }
    // About X or Y alone it is the least one already.
    const bool is_least = p.c.degrees() == 0.0 && (p.a.degrees() == 0.0 || p.b.degrees() == 0.0);
    if (!is_least) X_WT.rows = least_rotation_to({X_WT.rows[0].z, X_WT.rows[1].z, X_WT.rows[2].z});
    return X_WT;
}

}  // namespace ncsim::toolpath
