// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes that a program inherits from the previous program: Interpretation::inherited_modes.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode {
namespace {

std::string inherited(const std::string& program, Dialect dialect) {
    InterpreterOptions options;
    options.dialect = dialect;
    const Interpretation result = interpret({"p.nc", program}, options, [](const Motion&) {});
    std::string text;
    for (const std::string& mode : result.inherited_modes)
        text += (text.empty() ? "" : ", ") + mode;
    return text;
}

const std::string kCommon = "G21 G90 G17 G94 G54 G40 G49 G80";

TEST(HeadModes, AreThoseThatNoBlockSetsBeforeTheFirstMove) {
    const Dialect lcnc = Dialect::Rs274;
    EXPECT_EQ(inherited(kCommon + " G92.1\nG1 X5 F100\nM2\n", lcnc), "");
    EXPECT_EQ(inherited(kCommon + "\nG1 X5 F100\nM2\n", lcnc), "shift (G92.1)");
    EXPECT_EQ(inherited("G21 G90 G17 G94 G54 G49\nG52 X0 Y0 Z0\nG0 X5\nM2\n", lcnc),
              "cutter compensation (G40)");
    EXPECT_EQ(inherited("G92.1\nG0 X5\nG21 G90 G17 G94 G54 G40 G49\nM2\n", lcnc),
              "units (G20, G21), distances (G90, G91), plane (G17), feed mode (G94), coordinate "
              "system (G54), cutter compensation (G40), tool length (G43, G49)")
        << "words behind the move are too late";
    EXPECT_EQ(inherited(kCommon + " G92.1 G0 X5\nM2\n", lcnc), "") << "one block";
    EXPECT_EQ(inherited("G91 G28 Z0\n" + kCommon + " G92.1\nG0 X5\nM2\n", lcnc), "")
        << "moves to places of the machine belong to the head";
}

TEST(HeadModes, AreThoseThatTheControlHas) {
    const std::string program = kCommon + " G52 X0\nG0 X5\nM2\n";
    EXPECT_EQ(inherited(program, Dialect::Fanuc),
              "rotation (G69), scaling (G50), polar coordinates (G15)");
    EXPECT_EQ(inherited("G69 G50 G15 " + program, Dialect::Haas), "");
    EXPECT_EQ(inherited("G21 G90 G17 G94 G54 G49 G92.1\nG0 X5\nM2\n", Dialect::Grbl), "");
}

}  // namespace
}  // namespace ncsim::gcode
