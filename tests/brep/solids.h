// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids built by hand, with volumes by formulas.
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

/// Returns a cylinder of radius 5 and height 8; the frustum of a cone from radius 6 to 3 over 4; a
/// box of 20 x 16 x 10 with a through bore of 6; the same box with a drilled hole, with a dimple of
/// a ball, and with a slot; a bar with an annular groove; an oblique circular cylinder; and a box
/// with a bore of that form. Lengths are in mm.
std::vector<NamedPart> solids();

}  // namespace ncsim::brep::test
