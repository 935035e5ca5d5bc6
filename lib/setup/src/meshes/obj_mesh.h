// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in Wavefront OBJ: points and faces. Further statements are ignored, except for curves and
// surfaces, which are refused. Source: Appendix B1 of the Advanced Visualizer manual, 1995.
#pragma once

#include "ncsim/base/vec3.h"

#include <string_view>
#include <vector>

namespace ncsim::setup {

/// True if the text begins with a word of this format.
bool is_obj(std::string_view bytes);
/// Returns three corners per triangle, in the units of the file. Throws: Refused, with the line.
std::vector<Vec3> read_obj(std::string_view bytes);

}  // namespace ncsim::setup
