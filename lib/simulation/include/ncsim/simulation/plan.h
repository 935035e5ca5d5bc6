// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is to be simulated, and how: what options become.
#pragma once

#include "ncsim/cda/tiles.h"
#include "ncsim/report/facts.h"
#include "ncsim/setup/budget.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/toolpath/machine.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// A motion that met the stock. What motions met is found out by tiles in turns: by tile i of n the
/// motions i, i + n …
struct MetStock {
    std::uint64_t motion = 0;  ///< From 1, in the order of execution.
    std::uint64_t hulls = 0;   ///< How many cells did.
    bool operator==(const MetStock&) const = default;
};

/// What all tiles found.
struct CutTiles {
    std::shared_ptr<const cda::Tiles> tiles;
    std::vector<MetStock> met;  ///< By motion.
};

/// Of a model of rays. Chosen: along Z alone, where that is right, see choose_rays().
enum class RayDirections : std::uint8_t { Chosen, AlongZ, AlongAll };

/// Lengths in mm.
struct Plan {
    setup::Job job;
    std::string model = "cda";     ///< Of models().
    bool is_model_told = true;     ///< Else choose_model() may take another.
    bool is_model_chosen = false;  ///< It did.
    double resolution = 0.0;       ///< Of a model that has one; 0: the one that suits the stock.
    RayDirections rays = RayDirections::Chosen;
    double tolerance = 0.005;      ///< Of chords and of turning tools.
    double tool_tolerance = 0.05;  ///< Of round tools.
    /// Moves in a row become one where they stay that near to a line; 0: none do.
    double join_tolerance = 0.0;
    /// A first look: tools that nobody describes are guessed.
    bool draft = false;
    bool is_draft_exact = false;  ///< A draft that coarsen() left exact, because it is quick.
    /// How the machine turns, if somebody tells it; and with the program's zero, once it was
    /// surveyed.
    std::optional<setup::ToldKinematics> kinematics;
    std::shared_ptr<const toolpath::Kinematics> placed;
    /// Line of the program after which the simulation stops; from 1.
    std::optional<std::uint32_t> at_line;
    unsigned threads = 0;  ///< 0: as many as the machine has.
    /// Only this tile of the part, for its write_tile(); or all of them, which were cut before: the
    /// program is followed, and nothing is cut. Of the model "cda".
    std::optional<cda::TileNumber> tile;
    std::shared_ptr<const CutTiles> tiles;
    setup::Budget budget;

    // What is kept beside the part.
    bool keep_boundary = false;
    bool needs_exact = false;  ///< Something is made of it that only exact models have.
    bool keep_paths = false;   ///< Of the tip.
    bool keep_carved = false;  ///< The cells that were taken away, of tools that contain theirs.
    /// Volumes by tool: of a program with several tools, the part is measured at each tool change.
    bool tool_volumes = true;
    bool block_volumes = false;  ///< What each block removed, which is several times the work.
    bool hull_times =
        false;  ///< What each hull cost; only models that show their cells measure it.
};

/// Throws std::invalid_argument, which names the model, if programs are not verified with it.
void require_verifying(const Plan& plan);

/// How it is cut, for reports.
report::CuttingFacts cutting_facts(const Plan& plan);

}  // namespace ncsim::simulation
