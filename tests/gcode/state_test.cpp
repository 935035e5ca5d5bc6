// SPDX-License-Identifier: GPL-3.0-or-later
//
// State of a control: a refused block leaves no trace, and the position of the workpiece follows
// from the program.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Made {
    std::string motions;
    std::vector<ProgramFrame> frames;  // of the motions
    Interpretation result;
};

Made run(const std::string& program, InterpreterOptions options = {}) {
    Made made;
    options.tools.push_back({.number = 1,
                             .offset = {Length(), Length(), Length::from_mm(7)},
                             .length_specified = true,
                             .diameter = Length::from_mm(10.0)});
    made.result = interpret({"t.nc", program}, options, [&](const Motion& motion) {
        print(made.motions, motion);
        made.motions += '\n';
        made.frames.push_back(*motion.frame);
    });
    return made;
}

bool says(const Made& made, const std::string& code) {
    return std::ranges::any_of(made.result.diagnostics,
                               [&](const Diagnostic& d) { return d.code == code; });
}

Position at(double x, double y, double z) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

std::string last_line(const std::string& text) {
    const std::size_t before = text.rfind('\n', text.size() - 2);
    return before == std::string::npos ? text : text.substr(before + 1);
}

// --- A refused block ---------------------------------------------------------------------------

const std::string kStart = "G21 G90 G17 F100 T1 M6\nG0 X0 Y0 Z0\n";

// Checks that the program without the block in the third line makes the same motions.
void expect_nothing_left(const std::string& before, const std::string& refused,
                         const std::string& after) {
    SCOPED_TRACE(refused);
    const Made with = run(kStart + before + "\n" + refused + "\n" + after + "\nM2\n");
    const Made without = run(kStart + before + "\n\n" + after + "\nM2\n");
    EXPECT_TRUE(has_errors(with.result.diagnostics));
    EXPECT_FALSE(has_errors(without.result.diagnostics));
    EXPECT_EQ(with.motions, without.motions);
}

TEST(RefusedBlock, LeavesNothingBehind) {
    expect_nothing_left("", "G41 D1 G2 X10", "G1 X20\nX40 Y10");
    expect_nothing_left("", "G91 G20 F7 S9 M3 G2 X5", "G1 X20\nX40 Y10");
    expect_nothing_left("G38.2 Z-2", "G20 G2 X5", "G1 Z#5063");
    expect_nothing_left("G1 X1", "G55 G2 X3", "G1 X20");
    expect_nothing_left("", "G92 X5 G199", "G1 X20");
    expect_nothing_left("", "G43 H1 G2 X5", "G53 G0 Z0\nG1 Z1");
    expect_nothing_left("", "G68 X0 Y0 G1 X10", "G1 X20");
    expect_nothing_left("", "G18 G99 G81 X1", "G1 X5\nG2 X10 Y0 I2.5");
    // No curve is in progress that would take the next blocks as points.
    expect_nothing_left("", "G6.2 P3 X1 Y1", "G1 X5");
    expect_nothing_left("", "G5.2 P7 X1 Y1 Z1", "G5.2 X1 Y1 L3\nG5.2 X2 Y1\nG5.2 X3 Y2\nG5.3");
}

TEST(RefusedBlock, UnderCompensationLeavesTheHeldMove) {
    // The arc is too tight for the cutter; the corner before the arc is the corner of the lines.
    expect_nothing_left("G41 D1 G1 X20 Y0\nX40", "G3 X42 Y2 J2", "G1 X40 Y30\nG40 G0 X0");
}

// --- Position of the workpiece -----------------------------------------------------------------

TEST(Workpiece, MovesWithItsOffsetBeforeTheFirstCut) {
    const std::string cut = "G0 X0 Y0 Z5\nG1 Z-1\nX10\nM2\n";
    const std::string plain = run("G21 G90 F100\n" + cut).motions;
    for (const char* set_up : {"G10 L2 P1 X0 Y0 Z0", "G10 L2 P1 X-250.5 Y-131.25 Z-312.125",
                               "G10 L20 P1 X0 Y0 Z0", "G92 X0 Y0 Z0", "G92 X12 Y-3 Z50"}) {
        SCOPED_TRACE(set_up);
        const Made made = run(std::string("G21 G90 F100 ") + set_up + "\n" + cut);
        EXPECT_FALSE(says(made, "offset-unknown"));
        // The start position may differ.
        EXPECT_EQ(made.motions.substr(made.motions.find("L3 ")), plain.substr(plain.find("L3 ")));
    }
}

