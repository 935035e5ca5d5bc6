// SPDX-License-Identifier: GPL-3.0-or-later
//
// Specifications of tools: the text of each kind, assumed values, and refusals at the limits.
#include "ncsim/toolpath/tool_spec.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

constexpr double kAssumed = 50.0;

ToolSpec spec_of(const std::string& option) {
    std::string message;
    const auto spec = parse_tool_option("T1=" + option, message);
    EXPECT_TRUE(spec) << message;
    return spec.value_or(ToolSpec{});
}

std::string refusal_of(const std::string& option) {
    std::string message;
    EXPECT_FALSE(parse_tool_option("T1=" + option, message)) << option;
    return message.substr(message.find(": ") + 2);
}

TEST(ToolSpec, OfEachKindHasATextAndAssumedValues) {
    struct Row {
        const char* option;
        const char* text;
        const char* assumed;
    };
    for (const Row& row : std::vector<Row>{
             {"flat:D10", "flat end mill D10 L50", "length 50 mm"},
             {"D10", "flat end mill D10 L50", "kind flat end mill, length 50 mm"},
             {"D10:R2", "bull nose end mill D10 R2 L50", "kind bull nose end mill, length 50 mm"},
             {"D10:R4.89", "bull nose end mill D10 R4.89 L50",
              "kind bull nose end mill, length 50 mm"},
             {"D10:R4.9", "ball end mill D10 L50", "kind ball end mill, length 50 mm"},
             {"D10:A90", "v-cutter D10 L50", "kind v-cutter, length 50 mm"},
             {"ball:D10", "ball end mill D10 L50", "length 50 mm"},
             {"bull:D10:R1", "bull nose end mill D10 R1 L50", "length 50 mm"},
             {"flat:D10:R1", "bull nose end mill D10 R1 L50", "length 50 mm"},
             {"face:D50", "face mill D50 L50", "length 50 mm"},
             {"face:D50:R1", "face mill D50 R1 L50", "length 50 mm"},
             {"v:D10", "v-cutter D10 L50", "angle 90 deg, length 50 mm"},
             {"v:P0.2", "v-cutter D3.175 L50", "diameter 3.175 mm, angle 90 deg, length 50 mm"},
             {"v:P2", "v-cutter D4 L50", "diameter 4 mm, angle 90 deg, length 50 mm"},
             {"chamfer:D12:A60", "chamfer mill D12 L50", "length 50 mm"},
             {"countersink:D12:L20", "countersink D12 L20", "angle 90 deg"},
             {"drill:D8", "drill D8 L50", "angle 118 deg, length 50 mm"},
             {"taper:D3:A6", "tapered end mill D13.510424 L50", "length 50 mm"},
             {"slot:D20", "slot mill D20 L5, D12 to 41", "length 5 mm, neck 12 mm"},
             {"slot:D20:S8", "slot mill D20 L5, D8 to 29", "length 5 mm"},
             {"slot:D20:S20", "slot mill D20 L5, D12 to 17, D20 to 77", "length 5 mm, neck 12 mm"},
             {"dovetail:D20", "dovetail mill D20 L10, D12 to 46",
              "taper 30 deg, length 10 mm, neck 12 mm"},
             {"dovetail:D20:A14:L5:N8x10", "dovetail mill D20 L5, D8 to 15", ""},
             {"lollipop:D12", "lollipop mill D12 L12, D7.2 to 33.6", "neck 7.2 mm"},
             {"corner:P6:R4", "corner rounding mill D14 P6 R4 L4", ""},
             {"tap:D8", "tap D8 L50", "length 50 mm"},
             {"tap:D8:K1.25:L20", "tap D8 L20", ""},
             {"reamer:D8", "reamer D8 L50", "length 50 mm"},
             {"boring-bar:D20", "boring bar D20 L50", "length 50 mm"},
             {"thread:D10:K1.5", "thread mill D10 L50", "length 50 mm"},
             {"flat:D10:E30", "flat end mill D10 L30", "length 30 mm"},
             {"flat:D10:E30:S10x20", "flat end mill D10 L10, D10 to 30", "length 10 mm"},
             {"flat:D10:L20:E30:H20x10", "flat end mill D10 L20, D10 to 30, D20 to 40", ""},
             {"flat:D10:L20:S12", "flat end mill D10 L20, D12 to 56", ""}}) {
        SCOPED_TRACE(row.option);
        const ToolSpec spec = spec_of(row.option);
        EXPECT_EQ(describe(make_tool(spec, kAssumed)), row.text);
        EXPECT_EQ(assumed_values_text(spec, kAssumed), row.assumed);
        // A specification with its assumed values makes the same tool, and names the same values.
        const ToolSpec whole = filled(spec, kAssumed);
        EXPECT_EQ(describe(make_tool(whole, 7.0)), row.text);
        EXPECT_EQ(describe(make_tool(specified_part(whole), kAssumed)), row.text);
        EXPECT_EQ(filled(whole, 7.0), whole);
    }
}

TEST(ToolSpec, HasLengthsInMillimetresAndInches) {
    EXPECT_EQ(spec_of("flat:D6").diameter, 6.0);
    EXPECT_EQ(spec_of("flat:D6mm").diameter, 6.0);
    EXPECT_EQ(spec_of("flat:D0.5in").diameter, 12.7);
    EXPECT_EQ(spec_of("flat:D1/2").diameter, 12.7);
    EXPECT_EQ(spec_of("flat:D1/2in").diameter, 12.7);
    EXPECT_EQ(spec_of("flat:D1/2mm").diameter, 0.5) << "a fraction with a unit";
    EXPECT_EQ(spec_of("flat:D10:S12x1in").shank_length, 25.4);
    EXPECT_EQ(spec_of("flat:D10:H1/2x10mm").holder.at(0), (ToolSegment{12.7, 12.7, 10.0}));
    EXPECT_EQ(spec_of("flat:D10:H20-32x10").holder.at(0), (ToolSegment{20.0, 32.0, 10.0}));
}

