// SPDX-License-Identifier: GPL-3.0-or-later
//
// Animated machine that mills a part, for animated files.
#pragma once

#include "ncsim/export/moving_scene.h"

#include "run/outcome.h"

namespace ncsim::app {

/// Returns the tree of links, with the tools in the spindle and the joints as the program moves
/// them.
/// Requires: a simulation on a machine with links.
exporter::MovingScene moving_machine(const Outcome& outcome);

}  // namespace ncsim::app
