// SPDX-License-Identifier: GPL-3.0-or-later
//
// STEP as triangles. ncsim-step reads it, a program of its own: OpenCASCADE is 80 MB that nobody
// else needs, and what brings it down is a message here.
#pragma once

#include "ncsim/cda/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

struct StepSurface {
    cda::TriangleMesh mesh;               ///< mm; `face` counts the faces of all solids.
    std::vector<std::string> face_names;  ///< Empty: it has none.
};

/// Does it begin as STEP does?
bool is_step(std::string_view bytes);

/// Triangles within `deflection_mm` of its surfaces. Throws std::runtime_error that says why not:
/// no ncsim-step is there, it is no STEP, has no solid, or was too much.
StepSurface read_step(const std::string& bytes, double deflection_mm);

}  // namespace ncsim::setup
