// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/stock.h"

#include "ncsim/cda/polytope.h"

#include <gtest/gtest.h>

#include <numbers>

namespace ncsim::toolpath {
namespace {

std::optional<Stock> parsed(const char* text) {
    std::string message;
    const auto stock = parse_stock_option(text, message);
    EXPECT_EQ(stock.has_value(), message.empty()) << message;
    return stock;
}

std::optional<Box> stock(const char* text) {
    const auto known = parsed(text);
    if (!known) return std::nullopt;
    EXPECT_FALSE(known->is_round);
    return known->box;
}

TEST(StockOption, TakesTwoCornersInAnyOrder) {
    EXPECT_EQ(stock("0,0,-10:50,40,0"), (Box{{0, 0, -10}, {50, 40, 0}}));
    EXPECT_EQ(stock("50,40,0:0,0,-10"), (Box{{0, 0, -10}, {50, 40, 0}}));
    EXPECT_EQ(stock("0,0,0:1,1,1in"), (Box{{0, 0, 0}, {25.4, 25.4, 25.4}}));
}

TEST(StockOption, TakesSizes) {
    EXPECT_EQ(stock("50x40x10"), (Box{{-25, -20, -10}, {25, 20, 0}}));
    EXPECT_EQ(stock("50x40x10@0,0,-10"), (Box{{0, 0, -10}, {50, 40, 0}}));
}

TEST(StockOption, TakesInches) {
    const Box block{{-50.8, -25.4, -12.7}, {50.8, 25.4, 0}};
    EXPECT_EQ(stock("4x2x0.5in"), block);
    EXPECT_EQ(stock("4x2x1/2in"), block);
    EXPECT_EQ(stock("4inx2inx1/2in"), block);
    EXPECT_EQ(stock("4\"x2\"x0.5\""), block);
    EXPECT_EQ(stock("4 x 2 x 0.5 inch"), block);
    EXPECT_EQ(stock("4inx50.8mmx12.7mm"), block);
    EXPECT_EQ(stock("101.6x50.8x1/2"), block);
    EXPECT_EQ(stock("4x2x0.5@-2,-1,-0.5in"), block);
    EXPECT_EQ(stock("4x2x10deg"), std::nullopt);
    EXPECT_EQ(stock("4x2x0.5furlongs"), std::nullopt);
}

TEST(StockOption, TakesBars) {
    EXPECT_EQ(parsed("D60x30"), (Stock{{{-30, -30, -30}, {30, 30, 0}}, true}));
    EXPECT_EQ(parsed("d60x30@100,50,-5"), (Stock{{{70, 20, -5}, {130, 80, 25}}, true}));
    Stock lying{{{-50, -15, -15}, {50, 15, 15}}, true};
    lying.axis = 0;
    EXPECT_EQ(parsed("DX30x100"), lying);
    Stock across{{{-10, 5, -10}, {10, 25, 10}}, true};
    across.axis = 1;
    EXPECT_EQ(parsed("dy20x20@0,5,0"), across);
    EXPECT_EQ(parsed("D1x2in"), (Stock{{{-12.7, -12.7, -50.8}, {12.7, 12.7, 0}}, true}));
}

TEST(StockCell, OfABarTouchesTheCircleAndStaysWithinTheTolerance) {
    const Stock bar = *parsed("D60x30");
    for (const double tolerance : {0.5, 0.05, 0.005}) {
        SCOPED_TRACE(tolerance);
        const cda::Shape shape = stock_shape(bar, tolerance);
        const auto body = cda::ConvexPolytope::of(shape.outer, shape.lattice);
        ASSERT_TRUE(body);
        const double volume = body->volume() * 1e-15;
        const double pi = std::numbers::pi;
        EXPECT_GT(volume, pi * 30 * 30 * 30 * (1 - 1e-9));
        EXPECT_LT(volume, pi * (30 + tolerance) * (30 + tolerance) * 30);
        EXPECT_EQ(shape.lattice, cda::Lattice{1e-5});
        EXPECT_EQ(shape.outer.bounds.min.z, -30);
        // Four sides lie in the sides of the box.
        EXPECT_NEAR(body->bounds().max.x, 3e6, 1.0);
    }
}

TEST(StockOption, RefusesWhatIsNoBlock) {
    for (const char* bad :
         {"",       "1,2,3",  "0,0,0:0,1,1", "0,0,0:1,1", "1x2",         "0x1x1",
          "-1x1x1", "axbxc",  "1x1x1@0,0",   "D5",        "D0x3",        "Dx3",
          "D3x-1",  "D3x4x5", "D3x4@1,2",    "1e9x1x1",   "9999999x1x1", "1x1x1@99999999,0,0",
          ":",      "@"}) {
        SCOPED_TRACE(bad);
        EXPECT_FALSE(stock(bad));
    }
}

TEST(RoundStock, StandsAboutItsAxis) {
    Stock bar{{{-50, -15, -15}, {50, 15, 15}}, true};
    bar.axis = 0;
    const cda::Shape lying = stock_shape(bar, 0.01);
    std::string message;
    const cda::Shape upright = stock_shape(*parse_stock_option("D30x100@0,0,-50", message), 0.01);
    EXPECT_EQ(lying.outer.planes.size(), upright.outer.planes.size());
    EXPECT_NEAR(lying.outer.bounds.size().x, 100, 1e-6);
    EXPECT_NEAR(lying.outer.bounds.size().y, 30, 0.05);
}

TEST(DerivedStock, HasItsTopAtZeroWhereCutsGoBelow) {
    const DerivedStock s = derive_stock({{-5, -5, -8}, {105, 55, 30}}, 0.0);
    EXPECT_EQ(s.stock.box.max.z, 0);
    EXPECT_LE(s.stock.box.min.z, -10);
    EXPECT_LE(s.stock.box.min.x, -7);
    EXPECT_GE(s.stock.box.max.y, 57);
    EXPECT_FALSE(s.rule.empty());
}

TEST(DerivedStock, OfCutsAboveZeroEndsAtTheHighestTip) {
    const DerivedStock s = derive_stock({{0, 0, 2}, {10, 10, 40}}, 12.0);
    EXPECT_EQ(s.stock.box.max.z, 12);
    EXPECT_LT(s.stock.box.min.z, 2);
}

// Passes at 8, 6, 4 and 2: the first pass also removed 2 mm.
TEST(DerivedStock, OfPassesInEqualStepsEndsAStepAboveTheFirst) {
    HighestLevels levels;
    HighestLevels others;
    for (const double z : {4.0, 8.0, 2.0, 8.0})
        levels.add(z);
    EXPECT_EQ(levels.step(), std::nullopt) << "4 and 2 mm";
    EXPECT_EQ(derive_stock({{0, 0, 0}, {10, 10, 40}}, 8.0, levels).stock.box.max.z, 8);
    others.add(6.0);
    levels.add(others);
    EXPECT_EQ(levels.step(), 2.0);
    EXPECT_EQ(derive_stock({{0, 0, 0}, {10, 10, 40}}, 8.0, levels).stock.box.max.z, 10);
    // Cuts far below Z0: the zero is not on the part, and the part is around the cuts.
    EXPECT_EQ(derive_stock({{0, 0, -47}, {10, 10, 40}}, -45.0).stock.box.max.z, -45);
    EXPECT_EQ(derive_stock({{0, 0, -47}, {10, 10, 40}}, -30.0).stock.box.max.z, 0) << "a deep wall";
    EXPECT_EQ(derive_stock({{0, 0, -25}, {10, 10, 40}}, -25.0).stock.box.max.z, 0) << "one pass";
    EXPECT_EQ(derive_stock({{0, 0, -9}, {10, 10, 40}}, -8.0).stock.box.max.z, 0) << "near Z0";
    EXPECT_EQ(derive_stock({{0, 0, 0}, {10, 10, 40}}, 9.0, levels).stock.box.max.z, 9)
        << "something cuts higher up, on a slope";
    EXPECT_EQ(derive_stock({{0, 0, -1}, {10, 10, 40}}, 8.0, levels).stock.box.max.z, 0);
}

TEST(DerivedStock, IsNeverFlat) {
    const DerivedStock s = derive_stock({{0, 0, 0}, {10, 10, 40}}, 0.0);
    EXPECT_GE(s.stock.box.size().z, 1);
}

TEST(DerivedStock, OfNothingIsEmpty) {
    EXPECT_TRUE(derive_stock({}, 0).stock.box.is_empty());
}

TEST(DerivedStock, OfAPartThatTurnsIsABarAboutTheAxis) {
    const DerivedStock s = derive_bar({{10, -3, -3}, {90, 3, 40}}, 0, 18.5);
    EXPECT_TRUE(s.stock.is_round);
    EXPECT_EQ(s.stock.axis, 0);
    EXPECT_EQ(s.stock.box, (Box{{6, -18.5, -18.5}, {94, 18.5, 18.5}}));
    const Box block = derive_block({{-10, -20, -30}, {10, 20, 30}}).stock.box;
    EXPECT_EQ(block, (Box{{-12, -22, -33}, {12, 22, 33}}));
}

}  // namespace
}  // namespace ncsim::toolpath
