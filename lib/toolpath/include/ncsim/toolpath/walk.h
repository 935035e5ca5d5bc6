// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traversal of a program's motions, pose by pose, with the cells that the cutting pieces leave. The
// simulation subtracts the cells, and the verifier examines the cells first. Both use this class,
// so all that is verified is also simulated.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"
#include "ncsim/cda/sweep.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool_polytope.h"
#include "ncsim/toolpath/trace.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::toolpath {

/// Path of a rapid move of several axes: a straight line on controls that interpolate rapids, or a
/// dog-leg, in which every axis moves at its own rate until it arrives.
struct RapidPath {
    bool dog_leg = false;
    /// Rates of X, Y and Z in mm/min; only the ratios matter. Equal rates move at 45 degrees first.
    std::array<double, 3> rates{1.0, 1.0, 1.0};
};

/// Returns the straight pieces of a rapid move from its start to its end, at least one. The corners
/// lie where an axis arrives. X and U share a rate, as do Y and V, and Z and W; rotary axes are
/// interpolated over the whole move.
std::vector<gcode::Linear> legs_of(const gcode::Linear& rapid, const RapidPath& path);

/// Motion between two successive poses. References are valid during the call.
struct Step {
    const Pose& X_WA;
    const Pose& X_WB;
    /// Cells of the cutting pieces that may meet the stock and are wanted; often empty.
    std::span<const cda::Cell> cells;
    /// Fewer cells for the material that this step and the preceding steps removed, if this step
    /// ends a whole turn that leaves no core. Cells outside the wanted place are included.
    std::span<const cda::Cell> merged_cells;
    /// Cells for the material that the preceding straight steps along a line removed, over at most
    /// the tool's diameter, if this step does not continue that line.
    std::span<const cda::Cell> preceding_cells;
    /// Round sweeps instead of cells, with WalkOptions::prefers_sweeps.
    std::span<const cda::RoundSweep> sweeps;
    bool is_near = false;    ///< True if the stock is near enough for cells.
    SampleBounds bounds;     ///< Bounds of the motion that the step belongs to.
    RotationBounds turning;  ///< Rotation of the tool in the step, for further parts.
};

/// Returns the straight move of `motion` if the rotary axes are 0 at both ends and tip control is
/// off, as in most programs; otherwise null.
const gcode::Linear* straight_upright(const gcode::Motion& motion);

/// Places and parts of the tool to follow in addition to the cutter in the stock. `bounds` and
/// `turning` of the steps hold there, too.
struct WatchedParts {
    Box place;  ///< Further place where the tool's motion matters, such as fixtures; mm, W.
    bool shanks = false;  ///< True to follow the pieces that do not cut, too.
};

/// Everything that determines the steps of a traversal, besides the tools and the motions.
struct WalkOptions {
    ToolAccuracy accuracy = {};
    SamplingOptions sampling = {};
    RapidPath rapid = {};
    WatchedParts watch = {};
    std::shared_ptr<const Kinematics> specified = nullptr;  ///< The specified machine, or null.
    /// True for steps with `sweeps` instead of cells, whatever the accuracy, for tools whose
    /// cutting pieces are all cda::RoundSweep's, while the tool is upright.
    bool prefers_sweeps = false;
    /// False for steps without `merged_cells` and `preceding_cells`.
    bool merges_cells = true;
};

/// Traversal of motions with the tools and the machine of a program.
class Walk {
public:
    /// Starts a traversal. Cells whose bounds do not overlap `stock` (mm, W) are left out.
    Walk(const cda::Lattice& lattice, const Box& stock, WalkOptions options);

