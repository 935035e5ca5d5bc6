// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tool as pictures show it.
#pragma once

#include "ncsim/export/overlay.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_pose.h"

#include <vector>

namespace ncsim::app {

/// Returns a body for each piece of `tool` at pose X_WT: cutting pieces in gold, shank and holder
/// in grey; all in red if `is_marked`. Round shapes are within 0.02 mm.
std::vector<exporter::Body> tool_bodies(const toolpath::Tool& tool, const toolpath::Pose& X_WT,
                                        bool is_marked = false);

}  // namespace ncsim::app
