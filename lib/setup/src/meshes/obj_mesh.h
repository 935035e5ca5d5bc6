// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in Wavefront's OBJ (Appendix B1 of the Advanced Visualizer manual, 1995): points and
// faces; all else is passed over, but for what is no polygon.
#pragma once

#include "ncsim/cda/vec.h"

#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Does it begin with a word of this format?
bool is_obj(std::string_view bytes);
/// Three corners for each triangle, as they are. Throws Refused, with the line.
std::vector<cda::Vec3> read_obj(std::string_view bytes);

}  // namespace ncsim::setup