    /// Adds `tool` under `number`. The first tool of a number counts.
    const Cutter& add_tool(int number, const Tool& tool);
    /// Limits the following cells to tools near `place` (mm, W); all cells if empty.
    void restrict_cells(const std::optional<Box>& place) {
        region_ = place;
        skips_motions_ = false;
    }
    /// Does the same as restrict_cells(); in addition, a straight move or an arc that stays away
    /// from `place` is a single step from end to end, without bounds.
    void restrict_motions(const std::optional<Box>& place) {
        restrict_cells(place);
        skips_motions_ = place.has_value();
    }
    /// Returns the cutter of tool `number`; null if there is none.
    const Cutter* cutter(int number) const;

    /// Calls `step` for every two successive poses of the motion that differ, in order, and returns
    /// the bounds of the motion. Does nothing for dwells, tool changes, undescribed tools, and
    /// moves with an unknown start.
    SampleBounds take(const gcode::Motion& motion, cda::Origin origin,
                      const std::function<void(const Step&)>& step);
    /// Returns the start (mm, W) of the line that the last motion continued; empty if the motion
    /// continued none. The cells of a line as a whole may have the origin of any of its motions.
    std::optional<Vec3> line_start() const;
    /// Calls `step` for the tool at rest at the end of a motion with an unknown start. The path is
    /// unknown, but the end is certain. Does nothing if the end is unknown, too.
    void at_end_position(const gcode::Motion& motion, cda::Origin origin,
                         const std::function<void(const Step&)>& step);

private:
    struct ToolData {
        Cutter cutter;
        ToolExtent followed;
        std::vector<ToolPiece> pieces;
        std::vector<cda::RoundSweep> round;  ///< Cutting pieces, if all are round sweeps.
        std::optional<Cutter::Rotation> rows = std::nullopt;  ///< Orientation of `reach`.
        Cutter::Reach reach = {};

        Box bounds(const Pose& X_WA, const Pose& X_WB);
    };
    // Successive arcs about one centre.
    struct ArcRun {
        std::vector<cda::LatticePoint> way;
        Cutter::Rotation rows = {};
        double centre_1 = 0.0, centre_2 = 0.0;  // mm, in the plane of the arc
        int tool = 0;
    };
    // Successive straight moves along one line.
    struct LineRun {
        cda::LatticePoint start;
        Vec3 start_mm;
        std::vector<cda::LatticePoint> ends;
        std::vector<cda::StraightSteps::Step> steps;
        ToolData* tool = nullptr;
        cda::Origin origin = cda::kStockOrigin;  // the last that met the stock, or kStockOrigin
    };
    void extend_line_run(ToolData& tool, const gcode::Motion& motion, const Pose& X_WA,
                         const Pose& X_WB, cda::Origin origin);
    void end_line_run();
    bool extend_arc_run(const Cutter& cutter, const gcode::Motion& motion);
    void close_arc_run(Cutter& cutter, const Pose& X_WA, const Pose& X_WB, cda::Origin origin);
    bool stays_outside_region(const ToolData& tool, const gcode::Motion& motion, const Poses& poses,
                              const Pose& X_WA, const Pose& X_WB) const;
    void trace(ToolData& tool, const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
               const SweepSimplification& liberties);

    cda::Lattice lattice_;
    Box stock_;
    WalkOptions options_;         // without the part of the gain that facets have at least
    double gain_mm_;              // allowed gain of the hulls of rotating tools
    double slack_mm_;             // largest part of gain_mm_ for leaving out facets
    Box place_;                   // stock and watched place
    std::optional<Box> region_;   // place of wanted cells
    bool skips_motions_ = false;  // whether motions away from region_ are single steps
    Cutter::Rotation upright_ = pose_at({}).rows;
    std::map<int, ToolData> tools_;
    std::vector<cda::Cell> cells_;            // of one step; kept to reuse its memory
    std::vector<cda::Cell> merged_cells_;     // as cells_
    std::vector<cda::Cell> preceding_cells_;  // as cells_
    ArcRun arc_run_;
    LineRun line_run_;
    std::vector<cda::RoundSweep> sweeps_;  // as cells_
    bool is_near_ = false;                 // whether the step is near the stock
};

}  // namespace ncsim::toolpath
