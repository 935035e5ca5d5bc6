// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comments of a stock and comments of a key and a value, on both sides of their limits.
#include "tools/tool_comment.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using What = StockRemark::What;
using Key = KeyedRemark::Key;

// Returns the text `form` with the numbers in place of %1, %2 and %3.
std::string with_numbers(std::string form, const std::vector<std::string>& numbers) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string mark = "%" + std::to_string(i + 1);
        form.replace(form.find(mark), 2, numbers[i]);
    }
    return form;
}

// Forms of a size: all three lengths are more than 0, however small, and at most a kilometre.
TEST(StockRemark, IsASizeOfThreePositiveLengths) {
    for (const auto& [form, what] : std::vector<std::pair<std::string, What>>{
             {"STOCK/BLOCK,%1,%2,%3", What::Block},
             {"STOCK/BLOCK,%1,%2,%3,1,2,3", What::Block},
             {"$SetPartSize(%1,%2,%3)", What::Size},
             {"$SetPartSize(%1,%2,%3,1)", What::Size},
             {"Stock X:%1 Y:%2 Z:%3", What::Size},
             {"Stock X=%1 Y=%2 Z=%3", What::Size},
             {"Material Size: X%1 Y%2 Z%3", What::Size},
             {"STOCK %1x%2x%3", What::Size},
             {"Stock Size: %1(X) * %2(Y) * %3(Z) mm", What::Size},
             {"BLANK DX %1 DY %2 DZ %3", What::Size}}) {
        SCOPED_TRACE(form);
        const auto plain = read_stock_remark(with_numbers(form, {"40", "30", "0.5"}));
        ASSERT_TRUE(plain);
        EXPECT_EQ(plain->what, what);
        EXPECT_EQ(plain->first.value, (Vec3{40, 30, 0.5}));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::vector<std::string> numbers{"40", "30", "20"};
            numbers[axis] = "0.5";
            const auto small = read_stock_remark(with_numbers(form, numbers));
            ASSERT_TRUE(small) << axis;
            EXPECT_EQ(small->first.value[static_cast<int>(axis)], 0.5);
            numbers[axis] = "1000000";
            EXPECT_TRUE(read_stock_remark(with_numbers(form, numbers))) << axis;
            for (const char* bad : {"0", "1000001"}) {
                numbers[axis] = bad;
                EXPECT_FALSE(read_stock_remark(with_numbers(form, numbers))) << axis << ' ' << bad;
            }
        }
    }
}

TEST(StockRemark, HasAZeroInBothDirections) {
    const auto zero = [](const std::string& text) -> std::optional<Vec3> {
        const auto remark = read_stock_remark(text);
        if (!remark || remark->what != What::Zero) return std::nullopt;
        return remark->first.value;
    };
    EXPECT_EQ(zero("ZERO LEFT FRONT TOP"), (Vec3{-1, -1, 1}));
    EXPECT_EQ(zero("ORIGIN RIGHT BACK BOTTOM"), (Vec3{1, 1, -1}));
    EXPECT_EQ(zero("DATUM RIGHT REAR TOP"), (Vec3{1, 1, 1}));
    EXPECT_EQ(zero("WCS G54 UPPER RIGHT TOP"), (Vec3{1, 1, 1}));
    EXPECT_EQ(zero("XYZ ZERO CENTRE BOTTOM"), (Vec3{0, 0, -1}));
    EXPECT_EQ(zero("ZERO MIDDLE TOP"), (Vec3{0, 0, 1}));
    EXPECT_EQ(zero("WORK ZERO LEFT MIDDLE TOP"), (Vec3{-1, 0, 1}));
    for (const char* missing :
         {"ZERO FRONT TOP", "ZERO LEFT TOP", "ZERO LEFT FRONT", "ZERO CENTER", "LEFT FRONT TOP",
          "ZERO LEFT FRONT TOP 5 DEEP", "ZERO TOP", "WCS G43 LEFT FRONT TOP"}) {
        EXPECT_FALSE(zero(missing)) << missing;
    }
}

