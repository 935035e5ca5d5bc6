// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine that mills a part, for files that can move.
#pragma once

#include "ncsim/export/moving_scene.h"

#include "run/outcome.h"

namespace ncsim::app {

/// The links under those that carry them, with tools in the spindle and their joints as the program
/// moves them. Requires a simulation on a machine with links.
exporter::MovingScene moving_machine(const Outcome& outcome);

}  // namespace ncsim::app
