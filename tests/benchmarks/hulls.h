// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hulls that a program takes from its stock, as the exact models get them.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::bench {

struct Hulls {
    std::string name;
    cda::Box stock;  ///< mm
    cda::Lattice lattice;
    std::vector<cda::Cell> cells;

    cda::Cell stock_cell() const;
    /// Of what they leave, mm³.
    double exact_volume() const;
};

/// Of a file, or of one of the programs of programs.h; of them no more than `most`. Throws
/// std::invalid_argument if there is neither.
Hulls hulls_of(const std::string& name, std::size_t most = ~std::size_t{0});

/// What of them is in the stock, or, else, on the lattice, as polytopes.
enum class Within { Stock, Lattice };
std::vector<cda::ConvexPolytope> bodies_of(const Hulls& hulls, Within within);

}  // namespace ncsim::bench
