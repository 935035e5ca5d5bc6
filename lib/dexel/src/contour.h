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

/// Returns the surface by dual contouring of the rays. The rays along z determine which corners of
/// the grid are in the material. The ends of rays along an edge of the grid give the crossing of
/// the edge with the surface, and the normal. Each crossed cell gets a vertex for each piece of the
/// surface (cell_components.h): the point in the cell nearest to the planes at these crossings. The
/// vertices of the cells around each crossed edge form a facet. If two pieces that meet in a face
/// of a cell have the same vertices on both sides of the face, each piece gets a separate vertex in
/// between, so that every edge has two facets.
///
/// If a direction has no rays, the planes at the ends of the adjacent rays along z give the
/// crossings. If these planes are not usable, as for walls, the crossing is the middle of the edge,
/// or the stock's surface.
///
/// Mesher::MarchingCubes uses marching cubes instead, as in the thesis (2.2): vertices are ends of
/// rays, which cuts off all edges of the part.
/// Cost: expected O(corners of the grid / 64 + surface).
/// Source: Ju, Losasso, Schaefer, Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002.
cda::Boundary contour(const Grid& grid, const std::array<Rays, 3>& rays, const CuttingCell& stock,
                      const cda::Lattice& lattice, std::size_t threads, Mesher mesher);

}  // namespace ncsim::dexel
