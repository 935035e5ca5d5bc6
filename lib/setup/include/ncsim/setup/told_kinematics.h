// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/machine/chain.h"

#include <string>

namespace ncsim::setup {

/// How a machine turns.
struct ToldKinematics {
    machine::Chain chain;       ///< In machine coordinates.
    std::string untold_pivots;  ///< Letters of axes of which nobody told where they lie.
};

}  // namespace ncsim::setup
