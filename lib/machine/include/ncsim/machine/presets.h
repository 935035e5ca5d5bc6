// SPDX-License-Identifier: GPL-3.0-or-later
//
// Predefined machines, by name.
#pragma once

#include "ncsim/machine/chain.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ncsim::machine {

/// Returns the chain for machines whose rotary axes are unspecified: a table whose axes A, then B,
/// then C all pass through the program zero, with the signs of ISO 841:
///
///     X_WT = Rz(C) · Ry(B) · Rx(A) · translation(X+U, Y+V, Z+W)
const Chain& default_chain();

/// Name and description of a predefined machine.
struct Preset {
    std::string_view name;
    std::string_view what;  ///< Description for lists.
};
/// Returns all predefined machines.
std::vector<Preset> presets();

/// Returns the chain of the preset `name`, with all axes through the origin of M. Signs are those
/// of LinuxCNC's kinematics of the same name, where such kinematics exist: positive values of
/// tables rotate the part.
std::optional<Chain> preset(std::string_view name);

}  // namespace ncsim::machine
