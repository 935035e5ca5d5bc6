// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of pairs of tool poses to the cells that the tool removes between them.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/tool_pose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::toolpath {

/// Simplifications of the hulls of a rotating tool.
struct SweepSimplification {
    /// Height above the tip, mm, above which the tool is cut off, as by cut_off().
    double top_mm = std::numeric_limits<double>::infinity();
    /// Facets may be left out if the hull gains at most this, mm. Inscribed tools keep all facets.
    double slack_mm = 0.0;
    /// Height of slabs, mm: each piece leaves a hull per slab of slabs_of().
    double slab_mm = std::numeric_limits<double>::infinity();
};
/// Returns the simplifications under which the bounds of a step hold.
SweepSimplification simplification_of(const RotationBounds& turning, double slack_mm = 0.0);

/// Cutting pieces of a tool as polytopes on a lattice, ready to be moved.
class Cutter {
public:
    /// Makes the polytopes. `below` is the piece that the only piece of `tool` follows; see
    /// approximate_above().
    Cutter(const Tool& tool, const cda::Lattice& lattice, const ToolAccuracy& accuracy,
           const ToolPiece* below = nullptr);

    /// Appends to `cells` the convex hull of each piece, or of each slab of a piece, at X_WA and at
    /// X_WB. Hulls are exact if the poses differ only in translation; rotated corners are rounded
    /// to the lattice (by half a unit per axis). The error is on the side of the tool's accuracy. A
    /// tool at rest leaves its own shape. The deeper a cell along the tool's axis, the lower its
    /// rank: if a wall was cut in several depths, the whole wall belongs to the deepest pass. Poses
    /// beyond cda::kMaxPose units are clamped.
    void trace(const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
               std::vector<cda::Cell>& cells, const SweepSimplification& liberties = {});

    /// Appends cells for the cylindrical part of each piece on a whole turn that leaves no core, as
    /// computed by cda::TranslationSweep::around(); no cell if that volume is not known to exist.
    /// The volume lies within the cells that trace() makes of the steps. Its rank is before the
    /// rank of these cells.
    void cover(std::span<const cda::LatticePoint> turn, const Pose& X_WA, cda::Origin origin,
               std::vector<cda::Cell>& cells);

    /// Returns a box (mm) around all cells that trace() makes of these poses, except for the slack.
    /// The box is fast to compute, before tracing.
    Box bounds(const Pose& X_WA, const Pose& X_WB, const SweepSimplification& liberties = {}) const;
    /// True if the bounds of a hull that trace() makes of these poses overlap `place` (mm).
    /// Requires: the poses have the same orientation.
    bool meets(const Box& place, const Pose& X_WA, const Pose& X_WB);

    /// Returns the largest distance of a corner from the tool axis, mm.
    double radius_mm() const { return radius_ * lattice_.unit_mm; }

    /// Rows of a rotation matrix.
    using Rotation = std::array<Vec3, 3>;
    /// Box of the tool relative to its tip, along each axis, in lattice units.
    struct Reach {
        cda::LatticePoint low, high;
    };
    /// Returns the reach of the tool in the orientation of X_WT.
    Reach reach(const Pose& X_WT) const { return reach(X_WT.rows, high_); }
    /// Returns bounds() of two poses that both have this reach.
    Box bounds(const Pose& X_WA, const Pose& X_WB, const Reach& reach) const;

    /// Returns the dimensions of the cutting pieces.
    const ToolExtent& extent() const { return extent_; }
    /// Returns a bound on the distance between the tool and its polytopes.
    double error_mm() const { return error_mm_; }
    /// Returns the number of polytopes, for reports.
    std::size_t pieces() const { return pieces_.size(); }
    /// Returns the largest number of sides of a polytope.
    int sides() const { return sides_; }

private:
    Reach reach(const Rotation& rows, double end) const;

    struct Oriented {
        Rotation rows;
        std::vector<std::optional<cda::TranslationSweep>> sweeps;  // one per piece
        // Sweeps of the cylindrical part of each piece, unless that is the whole piece; made on
        // first use.
        std::vector<std::optional<cda::TranslationSweep>> straight;
    };

    Oriented& oriented(const Rotation& rows);
    // Returns the corners of the part `kept` of a piece, rotated by `rows`. Infinite heights cut
    // nothing off.
    std::vector<cda::LatticePoint> rotate_corners(const Rotation& rows, std::size_t piece,
                                                  const Slab& kept) const;

    cda::Lattice lattice_;
    cda::Rounding rounding_ = cda::Rounding::Outward;
    std::vector<PiecePolytope> pieces_;  // parallel to extent_.pieces
    std::vector<std::int64_t> tops_;     // top heights of pieces_, in units
    std::vector<Oriented> cache_;        // the latest orientations, newest last
    ToolExtent extent_;
    double radius_ = 0.0, low_ = 0.0, high_ = 0.0;  // cylinder around all corners, in units
    double error_mm_ = 0.0;
    int sides_ = 0;
};

/// True if the program specifies the start of the motion. A motion from an unknown start must not
/// leave a trace, because its path is made up.
bool has_known_start(const gcode::Motion& motion);
/// True if the program specifies the end of the motion. The end is certain even if the start is
/// unknown.
bool has_known_end(const gcode::Motion& motion);

}  // namespace ncsim::toolpath
