// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/boundary.h"

#include <vector>

namespace ncsim::brep {

/// A boundary, and for each of its faces who cut it.
struct Facets {
    cda::Boundary boundary;
    std::vector<std::vector<cda::Origin>> origins;
};

}  // namespace ncsim::brep
