// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex bodies against rows of rays. Of each ray, a cell has what lies above the highest of its
// planes that face down and below the lowest of those that face up.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"

#include "pending_cuts.h"
#include "rays.h"
#include "round_sweep.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
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

using Body = std::variant<CuttingCell, SweptTool>;

/// Cuts the rays of one direction, row by row.
class Cutter {
public:
    Cutter(const Grid& grid, Rays& rays, Lanes lanes = widest_lanes())
        : grid_(grid), rays_(rays), lanes_(lanes) {}

    /// The rows from `begin` to before `end`, by these in their order.
    void cut(std::span<const Body* const> bodies, std::size_t begin, std::size_t end);
    /// Makes the rays what the cell has of them.
    void fill(const CuttingCell& cell);

private:
    struct Range {
        std::size_t begin, end;
    };
    // Into met_, from the first ray of those that may be met; which these are.
    Range meet(const CuttingCell& cell, std::size_t row);
    Range meet(const SweptTool& tool, std::size_t row, const PendingCuts& pending,
               std::size_t pending_row);
    void take_away(std::size_t row, std::size_t ray, const PendingCuts::Cut& cut,
                   std::span<const Body* const> bodies);

    const Grid& grid_;
    Rays& rays_;
    Lanes lanes_;
    // Of the rays of a row, kept for its memory. Of a cell, s is the number of the facet.
    RowMeeting met_;
};

}  // namespace ncsim::dexel
