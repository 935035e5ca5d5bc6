// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fixtures and tool in mesh files.
#pragma once

#include "ncsim/export/moving_scene.h"

#include "run/outcome.h"

namespace ncsim::app {

/// Adds a node for each fixture, next to the part. Without a machine, adds the tool at its last
/// position, if the options show the tool.
void add_standing_bodies(const Outcome& outcome, exporter::MovingScene& scene);

}  // namespace ncsim::app
