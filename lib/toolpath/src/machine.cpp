// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/machine.h"

#include "ncsim/machine/presets.h"

namespace ncsim::toolpath {

using cda::Vec3;

Vec3 linear_axes(const gcode::Position& p) {
    return {(p.x + p.u).mm(), (p.y + p.v).mm(), (p.z + p.w).mm()};
}

machine::Values values_of(const gcode::Position& p) {
    return {p.x.mm(),      p.y.mm(), p.z.mm(), p.a.degrees(), p.b.degrees(),
            p.c.degrees(), p.u.mm(), p.v.mm(), p.w.mm()};
}

Pose pose_at(const gcode::Position& p) {
    return machine::default_chain().pose(values_of(p));
}

Poses::Poses(const Kinematics* told, const gcode::Motion& motion)
    : of_tip_(motion.coordinates == gcode::Coordinates::Tip) {
    if (told) {
        chain_ = told->chain.placed(told->zero, motion.length.mm());
    } else if (of_tip_) {
        chain_ = machine::default_chain();
    }
}

Pose Poses::at(const gcode::Position& position) const {
    if (!chain_) return pose_at(position);
    Pose X_WT = chain_->pose(values_of(position));
    if (of_tip_) X_WT.translation = linear_axes(position);
    return X_WT;
}

}  // namespace ncsim::toolpath
