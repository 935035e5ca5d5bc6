// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in VRML97 (ISO/IEC 14772-1:1997): IndexedFaceSet and Box where Transforms bring them, DEF
// and USE. What else has a shape is refused, for a shape that is left out would be one that nothing
// meets.
#pragma once

#include "ncsim/cda/vec.h"

#include <string_view>
#include <vector>

namespace ncsim::setup {

bool is_vrml(std::string_view bytes);
/// Three corners for each triangle, as they are. Throws Refused, with the line.
std::vector<cda::Vec3> read_vrml(std::string_view bytes);

}  // namespace ncsim::setup
