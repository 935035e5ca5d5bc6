// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice among the solutions that give the tool a direction, as controls make it.
#pragma once

#include "ncsim/machine/inverse.h"

#include <map>
#include <optional>

namespace ncsim::machine {

/// Range of a joint; mm or degrees.
struct Travel {
    double min = 0.0, max = 0.0;
    bool operator==(const Travel&) const = default;
};
/// By the letter of the joint; a joint without an entry is unlimited.
using Travels = std::map<char, Travel>;

/// Preference among solutions, by the motion or the end position of the master joint.
enum class SolutionPreference {
    Shortest,        ///< Shortest motion.
    PositiveMotion,  ///< Positive motion only (LinuxCNC's tilted planes, P1).
    NegativeMotion,  ///< Negative motion only (P2).
    EndPositive,     ///< End position at 0 or above, whatever the motion (SEQ+).
    EndNegative,     ///< End position at 0 or below (SEQ-).
};

/// Returns the master joint, which carries the second rotary joint: the joint next to the bed if
/// the machine has two rotary tables or two heads, the table if the machine has one of each. Null
/// unless the chain has exactly two rotary joints.
const Joint* master_of(const Chain& chain);

/// Returns the best solution of orientation_solutions(), including whole turns within `travels`.
/// The order of criteria is: least motion of the master joint, least motion of the second rotary
/// joint, master position nearest to 0, second position nearest to 0. No value if no solution is
/// allowed. Source: Fanuc 16i/18i-MB operator's manual, "Angle of rotation axis".
std::optional<Turns> orient(const Chain& placed, Vec3 axis, const Values& now,
                            const Travels& travels = {},
                            SolutionPreference prefer = SolutionPreference::Shortest);

}  // namespace ncsim::machine
