// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines by name.
#pragma once

#include "ncsim/machine/chain.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::machine {

/// What is taken where nobody tells how a machine turns: a table whose axes A, then B, then C all
/// pass through the program's zero, with the signs of ISO 841:
///
///     X_WT = Rz(C) · Ry(B) · Rx(A) · translation(X+U, Y+V, Z+W)
const Chain& default_chain();

struct Preset {
    std::string_view name;
    std::string_view what;  ///< For a list of them.
};
std::vector<Preset> presets();

/// The chain of a preset, all its axes through the origin of M. Signs are those of LinuxCNC's
/// kinematics of that name where there are any: tables turn the part by positive values.
std::optional<Chain> preset(std::string_view name);

}  // namespace ncsim::machine
