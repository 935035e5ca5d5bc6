// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hulls that a program removes from its stock, as passed to the exact models.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/polytope.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::bench {

struct Hulls {
    std::string name;
    Box stock;  ///< mm
    cda::Lattice lattice;
    std::vector<cda::Cell> cells;

    cda::Cell stock_cell() const;
    /// Returns the volume that the hulls leave, mm³.
    double exact_volume() const;
};

/// Returns at most `most` hulls of a file, or of a program of programs.h.
/// Throws: std::invalid_argument if there is neither.
Hulls hulls_of(const std::string& name, std::size_t most = ~std::size_t{0});

/// Clipping of hulls: to the stock, or to the range of the lattice.
enum class Within { Stock, Lattice };
/// Returns the clipped hulls as polytopes, without empty intersections.
std::vector<cda::ConvexPolytope> bodies_of(const Hulls& hulls, Within within);

}  // namespace ncsim::bench
