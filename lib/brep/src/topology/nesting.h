// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shells of a boundary, and their nesting: solids with the voids inside.
#pragma once

#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Returns the faces of each shell, by the shell's number; empty for numbers without faces.
std::vector<std::vector<std::uint32_t>> shells_of(const cda::Boundary& boundary);

/// Shell that encloses material, with the voids inside, as numbers of shells. A boundary with a
/// void alone has a nesting with that void as the outside.
struct Nesting {
    std::uint32_t outside = 0;
    std::vector<std::uint32_t> voids;
};
std::vector<Nesting> nesting_of(const cda::Boundary& boundary);

}  // namespace ncsim::brep
