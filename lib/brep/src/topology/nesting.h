// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// The faces of each shell, by its number; of a number that no face has, none.
std::vector<std::vector<std::uint32_t>> shells_of(const cda::Boundary& boundary);

/// Shells that enclose material, each with the voids that lie in it, as numbers of shells of the
/// boundary. A void by itself stands for one.
struct Nesting {
    std::uint32_t outside = 0;
    std::vector<std::uint32_t> voids;
};
std::vector<Nesting> nesting_of(const cda::Boundary& boundary);

}  // namespace ncsim::brep
