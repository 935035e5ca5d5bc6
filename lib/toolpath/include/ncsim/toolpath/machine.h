// SPDX-License-Identifier: GPL-3.0-or-later
//
// From axis positions to tool poses.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/machine/chain.h"
#include "ncsim/toolpath/pose.h"

#include <optional>

namespace ncsim::toolpath {

/// X_WT of machine::default_chain(), whose rotary axes pass through the origin of W:
///
///     X_WT = Rz(C) · Ry(B) · Rx(A) · translation(X+U, Y+V, Z+W)
///
/// A, B and C turn the tool, tip and all, about the X, Y and Z axis of W, counter-clockwise seen
/// from the positive end: what a rotary table under the part does, seen from the part (ISO 841).
///
/// Tools are round. How the product turns one about its own axis is left out: X_WT has the least
/// rotation that takes z to the axis of the tool. So equal axes have equal rotations, and C under
/// an upright tool moves it without turning it. For multiples of 90 degrees the matrix is exact.
Pose pose_at(const gcode::Position& position);

/// As a chain of joints takes it.
machine::Values values_of(const gcode::Position& position);

/// A machine, and where the program's zero is in it.
struct Kinematics {
    machine::Chain chain;  ///< In machine coordinates.
    cda::Vec3 zero;        ///< Of W, mm; counts where axes are programmed, and tables turn.
};

/// The poses of one motion: of a machine that somebody told, or of the default one.
class Poses {
public:
    /// `told` may be null, and must outlive this.
    Poses(const Kinematics* told, const gcode::Motion& motion);

    Pose at(const gcode::Position& position) const;
    /// Where the axes stand, X + U, Y + V, Z + W; or, under tip control, the tip: where X, Y and Z
    /// tell, and from there what U, V and W move it by. mm.
    cda::Vec3 place(const gcode::Position& position) const;
    /// Of that, what does not turn with any axis: without U, V and W under tip control.
    cda::Vec3 steady_place(const gcode::Position& position) const;
    /// And what does: how far U, V and W move the tip under tip control.
    cda::Vec3 shift(const gcode::Position& position) const;
    /// In W; null for the default one.
    const machine::Chain* chain() const { return chain_ ? &*chain_ : nullptr; }
    /// X, Y and Z are where the tip is in W, whatever turns.
    bool of_tip() const { return of_tip_; }

private:
    std::optional<machine::Chain> chain_;
    bool of_tip_ = false;
};

/// All axes in step, t from 0 to 1; the ends come out exactly.
gcode::Position between(const gcode::Position& a, const gcode::Position& b, double t);

/// X + U, Y + V, Z + W in mm.
cda::Vec3 linear_axes(const gcode::Position& position);

}  // namespace ncsim::toolpath
