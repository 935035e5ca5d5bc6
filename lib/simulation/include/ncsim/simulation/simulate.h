// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulation of a plan: all stages from the program to the part.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/overlay.h"
#include "ncsim/mesh/provenance.h"
#include "ncsim/simulation/cut_record.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/tool_pose.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/verifier.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::simulation {

struct StockHistory;

/// The part, with facts about the run.
struct Simulation : PartFacts {
    std::unique_ptr<cda::WorkpieceModel> part;
    mesh::Provenance provenance;  ///< For the origins in `part`.
    std::vector<CutRecord> cuts;  ///< For the same origins, if kept.
    /// Sources of the stock's faces, which have the first origins; null: all are the stock.
    std::shared_ptr<const StockHistory> history;
    std::optional<cda::Boundary> boundary;  ///< Boundary of `part`, if kept.
    std::uint64_t steps = 0;                ///< Steps from pose to pose, with or without contact.
    std::vector<cda::Cell> carved;          ///< Removed cells, if kept.
    std::vector<StockContact> stock_contacts;  ///< For a tile: motions that met the stock.
    /// For all tiles, by motion: the origin in `provenance` of each motion, which tiles name by its
    /// number.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> origins;
    verify::Place last_cut;  ///< The last motion that met the stock, in the files of the program.
    std::uint64_t last_motion = 0;  ///< Number of that motion, from 1 in the order of execution.
    std::uint32_t line = 0;         ///< Line of the last motion; 0 if there is none.
    /// Position of the tool, after its first motion.
    struct ToolPosition {
        int tool = 0;
        toolpath::Pose X_WT;
    };
    std::optional<ToolPosition> tool_position;
    /// The last move; only on a specified machine.
    std::optional<gcode::Motion> last_move;
    std::vector<exporter::PathLine> paths;  ///< Path of the tip, if kept.
    gcode::Diagnostics diagnostics;         ///< Motions that could not be followed.
};

/// Returns the number of origins that belong to earlier runs.
std::uint32_t earlier_origins(const StockHistory* history);

/// Replaces the origins of faces that tiles cut by the origins of a run without tiles. Throws:
/// std::runtime_error if the motion of a face did not meet the stock.
void name_motions(cda::Boundary& boundary, const Simulation& simulation);
/// Returns the surface of the part, with the origins of `simulation.provenance`, with or without
/// tiles.
cda::Boundary surface_of(const Simulation& simulation);

/// Returns the surface of the part on which faces of earlier runs count as the stock.
cda::Boundary surface_of_program(const Simulation& simulation);

/// Receives the number of moves done.
using ProgressSink = std::function<void(std::uint64_t)>;

/// Observer of the part while it is cut.
struct CutObserver {
    std::uint64_t every = 0;  ///< Number of moves between two calls; 0: never.
    std::function<void(const Simulation& so_far)> observe;
};

class PlayRecorder;

/// Parameters of a verification during the simulation.
struct Verification {
    /// Receives every motion; null without verification. Requires: a model that verifies.
    verify::Verifier* verifier = nullptr;
    /// Decides contacts that `verifier` leaves open; empty: the contacts stay open.
    std::function<verify::ContactDecision(const verify::OpenContact&)> decide;
    toolpath::RapidPath rapid;
    toolpath::WatchedParts watch;
    /// Side of the error of the tools that cut the part. Certain results need a known side.
    toolpath::Side side = toolpath::Side::Fair;
    /// Body that is cut, on the lattice of the stock; null for the whole stock.
    const cda::WorkpieceModel* start = nullptr;
    /// Stop cutting after so many motions that meet the stock, that is, after this origin.
    std::optional<std::uint32_t> most_cuts;
    bool keep_cuts = false;
    /// read_stock_history() of the stock, if faces of earlier runs shall keep their origins.
    std::shared_ptr<const StockHistory> history;
    PlayRecorder* play = nullptr;  ///< Receives path and states of the part; null: none.
    /// Each face belongs to a motion that left the whole face: steps are not combined.
    bool own_lines = false;
    /// Verify only this motion, and stop after it; from 1, in the order of execution.
    std::optional<std::uint64_t> only_motion;
    /// Simulation::tool_position is not the end of the last motion, but the pose with the tip
    /// nearest to this point.
    std::optional<Vec3> nearest_to;
    /// The last motion removes nothing. Requires: `only_motion`.
    bool last_removes_nothing = false;
    /// More steps of the tools, anywhere, throw StepLimit.
    std::optional<std::uint64_t> most_steps;
};

/// Thrown if a simulation needs more than Verification::most_steps.
struct StepLimit {};

/// Simulates the program. The result depends on `plan` and `verification` only. `progress` may be
/// empty. Motions after plan.at_line are left out. Requires: survey.is_ready().
Simulation simulate(const Plan& plan, const Survey& survey, const Verification& verification,
                    const ProgressSink& progress, const CutObserver& observer = {});

/// Surveys the program and simulates it. Throws: std::runtime_error with the reason if the program
/// cannot be simulated.
Simulation simulate(Plan plan);

}  // namespace ncsim::simulation
