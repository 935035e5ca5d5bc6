// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinematics of a machine, with its assumptions.
#pragma once

#include "ncsim/machine/orient.h"

#include <string>

namespace ncsim::setup {

/// Specified kinematics of a machine.
struct SpecifiedKinematics {
    machine::Chain chain;            ///< In machine coordinates.
    std::string unspecified_pivots;  ///< Letters of rotary axes with unknown position.
    std::string guess;               ///< Further assumptions, in words; empty if none.
    machine::Travels travels;        ///< Travels of rotary axes.
    /// Choice between two solutions for a direction.
    machine::SolutionPreference prefer = machine::SolutionPreference::Shortest;
};

}  // namespace ncsim::setup
