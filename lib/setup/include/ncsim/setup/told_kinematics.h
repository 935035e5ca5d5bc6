// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinematics of a machine, with its assumptions.
#pragma once

#include "ncsim/machine/orient.h"

#include <string>

namespace ncsim::setup {

/// Specified kinematics of a machine.
struct ToldKinematics {
    machine::Chain chain;       ///< In machine coordinates.
    std::string untold_pivots;  ///< Letters of rotary axes with unknown position.
    std::string guess;          ///< Further assumptions, in words; empty if none.
    machine::Travels travels;   ///< Travels of rotary axes.
    /// Choice between two solutions for a direction.
    machine::Prefer prefer = machine::Prefer::Shortest;
};

}  // namespace ncsim::setup
