// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interface to the kinematics of the machine, implemented outside lib/gcode; lib/gcode itself knows
// no joints.
#pragma once

#include "ncsim/gcode/feature_frame.h"
#include "ncsim/gcode/state.h"

#include <optional>
#include <string>

namespace ncsim::gcode {

/// Solves the kinematics of a machine. Joint positions are machine coordinates of the controlled
/// point without the tool length, in mm and degrees. Tip positions are positions on the part (frame
/// W) in the same numbers. If all rotary axes are at 0, joint and tip positions are equal. A turned
/// table turns the part; tip positions on the part are given as with all rotary axes at 0.
class JointSolver {
public:
    virtual ~JointSolver() = default;

    /// True if the machine has rotary axes.
    virtual bool turns() const = 0;

    /// Tip of a tool, and the direction from the tip to the spindle, on the part.
    struct TipPose {
        Triple tip{};
        Triple axis{0, 0, 1};
    };
    /// Returns the tip and direction of a tool of length `length_mm` with the joints at `joints`.
    virtual TipPose tip_pose(const Axes& joints, double length_mm) const = 0;

    /// Returns `joints` with X, Y and Z replaced so that the tip is at `tip`; nullopt if no X, Y
    /// and Z do this.
    virtual std::optional<Axes> joints_for(const Triple& tip, const Axes& joints,
                                           double length_mm) const = 0;

    /// Returns the vector `v`, fixed to the table, after the table moved from the joints `from` to
    /// the joints `to`. `v` and the result are in machine coordinates, mm.
    virtual Triple rotate_with_table(const Triple& v, const Axes& from, const Axes& to) const = 0;

    /// Choice among several solutions: the preference of the machine, or the first joint in the
    /// kinematic chain moves up or down.
    enum class Way : unsigned char { Specified, Up, Down };
    /// Joint values that orient the tool; without `joints` there is no solution, and `why_not`
    /// states the reason.
    struct Solution {
        std::optional<Axes> joints;
        /// A joint may have any value; the solution keeps the present value.
        bool singular = false;
        std::string why_not;
    };
    /// Returns rotary axis values that give the tool the direction `axis`, of unit length, starting
    /// from `joints`.
    virtual Solution joints_for_direction(const Triple& axis, const Axes& joints,
                                          Way way) const = 0;
};

}  // namespace ncsim::gcode
