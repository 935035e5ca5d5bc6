// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which block cuts a piece of the part free?
#pragma once

#include "ncsim/simulation/simulate.h"
#include "ncsim/verify/finding.h"

#include <vector>

namespace ncsim::simulation {

/// A finding of the rule part-cut-free for each piece beside the largest, at the block that
/// separated it: found by cutting again up to some of the motions whose walls it has, so that it
/// costs a few simulations where there is such a piece, and one boundary where there is none.
/// Pieces no thicker than the tools are accurate are noted together, at no place. Pieces that were
/// milled away later are not seen.
std::vector<verify::Finding> cut_free(const Plan& plan, const Survey& survey,
                                      const Verification& verification,
                                      const Simulation& simulation);

}  // namespace ncsim::simulation