TEST(Workpiece, IsTheCoordinateSystemOfTheFirstCut) {
    const Made made = run("G21 G90 F100\nG91 G28 Z0\nG90 G56 G0 X0 Y0\nG0 Z5\nG1 Z-1\nM2\n");
    EXPECT_EQ(made.result.workpiece_system, 3);
    EXPECT_EQ(last_line(made.motions), "L5 feed X0 Y0 Z-1 F100\n");
}

TEST(Workpiece, HasOtherSystemsAsFarAwayAsToldOrTellsThatNobodyDid) {
    const std::string program =
        "G21 G90 F100\nG54 G0 X0 Y0 Z5\nG1 Z-1\nG0 Z5\nG55 X1 Y2\nG1 Z-3\nM2\n";
    const Made unspecified = run(program);
    EXPECT_TRUE(says(unspecified, "offset-unknown"));
    EXPECT_EQ(last_line(unspecified.motions), "L6 feed X1 Y2 Z-3 F100\n");

    InterpreterOptions options;
    options.work_offsets[0] = at(-100, -50, -300);
    options.work_offsets[1] = at(100, -50, -310);
    options.work_offsets_specified[0] = options.work_offsets_specified[1] = true;
    const Made specified = run(program, options);
    EXPECT_FALSE(says(specified, "offset-unknown"));
    EXPECT_EQ(last_line(specified.motions), "L6 feed X201 Y2 Z-13 F100\n");

    // The program sets both, so no further data is needed.
    const Made set = run("G10 L2 P1 X-100 Y0 Z-300\nG10 L2 P2 X-80 Y0 Z-300\n" + program);
    EXPECT_FALSE(says(set, "offset-unknown"));
    EXPECT_EQ(last_line(set.motions), "L8 feed X21 Y2 Z-3 F100\n");

    // A known position in G54 and G10 L20 for G55 make G55 known.
    const Made from_there =
        run("G21 G90 F100\nG54 G0 X30 Y0 Z5\nG1 Z-1\nG10 L20 P2 X0 Y0 Z0\n"
            "G55 G0 Z5\nG1 X1\nM2\n");
    EXPECT_FALSE(says(from_there, "offset-unknown"));
    EXPECT_EQ(last_line(from_there.motions), "L6 feed X31 Y0 Z4 F100\n");
}

TEST(Workpiece, TakesExtendedSystemsThatAreTold) {
    InterpreterOptions options;
    options.work_offsets_specified[0] = true;
    options.extended_offsets[7] = at(40, 0, 0);
    const std::string program = "G21 G90 F100\nG0 X0 Y0 Z5\nG1 Z-1\nG54.1 P7 G0 X1\nG1 X2\nM2\n";
    const Made made = run(program, options);
    EXPECT_FALSE(says(made, "offset-unknown"));
    EXPECT_EQ(last_line(made.motions), "L5 feed X42 Y0 Z-1 F100\n");
    EXPECT_TRUE(says(run(program), "offset-unknown"));
}

TEST(Workpiece, StaysWhereItIsAfterTheFirstCut) {
    const Made made = run(
        "G21 G90 F100\nG10 L2 P1 X0 Y0 Z0\nG0 X0 Y0 Z5\nG1 Z-1\nG10 L2 P1 X7 Y0 Z0\nG1 X1\nM2\n");
    EXPECT_EQ(last_line(made.motions), "L6 feed X8 Y0 Z-1 F100\n");
}

// --- Partly specified frames --------------------------------------------------------------------

// Returns offsets as read_job sets them: an unspecified system is 300 mm below home.
InterpreterOptions with_home() {
    InterpreterOptions options;
    for (Position& origin : options.work_offsets)
        origin.z = Length::from_mm(-300);
    return options;
}

