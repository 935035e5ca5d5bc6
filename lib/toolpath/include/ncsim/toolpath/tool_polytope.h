// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round tools become polytopes: the one place where the shape of a tool is approximated.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/toolpath/side.h"
#include "ncsim/toolpath/tool.h"

#include <vector>

namespace ncsim::toolpath {

struct ToolAccuracy {
    /// Largest distance between the surfaces of the tool and of the polytope, in mm, to either
    /// side. 0.05 gives a 10 mm end mill 24 sides.
    double tolerance_mm = 0.05;
    Side side = Side::Circumscribed;
};

/// Corners of a polytope in lattice units, in frame T. Facets with four or more corners are exactly
/// flat: its horizontal sections at corners are polygons with integer corners whose sides are
/// parallel.
struct PiecePolytope {
    std::vector<cda::LatticePoint> points_T;
    int sides = 0;  ///< Of the largest of these polygons, a multiple of 4.
    /// Bound on the distance between both surfaces. It may exceed a tolerance that is less than a
    /// thousandth of the radius or less than 2 √r units, where r is the radius in units (14 µm for
    /// 5 mm at 10 nm), as the lattice polygons are no finer, and where it would take more than
    /// 8,192 corners.
    double error_mm = 0.0;
    bool cutting = true;
};

/// The polytope of a piece with the fewest facets that was found to meet the tolerance, but at
/// least 16 sides. Four sides have the normals ±x and ±y; circumscribed, the lower end lies exactly
/// at its height, and these sides, if the piece is a cylinder, exactly at its radius: axis-parallel
/// slots get their nominal width and depth. Pieces of several radii, such as ball noses, have rings
/// whose radii are multiples of one number b between √r/2 and 2√r units (or r/200, if that is
/// more), where r is the largest radius. Where no such b divides r, or none is fine enough for the
/// other radii, the four sides lie a few units farther out, always less than √r/2. Forms of three
/// radii and more, and whole balls (lollipops) of a few units, may need twice the least tolerance.
///
/// Facets of cones under a wider ring, as at the tips of drills and V-bits, meet exactly in their
/// corners, where their normals would be rounded otherwise: that ring is lower by less than a
/// quarter of the tolerance (a drill of 4 mm: 0.3 µm), and a tool of one radius has one that is a
/// multiple of a b of a thousand to some thousands units, which is up to nine units larger than it
/// where no such b divides it. Inscribed, cones that go on to the upper end are not moved.
///
/// Rings around rounded corners have fewer sides where they are smaller: of the largest polygon
/// every second, third … in a multiple of four; azimuth and profile share the tolerance. A ball of
/// radius r takes about 2.1 r/ε planes (fair: 1.4 to 1.8) where it took 3 to 4 with as many sides
/// everywhere.
///
/// For a k-gon the radial error is r(1/cos(π/k) - 1); an arc of radius ρ over the angle Φ in n
/// steps adds ρ(1/cos(Φ/2n) - 1); the lattice adds about 1/b of r. error_mm is measured, not
/// estimated: the corner farthest from the round piece, or the part of it farthest from the
/// polytope.
PiecePolytope approximate(const ToolPiece& piece, const cda::Lattice& lattice,
                          const ToolAccuracy& accuracy);

/// The polytope of `piece`, a cylinder, if it is as thick as the upper end of `below`: with the
/// corners that approximate() gives that, so that the one goes where the other has been without
/// touching more than the walls. Else approximate().
PiecePolytope approximate_above(const ToolPiece& below, const ToolPiece& piece,
                                const cda::Lattice& lattice, const ToolAccuracy& accuracy);

}  // namespace ncsim::toolpath
