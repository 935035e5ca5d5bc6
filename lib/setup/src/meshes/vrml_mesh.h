// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in VRML97: IndexedFaceSet and Box, placed by Transforms, with DEF and USE. Further shapes
// are refused, because a shape that is left out would never collide. Source: ISO/IEC 14772-1:1997.
#pragma once

#include "ncsim/base/vec3.h"

#include <string_view>
#include <vector>

namespace ncsim::setup {

/// True if the text begins as a VRML file does.
bool is_vrml(std::string_view bytes);
/// Returns three corners per triangle, in the units of the file. Throws: Refused, with the line.
std::vector<Vec3> read_vrml(std::string_view bytes);

}  // namespace ncsim::setup
