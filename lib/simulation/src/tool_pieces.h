// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of a tool for pages.
#pragma once

#include "ncsim/simulation/play_data.h"
#include "ncsim/toolpath/tool.h"

#include <vector>

namespace ncsim::simulation {

/// Returns a body for each piece of `tool`, tip in the origin: cutting pieces in gold, shank and
/// holder in grey. Round shapes are within 0.1 mm.
std::vector<ColouredMesh> tool_pieces(const toolpath::Tool& tool);

}  // namespace ncsim::simulation
