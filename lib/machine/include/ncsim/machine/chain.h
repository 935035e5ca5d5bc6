// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a machine moves its tool against its part: the joints on the way from the part over the bed
// to the tool, each as it stands when all are at 0 (product of exponentials: Brockett 1984; Lynch
// and Park, Modern Robotics, 2017, ch. 4). So there are no frames of links to get wrong.
//
// Frames: M machine, whose coordinates are those of the spindle nose while nothing is turned; W
// workpiece and T tool, parallel to M while all joints are at 0.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/machine/pose.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::machine {

/// X Y Z A B C U V W: mm and degrees.
using Values = std::array<double, 9>;
inline constexpr std::string_view kLetters = "XYZABCUVW";
/// Its place in Values; nothing for other letters.
std::optional<std::size_t> index_of(char letter);

/// One moving axis. What lies behind it, towards the tool, moves against what lies before it.
struct Joint {
    char letter = 'X';
    bool turns = false;   ///< Else it moves along `direction`.
    cda::Vec3 direction;  ///< Of unit length, and the way of positive values: see tool_sign().
    cda::Vec3 through;    ///< A point of the axis it turns about, mm.
    bool operator==(const Joint&) const = default;
};

/// Positive values move the tool against the part: with the right hand about `direction` (ISO 841);
/// or, of a table whose scale has the other sign, the part against the tool.
enum class Positive { Tool, Part };
/// Its motion as that of the tool against the part, which is what a Joint tells.
Joint joint_of(char letter, bool turns, cda::Vec3 direction, cda::Vec3 through = {},
               Positive positive = Positive::Tool);

/// From the part to the tool. Rotary joints and linear ones may stand in any order.
struct Chain {
    std::vector<Joint> joints;
    bool operator==(const Chain&) const = default;

    /// The joint of this letter, null if there is none.
    const Joint* find(char letter) const;
    /// Do U, V or W have one of their own? Such a one is no motor: see along_tool().
    bool has_second_axes() const;
    /// Does one that turns stand behind one that moves straight: a head?
    bool has_head() const;

    /// The same in W: `zero` is that of the program in machine coordinates, and `length` how far
    /// the tip is below the spindle nose, mm. Then the tip is at the origin while all are at 0, and
    /// at (x, y, z) of the program while nothing is turned.
    Chain placed(cda::Vec3 zero, double length) const;

    /// X_WT of a chain that is placed. Joints that are not there count for nothing, but U, V and W,
    /// which are added to X, Y and Z. Tools are round: turns of one about its own axis are left
    /// out, X_WT has the least rotation that takes z to the axis of the tool. For multiples of 90
    /// degrees about axes that are parallel to X, Y or Z the matrix is exact.
    Pose pose(const Values& values) const;

    /// By how much U, V and W move the tip, as the part sees it, mm.
    cda::Vec3 shift_of_second_axes(const Values& values) const;
};

/// A joint that is none of the machine's: the control moves X, Y and Z so that the tip goes along
/// the tool by what is told of the letter, as LinuxCNC's 5axiskins does it for W. Next to the tool.
Joint along_tool(char letter);

/// Turns `p` by `degrees` about the axis of the joint, or moves it along by `value`.
cda::Vec3 moved(const Joint& joint, double value, cda::Vec3 p);
/// The same as a pose.
Pose pose_of(const Joint& joint, double value);
/// A direction turned by the joint; one that does not turn leaves it.
cda::Vec3 turned(const Joint& joint, double value, cda::Vec3 direction);

}  // namespace ncsim::machine
