// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/machine.h"

#include "ncsim/toolpath/angles.h"

namespace ncsim::toolpath {

using cda::Vec3;

Vec3 linear_axes(const gcode::Position& p) {
    return {(p.x + p.u).mm(), (p.y + p.v).mm(), (p.z + p.w).mm()};
}

Pose pose_at(const gcode::Position& p) {
    Pose X_WT;
    X_WT.translation = linear_axes(p);
    // Turned only about axes that are turned: a product with the identity is exact, but -0.0
    // would make two equal orientations differ in their bits.
    if (p.a.degrees() != 0.0) {
        const SinCos a = sin_cos(p.a.degrees());
        X_WT = Pose{{Vec3{1, 0, 0}, Vec3{0, a.cos, -a.sin}, Vec3{0, a.sin, a.cos}}, {}} * X_WT;
    }
    if (p.b.degrees() != 0.0) {
        const SinCos b = sin_cos(p.b.degrees());
        X_WT = Pose{{Vec3{b.cos, 0, b.sin}, Vec3{0, 1, 0}, Vec3{-b.sin, 0, b.cos}}, {}} * X_WT;
    }
    if (p.c.degrees() != 0.0) {
        const SinCos c = sin_cos(p.c.degrees());
        X_WT = Pose{{Vec3{c.cos, -c.sin, 0}, Vec3{c.sin, c.cos, 0}, Vec3{0, 0, 1}}, {}} * X_WT;
    }
    return X_WT;
}

}  // namespace ncsim::toolpath
