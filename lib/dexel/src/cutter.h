// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex bodies against rows of rays. The interval of a cell on a ray is above the highest of the
// planes that face down and below the lowest of the planes that face up.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"

#include "pending_cuts.h"
#include "rays.h"
#include "round_sweep.h"

#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace ncsim::dexel {

/// A cell in doubles. Normals have 24 bits and rays lie at half units, so only the final quotient
/// is rounded.
struct CuttingCell {
    CuttingCell(const cda::Cell& cell, const cda::Lattice& lattice, const Grid& grid);

    struct Facet {
        std::array<double, 3> normal;
        double offset;
        PackedNormal left;  ///< Normal of the remaining part at the facet: into the cell.
    };
    std::vector<Facet> facets;
    GridBox box;
    cda::Origin origin;
};

/// A body that cuts rays.
using Body = std::variant<CuttingCell, SweptTool>;

/// Cuts the rays of a direction, row by row.
class Cutter {
public:
    Cutter(const Grid& grid, Rays& rays, Lanes lanes = widest_lanes())
        : grid_(grid), rays_(rays), lanes_(lanes) {}

    /// Cuts rows [begin, end) by the bodies in the given order.
    void cut(std::span<const Body* const> bodies, std::size_t begin, std::size_t end);
    /// Sets each ray to the cell's interval.
    void fill(const CuttingCell& cell);

private:
    struct Range {
        std::size_t begin, end;
    };
    // Computes meeting_ from the first ray that the body may meet; returns the range of these rays.
    Range intersect(const CuttingCell& cell, std::size_t row);
    Range intersect(const SweptTool& tool, std::size_t row, const PendingCuts& pending,
                    std::size_t pending_row);
    void subtract(std::size_t row, std::size_t ray, const PendingCuts::Cut& cut,
                  std::span<const Body* const> bodies);

    const Grid& grid_;
    Rays& rays_;
    Lanes lanes_;
    // Results for the rays of a row, a member to keep the memory. For a cell, s is the facet
    // number.
    RowMeeting meeting_;
};

}  // namespace ncsim::dexel