TEST(StockRemark, IsACornerOrAPlaceOfVectric) {
    const auto corner = [](const std::string& text) {
        const auto remark = read_stock_remark(text);
        return remark && remark->what == What::ZeroXY ? remark->first.value : Vec3{9, 9, 9};
    };
    EXPECT_EQ(corner("XY Origin for Material = Bottom Left Corner"), (Vec3{-1, -1, 0}));
    EXPECT_EQ(corner("XY Origin for Material = Top Right Corner"), (Vec3{1, 1, 0}));
    EXPECT_EQ(corner("XY Origin for Material = Center"), (Vec3{0, 0, 0}));
    EXPECT_FALSE(read_stock_remark("XY Origin for Material"));
    EXPECT_EQ(read_stock_remark("Z Origin for Material = Table Surface")->what, What::ZeroAtBed);
    EXPECT_EQ(read_stock_remark("Z Origin for Material = Bed")->what, What::ZeroAtBed);
    EXPECT_EQ(read_stock_remark("Z Origin for Material = Material Surface")->what, What::ZeroAtTop);
    EXPECT_EQ(read_stock_remark("Material Origin: X0 Y0 Z0")->what, What::ZeroXY);
    EXPECT_EQ(read_stock_remark("Material Origin: X0 Y0 Z1")->what, What::Elsewhere);
    EXPECT_EQ(read_stock_remark("Material Size")->what, What::Heading);
    EXPECT_EQ(read_stock_remark("Material Size:")->what, What::Heading);
    EXPECT_EQ(read_stock_remark("FROM/1,2,3")->first.value, (Vec3{1, 2, 3}));
    EXPECT_EQ(read_stock_remark("FROM/1,2,3")->what, What::Start);
    EXPECT_FALSE(read_stock_remark("FROM/1,2"));
    EXPECT_EQ(read_stock_remark("BLK FORM 0.1 Z X-1 Y-2 Z-3")->first.value, (Vec3{-1, -2, -3}));
    EXPECT_EQ(read_stock_remark("BLK FORM 0.2 X1 Y2 Z3")->what, What::Max);
    EXPECT_FALSE(read_stock_remark("BLK FORM 0.2 X1 Y2"));
}

TEST(StockRemark, OfMixedUnitsIsNone) {
    EXPECT_EQ(read_stock_remark("STOCK 40 x 30 x 1/2")->first.unit, text::Unit::Inch);
    EXPECT_EQ(read_stock_remark("STOCK 40mmx30mmx5mm")->first.unit, text::Unit::Millimetre);
    EXPECT_EQ(read_stock_remark("STOCK 4inx3inx1in")->first.unit, text::Unit::Inch);
    EXPECT_EQ(read_stock_remark("STOCK 40 x 30 x 5")->first.unit, text::Unit::None);
    EXPECT_FALSE(read_stock_remark("STOCK 40mm x 3in x 5"));
    EXPECT_FALSE(read_stock_remark("STOCK 40 x 30 deg x 5"));
    EXPECT_FALSE(read_stock_remark("STOCK 40 x 30 x 5 deg"));
    EXPECT_FALSE(read_stock_remark("BLANK DX 40 DY 30 deg DZ 5"));
}

TEST(SizeRemark, BeginsWithX) {
    EXPECT_EQ(read_size_remark(" X= 76.0, Y= 5.5, Z= 1.0")->value, (Vec3{76, 5.5, 1}));
    EXPECT_FALSE(read_size_remark("Y= 5.5, X= 76.0, Z= 1.0"));
    EXPECT_FALSE(read_size_remark("X= 76.0, Y= 5.5, Z= 0"));
    EXPECT_FALSE(read_size_remark(""));
}

TEST(KeyedRemark, IsAKeyAndAValueToTheEnd) {
    const auto keyed = [](const char* text) { return read_keyed_remark(text); };
    EXPECT_EQ(keyed("DIAMETER: 6.0")->value, 6.0);
    EXPECT_EQ(keyed("DIAMETER: 6.0")->unit, text::Unit::None);
    EXPECT_EQ(keyed("DIAMETER: 1/4")->unit, text::Unit::Inch);
    EXPECT_EQ(keyed("DIAMETER: 1/4 mm")->unit, text::Unit::Millimetre);
    EXPECT_EQ(keyed("DIAMETER: 6 mm")->unit, text::Unit::Millimetre);
    EXPECT_EQ(keyed("tool_radius = 3")->value, 6.0) << "the diameter";
    EXPECT_EQ(keyed("tool_radius = 3")->key, Key::Diameter);
    EXPECT_EQ(keyed("Tool Number: 3")->key, Key::ToolNumber);
    EXPECT_EQ(keyed("Tip Radius: 0")->value, 0.0);
    EXPECT_EQ(keyed("Taper Angle: 5 deg")->value, 5.0);
    EXPECT_EQ(keyed("torus_radius = 0.5")->key, Key::TorusRadius);
    EXPECT_EQ(keyed("Tool Type: Ball Nosed")->kind, ToolKind::BallEndMill);
    EXPECT_FALSE(keyed("Tool Type: ?")->kind);
    // Keys of PowerMill have a colon, keys of PyCAM an equals sign.
    for (const char* none : {"DIAMETER = 6", "tool_radius: 3", "DIAMETER: -1", "DIAMETER: 6 x",
                             "DIAMETER:", "DIAMETER 6", "WIDTH: 6", ":6", ""}) {
        EXPECT_FALSE(keyed(none)) << none;
    }
}

}  // namespace
}  // namespace ncsim::toolpath
