// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the joints of a machine go in a motion, at any time of it, and how fast: what moves its
// links, as poses of the tool do not tell.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/machine/relative.h"
#include "ncsim/toolpath/machine.h"
#include "ncsim/toolpath/walk.h"

#include <memory>
#include <optional>
#include <vector>

namespace ncsim::toolpath {

class JointPath {
public:
    /// Of a straight move or an arc; `machine` and `motion` must outlive it.
    JointPath(const Kinematics& machine, const gcode::Motion& motion);
    ~JointPath();
    JointPath(JointPath&&) noexcept;

    /// In machine coordinates, as those of the spindle nose; t from 0 to 1. What U, V and W move
    /// the tip by, X, Y and Z do. Nothing where the axes cannot bring the tip there.
    std::optional<machine::Values> at(double t) const;
    /// From t0 to t1, where the joints are at `from` and `to`. Nothing of a machine whose linear
    /// axes have a rotary one between them, under tip control.
    std::optional<machine::Going> going(double t0, const machine::Values& from, double t1,
                                        const machine::Values& to) const;
    /// The tip as the part sees it: how far it goes from t0 to t1, and how much its way bends, as
    /// Ball::speed and bend; mm. Where the tip is programmed, else nothing.
    std::optional<machine::Ball> tip(double t0, double t1) const;

private:
    struct Course;
    std::unique_ptr<const Course> course_;
};

/// A motion in straight moves and arcs, in order: rapid moves by `rapid`, splines by chords; none
/// of dwells and tool changes.
struct Legs {
    std::vector<gcode::Motion> motions;
    double missed_mm = 0.0;  ///< The curve is no farther from the chords.
};
Legs legs_of(const gcode::Motion& motion, const RapidPath& rapid);

}  // namespace ncsim::toolpath
