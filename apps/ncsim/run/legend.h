// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes, zero, scale, legend and marked places of a picture.
#pragma once

#include "ncsim/export/marks.h"
#include "ncsim/export/render_options.h"

#include "run/outcome.h"

namespace ncsim::app {

/// Returns the marks that the options request.
exporter::Marks marks_of(const Outcome& outcome, const exporter::RenderOptions& options);

}  // namespace ncsim::app
