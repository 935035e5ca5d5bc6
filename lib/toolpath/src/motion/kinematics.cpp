// SPDX-License-Identifier: GPL-3.0-or-later
//
// Poses of the default machine and of specified machines.
#include "ncsim/toolpath/kinematics.h"

#include "ncsim/machine/presets.h"

namespace ncsim::toolpath {

using gcode::Position;

Vec3 linear_axes(const Position& p) {
    return {(p.x + p.u).mm(), (p.y + p.v).mm(), (p.z + p.w).mm()};
}

machine::Values values_of(const Position& p) {
    return {p.x.mm(),      p.y.mm(), p.z.mm(), p.a.degrees(), p.b.degrees(),
            p.c.degrees(), p.u.mm(), p.v.mm(), p.w.mm()};
}

Pose pose_at(const Position& p) {
    return machine::default_chain().pose(values_of(p));
}

Poses::Poses(const Kinematics* specified, const gcode::Motion& motion)
    : has_tip_control_(motion.coordinates == gcode::Coordinates::Tip) {
    if (specified) {
        chain_ = specified->chain.placed(specified->zero, motion.length.mm());
    } else if (has_tip_control_) {
        chain_ = machine::default_chain();
    }
}

Pose Poses::at(const Position& position) const {
    if (!chain_) return pose_at(position);
    Pose X_WT = chain_->pose(values_of(position));
    if (has_tip_control_) X_WT.translation = place(position);
    return X_WT;
}

Vec3 Poses::place(const Position& position) const {
    return has_tip_control_ ? unrotated_place(position) + shift(position) : linear_axes(position);
}

Vec3 Poses::unrotated_place(const Position& position) const {
    if (!has_tip_control_) return linear_axes(position);
    return {position.x.mm(), position.y.mm(), position.z.mm()};
}

Vec3 Poses::shift(const Position& position) const {
    return has_tip_control_ ? chain_->shift_of_second_axes(values_of(position)) : Vec3{};
}

}  // namespace ncsim::toolpath
