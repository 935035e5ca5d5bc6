// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids put together by hand, with their volumes as on paper.
#pragma once

#include "ncsim/brep/part.h"

#include <string>
#include <vector>

namespace ncsim::brep::test {

struct NamedPart {
    std::string name;
    Part part;
    double volume = 0.0;  ///< mm³
    int faces = 0;
};

/// A cylinder of radius 5 and height 8; the frustum of a cone from radius 6 to 3 over 4; a box of
/// 20 x 16 x 10 with a bore of 6 mm right through; the same box with a hole of a drill, with a
/// dimple of a ball, with a slot; a bar with a ring groove; a circle that moves
/// askew, and a box with a bore of that form.
std::vector<NamedPart> solids();

}  // namespace ncsim::brep::test
