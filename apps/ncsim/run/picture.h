// SPDX-License-Identifier: GPL-3.0-or-later
//
// Picture of `ncsim run --png`.
#pragma once

#include "ncsim/export/image.h"

#include "run/outcome.h"

namespace ncsim::app {

/// Draws the part as the options request: one view, or several on a sheet with a caption.
/// Requires: a simulation.
/// Throws: std::runtime_error if the picture cannot be drawn, or the sheet would be too large.
exporter::Image picture(const Outcome& outcome);

}  // namespace ncsim::app