TEST(ToolSpec, IsRefusedBeyondItsLimits) {
    EXPECT_EQ(spec_of("v:D10:A1").angle, 1.0);
    EXPECT_EQ(spec_of("v:D10:A179").angle, 179.0);
    EXPECT_EQ(refusal_of("v:D10:A0.9"), "an angle is between 1 and 179 degrees");
    EXPECT_EQ(refusal_of("v:D10:A179.1"), "an angle is between 1 and 179 degrees");
    EXPECT_EQ(spec_of("taper:D3:A80").taper, 80.0);
    EXPECT_EQ(refusal_of("taper:D3:A80.1"), "a flank opens by 80 degrees per side at most");
    EXPECT_EQ(spec_of("dovetail:D20:A39").taper, 39.0);
    EXPECT_EQ(spec_of("dovetail:D20:A40").taper, 50.0);
    EXPECT_EQ(refusal_of("flat:ball:D6"), "a tool has one kind");
    EXPECT_EQ(refusal_of("flat:D6:D7"), "D is specified twice");
    EXPECT_EQ(refusal_of("flat:D0.0000009"),
              "a tool needs a diameter, as in D10, between 1 nm and 1 km");
    EXPECT_EQ(refusal_of("flat:D1000000"),
              "a tool needs a diameter, as in D10, between 1 nm and 1 km");
    EXPECT_EQ(refusal_of("flat:D6:L0"), "a length of that size is no tool's");
    EXPECT_EQ(refusal_of("flat:D6:S6x1000000"), "a length of that size is no tool's");
    EXPECT_EQ(refusal_of("flat:D6:H1000000x5"), "a length of that size is no holder's");
    EXPECT_EQ(refusal_of("flat:D6:H5-1000000x5"), "a length of that size is no holder's");
    const std::string corner =
        "a corner rounding mill needs R, its concave radius, and a diameter: D, or P of the tip, "
        "smaller than D";
    EXPECT_EQ(refusal_of("corner:D10"), corner);
    EXPECT_EQ(refusal_of("corner:R4"), corner);
    EXPECT_EQ(refusal_of("corner:D10:P10:R4"), corner);
    EXPECT_EQ(refusal_of("corner:D10:P11:R4"), corner);
    EXPECT_EQ(spec_of("corner:D10:P9.99:R4").tip_diameter, 9.99);
}

TEST(ToolSpec, HasNoValueThatItsKindDoesNotHave) {
    EXPECT_EQ(refusal_of("flat:D10:A60"), "a flat end mill has no angle (A)");
    EXPECT_EQ(refusal_of("drill:D10:R1"), "a drill has no corner radius (R)");
    EXPECT_EQ(refusal_of("v:D10:R1"), "a v-cutter has no corner radius (R)");
    EXPECT_EQ(refusal_of("dovetail:D10:R1"), "a dovetail mill has no corner radius (R)");
    EXPECT_EQ(refusal_of("flat:D10:P1"), "a flat end mill has no tip diameter (P)");
    EXPECT_EQ(refusal_of("flat:D10:K1"), "a flat end mill has no pitch (K)");
    EXPECT_EQ(spec_of("flat:D10:R0").corner_radius, 0.0);
    // Values within a hundredth of the diameter are as CAM systems round.
    EXPECT_EQ(spec_of("ball:D10:R5.1").corner_radius, 5.1);
    EXPECT_EQ(refusal_of("ball:D10:R5.11"), "R5.11 of a ball end mill is not half of D10");
    EXPECT_EQ(refusal_of("ball:D10:R4.89"), "R4.89 of a ball end mill is not half of D10");
    EXPECT_EQ(spec_of("bull:D10:R5.1").corner_radius, 5.1);
    EXPECT_EQ(refusal_of("bull:D10:R5.11"), "R5.11 is more than half of D10");
    EXPECT_EQ(spec_of("v:D10:P10").tip_diameter, 10.0);
    EXPECT_EQ(refusal_of("v:D10:P10.01"), "P10.01 is more than D10");
    EXPECT_EQ(spec_of("v:D10:A90:L4.9").length, 4.9);
    EXPECT_EQ(refusal_of("v:D10:A90:L4.89"), "L4.89 is less than the height of the cone, 5 mm");
    EXPECT_EQ(refusal_of("bull:D10:R5:L4"), "L4 is less than the height of the shape, 5 mm");
    EXPECT_EQ(refusal_of("lollipop:D12:L20"), "L20 is more than the height of the shape, 12 mm");
    EXPECT_EQ(spec_of("slot:D20:L4:R4.2").corner_radius, 4.2);
    EXPECT_EQ(refusal_of("slot:D20:L4:R4.21"), "R4.21 is more than L4");
    EXPECT_EQ(refusal_of("corner:D20:P6:R4:L4"),
              "D20 is more than P + 2 R, and L4 leaves no shoulder");
    EXPECT_EQ(spec_of("corner:D20:P6:R4:L4.01").length, 4.01);
    EXPECT_EQ(spec_of("flat:D10:L20:S10x30:E50").stick_out, 50.0);
    EXPECT_EQ(spec_of("flat:D10:L20:S10x30:E49.9").stick_out, 49.9);
    EXPECT_EQ(refusal_of("flat:D10:L20:S10x30:E49.89"),
              "E49.89 is less than flutes, neck and shank together, 50 mm");
}

}  // namespace
}  // namespace ncsim::toolpath
