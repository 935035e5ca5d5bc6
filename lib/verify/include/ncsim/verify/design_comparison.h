// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of the part with the design: gouges and excesses.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/boundary.h"

#include <optional>
#include <vector>

namespace ncsim::verify {

/// Connected place where the part and the design differ by more than the tolerance.
struct DesignRegion {
    /// Largest depth found in the region, mm. Points of the region are searched at distances of at
    /// most DesignComparison::grain_mm.
    double depth_mm = 0.0;
    Vec3 point;  ///< Point of the largest depth; mm, W.
    /// Lower bound (mm) of the depth of a point of the region below the surface of the body that
    /// contains the point: the design for a gouge, the part for an excess. If that body is thin
    /// there, as at a sharp edge, the bound is less than `depth_mm`.
    double below_mm = 0.0;
    Box box;  ///< Box of the points found; mm, W.
    /// Origin of the face of the part at or nearest to the deepest point that lies at a cut face;
    /// kStockOrigin if no point does.
    cda::Origin origin = cda::kStockOrigin;
    std::vector<cda::Origin> origins;  ///< Origins of all faces at points of the region, sorted.
};

/// Regions of missing material (gouge) or of material left (excess).
struct DesignSide {
    std::vector<DesignRegion> regions;  ///< Deepest first.
    /// Volume (mm³) of the whole difference on this side, including the part within the tolerance.
    /// Empty if common_volume() gave no result.
    std::optional<double> volume_mm3;
};

/// Result of compare().
struct DesignComparison {
    DesignSide gouge, excess;
    /// Largest distance (mm) found between a point and the opposite surface, also within the
    /// tolerance.
    double deviation_mm = 0.0;
    /// Bound (mm) for undetected differences. Each place deeper than the tolerance plus this value
    /// was found, or another place within a grain around that place was. Each region found is
    /// deeper than the tolerance. The true largest depth exceeds the reported depth by at most this
    /// value and 2 %.
    double resolution_mm = 0.0;
    /// Size (mm) of the cubes in which findings are gathered. Regions nearer to each other than
    /// this size are merged; regions less than twice this size apart along each axis may be merged.
    double grain_mm = 0.0;
};

/// Compares `part` with `design`. The depth of a point is its distance from the opposite surface.
/// Gouges are points of the part's surface inside the design and points of the design's surface
/// outside the part; excesses are the reverse.
///
/// The search does not sample blindly. A piece of surface is skipped if a proof shows that the
/// piece lies within the tolerance: prisms over the triangles of the opposite surface cover the
/// piece, or all corners of the piece are within the tolerance of a single triangle, which is
/// convex. The remaining pieces are halved down to an eighth of the tolerance. If the number of
/// pieces exceeds a limit, the search stops early and `resolution_mm` is larger.
/// Requires: tolerance_mm > 0. The part and the design are not empty. `design` is a closed,
///   oriented surface that does not cross itself; mm, W.
/// Guarantees: the result depends on the arguments only.
DesignComparison compare(const cda::Boundary& part, const TriangleMesh& design,
                         double tolerance_mm);

}  // namespace ncsim::verify