InterpreterOptions with_offset(std::size_t index, Position origin) {
    InterpreterOptions options = with_home();
    options.work_offsets[index] = origin;
    options.work_offsets_specified[index] = true;
    return options;
}

std::string line_of(const Made& made, const std::string& name) {
    const std::size_t begin = made.motions.find(name + " ");
    if (begin == std::string::npos) return {};
    return made.motions.substr(begin, made.motions.find('\n', begin) - begin);
}

const std::string kCut = "G21 G90 F100\nG54 G0 X0 Y0 Z5\nG1 Z-1\nG0 Z5\n";

TEST(PartlySpecified, AnAxisOfG55WithoutAPlaceStaysWhereItIs) {
    const std::string program =
        kCut + "G10 L2 P1 X10 Y10 Z-50\nG10 L2 P2 X60 Y10\n" + "G55 G0 X0 Y0\nG1 Z-1\nM2\n";
    // The rapid moves in X and Y only, so no coordinate of the move is assumed.
    const Made late = run("G10 L2 P1 X10 Y10 Z-50\n" + program, with_home());
    EXPECT_EQ(line_of(late, "L8"), "L8 rapid X50 Y0 Z5");
    EXPECT_EQ(line_of(late, "L9"), "L9 feed X50 Y0 Z-1 F100");
    EXPECT_TRUE(says(late, "offset-unknown"));
    // The names of the systems do not matter.
    const Made extended = run("G10 L2 P3 X10 Y10 Z-50\n" + kCut +
                                  "G56 G0 X0 Y0 Z5\nG1 Z-2\n"
                                  "G10 L2 P9 X60 Y10\nG59.3 G0 X0 Y0\nM2\n",
                              with_home());
    EXPECT_EQ(last_line(extended.motions), "L9 rapid X50 Y0 Z-2\n");
}

TEST(PartlySpecified, TheFirstMoveInAFrameWithoutAPlaceIsNamed) {
    std::vector<std::uint32_t> lines;
    const auto note = [&](const Motion& motion) {
        if (motion.offset_unknown) lines.push_back(motion.span.line);
    };
    const std::string head = "G10 L2 P1 X10 Y10 Z-50\nG10 L2 P2 X60 Y10\n";
    interpret({"t.nc", head + kCut + "G55 G0 X0 Y0\nG1 Z-1\nG0 Z5\nG54 X0 Y0\nG0 Z4\nM2\n"},
              with_home(), note);
    // Up in G55, across in G54 at the same height, and the moves from there.
    EXPECT_EQ(lines, (std::vector<std::uint32_t>{8, 9, 10, 11}));
}

TEST(PartlySpecified, OneSystemIsSpecifiedAndTheOtherIsNot) {
    for (const std::size_t specified : {std::size_t{0}, std::size_t{1}}) {
        SCOPED_TRACE(specified);
        const Made made = run(kCut + "G55 G0 X3 Y0\nG1 Z-2\nG0 Z5\nG54 G0 X7\nM2\n",
                              with_offset(specified, at(-100, -50, -80)));
        EXPECT_TRUE(says(made, "offset-unknown"));
        EXPECT_EQ(line_of(made, "L5"), "L5 rapid X3 Y0 Z5");
        EXPECT_EQ(line_of(made, "L6"), "L6 feed X3 Y0 Z-2 F100");
        EXPECT_EQ(line_of(made, "L8"), "L8 rapid X7 Y0 Z5");
    }
}

TEST(PartlySpecified, ShiftsOfTheProgramStay) {
    for (const char* shift : {"G92 X0 Y0 Z25", "G52 Z-20"}) {
        SCOPED_TRACE(shift);
        const Made made =
            run(kCut + shift + "\nG55 G0 X3\nM2\n", with_offset(0, at(-100, -50, -80)));
        EXPECT_EQ(line_of(made, "L6"), "L6 rapid X3 Y0 Z5");
    }
}

