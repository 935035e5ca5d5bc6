// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes of Klartext and SINUMERIK that a program must end: each is reported, and not reported if
// the program ends it.
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode {
namespace {

using klartext_test::klartext;
using language_test::Made;
using sinumerik_test::sinumerik;

/// Returns the warnings and errors with the code `code`, with their lines.
std::string reported(const Made& made, const std::string& code) {
    std::string out;
    for (const Diagnostic& d : made.result.diagnostics) {
        if (d.code == code) out += std::to_string(d.span.line) + ": " + d.message + "\n";
    }
    return out;
}

std::string left_on(const Made& made) {
    return reported(made, "left-on");
}

TEST(ModesLeftOn, KlartextAtTheEnd) {
    const std::string end = " is active at the end of the program; end it with ";
    const std::string preset = "CYCL DEF 247 Q339=1\n";
    const auto of = [&](const std::string& blocks) {
        return left_on(language_test::run(klartext(preset + blocks)));
    };
    EXPECT_EQ(of("L X+1 F100"), "");
    EXPECT_EQ(of("CYCL DEF 7.0\nCYCL DEF 7.1 X+5\nL X+1 F100"),
              "8: a datum shift" + end + "CYCL DEF 7.1 X+0\n");
    EXPECT_EQ(of("CYCL DEF 7.0\nCYCL DEF 7.1 X+5\nL X+1 F100\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0"), "");
    EXPECT_EQ(of("CYCL DEF 8.0\nCYCL DEF 8.1 X"), "7: a mirror image" + end + "CYCL DEF 8.1\n");
    EXPECT_EQ(of("CYCL DEF 8.0\nCYCL DEF 8.1 X\nCYCL DEF 8.0\nCYCL DEF 8.1"), "");
    EXPECT_EQ(of("CYCL DEF 10.0\nCYCL DEF 10.1 ROT+30"),
              "7: a rotation" + end + "CYCL DEF 10.1 ROT+0\n");
    EXPECT_EQ(of("CYCL DEF 10.0\nCYCL DEF 10.1 ROT+30\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+0"), "");
    EXPECT_EQ(of("L X-20 F100\nL X+1 RL\nL X+50"), "8: cutter compensation" + end + "R0\n");
    EXPECT_EQ(of("L X-20 F100\nL X+1 RL\nL X+50\nL X+60 R0"), "");
}

TEST(ModesLeftOn, KlartextAtAToolChange) {
    const std::string change = " is active at the tool change; end it before with ";
    const auto of = [](const std::string& blocks) {
        return left_on(language_test::run(klartext(blocks)));
    };
    EXPECT_EQ(of("L X-20 F100\nL X+1 RL\nL X+50\nL Z+80 FMAX\nTOOL CALL 2 Z S900\nL R0 X+9"),
              "8: cutter compensation" + change + "R0\n");
    EXPECT_EQ(of("L X-20 F100\nL X+1 RL\nL X+50 R0\nL Z+80 FMAX\nTOOL CALL 2 Z S900"), "");
}

TEST(ModesLeftOn, PresetBeforeADatumShift) {
    const auto of = [](const std::string& blocks) {
        return reported(language_test::run(klartext(blocks)), "preset-missing");
    };
    const std::string shift = "CYCL DEF 7.0\nCYCL DEF 7.1 X+5\nCYCL DEF 7.0\nCYCL DEF 7.1 X+0";
    EXPECT_EQ(
        of(shift),
        "5: cycle 7 shifts a datum, and no cycle 247 selects the preset; program CYCL DEF 247 "
        "before\n");
    EXPECT_EQ(of("CYCL DEF 247 Q339=2\n" + shift), "");
}

TEST(ModesLeftOn, SinumerikAtTheEnd) {
    const std::string end = " is active at the end of the program; end it with ";
    const auto of = [](const std::string& blocks) {
        return left_on(sinumerik_test::run(sinumerik(blocks)));
    };
    EXPECT_EQ(of("G1 X1 F100"), "");
    EXPECT_EQ(of("TRANS X5\nG1 X1 F100"), "7: a programmable frame" + end + "TRANS\n");
    EXPECT_EQ(of("TRANS X5\nG1 X1 F100\nTRANS"), "");
    EXPECT_EQ(of("MCALL CYCLE81(20,0,2,-5)\nX5"), "7: MCALL" + end + "MCALL alone\n");
    EXPECT_EQ(of("MCALL CYCLE81(20,0,2,-5)\nX5\nMCALL"), "");
    EXPECT_EQ(of("G1 X-20 F100\nG41 X0\nX50"), "8: cutter compensation" + end + "G40\n");
    EXPECT_EQ(of("G1 X-20 F100\nG41 X0\nX50\nG40 X60"), "");
}

TEST(ModesLeftOn, SinumerikAtAToolChange) {
    const std::string change = " is active at the tool change; end it before with ";
    const auto of = [](const std::string& blocks) {
        return left_on(sinumerik_test::run(sinumerik(blocks)));
    };
    EXPECT_EQ(of("MCALL CYCLE81(20,0,2,-5)\nX5\nT2 M6\nMCALL"),
              "7: MCALL" + change + "MCALL alone\n");
    EXPECT_EQ(of("MCALL CYCLE81(20,0,2,-5)\nX5\nMCALL\nT2 M6"), "");
}

TEST(ModesLeftOn, ToolChangeWithoutRetract) {
    const auto klartext_of = [](const std::string& blocks) {
        return reported(language_test::run(klartext(blocks)), "change-without-retract");
    };
    const auto sinumerik_of = [](const std::string& blocks) {
        return reported(sinumerik_test::run(sinumerik(blocks)), "change-without-retract");
    };
    const std::string text =
        ": the tool changes at the lowest height of its cut; retract it before\n";
    EXPECT_EQ(klartext_of("L Z-5 F100\nL X+20\nTOOL CALL 2 Z S900"), "6" + text);
    EXPECT_EQ(klartext_of("L Z-5 F100\nL X+20\nL Z+50 FMAX\nTOOL CALL 2 Z S900"), "");
    EXPECT_EQ(klartext_of("L Z-5 F100\nL X+20\nL M140 MB+50\nTOOL CALL 2 Z S900"), "");
    EXPECT_EQ(klartext_of("L Z-5 F100\nL X+20\nL Z+0 FMAX M91\nTOOL CALL 2 Z S900"), "");
    // Only speed and feed, or the same tool: no change.
    EXPECT_EQ(klartext_of("L Z-5 F100\nL X+20\nTOOL CALL S900\nTOOL CALL 1 Z S900"), "");
    EXPECT_EQ(sinumerik_of("G1 Z-5 F100\nX20\nT2 M6"), "7" + text);
    EXPECT_EQ(sinumerik_of("G1 Z-5 F100\nX20\nG0 Z50\nT2 M6"), "");
    EXPECT_EQ(sinumerik_of("G1 Z-5 F100\nX20\nG0 SUPA Z0 D0\nT2 M6"), "");
}

}  // namespace
}  // namespace ncsim::gcode
