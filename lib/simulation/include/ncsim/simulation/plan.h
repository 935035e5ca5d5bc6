// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plan of a simulation: program, set-up and parameters, derived from options.
#pragma once

#include "ncsim/cda/tiles.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/setup/budget.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/toolpath/kinematics.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// A motion that met the stock. Tiles share this search in turns: tile i of n examines the motions
/// i, i + n, …
struct StockContact {
    std::uint64_t motion = 0;  ///< Number in the order of execution, from 1.
    std::uint64_t hulls = 0;   ///< Number of cells that met the stock.
    bool operator==(const StockContact&) const = default;
};

/// Results of all tiles.
struct CutTiles {
    std::shared_ptr<const cda::Tiles> tiles;
    std::vector<StockContact> stock_contacts;  ///< Sorted by motion.
};

/// Directions of a model of rays. Chosen: by choose_rays(), along Z alone if possible.
enum class RayDirections : std::uint8_t { Chosen, AlongZ, AlongAll };

/// Program, set-up and parameters of a simulation. Lengths in mm.
struct Plan {
    setup::Job job;
    std::string model = "cda";       ///< Name of models().
    bool is_model_specified = true;  ///< False if choose_model() may choose the model.
    bool is_model_chosen = false;    ///< True if choose_model() chose the model.
    double resolution = 0.0;         ///< For a model with resolution; 0: suitable for the stock.
    RayDirections rays = RayDirections::Chosen;
    double tolerance = 0.005;      ///< For chords and rotating tools.
    double tool_tolerance = 0.05;  ///< For round tools.
    /// Successive moves within this distance of a line become a single move; 0: no moves are
    /// joined.
    double join_tolerance = 0.0;
    /// True for a quick picture: undescribed tools are assumed.
    bool draft = false;
    /// True for a draft that coarsen() left exact, because it is fast.
    bool is_draft_exact = false;
    /// Kinematics of the machine, if specified.
    std::optional<setup::SpecifiedKinematics> kinematics;
    /// Kinematics with the program zero; set by the survey.
    std::shared_ptr<const toolpath::Kinematics> placed;
    /// All motions of the program, unless they are very many; set by the survey.
    std::shared_ptr<const std::vector<gcode::Motion>> motions;
    /// Line of the program after which the simulation stops; from 1.
    std::optional<std::uint32_t> at_line;
    unsigned threads = 0;  ///< Number of threads; 0: as many as the computer has.
    /// Simulates only this tile of the part, for write_tile(). For the model "cda".
    std::optional<cda::TileNumber> tile;
    /// All tiles, which were cut before: the program is followed without cutting. For the model
    /// "cda".
    std::shared_ptr<const CutTiles> tiles;
    setup::Budget budget;

    // Results to keep in addition to the part.
    bool keep_boundary = false;
    bool needs_exact = false;  ///< True if a result is requested that only exact models have.
    bool keep_paths = false;   ///< Path of the tip.
    bool keep_removed_cells = false;  ///< Removed cells, of circumscribed tools.
    /// Volumes by tool: if the program has several tools, the part is measured at each tool change.
    bool tool_volumes = true;
    /// Volume that each block removed; this takes several times the work.
    bool block_volumes = false;
    /// Time of each hull; only models that show their cells measure it.
    bool hull_times = false;
};

/// Throws: std::invalid_argument with the name of the model if the model does not support
/// verification.
void require_verifying(const Plan& plan);

}  // namespace ncsim::simulation
