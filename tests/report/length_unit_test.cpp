// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of texts in inches.
#include "ncsim/report/length_unit.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::report {
namespace {

std::string inches(const std::string& text) {
    return in_unit(text, LengthUnit::Inch);
}

TEST(LengthUnit, ConvertsNumbersWithAUnit) {
    EXPECT_EQ(inches("12.7 mm"), "0.5 in");
    EXPECT_EQ(inches("depth: 25.4 mm."), "depth: 1 in.");
    EXPECT_EQ(inches("(-25.4 mm)"), "(-1 in)");
    EXPECT_EQ(inches("0.002 mm missed"), "7.87e-05 in missed");
    EXPECT_EQ(inches("16387.064 mm3, 645.16 mm2, 16.387064 cm3"), "1 in3, 1 in2, 1 in3");
    EXPECT_EQ(inches("254 mm/min, 2.54 mm/rev"), "10 in/min, 0.1 in/rev");
    EXPECT_EQ(inches("rapid 1:56 min at 10 m/min"), "rapid 1:56 min at 393.7008 in/min");
    EXPECT_EQ(inches("645.16 mm3/mm, 16387.064 mm3/min"), "1 in3/in, 1 in3/min");
}

TEST(LengthUnit, ConvertsRangesProductsAndPlaces) {
    EXPECT_EQ(inches("between 25.4 and 50.8 mm it cuts"), "between 1 and 2 in it cuts");
    EXPECT_EQ(
        inches(
            "25.4 x 50.8 x 76.2 mm, X -12.7 to 12.7, Y 0 to 50.8, Z -76.2 to 0, turned X180,Z30"),
        "1 x 2 x 3 in, X -0.5 to 0.5, Y 0 to 2, Z -3 to 0, turned X180,Z30");
    EXPECT_EQ(inches("at X25.4 Y-12.7 Z0"), "at X1 Y-0.5 Z0");
    EXPECT_EQ(inches("turned X180, moved by X0 Y0 Z-25.4"), "turned X180, moved by X0 Y0 Z-1");
}

TEST(LengthUnit, LeavesWhatIsNoLength) {
    for (const char* text :
         {"T12 in line 40", "3 mmx", "12 mmap", "the fixture '5 mm stop' of 3 parts", "A30 C45",
          "5 % of it", "an R5 of a variable", "tool's 3 flutes", "1:02 min", "X", "-", "mm", ""})
        EXPECT_EQ(inches(text), text);
    EXPECT_EQ(inches("the tool's tip is 25.4 mm from 'a 9 mm hole', 25.4 mm"),
              "the tool's tip is 1 in from 'a 9 mm hole', 1 in");
    const std::string any = "25.4 mm at X25.4";
    EXPECT_EQ(in_unit(any, LengthUnit::Millimetre), any);
}

TEST(LengthUnit, ConvertsDescriptionsOfTools) {
    const auto tool = [](const char* text) { return tool_in_unit(text, LengthUnit::Inch); };
    EXPECT_EQ(tool("flat end mill D12.7 L25.4"), "flat end mill D0.5in L1in");
    EXPECT_EQ(tool("bull nose end mill D12.7 R2.54 L25.4, D12.7-25.4 to 50.8"),
              "bull nose end mill D0.5in R0.1in L1in, D0.5in-1in to 2 in");
    EXPECT_EQ(tool("v-cutter D12.7 A90 L6.35"), "v-cutter D0.5in A90 L0.25in");
    EXPECT_EQ(tool_in_unit("drill D6 L40", LengthUnit::Millimetre), "drill D6 L40");
}

}  // namespace
}  // namespace ncsim::report