TEST(PartlySpecified, HomeIsWhereTheSpecifiedFrameHasIt) {
    // G54 is 80 below home, and the same is assumed for G55.
    const Made made =
        run(kCut + "G53 G0 Z0\nG55 G0 X3\nG0 Z9\nM2\n", with_offset(0, at(-100, -50, -80)));
    EXPECT_EQ(line_of(made, "L5"), "L5 rapid X0 Y0 Z80 machine");
    EXPECT_EQ(line_of(made, "L6"), "L6 rapid X3 Y0 Z80");
    // The position of home in G55 is specified, regardless of assumptions in G54.
    const Made other = run(kCut + "G53 G0 Z0\nG55 G0 X3\nG0 Z9\nG53 G0 Z0\nM2\n",
                           with_offset(1, at(-100, -50, -60)));
    EXPECT_EQ(line_of(other, "L6"), "L6 rapid X3 Y0 Z60");
    EXPECT_EQ(line_of(other, "L7"), "L7 rapid X3 Y0 Z9");
    EXPECT_EQ(line_of(other, "L8"), "L8 rapid X3 Y0 Z60 machine");
    // Also before the first cut.
    const Made before = run("G21 G90 F100\nG53 G0 Z0\nG55 G0 X3 Y0\nG0 Z9\nG1 Z-1\nM2\n",
                            with_offset(1, at(-100, -50, -60)));
    EXPECT_EQ(line_of(before, "L3"), "L3 rapid X3 Y0 Z60 from-unknown-xy");
    EXPECT_FALSE(says(before, "offset-unknown"));
}

TEST(PartlySpecified, IncrementsAndResidingAxesKeepTheFrameTheyAreKnownIn) {
    const Made made =
        run(kCut + "G55 G91 G0 X3\nG1 Z-6.5\nM2\n", with_offset(0, at(-100, -50, -80)));
    EXPECT_EQ(last_line(made.motions), "L6 feed X3 Y0 Z-1.5 F100\n");
    EXPECT_FALSE(says(made, "offset-unknown"));
}

TEST(PartlySpecified, TheOffsetOfTheActiveSystemMovesNothing) {
    // G54 is set in the middle of the program.
    const Made made = run(kCut + "G10 L2 P1 X-100 Y-80 Z-50\nG0 X4\nG0 Z6\nM2\n", with_home());
    EXPECT_EQ(line_of(made, "L6"), "L6 rapid X4 Y0 Z5");
    EXPECT_EQ(line_of(made, "L7"), "L7 rapid X4 Y0 Z6");
    EXPECT_TRUE(says(made, "offset-unknown"));
    const Made variable = run("(a) O1\n" + kCut + "#5223=-50.\nG0 X4\nM2\n", [] {
        InterpreterOptions options = with_home();
        options.dialect = Dialect::Fanuc;
        return options;
    }());
    EXPECT_EQ(line_of(variable, "L7"), "L7 rapid X4 Y0 Z5");
}

TEST(PartlySpecified, ARefusedBlockLeavesNoAssumption) {
    const InterpreterOptions options = with_offset(1, at(-100, -50, -60));
    const Made with = run(kCut + "G55 G2 X3\nG54 G0 X7\nG55 X8\nG0 Z9\nM2\n", options);
    const Made without = run(kCut + "\nG54 G0 X7\nG55 X8\nG0 Z9\nM2\n", options);
    EXPECT_TRUE(has_errors(with.result.diagnostics));
    EXPECT_EQ(with.motions, without.motions);
    EXPECT_EQ(last_line(with.motions), "L8 rapid X8 Y0 Z9\n");
}

TEST(PartlySpecified, MovesUnderCompensationAndCornersAreOfTheirFrame) {
    const std::string end = "G54 G0 X9 Y0\nX8\nM2\n";
    for (const char* moves : {"G41 D1 G1 X20\nX30\nZ2\nG40 X40\n", "G1 X30 ,R2\nY10\nZ2\n"}) {
        SCOPED_TRACE(moves);
        std::vector<std::uint32_t> lines;
        InterpreterOptions options = with_offset(0, at(-100, -50, -80));
        options.tools = {{.number = 1, .offset = {}, .diameter = Length::from_mm(4.0)}};
        const std::string program = kCut + "G55\n" + moves + end;
        interpret({"t.nc", program}, options, [&](const Motion& motion) {
            if (motion.offset_unknown) lines.push_back(motion.span.line);
        });
        // In the last move Z is from G55, although G54 is active.
        const auto last = static_cast<std::uint32_t>(std::ranges::count(program, '\n') - 1);
        ASSERT_FALSE(lines.empty());
        EXPECT_EQ(lines.back(), last);
    }
}

