// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace ncsim::toolpath {

/// On which side of the round tool the polytope errs. Circumscribed: it contains the tool, so a
/// simulation removes everything the tool does, and a little more. Inscribed: the other way, but
/// for less than a unit at the rim of a cone that ends between two lattice heights. Fair: as
/// circumscribed but for balls and rounded corners, whose facets lie within the tool and whose
/// corners stand out of it, so that what a finishing cut leaves is neither too much nor too little
/// on average; their lower end, and where they become cylinder, cone or disc, are exact.
enum class Side : std::uint8_t { Circumscribed, Inscribed, Fair };

}  // namespace ncsim::toolpath
