// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/stock.h"

#include <gtest/gtest.h>

namespace ncsim::toolpath {
namespace {

using cda::Box;
using cda::Vec3;

std::optional<Box> stock(const char* text) {
    std::string message;
    const auto box = parse_stock_option(text, message);
    EXPECT_EQ(box.has_value(), message.empty()) << message;
    return box;
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

TEST(StockOption, RefusesWhatIsNoBlock) {
    for (const char* bad :
         {"", "1,2,3", "0,0,0:0,1,1", "0,0,0:1,1", "1x2", "0x1x1", "-1x1x1", "axbxc", "1x1x1@0,0",
          "1e9x1x1", "9999999x1x1", "1x1x1@99999999,0,0", ":", "@"}) {
        SCOPED_TRACE(bad);
        EXPECT_FALSE(stock(bad));
    }
}

TEST(DerivedStock, HasItsTopAtZeroWhereCutsGoBelow) {
    const DerivedStock s = derive_stock({{-5, -5, -8}, {105, 55, 30}}, 0.0);
    EXPECT_EQ(s.box.max.z, 0);
    EXPECT_LE(s.box.min.z, -10);
    EXPECT_LE(s.box.min.x, -7);
    EXPECT_GE(s.box.max.y, 57);
    EXPECT_FALSE(s.rule.empty());
}

TEST(DerivedStock, OfCutsAboveZeroEndsAtTheHighestTip) {
    const DerivedStock s = derive_stock({{0, 0, 2}, {10, 10, 40}}, 12.0);
    EXPECT_EQ(s.box.max.z, 12);
    EXPECT_LT(s.box.min.z, 2);
}

TEST(DerivedStock, IsNeverFlat) {
    const DerivedStock s = derive_stock({{0, 0, 0}, {10, 10, 40}}, 0.0);
    EXPECT_GE(s.box.size().z, 1);
}

TEST(DerivedStock, OfNothingIsEmpty) {
    EXPECT_TRUE(derive_stock({}, 0).box.is_empty());
}

}  // namespace
}  // namespace ncsim::toolpath
