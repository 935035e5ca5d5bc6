// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a moving tool leaves behind: pairs of poses become cells.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/toolpath/pose.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool.h"
#include "ncsim/toolpath/tool_polytope.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::toolpath {

/// How the hulls of a tool that turns are made, and what they may leave out.
struct Liberties {
    /// What is farther than this above the tip, as cut_off() says, mm.
    double top_mm = std::numeric_limits<double>::infinity();
    /// Facets without which the hull gains no more than this, mm. Inscribed tools keep all.
    double slack_mm = 0.0;
    /// A hull for each slab of a piece, as slabs_of() says.
    double slab_mm = std::numeric_limits<double>::infinity();
};
/// For the hulls that the bounds of a step are about.
Liberties liberties_of(const Turning& turning, double slack_mm = 0.0);

/// The cutting pieces of a tool as polytopes on a lattice, ready to be moved.
class Cutter {
public:
    /// `below`: what the only piece follows, if it is as thick as that: see approximate_above().
    Cutter(const Tool& tool, const cda::Lattice& lattice, const ToolAccuracy& accuracy,
           const ToolPiece* below = nullptr);

    /// Appends to `cells` the convex hull of each piece, or each of its slabs, at X_WA and at X_WB.
    /// Poses that differ in their translation only make exact hulls; turned ones are rounded to the
    /// lattice corner by corner (half a unit an axis). Errs on the side of the tool's accuracy. A
    /// tool at rest leaves its own shape. The deeper along the tool's axis, the lower the rank:
    /// where a wall was cut in several depths, the deepest pass has all of it. Poses beyond
    /// cda::kMaxPose units are clamped to it.
    void trace(const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
               std::vector<cda::Cell>& cells, const Liberties& liberties = {});

    /// Appends what the cylindrical part of each piece takes away on a whole turn that leaves no
    /// core, as cda::TranslationSweep::around() has it, if it is known to be something: all of it
    /// is in the cells that trace() makes of the steps. Before these in rank.
    void cover(std::span<const cda::LatticePoint> turn, const Pose& X_WA, cda::Origin origin,
               std::vector<cda::Cell>& cells);

    /// Encloses everything `trace` makes of these poses, but for the slack; in mm. Cheap: to ask
    /// before tracing.
    cda::Box bounds(const Pose& X_WA, const Pose& X_WB, const Liberties& liberties = {}) const;
    /// Does one of the hulls that `trace` makes of these poses, which do not differ in how the tool
    /// stands, have bounds that overlap `place` (mm)?
    bool meets(const cda::Box& place, const Pose& X_WA, const Pose& X_WB);

    /// Nothing reaches farther from the axis, mm.
    double radius_mm() const { return radius_ * lattice_.unit_mm; }

    using Rotation = std::array<cda::Vec3, 3>;
    /// How far the tool reaches from its tip along each axis.
    struct Reach {
        cda::LatticePoint low, high;
    };
    Reach reach(const Pose& X_WT) const { return reach(X_WT.rows, high_); }
    /// The same as bounds() of poses that have this reach both.
    cda::Box bounds(const Pose& X_WA, const Pose& X_WB, const Reach& reach) const;

    const ToolExtent& extent() const { return extent_; }
    /// Bound on the distance between the tool and its polytopes.
    double error_mm() const { return error_mm_; }
    /// Facets of the tool in the form it is moved in, for reports.
    std::size_t pieces() const { return pieces_.size(); }
    int sides() const { return sides_; }

private:
    Reach reach(const Rotation& rows, double end) const;

    struct Oriented {
        Rotation rows;
        std::vector<std::optional<cda::TranslationSweep>> sweeps;  // one per piece
        // Of what is a cylinder of each, where that is not all; once they are asked for.
        std::vector<std::optional<cda::TranslationSweep>> straight;
    };

    Oriented& oriented(const Rotation& rows);
    // Corners of what is left of a piece between two heights; infinite ones cut nothing off.
    std::vector<cda::LatticePoint> turned(const Rotation& rows, std::size_t piece,
                                          const Slab& kept) const;

    cda::Lattice lattice_;
    cda::Rounding rounding_ = cda::Rounding::Outward;
    std::vector<PiecePolytope> pieces_;  // as many as extent_ has
    std::vector<std::int64_t> tops_;     // of these, in units
    std::vector<Oriented> cache_;        // the latest orientations, newest last
    ToolExtent extent_;
    double radius_ = 0.0, low_ = 0.0, high_ = 0.0;  // of a cylinder around all corners, in units
    double error_mm_ = 0.0;
    int sides_ = 0;
};

/// Does the program say where this motion starts? One that comes from an unknown place must not
/// leave a trace: the path is made up.
bool has_known_start(const gcode::Motion& motion);
/// Does it say where it ends? That is certain, wherever the motion came from.
bool has_known_end(const gcode::Motion& motion);

}  // namespace ncsim::toolpath
