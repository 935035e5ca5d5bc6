// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions and speeds of a machine's joints during a motion. The links of the machine move with
// the joints; poses of the tool do not determine the links.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/machine/relative.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/walk.h"

#include <memory>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

/// Joint positions during a straight move or an arc.
class JointPath {
public:
    /// Requires: `motion` is a straight move or an arc; `machine` and `motion` outlive this object.
    JointPath(const Kinematics& machine, const gcode::Motion& motion);
    ~JointPath();
    JointPath(JointPath&&) noexcept;

    /// Returns the joints at `t` from 0 to 1, in machine coordinates of the spindle nose (mm,
    /// degrees). U, V and W are 0; X, Y and Z include their motion. Empty if the axes cannot bring
    /// the tip there.
    std::optional<machine::Values> at(double t) const;
    /// Returns the motion of the joints from `t0` to `t1`, where the joints are at `from` and `to`.
    /// Empty under tip control if the machine has a rotary axis between its linear axes.
    std::optional<machine::JointMotion> joint_motion(double t0, const machine::Values& from,
                                                     double t1, const machine::Values& to) const;
    /// Returns the tip in the workpiece frame from `t0` to `t1`: path length and bend, as
    /// Ball::speed and Ball::bend, in mm. Empty if the motion is not under tip control.
    std::optional<machine::Ball> tip(double t0, double t1) const;

private:
    struct Course;
    std::unique_ptr<const Course> course_;
};

/// Straight moves and arcs that make up a motion, in order.
struct Legs {
    std::vector<gcode::Motion> motions;
    double missed_mm = 0.0;  ///< Largest distance between the curve and its chords.
};
/// Divides a motion into legs. Rapid moves follow `rapid`, splines become chords; dwells and tool
/// changes have no legs.
Legs legs_of(const gcode::Motion& motion, const RapidPath& rapid);

}  // namespace ncsim::toolpath
