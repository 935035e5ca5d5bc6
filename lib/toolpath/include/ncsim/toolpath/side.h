// SPDX-License-Identifier: GPL-3.0-or-later
//
// Direction of the error of a tool's polytope.
#pragma once

#include <cstdint>

namespace ncsim::toolpath {

/// Side of the round tool on which the polytope errs.
/// - Circumscribed: the polytope contains the tool, so a simulation removes all that the tool
///   removes, and a little more.
/// - Inscribed: the tool contains the polytope, except for less than a unit at the rim of a cone
///   that ends between two lattice heights.
/// - Fair: as Circumscribed, except on balls and rounded corners. There the facets lie within the
///   tool and the corners outside, so a finishing cut leaves neither too much nor too little on
///   average. The lower end, and the transition to a cylinder, cone or disc, are exact.
enum class Side : std::uint8_t { Circumscribed, Inscribed, Fair };

}  // namespace ncsim::toolpath
