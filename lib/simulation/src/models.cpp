// SPDX-License-Identifier: GPL-3.0-or-later
//
// Table of the models.
#include "ncsim/simulation/models.h"

#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/dexel/dexel.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::simulation {

namespace {

using ModelFactory = std::unique_ptr<cda::WorkpieceModel> (*)(const ModelParameters&);

std::unique_ptr<cda::WorkpieceModel> make_tree(const ModelParameters& parameters) {
    if (parameters.tiles) return cda::Tiles::model(parameters.tiles);
    cda::TreeParameters tree;
    tree.threads = parameters.threads;
    tree.tile = parameters.tile;
    tree.halvings = parameters.halvings;
    tree.interrupt = parameters.interrupt;
    return std::make_unique<cda::TreeCda>(tree);
}

std::unique_ptr<cda::WorkpieceModel> make_flat(const ModelParameters& parameters) {
    return std::make_unique<cda::FlatCda>(parameters.clock);
}

std::unique_ptr<cda::WorkpieceModel> make_dexel(const ModelParameters& parameters) {
    return std::make_unique<dexel::Dexel>(dexel::DexelParameters{
        parameters.threads, parameters.resolution_mm,
        parameters.only_along_z ? dexel::Directions::OnlyZ : dexel::Directions::Three});
}

constexpr std::array kModels = {
    ModelInfo{.name = cda::TreeCda::kName,
              .what = "a tree of aggregates, for programs of any length",
              .exact = true,
              .verifies = true},
    ModelInfo{.name = cda::FlatCda::kName,
              .what = "the aggregate of the thesis, to be looked at: --stats, --xml",
              .exact = true,
              .shows_cells = true},
    ModelInfo{.name = dexel::Dexel::kName,
              .what = "rays, for a quick look at long programs: what is thinner than --resolution "
                      "may be missing",
              .has_resolution = true},
};
constexpr std::array<ModelFactory, kModels.size()> kFactories = {make_tree, make_flat, make_dexel};

}  // namespace

std::span<const ModelInfo> models() {
    return kModels;
}

const ModelInfo* find_model(std::string_view name) {
    const auto* const found = std::ranges::find(kModels, name, &ModelInfo::name);
    return found == kModels.end() ? nullptr : &*found;
}

const ModelInfo& verifying_model() {
    return *std::ranges::find(kModels, true, &ModelInfo::verifies);
}

std::string model_names(bool (*suits)(const ModelInfo&)) {
    std::vector<std::string_view> names;
    for (const ModelInfo& model : kModels) {
        if (!suits || suits(model)) names.push_back(model.name);
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

std::unique_ptr<cda::WorkpieceModel> make_model(std::string_view name,
                                                const ModelParameters& parameters) {
    const ModelInfo* model = find_model(name);
    if (!model) throw std::invalid_argument("there is no model " + std::string(name));
    return kFactories[static_cast<std::size_t>(model - kModels.data())](parameters);
}

std::string tile_data(const cda::WorkpieceModel& part) {
    std::ostringstream bytes;
    dynamic_cast<const cda::TreeCda&>(part).write_tile(bytes);
    return std::move(bytes).str();
}

}  // namespace ncsim::simulation
