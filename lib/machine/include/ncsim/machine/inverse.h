// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inverse kinematics in closed form: joint values that bring the tool to a direction and a
// position.
// Source: subproblems 1 and 2 of Paden and Kahan, in Murray, Li and Sastry, A Mathematical
// Introduction to Robotic Manipulation, 1994, ch. 3.
#pragma once

#include "ncsim/machine/chain.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::machine {

/// Joint values that give the tool a direction.
struct Turns {
    Values values{};  ///< Rotary joints in (-180, 180]; all other values as in `now`.
    /// True if a rotary joint may have any value; that joint keeps its value in `now`.
    bool singular = false;
};

/// Returns all solutions, at most two, that give the tool the direction `axis` (unit). `now` has
/// the current joint values.
/// Requires: at most two rotary joints. The result is empty for chains with more; programs for such
/// machines must specify angles.
std::vector<Turns> orientation_solutions(const Chain& placed, Vec3 axis, const Values& now = {});

/// Returns the joint values `turned`, with X, Y and Z replaced so that the tip is at `tip`; no
/// value if the directions of X, Y and Z lie in one plane.
std::optional<Values> values_for(const Chain& placed, Vec3 tip, const Values& turned);

}  // namespace ncsim::machine
