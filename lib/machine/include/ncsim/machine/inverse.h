// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which joint values bring a tool where it is to be, in closed form (subproblems 1 and 2 of Paden
// and Kahan: Murray, Li and Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, ch.
// 3).
#pragma once

#include "ncsim/machine/chain.h"

#include <array>
#include <optional>
#include <vector>

namespace ncsim::machine {

struct Turns {
    Values values{};        ///< Of the rotary joints, in (-180, 180]; the others as they were.
    bool singular = false;  ///< One of them may stand anywhere: it stays where it was.
};

/// All ways, none to two, to give the tool the direction `axis`, of unit length. The chain has two
/// joints that turn, or one, or none; chains of more have no answer: tell angles. `now`: where the
/// joints stand.
std::vector<Turns> turns_for(const Chain& placed, cda::Vec3 axis, const Values& now = {});

/// X, Y and Z that bring the tip to `tip` with the other joints at `turned`; nothing if the
/// directions of X, Y and Z lie in one plane.
std::optional<Values> values_for(const Chain& placed, cda::Vec3 tip, const Values& turned);

}  // namespace ncsim::machine
