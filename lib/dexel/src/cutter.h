// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex bodies against rows of rays. Of each ray, a cell has what lies above the highest of its
// planes that face down and below the lowest of those that face up.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"

#include "rays.h"
#include "round_sweep.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ncsim::dexel {

/// A cell in doubles. Normals have 24 bits and rays lie at half units, so that nothing is rounded
/// but the quotient at last.
struct CuttingCell {
    CuttingCell(const cda::Cell& cell, const cda::Lattice& lattice, const Grid& grid);

    struct Facet {
        std::array<double, 3> normal;
        double offset;
        PackedNormal left;  ///< Of what is left of a part there: into the cell.
    };
    std::vector<Facet> facets;
    GridBox box;
    cda::Origin origin;
};

/// Cuts the rays of one direction, row by row.
class Cutter {
public:
    Cutter(const Grid& grid, Rays& rays) : grid_(grid), rays_(rays) {}

    /// The rows from `begin` to before `end`.
    void cut(const CuttingCell& cell, std::size_t begin, std::size_t end);
    void cut(const SweptTool& tool, std::size_t begin, std::size_t end);
    /// Makes the rays what the cell has of them.
    void fill(const CuttingCell& cell);

private:
    struct Range {
        std::size_t begin, end;
    };
    Range find_intervals(const CuttingCell& cell, std::size_t row, Range range);
    template <class Take>
    void for_each_interval(const CuttingCell& cell, std::size_t row, Take take);

    const Grid& grid_;
    Rays& rays_;
    // Of the rays of a row, kept for their memory: where the interval begins and ends, and the
    // facets there.
    std::vector<double> low_, high_, low_facet_, high_facet_;
};

}  // namespace ncsim::dexel
