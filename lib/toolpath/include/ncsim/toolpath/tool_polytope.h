// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round tools become polytopes: the one place where the shape of a tool is approximated.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/toolpath/tool.h"

#include <cstdint>
#include <vector>

namespace ncsim::toolpath {

/// On which side of the round tool the polytope errs. Circumscribed: it contains the tool, so a
/// simulation removes everything the tool does, and a little more. Inscribed: the other way.
enum class Side : std::uint8_t { Circumscribed, Inscribed };

struct ToolAccuracy {
    /// Largest distance between the surfaces of the tool and of the polytope, in mm. 0.05 gives
    /// a 10 mm end mill 24 sides.
    double tolerance_mm = 0.05;
    Side side = Side::Circumscribed;
};

/// Corners of a polytope in lattice units, in frame T. Facets with four or more corners are exactly
/// flat: all its horizontal sections are integer multiples of one polygon with integer corners.
struct PiecePolytope {
    std::vector<cda::LatticePoint> points_T;
    int sides = 0;  ///< Of that polygon, a multiple of 4.
    /// Bound on the distance between both surfaces. It may exceed a tolerance that is less than a
    /// thousandth of the radius, where the lattice polygons are no finer, and where it would take
    /// more than 8,192 corners.
    double error_mm = 0.0;
    bool cutting = true;
};

/// The polytope of a piece with the fewest facets that meets the tolerance, but at least 16
/// sides. Four sides have the normals ±x and ±y and, circumscribed, lie exactly at the largest
/// radius, the lower end exactly at its height: axis-parallel slots get their nominal width and
/// depth.
///
/// For a k-gon the radial error is r(1/cos(π/k) - 1); an arc of radius ρ over the angle Φ in n
/// steps adds ρ(1/cos(Φ/2n) - 1); the lattice adds less than 0.2 % of r. error_mm is measured, not
/// estimated: the corner farthest from the round piece.
PiecePolytope approximate(const ToolPiece& piece, const cda::Lattice& lattice,
                          const ToolAccuracy& accuracy);

}  // namespace ncsim::toolpath
