// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinematic chain of a machine: the joints from the part over the bed to the tool, in their
// positions at joint values 0 (product of exponentials: Brockett 1984; Lynch and Park, Modern
// Robotics, 2017, ch. 4). Links need no frames of their own.
// Frames: M machine, with the coordinates of the spindle nose while no joint is rotated; W
// workpiece and T tool, parallel to M while all joints are at 0.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/machine/pose.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::machine {

/// Joint values of X Y Z A B C U V W; mm and degrees.
using Values = std::array<double, 9>;
inline constexpr std::string_view kLetters = "XYZABCUVW";
/// Returns the index of `letter` in Values; no value for all remaining letters.
std::optional<std::size_t> index_of(char letter);

/// One axis of the machine. The links behind the joint, towards the tool, move against the links
/// before the joint.
struct Joint {
    char letter = 'X';
    bool turns = false;  ///< False for a joint that moves along `direction`.
    Vec3 direction;      ///< Unit vector; the direction in which positive values move the tool.
    Vec3 through;        ///< A point on the axis of rotation, mm.
    bool operator==(const Joint&) const = default;
};

/// Meaning of positive values. Tool: the tool moves against the part, rotary joints by the
/// right-hand rule about `direction` (ISO 841). Part: the part moves against the tool, as on tables
/// whose scale has the opposite sign.
enum class Positive { Tool, Part };
/// Returns the joint, with the motion converted to that of the tool against the part.
Joint joint_of(char letter, bool turns, Vec3 direction, Vec3 through = {},
               Positive positive = Positive::Tool);

/// Joints from the part to the tool. Rotary and linear joints may be in any order.
struct Chain {
    std::vector<Joint> joints;
    bool operator==(const Chain&) const = default;

    /// Returns the joint of `letter`, null if there is none.
    const Joint* find(char letter) const;
    /// True if U, V or W has a joint. Such a joint is no motor: see along_tool().
    bool has_second_axes() const;
    /// True if a rotary joint follows a linear joint: the machine has a head.
    bool has_head() const;

    /// Returns the chain in W. `zero` is the program zero in machine coordinates, `length` the
    /// distance of the tip below the spindle nose, mm. The tip is at the origin while all joints
    /// are at 0, and at (x, y, z) of the program while no joint is rotated.
    Chain placed(Vec3 zero, double length) const;

    /// Returns X_WT.
    /// Requires: the chain comes from placed().
    /// Values without a joint are ignored, except U, V and W, which are added to X, Y and Z.
    /// Because tools are round, rotation about the tool's own axis is left out: X_WT has the least
    /// rotation that takes z to the tool's axis. For multiples of 90 degrees about axes parallel to
    /// X, Y or Z, the matrix is exact.
    Pose pose(const Values& values) const;

    /// Returns the displacement of the tip by U, V and W in W, mm.
    Vec3 shift_of_second_axes(const Values& values) const;
};

/// Returns a joint next to the tool that is no axis of the machine: the control moves X, Y and Z so
/// that the tip moves along the tool by the value of `letter`. LinuxCNC's 5axiskins does this for
/// W.
Joint along_tool(char letter);

/// Rotates `p` by `value` degrees about the axis of the joint, or moves `p` by `value` mm along it.
Vec3 move_by_joint(const Joint& joint, double value, Vec3 p);
/// Returns the motion of the joint as a pose.
Pose pose_of(const Joint& joint, double value);
/// Rotates `direction` with the joint; a linear joint leaves `direction` unchanged.
Vec3 rotate_by_joint(const Joint& joint, double value, Vec3 direction);

}  // namespace ncsim::machine
