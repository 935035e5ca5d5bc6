// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight and round elements of the profile of a tool. mm, from the tip along the axis.
#pragma once

#include "ncsim/toolpath/tool.h"

#include <vector>

namespace ncsim::brep {

/// Element of a profile. Straight: radius and height at the lower and the upper end. Round:
/// `fillet` about (radius, height).
struct ProfileElement {
    double radius = 0.0, height = 0.0, end_radius = 0.0, end_height = 0.0;
    double fillet = 0.0;
    double rise() const { return end_height - height; }
    double widening() const { return end_radius - radius; }
};

/// Returns the elements from the tip upwards, closed below and above by discs.
std::vector<ProfileElement> elements_of(const toolpath::ToolPiece& piece);

}  // namespace ncsim::brep
