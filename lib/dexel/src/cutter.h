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
#include <cstdint>
#include <span>
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
    Cutter(const Grid& grid, Rays& rays, Lanes lanes = widest_lanes())
        : grid_(grid), rays_(rays), lanes_(lanes) {}

    /// The rows from `begin` to before `end`.
    void cut(const CuttingCell& cell, std::size_t begin, std::size_t end);
    void cut(const SweptTool& tool, std::size_t begin, std::size_t end);
    /// The same for several that are all open above the stock, one after the other; of rays along z
    /// alone. Each ray is cut once, by the one that reaches lowest there, the first of several.
    void cut_open(std::span<const SweptTool* const> tools, std::size_t begin, std::size_t end);
    /// Makes the rays what the cell has of them.
    void fill(const CuttingCell& cell);

private:
    struct Range {
        std::size_t begin, end;
    };
    static void leave_out_lower(const double* ends, const double* x, const SweptTool& tool,
                                double reach, Range& range);
    Range find_intervals(const CuttingCell& cell, std::size_t row, Range range);
    // Of the rays from `begin` on, what is between the places of these arrays, where that is not
    // in their gap anyhow. end(i, below): of what is left of ray begin + i there.
    template <class MakeEnd>
    void take_away(std::size_t row, std::size_t begin, std::size_t count, const double* low,
                   const double* high, const MakeEnd& end);

    const Grid& grid_;
    Rays& rays_;
    Lanes lanes_;
    // Of the rays of a row, kept for their memory: where the interval begins and ends, and the
    // facets there.
    std::vector<double> low_, high_, low_facet_, high_facet_;
    RowMeeting met_;
    LowestRow lowest_;
    std::vector<double> padded_x_;
    std::vector<std::int32_t> low_units_, high_units_;
    std::vector<std::uint8_t> is_cut_;
};

}  // namespace ncsim::dexel
