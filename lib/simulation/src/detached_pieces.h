// SPDX-License-Identifier: GPL-3.0-or-later
//
// Search for the block that separates a piece from the part.
#pragma once

#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/finding.h"

#include <vector>

namespace ncsim::simulation {

/// Returns a finding of the rule part-cut-free for each piece except the largest, at the block that
/// separated it. The block is found by simulations up to some of the motions that left the piece's
/// walls. Pieces not thicker than the accuracy of the tools are reported together, without a place.
/// Pieces that were milled away later are not found.
/// Cost: a few simulations if there is a piece; otherwise one boundary.
std::vector<verify::Finding> detached_pieces(const Plan& plan, const Survey& survey,
                                             const Verification& verification,
                                             const Simulation& simulation);

}  // namespace ncsim::simulation