TEST(PartlySpecified, DistancesThatAreSpecifiedCount) {
    // Z of both systems is specified; X and Y of both are not.
    const Made made = run("G10 L2 P1 Z-50\nG10 L2 P2 Z-60\n" + kCut +
                              "G55 G91 G0 X1\nG90 Z5\n"
                              "M2\n",
                          with_home());
    EXPECT_EQ(line_of(made, "L7"), "L7 rapid X1 Y0 Z5");
    EXPECT_EQ(line_of(made, "L8"), "L8 rapid X1 Y0 Z-5");
    EXPECT_FALSE(says(made, "offset-unknown"));
    // The position of the tool in G54 is the zero of G55.
    const Made here = run(kCut + "G10 L20 P2 X0 Y0 Z0\nG55 G0 X1 Y0 Z1\nM2\n",
                          with_offset(0, at(-100, -50, -80)));
    EXPECT_EQ(last_line(here.motions), "L6 rapid X1 Y0 Z6\n");
    EXPECT_FALSE(says(here, "offset-unknown"));
}

// --- Offsets in the program and in [offsets] ----------------------------------------------------

TEST(OffsetConflict, IsToldWithItsBlock) {
    const InterpreterOptions options = with_offset(0, at(-100, -80, -50));
    const auto conflicts = [&](const std::string& head, const std::string& tail = "") {
        return run(head + "\n" + kCut + tail + "M2\n", options).result.offset_conflicts;
    };
    for (const char* same : {"", "G10 L2 P1 X-100 Y-80 Z-50", "G10 L2 P1 X-100.0005",
                             "G10 L2 P2 X7 Y8 Z9", "G10 L2 P1 Z-70\nG10 L2 P1 Z-50"}) {
        SCOPED_TRACE(same);
        EXPECT_TRUE(conflicts(same, "G55 G1 X1\n").empty());
    }
    for (const char* other : {"G10 L2 P1 X-100 Y-80 Z-50.002", "G10 L2 P1 X-99", "G10 L20 P1 Z5",
                              "G91 G10 L2 P1 Z-1\nG90", "G54\nG10 L2 P1 Y-81\nG55\nG54"}) {
        SCOPED_TRACE(other);
        const auto found = conflicts(other);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].system, 1);
        EXPECT_EQ(found[0].specified, (std::array{-100.0, -80.0, -50.0}));
    }
    EXPECT_EQ(conflicts("\nG10 L2 P1 X-99")[0].place.span.line, 2U);
    EXPECT_EQ(conflicts("G10 L2 P1 X-99")[0].written[0], -99.0);
    EXPECT_FALSE(conflicts("G10 L20 P1 Z5")[0].written[2].has_value());
    // A shift after a cut at the specified position is intended by the program.
    EXPECT_TRUE(conflicts("", "G10 L2 P1 X-90\nG1 X1\n").empty());
}

TEST(OffsetConflict, OfExtendedSystemsAndVariables) {
    InterpreterOptions options = with_home();
    options.dialect = Dialect::Fanuc;
    options.extended_offsets[7] = at(40, 0, 0);
    const auto count = [&](const std::string& head) {
        return run("O1\n" + head + "\n" + kCut + "G54.1 P7 G1 X1.\nM30\n", options)
            .result.offset_conflicts.size();
    };
    EXPECT_EQ(count("G10 L20 P7 X41."), 1U);
    EXPECT_EQ(count("G10 L20 P7 X40."), 0U);
    EXPECT_EQ(count("#7121=41."), 1U);
    EXPECT_EQ(count("#7121=40."), 0U);
}

// --- Where the tool starts ----------------------------------------------------------------------

