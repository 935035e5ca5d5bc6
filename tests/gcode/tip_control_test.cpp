// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tip control: after the word that the machine defines for tip control, X, Y and Z are positions of
// the tip.
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Made {
    std::vector<Motion> moves;
    Interpretation result;

    bool says(const std::string& code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [&](const Diagnostic& d) { return d.code == code; });
    }
};

TipControl specified() {
    return {{{428, Coordinates::Tip}, {429, Coordinates::Axes}}, true, false};
}

Made run(const std::string& program, TipControl tip_control = specified()) {
    InterpreterOptions options;
    options.tip_control = std::move(tip_control);
    options.tools.push_back({.number = 1,
                             .offset = {Length(), Length(), Length::from_mm(70)},
                             .length_specified = true,
                             .diameter = Length::from_mm(10.0)});
    Made made;
    made.result =
        interpret({"t.nc", "G21 G90 G17 F100\n" + program}, options, [&](const Motion& motion) {
            if (start_of(motion)) made.moves.push_back(motion);
        });
    return made;
}

bool knows(const KnownAxes& axes) {
    return axes == KnownAxes{true, true, true};
}

TEST(TipControl, BeginsAndEndsWithTheWordsOfTheMachine) {
    const Made made = run("G0 X1 Y2 Z3\nM428\nG1 X4 A10\nG1 A0\nM429\nG1 X5\n");
    EXPECT_TRUE(made.result.diagnostics.empty() || !made.says("kinematics"));
    ASSERT_EQ(made.moves.size(), 4U);
    EXPECT_EQ(made.moves[0].coordinates, Coordinates::Axes);
    EXPECT_EQ(made.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[2].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Axes);
    // With all rotary axes at 0 the tip position equals the linear axes.
    for (std::size_t i = 1; i < made.moves.size(); ++i)
        EXPECT_TRUE(knows(made.moves[i].known_start)) << i;
}

TEST(TipControl, MayBeThereFromTheStart) {
    TipControl from_start = specified();
    from_start.at_start = Coordinates::Tip;
    const Made made = run("G0 X1 Y2 Z3\nG1 X4 A10\nG1 A0\nM429\nG1 X5\n", from_start);
    ASSERT_EQ(made.moves.size(), 4U);
    EXPECT_EQ(made.moves[0].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Axes);
}

TEST(TipControl, WordsThatNobodyToldStopTheProgram) {
    EXPECT_TRUE(run("G0 X1 Y2 Z3 A10\nM428\nG1 X4\n", {}).says("kinematics"));
    EXPECT_TRUE(run("G0 X1 Y2 Z3 A10\nM430\nG1 X4\n").says("kinematics"));
    EXPECT_TRUE(run("G43.4 H1\nG1 X4\n", {}).result.stopped);
    EXPECT_TRUE(run("G43.5 H1\nG1 X4\n").result.stopped);
    EXPECT_TRUE(run("G68.2 X0 Y0 Z0 I0 J10 K0\nG1 X4\n").result.stopped);
}

TEST(TipControl, BeginsWithG43_4AndEndsWithG49) {
    const Made made = run("G0 X1 Y2 Z3\nG43.4 H1\nG1 X4 Y2 Z3 A10\nG1 A0\nG49\nG1 X5 Y0 Z0\n");
    EXPECT_FALSE(made.result.stopped);
    ASSERT_EQ(made.moves.size(), 4U);
    EXPECT_EQ(made.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[1].length.mm(), 70.0);
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Axes);
    EXPECT_EQ(made.moves[3].length.mm(), 0.0);
    EXPECT_TRUE(made.result.uses_length_offsets);
    // Plain G43 is a different mode of the same group.
    EXPECT_EQ(run("G0 X1 Y2 Z3\nG43.4 H1\nG43 H1\nG1 X4\n").moves.back().coordinates,
              Coordinates::Axes);
}

// After the change the tip position depends on the kinematics, which are never guessed.
TEST(TipControl, AMoveAfterASwitchWithTurnedAxesComesFromNowhere) {
    const Made made = run("G0 X1 Y2 Z3 A10\nM428\nG1 X4\nY5 Z6\nG1 X7\nM429\nG1 X8\n");
    ASSERT_EQ(made.moves.size(), 5U);
    EXPECT_TRUE(knows(made.moves[0].known_end));
    EXPECT_EQ(made.moves[1].known_start, (KnownAxes{false, false, false}));
    EXPECT_EQ(made.moves[1].known_end, (KnownAxes{true, false, false}));
    EXPECT_TRUE(knows(made.moves[3].known_start));
    EXPECT_EQ(made.moves[4].known_start, (KnownAxes{false, false, false}));
    // Increments from an unknown position lead to an unknown position.
    const Made by_steps = run("G0 X1 Y2 Z3 A10\nM428\nG91 G1 X4 Y1 Z1\nX1\n");
    EXPECT_TRUE(by_steps.moves.back().start_assumed);
}

TEST(TipControl, APlaceOfTheMachineIsNoPlaceOfTheTipThen) {
    const Made made = run("M428\nG0 X1 Y2 Z3 A10\nG53 G0 Z0\nG0 X1\nG0 X1 Y2 Z3\nG1 X2\n");
    ASSERT_EQ(made.moves.size(), 5U);
    EXPECT_EQ(made.moves[1].known_start, (KnownAxes{false, false, false}));
    EXPECT_EQ(made.moves[1].known_end, (KnownAxes{false, false, false}));
    EXPECT_EQ(made.moves[2].known_end, (KnownAxes{true, false, false}));
    EXPECT_TRUE(knows(made.moves[4].known_start));
    // With all rotary axes at 0 the position is known.
    const Made upright = run("M428\nG0 X1 Y2 Z3\nG53 G0 Z0\nG0 X1\n");
    EXPECT_TRUE(knows(upright.moves[1].known_end));
}

TEST(TipControl, G43_4WithTurnedAxesNeedsToKnowWhatTurnsWithTheTable) {
    const std::string program = "G0 X1 Y2 Z3 A10\nG43.4 H1\nG1 X4 Y5 Z6\n";
    EXPECT_TRUE(run(program).result.stopped);
    TipControl at_zero = specified();
    at_zero.frame_at_zero = true;
    const Made made = run(program, at_zero);
    EXPECT_FALSE(made.result.stopped);
    EXPECT_EQ(made.moves.back().known_start, (KnownAxes{false, false, false}));
}

TEST(TipControl, WhatIsNotSimulatedWithATiltedToolIsAnError) {
    for (const char* block : {"G81 X1 R2 Z-5", "G41 D1 X5", "G68 X0 Y0 R30\nG1 X5"}) {
        const Made made = run(std::string("M428\nG0 X1 Y2 Z3 A10\nG1 X0\n") + block + "\n");
        EXPECT_TRUE(made.says("kinematics")) << block;
        const Made upright = run(std::string("M428\nG0 X1 Y2 Z3\nG1 X0\n") + block + "\n");
        EXPECT_FALSE(upright.says("kinematics")) << block;
    }
}

TEST(TipControl, AnyMCodeMayBeTheOne) {
    const Made made =
        run("G0 X0 Y0 Z0\nM128\nG1 X4 A10\n", {{{128, Coordinates::Tip}}, false, false});
    EXPECT_EQ(made.moves.back().coordinates, Coordinates::Tip);
    EXPECT_TRUE(made.result.diagnostics.empty() || !made.says("unknown-m"));
}

}  // namespace
}  // namespace ncsim::gcode
