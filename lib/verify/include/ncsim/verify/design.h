// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part against the design: where was too much taken away, and where is too much left?
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/cda/vec.h"

#include <optional>
#include <vector>

namespace ncsim::verify {

/// A place where part and design are farther apart than the tolerance.
struct DesignRegion {
    double depth_mm = 0.0;  ///< The largest found in it; no point of it was asked farther than
                            ///< DesignComparison::grain_mm from another.
    cda::Vec3 point;        ///< Where that is, mm, W.
    /// Depth of a point of the region below the surface of the body that has it, at least, mm: of
    /// the design for a gouge, of the part for an excess. Where that body is thin, as at a sharp
    /// edge, this is less than `depth_mm`.
    double below_mm = 0.0;
    cda::Box box;  ///< Of the points found in it, mm, W.
    /// Of the face of the part at or nearest to its deepest point that is at a face that was cut;
    /// the stock's if there is none.
    cda::Origin origin = cda::kStockOrigin;
    std::vector<cda::Origin> origins;  ///< Of all faces at its points, sorted.
};

/// What is missing (gouge), or what is too much (excess).
struct DesignSide {
    std::vector<DesignRegion> regions;  ///< The deepest first.
    /// mm³, of the whole difference on this side, what is within the tolerance included. Empty
    /// where common_volume() had nothing to say.
    std::optional<double> volume_mm3;
};

struct DesignComparison {
    DesignSide gouge, excess;
    /// The farthest that a point was found from the other surface, mm; within the tolerance, too.
    double deviation_mm = 0.0;
    /// What lies deeper than the tolerance and this was found, or something was in a grain around
    /// it; what was found lies deeper than the tolerance. The deepest of all is deeper than told
    /// by no more than this and 2 %.
    double resolution_mm = 0.0;
    /// Regions that are nearer to each other than this may be told as one, mm.
    double grain_mm = 0.0;
};

/// Compares a part with its design: a closed, oriented surface that does not cross itself, in mm,
/// in W. Depth is the distance to the other surface, asked of both surfaces: a gouge of the points
/// of the part's surface inside the design and of the points of the design's outside the part, an
/// excess of the others.
///
/// Not sampled blindly: a piece of surface of which it is proved that it lies within the tolerance
/// (covered by prisms over the other's triangles, or near to a convex one in all its corners) is
/// left alone, the rest is halved, down to an eighth of the tolerance. Where that would be too many
/// pieces, `resolution_mm` tells where it stopped. Requires tolerance_mm > 0, and that of part and
/// design there is something. The result depends on the arguments only.
DesignComparison compare(const cda::Boundary& part, const cda::TriangleMesh& design,
                         double tolerance_mm);

}  // namespace ncsim::verify
