// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/machine/orient.h"

#include <string>

namespace ncsim::setup {

/// How a machine turns.
struct ToldKinematics {
    machine::Chain chain;       ///< In machine coordinates.
    std::string untold_pivots;  ///< Letters of axes of which nobody told where they lie.
    std::string guess;          ///< What else nobody told, in words; empty: nothing.
    machine::Travels travels;   ///< Of rotary axes.
    machine::Prefer prefer = machine::Prefer::Shortest;  ///< Where two ways lead to a direction.
};

}  // namespace ncsim::setup