TEST(Start, IsKnownWhereSomebodyTells) {
    EXPECT_NE(run("G21 G90\nG0 X1\nM2\n").motions.find("from-unknown"), std::string::npos);
    EXPECT_EQ(run("G21 G90\nG92 X0 Y0 Z5\nG0 X1\nM2\n").motions, "L3 rapid X1 Y0 Z5\n");
    InterpreterOptions options;
    options.start = {Length::from_mm(1), Length::from_mm(2), Length::from_mm(50)};
    EXPECT_EQ(run("G21 G90\nG0 X10\nM2\n", options).motions, "L2 rapid X10 Y2 Z50\n");
    options.start[2].reset();
    EXPECT_EQ(run("G21 G90\nG0 X10\nM2\n", options).motions, "L2 rapid X10 Y2 Z0 from-unknown-z\n");
}

std::string first_feed(const std::string& head, InterpreterOptions options) {
    options.start = {Length(), Length(), Length::from_mm(50)};
    const Made made = run("G21 G90 F100\n" + head + "\nG0 X4\nG1 X5\nM2\n", options);
    EXPECT_FALSE(says(made, "offset-unknown"));
    const std::string last = last_line(made.motions);
    const std::size_t begin = last.find(' ') + 1;
    return last.substr(begin, last.find(" F100") - begin);
}

TEST(Start, IsInG54AsItIsAtTheFirstMove) {
    const InterpreterOptions specified = with_offset(0, at(-100, -80, -50));
    for (const char* head : {"", "G10 L2 P1 X-100 Y-80 Z-50", "G10 L2 P1 Z-90", "G10 L2 P1 X-7",
                             "T1 M6\nG10 L2 P1 Z-90\nG54", "G54\nG10 L2 P1 Z-50\nG10 L2 P1 Z-7",
                             "G55\nG10 L2 P1 Z-50\nG54", "G20\nG10 L2 P1 Z-2\nG21",
                             "G92.1\nG10 L2 P1 Z-50", "G52 X0 Y0 Z0\nG10 L2 P1 Z-50"}) {
        SCOPED_TRACE(head);
        EXPECT_EQ(first_feed(head, with_home()), "feed X5 Y0 Z50");
        EXPECT_EQ(first_feed(head, specified), "feed X5 Y0 Z50");
    }
}

TEST(Start, IsInG55IfG54HasNoPlace) {
    EXPECT_EQ(first_feed("G55", with_home()), "feed X5 Y0 Z50");
    EXPECT_EQ(first_feed("G10 L2 P2 X-10 Y-10 Z-40\nG55", with_home()), "feed X5 Y0 Z50");
    EXPECT_EQ(first_feed("G55\nG10 L2 P2 X-10 Y-10 Z-40", with_home()), "feed X5 Y0 Z50");
    // Both are specified: 20 lower, 10 to the right.
    EXPECT_EQ(first_feed("G10 L2 P1 X0 Y0 Z-20\nG10 L2 P2 X10 Y0 Z-40\nG55", with_home()),
              "feed X5 Y0 Z70");
    // Only G54 is specified; using the same offset for G55 is an assumption.
    InterpreterOptions options = with_offset(0, at(-100, -80, -50));
    options.start = {Length(), Length(), Length::from_mm(50)};
    bool is_unknown = false;
    interpret({"t.nc", "G21 G90 F100\nG55 G0 X4\nG1 X5\nM2\n"}, options,
              [&](const Motion& motion) { is_unknown |= motion.offset_unknown; });
    EXPECT_TRUE(is_unknown);
}

TEST(Start, IsSpecifiedUnderTipControlToo) {
    InterpreterOptions options = with_offset(0, at(-100, -80, -50));
    options.tip_control.at_start = Coordinates::Tip;
    EXPECT_EQ(first_feed("G54", options), "feed X5 Y0 Z50");
}

TEST(Start, OfAnAxisWithoutOneIsHome) {
    // G98: back to the initial Z.
    const Made made =
        run("G21 G90 F100\nG10 L2 P1 X0 Y0 Z-80\nG0 X0 Y0\nG81 X1 Z-3 R2\nM2\n", with_home());
    EXPECT_EQ(last_line(made.motions), "L4 rapid X1 Y0 Z80\n");
}

