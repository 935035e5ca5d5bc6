// SPDX-License-Identifier: GPL-3.0-or-later
//
// Approximation of round tools by polytopes; no other file approximates the shape of a tool.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/toolpath/side.h"
#include "ncsim/toolpath/tool.h"

#include <vector>

namespace ncsim::toolpath {

/// Accuracy of a tool's polytope.
struct ToolAccuracy {
    /// Largest distance between the surfaces of the tool and of the polytope, in mm, on either
    /// side. A tolerance of 0.05 gives a 10 mm end mill 24 sides.
    double tolerance_mm = 0.05;
    Side side = Side::Circumscribed;
    /// True if the tool turns during cuts. Otherwise the directions of most edges are short, so
    /// that the walls of successive moves meet in the edges.
    bool turns = false;
};

/// Corners of a polytope in lattice units, in frame T. Facets with four or more corners are exactly
/// planar, because horizontal sections at corner heights are polygons with integer corners and
/// parallel sides.
struct PiecePolytope {
    std::vector<cda::LatticePoint> points_T;
    int sides = 0;  ///< Number of sides of the largest section, a multiple of 4.
    /// Bound on the distance between both surfaces. It may exceed a tolerance below a thousandth of
    /// the radius or below 2 √r units, where r is the radius in units (14 µm for 5 mm at 10 nm),
    /// because lattice polygons are no finer, and a tolerance that requires more than 8,192
    /// corners.
    double error_mm = 0.0;
    bool cutting = true;
};

/// Returns the cheapest polytope found that meets the tolerance, with at least 16 sides. The cost
/// is the number of facets, plus a share for edges without short directions (ToolAccuracy::turns)
/// and for edges that finished parts show. Four sides have the normals ±x and ±y. Circumscribed,
/// the lower end lies exactly at its height, and these four sides of a cylinder lie exactly at its
/// radius: axis-parallel slots get their nominal width and depth. Pieces with several radii, such
/// as ball noses, have rings whose radii are multiples of a number b between √r/2 and 2√r units (or
/// r/200 if larger), where r is the largest radius. If no such b divides r, or none is fine enough
/// for the remaining radii, the four sides lie a few units farther out, always less than √r/2.
/// Profiles with three or more radii, and whole balls (lollipops) of a few units, may need twice
/// the least tolerance.
///
/// Facets of cones under a wider ring, as at the tips of drills and V-bits, meet exactly in the
/// corners of that ring; otherwise their normals would be rounded. Therefore the ring is lower by
/// less than a quarter of the tolerance (0.3 µm for a drill of 4 mm). A tool with a single radius
/// has a ring radius that is a multiple of a number b of one thousand to some thousand units; if no
/// such b divides the radius, the ring is up to nine units larger. Inscribed, cones that extend to
/// the upper end are not moved.
///
/// Smaller rings around rounded corners have fewer sides: every second, third … side of the largest
/// polygon, in a multiple of four. Azimuth and profile share the tolerance. A ball of radius r
/// needs about 2.1 r/ε planes (fair: 1.4 to 1.8), compared with 3 to 4 r/ε if all rings have
/// equally many sides.
///
/// The radial error of a k-gon is r(1/cos(π/k) - 1). An arc of radius ρ over the angle Φ in n steps
/// adds ρ(1/cos(Φ/2n) - 1). The lattice adds about r/b. error_mm is measured, not estimated: the
/// largest distance of a corner from the round piece, or of a point of the round piece from the
/// polytope.
PiecePolytope approximate(const ToolPiece& piece, const cda::Lattice& lattice,
                          const ToolAccuracy& accuracy);

/// Returns the polytope of the cylinder `piece`; if `piece` is as thick as the upper end of
/// `below`, with the corners of approximate(`below`), so that `piece` follows `below` through a cut
/// and touches only the walls. Otherwise returns approximate(`piece`).
PiecePolytope approximate_above(const ToolPiece& below, const ToolPiece& piece,
                                const cda::Lattice& lattice, const ToolAccuracy& accuracy);

}  // namespace ncsim::toolpath
