// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `ncsim run --png` shows.
#pragma once

#include "ncsim/export/image.h"

#include "run/outcome.h"

namespace ncsim::app {

/// The part as the options of its job ask: one view, or several on a sheet with a caption. Requires
/// a simulation. Throws std::runtime_error if nothing can be drawn, or the sheet would be too
/// large.
exporter::Image picture(const Outcome& outcome);

}  // namespace ncsim::app
