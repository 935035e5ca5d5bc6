// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of models: each stated property of a model is tested.
#include "ncsim/simulation/models.h"

#include "support/oracle.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace ncsim::simulation {
namespace {

using cda::Boundary;
using cda::CannotAnswer;
using cda::Cell;
using cda::Origin;
using cda::WorkpieceModel;
using test::kLattice;
using test::mm_box;

// Returns a block with a slot and a bore that enters the slot.
std::unique_ptr<WorkpieceModel> slotted(std::string_view model) {
    auto part = make_model(model, {.threads = 2})->create(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    Cell slot = mm_box(-1, 1, 2, 5, 3, 5);
    slot.origin = Origin{1};
    Cell bore = mm_box(1, 0, 1, 2, 2, 5);
    bore.origin = Origin{2};
    part->subtract(slot);
    part->subtract(bore);
    return part;
}

TEST(Models, HaveNamesOfTheirOwnAndTellThem) {
    for (const ModelInfo& model : models()) {
        EXPECT_EQ(find_model(model.name), &model);
        EXPECT_EQ(make_model(model.name)->name(), model.name);
        EXPECT_EQ(slotted(model.name)->clone()->name(), model.name);
        EXPECT_FALSE(model.what.empty());
    }
    EXPECT_EQ(find_model("voxel"), nullptr);
    EXPECT_THROW(make_model("voxel"), std::invalid_argument);
}

TEST(Models, ThatAreExactMakeTheSameCorners) {
    const Boundary expected = slotted(models().front().name)->boundary();
    for (const ModelInfo& model : models()) {
        if (!model.exact) continue;
        SCOPED_TRACE(model.name);
        const auto part = slotted(model.name);
        EXPECT_EQ(part->boundary().vertices, expected.vertices);
        EXPECT_NEAR(part->volume(), 64 - 16 - 1 * 1 * 2 - 1 * 1 * 1 - 1 * 1 * 1, 1e-9);
        EXPECT_EQ(part->lattice(), kLattice);
    }
}

TEST(Models, AnswerWhatTheTableSaysAndRefuseTheRestByName) {
    for (const ModelInfo& model : models()) {
        SCOPED_TRACE(model.name);
        const auto part = slotted(model.name);
        const auto refuses = [&](const auto& ask) {
            try {
                ask();
            } catch (const CannotAnswer& e) {
                EXPECT_NE(std::string(e.what()).find(model.name), std::string::npos) << e.what();
                return true;
            }
            return false;
        };
        const Cell in_material = mm_box(3, 3, 0, 4, 4, 1);
        const Cell in_the_slot = mm_box(0, 1, 2, 4, 3, 4);
        EXPECT_EQ(refuses([&] { part->contact(in_material); }), !model.verifies);
        EXPECT_EQ(refuses([&] { part->common_volume(in_material); }), !model.verifies);
        if (model.verifies) {
            EXPECT_TRUE(part->contact(in_material).has_value());
            EXPECT_FALSE(part->contact(in_the_slot).has_value());
            EXPECT_NEAR(part->common_volume(in_material), 1.0, 1e-12);
            EXPECT_EQ(part->common_volume(in_the_slot), 0.0);
        }
        std::ostringstream out;
        EXPECT_EQ(refuses([&] { part->write_statistics(out); }), !model.shows_cells);
        EXPECT_EQ(refuses([&] { part->write_cells(out); }), !model.shows_cells);
        EXPECT_EQ(out.str().empty(), !model.shows_cells);
    }
    EXPECT_TRUE(verifying_model().verifies);
}

TEST(Models, AreAllInTheReadme) {
    std::ifstream file(std::string(NCSIM_SOURCE_DIR) + "/README.md");
    const std::string readme(std::istreambuf_iterator<char>(file), {});
    for (const ModelInfo& model : models())
        EXPECT_NE(readme.find("--model " + std::string(model.name)), std::string::npos)
            << model.name;
}

TEST(Models, AreListedAsPeopleDo) {
    EXPECT_EQ(model_names(), "cda, cda-flat or dexel");
    EXPECT_EQ(model_names([](const ModelInfo& model) { return model.shows_cells; }), "cda-flat");
}

}  // namespace
}  // namespace ncsim::simulation