TEST(Start, IsWhereTheProgramSaysIt) {
    const InterpreterOptions specified = with_offset(0, at(-100, -80, -50));
    for (const InterpreterOptions& options : {with_home(), specified}) {
        EXPECT_EQ(first_feed("G92 Z10", options), "feed X5 Y0 Z50");
        EXPECT_EQ(first_feed("G10 L20 P1 Z10", options), "feed X5 Y0 Z10");
    }
}

TEST(Start, OfTheMachineNeedsNoDistanceAtTheHeightOfHome) {
    const auto has_unknown = [](const std::string& lift) {
        InterpreterOptions options = with_offset(0, at(-100, -80, -50));
        options.start = {Length::from_mm(100), Length::from_mm(80), Length::from_mm(50)};
        options.start_is_of_machine = true;
        bool is_unknown = false;
        interpret({"t.nc", "G21 G90 F100\n" + lift + "G55 G0 X4 Y0\nG0 Z5\nG1 X5\nM2\n"}, options,
                  [&](const Motion& motion) {
                      is_unknown |= motion.offset_unknown && !motion.machine_coordinates;
                  });
        return is_unknown;
    };
    EXPECT_FALSE(has_unknown("G53 G0 Z0\n"));
    EXPECT_TRUE(has_unknown(""));
}

TEST(Start, OfTheMachineStaysInTheMachine) {
    InterpreterOptions options = with_offset(0, at(-100, -80, -50));
    options.start = {Length(), Length(), Length::from_mm(50)};
    options.start_is_of_machine = true;
    const Made made = run("G21 G90 F100\nG10 L2 P1 Z-60\nG0 X4\nG1 X5\nM2\n", options);
    EXPECT_EQ(last_line(made.motions), "L4 feed X5 Y0 Z60 F100\n");
}

// --- Observation --------------------------------------------------------------------------------

// Files, lines and feeds in the order of execution; line 0 comes before the first block.
TEST(StateObserver, SeesEachBlockOnce) {
    const auto seen = [](const std::string& program, Dialect dialect) {
        std::string text;
        InterpreterOptions options;
        options.dialect = dialect;
        options.read_file = [](std::string_view name) -> std::optional<SourceFile> {
            if (name != "O22") return std::nullopt;
            return SourceFile{"O22", "O22\nG91 G1 Z-1 F5\nG90 M99\n"};
        };
        options.observe_state = [&](std::uint32_t file, std::uint32_t line,
                                    const MachineState& state) {
            text += std::to_string(file) + ':' + std::to_string(line) + '=';
            text += std::to_string(static_cast<int>(state.feed)) + ' ';
        };
        run(program, options);
        return text;
    };
    EXPECT_EQ(seen("G21 G90 F1\nG0 X0\n(a)\nG1 X5 F3\nM30\n", Dialect::Fanuc),
              "0:0=0 0:1=1 0:2=1 0:3=1 0:4=3 0:5=0 ");
    // Ends without M30 and M99, and the end of a program resets modes.
    EXPECT_EQ(seen("G21 F1\nG1 X1\n", Dialect::Fanuc), "0:0=0 0:1=1 0:2=1 ");
    EXPECT_EQ(seen("G21 F1\nM98 P22\nM30\n", Dialect::Fanuc),
              "0:0=0 0:1=1 0:2=1 1:2=5 1:3=5 0:3=0 ");
    EXPECT_EQ(seen("0 BEGIN PGM A MM\n1 LBL 1\n2 L X+1 F7\n3 CALL LBL 1 REP 1\n4 END PGM A MM\n",
                   Dialect::Heidenhain),
              "0:0=0 0:1=0 0:2=0 0:3=7 0:4=7 0:3=7 0:4=7 0:5=0 ");
    EXPECT_EQ(seen("G71 F2\nR1=4\nG1 X=R1 F=R1\nM30\n", Dialect::Sinumerik),
              "0:0=0 0:1=2 0:2=2 0:3=4 0:4=0 ");
}

