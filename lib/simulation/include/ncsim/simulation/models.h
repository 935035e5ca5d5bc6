// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of the workpiece by name, with their purposes. Options, help, refusals and tests read this
// table.
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/tiles.h"
#include "ncsim/cda/workpiece.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ncsim::simulation {

/// Description of a model for users and callers.
struct ModelInfo {
    std::string_view name;        ///< Value of the option `--model`.
    std::string_view what;        ///< A phrase for help texts.
    bool exact = false;           ///< The parts are equal to the aggregate's, corner for corner.
    bool verifies = false;        ///< Is a cda::VerifyingModel, fast enough for a query per motion.
    bool has_resolution = false;  ///< Smaller details may be missing.
    /// Is a cda::CellModel, so pictures need no boundary.
    bool shows_cells = false;
};

/// Returns all models; the first is the default.
std::span<const ModelInfo> models();

/// Returns the model of this name; null if there is none.
const ModelInfo* find_model(std::string_view name);
/// Returns the first model that supports verification.
const ModelInfo& verifying_model();
/// Returns the names of the models that `suits` accepts, or of all: "cda or cda-flat".
std::string model_names(bool (*suits)(const ModelInfo&) = nullptr);

/// Parameters of a model; they do not change the part.
struct ModelParameters {
    unsigned threads = 0;         ///< Number of threads; 0: as many as the computer has.
    double (*clock)() = nullptr;  ///< Clock, in seconds; if given, the time of hulls is measured.
    double resolution_mm = 0.0;   ///< For a model with resolution, mm; 0: default of the model.
    bool only_along_z = false;    ///< For a model of rays.
    // For the tree only:
    int halvings = 6;                                    ///< See cda::TreeParameters::halvings.
    std::optional<cda::TileNumber> tile = std::nullopt;  ///< Only this tile of the part.
    std::shared_ptr<const cda::Tiles> tiles = nullptr;   ///< All tiles, which were cut before.
    std::function<void()> interrupt{};                   ///< See cda::TreeParameters::interrupt.
};

/// Returns an empty prototype. Throws: std::invalid_argument if there is no model of this name.
std::unique_ptr<cda::WorkpieceModel> make_model(std::string_view name,
                                                const ModelParameters& parameters = {});

/// Returns the data of a tile, for cda::Tiles. Requires: `part` is of a model made with
/// ModelParameters::tile.
std::string tile_data(const cda::WorkpieceModel& part);

}  // namespace ncsim::simulation
