// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of models: each stated property of a model is tested.
#include "ncsim/simulation/models.h"

#include "ncsim/cda/cell_model.h"

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

TEST(Models, AnswerWhatTheTableSays) {
    for (const ModelInfo& model : models()) {
        SCOPED_TRACE(model.name);
        const auto part = slotted(model.name);
        const auto* const verifying = dynamic_cast<const cda::VerifyingModel*>(part.get());
        const auto* const cells = dynamic_cast<const cda::CellModel*>(part.get());
        ASSERT_EQ(verifying != nullptr, model.verifies);
        ASSERT_EQ(cells != nullptr, model.shows_cells);
        EXPECT_EQ(part->aliasing().has_value(), model.has_resolution);
        EXPECT_EQ(dynamic_cast<cda::SweepModel*>(part.get()) != nullptr, model.has_resolution);
        EXPECT_EQ(dynamic_cast<cda::AccountingModel*>(part.get()) != nullptr, model.exact);
        if (verifying) {
            const Cell in_material = mm_box(3, 3, 0, 4, 4, 1);
            const Cell in_the_slot = mm_box(0, 1, 2, 4, 3, 4);
            EXPECT_TRUE(verifying->contact(in_material).has_value());
            EXPECT_FALSE(verifying->contact(in_the_slot).has_value());
            EXPECT_NEAR(verifying->common_volume(in_material), 1.0, 1e-12);
            EXPECT_EQ(verifying->common_volume(in_the_slot), 0.0);
        }
        if (cells) {
            std::ostringstream statistics, xml;
            cells->write_statistics(statistics);
            cells->write_cells(xml);
            EXPECT_FALSE(statistics.str().empty());
            EXPECT_FALSE(xml.str().empty());
        }
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