// --- Tool lengths and the spindle ---------------------------------------------------------------

TEST(LengthRegister, IsTheOneThatIsActive) {
    const Made made =
        run("G21 G90\nG0 X0\nT1 M6\nG43 H3\nG0 X1\nT2 M6\nG0 X2\nG43 G0 X3\nG49\n"
            "G0 X4\nG43.1 Z5\nG0 X5\nM2\n");
    std::vector<int> registers;
    for (const ProgramFrame& frame : made.frames)
        registers.push_back(frame.length_register);
    EXPECT_TRUE(made.result.uses_length_offsets);
    EXPECT_EQ(registers, (std::vector<int>{0, 0, 3, 3, 3, 2, 0, kStatedLength}));
    EXPECT_FALSE(run("G0 X1\nG49\nG0 X2\nM2\n").result.uses_length_offsets);
}

TEST(GaugeLength, IsThatOfTheTableBeforeWhatTheProgramWrites) {
    const auto lengths_of = [](const std::string& program) {
        std::vector<std::optional<double>> lengths;
        for (const ProgramFrame& frame : run(program).frames)
            lengths.push_back(frame.tool_length);
        return lengths;
    };
    using Lengths = std::vector<std::optional<double>>;
    // T1 is 7 mm long, independent of writes to its register; the length of T2 is unknown before
    // the write.
    EXPECT_EQ(lengths_of("G21 G90 T1 M6\nG0 X1\nG10 L1 P1 Z90\nG0 X2\nM2\n"),
              (Lengths{7.0, 7.0, 7.0}));
    EXPECT_EQ(lengths_of("G21 G90 T2 M6\nG0 X1\nG10 L1 P2 Z90\nG0 X2\nM2\n"),
              (Lengths{std::nullopt, std::nullopt, 90.0}));
}

TEST(Spindle, StandsStillAfterAStopWhereTheMachineStopsIt) {
    const auto after = [](Dialect dialect, const char* code) {
        InterpreterOptions options;
        options.dialect = dialect;
        std::string seen;
        interpret(
            {"t.nc", std::string("G21 G90 F100 S500 M3\nG0 X0 Y0 Z0\n") + code + "\nG1 X1\nM2\n"},
            options, [&](const Motion& m) {
                seen = m.spindle == SpindleTurning::Stopped ? "off"
                       : m.spindle_in_doubt                 ? "in doubt"
                                                            : "on";
            });
        return seen;
    };
    EXPECT_EQ(after(Dialect::Fanuc, "M0"), "off");
    EXPECT_EQ(after(Dialect::Haas, "M0"), "off");
    EXPECT_EQ(after(Dialect::Haas, "M1"), "in doubt");
    EXPECT_EQ(after(Dialect::Rs274, "M0"), "in doubt");
    EXPECT_EQ(after(Dialect::Grbl, "M0"), "on");
    EXPECT_EQ(after(Dialect::Rs274, "M0\nM3"), "on");
    EXPECT_EQ(after(Dialect::Rs274, "M19"), "off");
}

// --- Messages -----------------------------------------------------------------------------------

TEST(Lines, AreTheSameOneByOneAndAllAtOnce) {
    for (const char* text :
         {"", "\n", "G0", "G0 X1\nG1 Y2\n", "\xEF\xBB\xBFG0\r\n\r\nM30\r\n", "a\rb\rc", "\n\nM2"}) {
        const SourceFile file{"t.nc", text};
        const auto lines = lines_of(file);
        for (std::uint32_t n = 1; n <= lines.size() + 2; ++n)
            EXPECT_EQ(n <= lines.size() ? lines[n - 1] : "", line_text(file, n)) << n;
    }
}

TEST(Messages, QuoteTheProgram) {
    const Made made = run("%\nO2345 (PART)\nG0 X1 Y1 Z1\nM30\n%\n");
    ASSERT_FALSE(made.result.diagnostics.empty());
    EXPECT_EQ(made.result.diagnostics.front().message,
              "read as fanuc: the program number O2345 (line 2)");
}

}  // namespace
}  // namespace ncsim::gcode
