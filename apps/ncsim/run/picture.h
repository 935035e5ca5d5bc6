// SPDX-License-Identifier: GPL-3.0-or-later
//
// Picture of `ncsim run --png`.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/image.h"

#include "run/outcome.h"

#include <string_view>

namespace ncsim::app {

/// Draws the part as the options request: one view, or several on a sheet with a caption.
/// Requires: a simulation.
/// Throws: std::runtime_error if the picture cannot be drawn, or the sheet would be too large.
exporter::Image picture(const Outcome& outcome);

/// Throws: std::runtime_error if the plane of --cut-view does not cut a body with the box `body`.
/// `name`: "stock" or "part".
void require_cut_view(const Options& options, const Box& body, std::string_view name);

}  // namespace ncsim::app
