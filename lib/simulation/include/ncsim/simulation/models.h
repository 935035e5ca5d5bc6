// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models of the workpiece by name, and what each of them is for: the one table that options,
// help, refusals and tests read.
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/tiles.h"
#include "ncsim/cda/workpiece.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ncsim::simulation {

/// What people and callers are told about a model.
struct ModelInfo {
    std::string_view name;  ///< As in `--model`.
    std::string_view what;  ///< A phrase.
    bool exact = false;     ///< Its parts are the aggregate's, corner for corner.
    /// Answers contact() and common_volume() at a price that a question a motion can have.
    bool verifies = false;
    bool has_resolution = false;  ///< What is smaller may be missing.
    /// Answers write_statistics() and write_cells(), and is drawn by its masks, so that its
    /// pictures need no boundary.
    bool shows_cells = false;
};

/// All of them, the one that is taken where nobody asks for another first.
std::span<const ModelInfo> models();

/// Null if there is none of this name.
const ModelInfo* find_model(std::string_view name);
/// The first that programs are verified with.
const ModelInfo& verifying_model();
/// "cda or cda-flat", of those that `suits` accepts, or all.
std::string model_names(bool (*suits)(const ModelInfo&) = nullptr);

/// How a model works; none of it changes a part.
struct ModelParameters {
    unsigned threads = 0;         ///< 0: as many as the machine has.
    double (*clock)() = nullptr;  ///< Seconds; where given, what hulls cost is measured.
    double resolution_mm = 0.0;   ///< Of a model that has one; 0: it chooses.
    bool only_along_z = false;    ///< Of a model of rays.
    // Of the tree alone:
    int halvings = 6;                                    ///< As in cda::TreeParameters.
    std::optional<cda::TileNumber> tile = std::nullopt;  ///< Only this tile of the part.
    std::shared_ptr<const cda::Tiles> tiles = nullptr;   ///< All of them, which were cut before.
};

/// An empty prototype. Throws std::invalid_argument if there is no such model.
std::unique_ptr<cda::WorkpieceModel> make_model(std::string_view name,
                                                const ModelParameters& parameters = {});

}  // namespace ncsim::simulation
