// SPDX-License-Identifier: GPL-3.0-or-later
//
// Picture of a machine.
#pragma once

#include "ncsim/export/image.h"
#include "ncsim/export/overlay.h"
#include "ncsim/export/render_options.h"
#include "ncsim/setup/machine_file.h"

#include <string>
#include <vector>

namespace ncsim::app {

/// Makes the links with these names transparent.
/// Throws: std::runtime_error for a name that no link with a mesh has.
void make_transparent(setup::MachineFile& file, const std::vector<std::string>& names);

/// Returns a link of a machine as a body with corners at `corners`.
exporter::Body machine_body(const setup::MachineBody& link, std::vector<Vec3> corners);

/// Draws the links with the joints at `values`, seen along `view`.
/// Throws: std::runtime_error if no link has a shape, or the picture cannot be drawn.
exporter::Image picture_of(const setup::MachineFile& file, const machine::Values& values,
                           exporter::View view);

}  // namespace ncsim::app
