// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plan → part: the one place where all stages meet.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/workpiece.h"
#include "ncsim/export/overlay.h"
#include "ncsim/export/provenance.h"
#include "ncsim/report/facts.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/pose.h"
#include "ncsim/toolpath/walk.h"
#include "ncsim/verify/verifier.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::simulation {

/// A motion that met the block.
struct Cut {
    verify::Place place;
    std::uint64_t motion = 0;  ///< From 1, in the order of execution.
    int tool = 0;
};

/// The part, and what happened on the way to it.
struct Simulation : report::PartFacts {
    std::unique_ptr<cda::WorkpieceModel> part;
    exporter::Provenance provenance;        ///< For the origins in `part`.
    std::vector<Cut> cuts;                  ///< For the same origins; only if they are kept.
    std::optional<cda::Boundary> boundary;  ///< Of `part`, if it is kept.
    std::uint64_t steps = 0;                ///< From pose to pose, whether they met it or not.
    std::vector<cda::Cell> carved;          ///< What was taken away, if it is kept.
    std::vector<MetStock> met;              ///< Of a tile: what it found out for all.
    /// Of all tiles, by motion: the origin it has in `provenance`, where tiles call it by its
    /// number.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> origins;
    verify::Place last_cut;  ///< The last motion that met the block, in the files of the program.
    std::uint64_t last_motion = 0;  ///< Its number, from 1 in the order of execution.
    std::uint32_t line = 0;         ///< Of the last motion that was made; 0: none yet.
    /// Where the tool stands, once it has moved.
    struct Standing {
        int tool = 0;
        toolpath::Pose X_WT;
    };
    std::optional<Standing> standing;
    /// The last move that was made; only on a machine that is told.
    std::optional<gcode::Motion> last_move;
    std::vector<exporter::PathLine> paths;  ///< Of the tip, if they are kept.
    gcode::Diagnostics diagnostics;         ///< Motions that could not be followed.
};

/// Gives faces that tiles cut the origins that they would have without. Throws std::runtime_error
/// if the motion of one did not meet the stock.
void name_motions(cda::Boundary& boundary, const Simulation& simulation);
/// The surface of the part, with the origins of `simulation.provenance`, tiles or not.
cda::Boundary surface_of(const Simulation& simulation);

/// How far it got: moves done.
using ProgressSink = std::function<void(std::uint64_t)>;

/// Looks at the part while it is cut.
struct Onlooker {
    std::uint64_t every = 0;  ///< Moves between two looks; 0: never.
    std::function<void(const Simulation& so_far)> look;
};

/// How a program is verified while it is simulated.
struct Verification {
    /// Sees every motion; null: nothing is verified. Needs a model that verifies.
    verify::Verifier* verifier = nullptr;
    toolpath::RapidPath rapid;
    toolpath::Watch watch;
    /// Of the tools that cut the part. What is to be certain needs to know on which side they err.
    toolpath::Side side = toolpath::Side::Fair;
    /// What is cut; null: the whole block. On the lattice of the block.
    const cda::WorkpieceModel* start = nullptr;
    /// Stop cutting after so many motions that meet the block: those of the origins 1 to this.
    std::optional<std::uint32_t> most_cuts;
    bool keep_cuts = false;
    /// Each face is of a motion that left all of it: nothing is told of steps together.
    bool own_lines = false;
    /// Verify this motion alone, and stop after it; from 1, in the order of execution.
    std::optional<std::uint64_t> only_motion;
    /// More steps of the tools, wherever they are, throw StepLimit.
    std::optional<std::uint64_t> most_steps;
};

/// A simulation would take more than Verification::most_steps.
struct StepLimit {};

/// Requires survey.is_ready(). The result depends on `plan` and `verification` only. `progress` may
/// be empty. Where plan.at_line is set, what comes after that line is not done.
Simulation simulate(const Plan& plan, const Survey& survey, const Verification& verification,
                    const ProgressSink& progress, const Onlooker& onlooker = {});

/// Surveys the program and simulates it. Throws std::runtime_error that says why if it cannot be.
Simulation simulate(Plan plan);

}  // namespace ncsim::simulation
