// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the flat aggregate: contacts of cells, statistics and XML.
#include "ncsim/cda/flat.h"

#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;

FlatCda part_of(const Cell& stock, const std::vector<Cell>& cuts) {
    FlatCda part(stock, kLattice);
    std::uint32_t number = 0;
    for (Cell cut : cuts) {
        cut.origin = Origin{++number};
        part.subtract(cut);
    }
    return part;
}

TEST(FlatCda, CellsThatTouchFromOppositeSidesMakeAContact) {
    const FlatCda part =
        part_of(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 0, 2, 2, 4, 4), mm_box(2, 0, 2, 3, 4, 4)});
    EXPECT_EQ(part.contacts().size(), 1U);
    EXPECT_TRUE(part.zero().empty());
}

TEST(FlatCda, KeepsNoCellThatOnlyTouchesTheStock) {
    EXPECT_TRUE(part_of(mm_box(0, 0, 0, 4, 4, 4), {mm_box(4, 0, 0, 6, 4, 4)}).negative().empty());
}

TEST(Statistics, HasARowForEachCut) {
    const FlatCda part =
        part_of(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 1, 2, 3, 3, 5), mm_box(2, 1, 2, 5, 3, 5)});
    std::ostringstream csv;
    part.write_statistics(csv);
    const std::string text = csv.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
    EXPECT_EQ(part.steps()[0].stencilled_negative_facets, 1U);
    EXPECT_EQ(part.steps()[0].visible_negative_facets, 5U);
    EXPECT_EQ(part.steps()[1].new_zero_cells, 1U);
}

TEST(Xml, NamesCellsFacetsAndBindings) {
    const FlatCda part = part_of(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 1, 2, 3, 3, 5)});
    std::ostringstream xml;
    part.write_cells(xml);
    EXPECT_NE(xml.str().find("<cell kind=\"negative\" index=\"0\" origin=\"1\">"),
              std::string::npos);
    EXPECT_NE(xml.str().find("<up kind=\"positive\" cell=\"0\""), std::string::npos);
    EXPECT_NE(xml.str().find("<down kind=\"negative\" cell=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace ncsim::cda
