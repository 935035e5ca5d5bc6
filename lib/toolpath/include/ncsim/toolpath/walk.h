// SPDX-License-Identifier: GPL-3.0-or-later
//
// The walk of a program's tools: motion by motion, pose by pose, with the cells that the cutting
// pieces leave behind. Who simulates subtracts them; who verifies looks at them first. Both walk
// here, so that nothing is verified that was not simulated.
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

/// How a rapid move of several axes goes: in a straight line, as on controls that interpolate it,
/// or as a dog-leg, every axis at its own rate until it is there.
struct RapidPath {
    bool dog_leg = false;
    /// X, Y, Z in mm/min; only their ratios matter. All equal: 45 degrees first.
    std::array<double, 3> rates{1.0, 1.0, 1.0};
};

/// The straight pieces of a rapid move, from its start to its end, at least one. X and U (Y and V,
/// Z and W) share a rate; rotary axes run in step with the whole. A path with known ends: the
/// corners lie where an axis arrives.
std::vector<gcode::Linear> legs_of(const gcode::Linear& rapid, const RapidPath& path);

/// Between two successive poses. References are valid during the call.
struct Step {
    const Pose& X_WA;
    const Pose& X_WB;
    /// Of the cutting pieces; only those that may meet the stock, where they are wanted. Often
    /// none.
    std::span<const cda::Cell> cells;
    /// What this step took away together with those before it, in fewer cells, where it ends a
    /// whole turn that leaves no core. Some of that may not be wanted.
    std::span<const cda::Cell> covering;
    /// Likewise what those before it took that went straight on, no farther than the tool is wide,
    /// where this one does not.
    std::span<const cda::Cell> straight;
    /// Or of these, where the walk leaves round tools as they are.
    std::span<const cda::RoundSweep> sweeps;
    bool is_near = false;  ///< Is the stock near enough for cells?
    SampleBounds bounds;   ///< Of the motion the step belongs to.
    Turning turning;       ///< And how the tool turns in it: for other parts of the tool.
};

/// The line of a straight move in which nothing is turned, now or before, as of most programs most
/// are; else null.
const gcode::Linear* straight_upright(const gcode::Motion& motion);

/// What has to be followed besides the cutter in the stock: there, too, `bounds` and `turning` of
/// the steps hold.
struct Watch {
    cda::Box place;       ///< Where else it matters what the tool does: fixtures; mm, W.
    bool shanks = false;  ///< And the pieces that do not cut.
};

class Walk {
public:
    /// Cells whose bounds do not overlap `stock` (mm, W) are left out. `told`: how the machine
    /// turns.
    Walk(const cda::Lattice& lattice, const cda::Box& stock, const ToolAccuracy& accuracy,
         const SamplingOptions& sampling, RapidPath rapid = {}, const Watch& watch = {},
         std::shared_ptr<const Kinematics> told = nullptr);

    /// From now on tools whose cutting pieces are cda::RoundSweep's are swept as they are, whatever
    /// the accuracy, where they stand upright and go straight ahead.
    void leave_round() { leaves_round_ = true; }
    /// From now on no step has `covering` or `straight`.
    void tell_steps_alone() { covers_ = false; }
    /// Makes `tool` known under `number`; the first one of a number counts.
    const Cutter& add_tool(int number, const Tool& tool);
    /// From now on no more cells are made than those near `place` (mm, W); nothing: all.
    void want_cells(const std::optional<cda::Box>& place) {
        wanted_ = place;
        passes_by_ = false;
    }
    /// The same, and motions that turn the tool and stay away from there are no more than a step
    /// from end to end, without bounds.
    void want_nothing_but(const std::optional<cda::Box>& place) {
        want_cells(place);
        passes_by_ = place.has_value();
    }
    /// Null if there is none of this number.
    const Cutter* cutter(int number) const;

    /// Calls `step` for each two poses of the motion that differ, in order. Does nothing for
    /// dwells and tool changes, tools that nobody described, and moves whose start the program does
    /// not tell. Returns the bounds of the motion.
    SampleBounds take(const gcode::Motion& motion, cda::Origin origin,
                      const std::function<void(const Step&)>& step);
    /// Calls `step` for the tool at rest where a motion ends whose start is not known: not what it
    /// cuts, but certainly where it is. Does nothing if the end is not known either.
    void arrive(const gcode::Motion& motion, cda::Origin origin,
                const std::function<void(const Step&)>& step);

private:
    struct Known {
        Cutter cutter;
        ToolExtent followed;
        std::vector<ToolPiece> pieces;
        std::vector<cda::RoundSweep>
            round;  ///< Its cutting pieces, if all can be swept as they are.
        std::optional<Cutter::Rotation> rows = std::nullopt;  ///< Where its reach is known.
        Cutter::Reach reach = {};

        cda::Box bounds(const Pose& X_WA, const Pose& X_WB);
    };
    // Arcs in a row about one middle, so far.
    struct Round {
        std::vector<cda::LatticePoint> way;
        Cutter::Rotation rows = {};
        double centre_1 = 0.0, centre_2 = 0.0;  // mm, in the plane of the arc
        int tool = 0;
    };
    // Straight moves in a row, one as the other.
    struct Run {
        cda::LatticePoint start;
        std::vector<cda::LatticePoint> ends;
        std::vector<cda::StraightSteps::Step> steps;
        Known* tool = nullptr;
        cda::Origin origin = cda::kStockOrigin;  // the last that met the stock, if one did
    };
    void go_on(Known& tool, const gcode::Motion& motion, const Pose& X_WA, const Pose& X_WB,
               cda::Origin origin);
    void end_run();
    bool go_round(const Cutter& cutter, const gcode::Motion& motion);
    void close_round(Cutter& cutter, const Pose& X_WA, const Pose& X_WB, cda::Origin origin);
    bool passes_by(const Known& tool, const gcode::Motion& motion, const Poses& poses,
                   const Pose& X_WA, const Pose& X_WB) const;
    void trace(Known& tool, const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
               const Liberties& liberties);

    cda::Lattice lattice_;
    cda::Box stock_;
    ToolAccuracy accuracy_;
    SamplingOptions sampling_;
    double gain_mm_;   // that the hulls of turning tools may have,
    double slack_mm_;  // and the most of it that facets are left out for
    RapidPath rapid_;
    Watch watch_;
    std::shared_ptr<const Kinematics> told_;
    cda::Box place_;                  // that matters: the stock and what is watched
    std::optional<cda::Box> wanted_;  // cells
    bool passes_by_ = false;          // all else
    Cutter::Rotation upright_ = pose_at({}).rows;
    std::map<int, Known> tools_;
    bool leaves_round_ = false;
    bool covers_ = true;
    std::vector<cda::Cell> cells_;     // of one step, kept for its memory
    std::vector<cda::Cell> covering_;  // likewise
    std::vector<cda::Cell> straight_;  // likewise
    Round round_;
    Run run_;
    std::vector<cda::RoundSweep> sweeps_;  // likewise
    bool is_near_ = false;                 // the stock, in that step
};

}  // namespace ncsim::toolpath
