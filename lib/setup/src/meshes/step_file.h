// SPDX-License-Identifier: GPL-3.0-or-later
//
// STEP files as triangles. A separate program, ncsim-step, reads STEP: OpenCASCADE has 80 MB, which
// no further part needs, and a crash of OpenCASCADE becomes a message.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Triangles of a STEP file.
struct StepSurface {
    TriangleMesh mesh;                    ///< mm; `face` counts the faces of all solids.
    std::vector<std::string> face_names;  ///< Empty for faces without a name.
};

/// True if the text begins as a STEP file does.
bool is_step(std::string_view bytes);

/// Returns triangles within `deflection_mm` of the surfaces. Throws: std::runtime_error with the
/// reason: ncsim-step is missing, the file is invalid or has no solid, or a limit was exceeded.
StepSurface read_step(const std::string& bytes, double deflection_mm);

}  // namespace ncsim::setup
