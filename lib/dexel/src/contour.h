// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface between the ends of rays: dual contouring.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/dexel/mesher.h"

#include "cutter.h"
#include "rays.h"

#include <array>
#include <cstddef>

namespace ncsim::dexel {

/// Which corners of the grid are in the material is told by the rays along z; where edges of the
/// grid cross the surface, and how it lies there, by the ends of rays along them. Each cell that is
/// crossed gets a corner of the surface for each piece of it (cell_components.h), which is nearest
/// to the planes at these ends and in the cell; around each crossed edge, the cells' corners are a
/// facet. Where two pieces that meet in a face of a cell have the same corners on both sides of it,
/// each gets one of its own between, so that all edges have two facets.
///
/// Ju, Losasso, Schaefer, Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002. Expected
/// O(corners of the grid / 64 + surface).
///
/// Of directions without rays, edges cross the surface where the planes at the ends of the rays
/// beside them do; where these tell nothing, as of walls, in the middle, and on the stock's own
/// surface where that is.
///
/// Or marching cubes, as the thesis has them (2.2): with the ends of rays as corners, which cuts
/// all edges of the part off.
class Contour {
public:
    Contour(const Grid& grid, const std::array<Rays, 3>& rays, const CuttingCell& stock,
            const cda::Lattice& lattice, std::size_t threads, Mesher mesher);

    cda::Boundary boundary() const;

private:
    const Grid& grid_;
    const std::array<Rays, 3>& rays_;
    const CuttingCell& stock_;
    cda::Lattice lattice_;
    std::size_t threads_;
    Mesher mesher_;
};

}  // namespace ncsim::dexel
