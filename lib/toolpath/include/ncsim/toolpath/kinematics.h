// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of axis positions to tool poses.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/machine/chain.h"
#include "ncsim/toolpath/tool_pose.h"

#include <optional>

namespace ncsim::toolpath {

/// Returns X_WT of machine::default_chain(), whose rotary axes pass through the origin of W:
///
///     X_WT = Rz(C) · Ry(B) · Rx(A) · translation(X+U, Y+V, Z+W)
///
/// A, B and C rotate the tool, including its tip, about the X, Y and Z axis of W, counter-clockwise
/// seen from the positive end. This is the motion of a rotary table under the part, seen from the
/// part (ISO 841).
///
/// Tools are round, so the rotation about the tool's own axis is left out: X_WT has the least
/// rotation that takes z to the tool axis. Therefore equal axes have equal rotations, and C under
/// an upright tool moves the tool without rotating it. The matrix is exact for multiples of 90
/// degrees.
Pose pose_at(const gcode::Position& position);

/// Returns the axis positions in the order of machine::kLetters, in mm and degrees.
machine::Values values_of(const gcode::Position& position);

/// A machine and the position of the program zero in the machine.
struct Kinematics {
    machine::Chain chain;  ///< In machine coordinates.
    /// Origin of W in machine coordinates, mm. It matters if axes are programmed and tables rotate.
    Vec3 zero;
};

/// Poses of the tool during one motion, for a specified machine or for the default machine.
class Poses {
public:
    /// Uses the specified machine, or the default machine if null. Requires: the machine outlives
    /// this object.
    Poses(const Kinematics* specified, const gcode::Motion& motion);

    /// Returns X_WT at the axis positions `position`.
    Pose at(const gcode::Position& position) const;
    /// Returns the linear axes X + U, Y + V, Z + W; under tip control the tip: X, Y and Z plus the
    /// shift by U, V and W. In mm.
    Vec3 place(const gcode::Position& position) const;
    /// Returns the part of place() that no axis rotates: under tip control without U, V and W. In
    /// mm.
    Vec3 unrotated_place(const gcode::Position& position) const;
    /// Returns the shift of the tip by U, V and W under tip control, which rotates with the axes;
    /// otherwise 0. In mm.
    Vec3 shift(const gcode::Position& position) const;
    /// Returns the chain of joints in W. Null for the default machine without tip control.
    const machine::Chain* chain() const { return chain_ ? &*chain_ : nullptr; }
    /// True if X, Y and Z are the tip's position in W (tip control).
    bool has_tip_control() const { return has_tip_control_; }

private:
    std::optional<machine::Chain> chain_;
    bool has_tip_control_ = false;
};

/// Interpolates all axes linearly, `t` from 0 to 1. Guarantees: t = 0 gives `a` and t = 1 gives `b`
/// exactly.
gcode::Position interpolate(const gcode::Position& a, const gcode::Position& b, double t);

/// Returns X + U, Y + V, Z + W in mm.
Vec3 linear_axes(const gcode::Position& position);

}  // namespace ncsim::toolpath
