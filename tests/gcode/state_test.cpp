// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a control remembers: a block that is refused leaves nothing behind, and where the workpiece
// is follows from the program.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

struct Made {
    std::string motions;
    Interpretation result;
};

Made run(const std::string& program, InterpreterOptions options = {}) {
    Made made;
    options.tools.push_back({.number = 1,
                             .offset = {Length(), Length(), Length::from_mm(7)},
                             .length_told = true,
                             .diameter = Length::from_mm(10.0)});
    made.result = interpret({"t.nc", program}, options, [&](const Motion& motion) {
        print(made.motions, motion);
        made.motions += '\n';
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

// The same program without the block in its third line makes the same motions.
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
    // No curve is under way, whose points the next blocks would be.
    expect_nothing_left("", "G6.2 P3 X1 Y1", "G1 X5");
    expect_nothing_left("", "G5.2 P7 X1 Y1 Z1", "G5.2 X1 Y1 L3\nG5.2 X2 Y1\nG5.2 X3 Y2\nG5.3");
}

TEST(RefusedBlock, UnderCompensationLeavesTheHeldMove) {
    // The arc is too tight for the cutter; the corner before it is that of the lines.
    expect_nothing_left("G41 D1 G1 X20 Y0\nX40", "G3 X42 Y2 J2", "G1 X40 Y30\nG40 G0 X0");
}

// --- Where the workpiece is ---------------------------------------------------------------------

TEST(Workpiece, MovesWithItsOffsetBeforeTheFirstCut) {
    const std::string cut = "G0 X0 Y0 Z5\nG1 Z-1\nX10\nM2\n";
    const std::string plain = run("G21 G90 F100\n" + cut).motions;
    for (const char* set_up : {"G10 L2 P1 X0 Y0 Z0", "G10 L2 P1 X-250.5 Y-131.25 Z-312.125",
                               "G10 L20 P1 X0 Y0 Z0", "G92 X0 Y0 Z0", "G92 X12 Y-3 Z50"}) {
        SCOPED_TRACE(set_up);
        const Made made = run(std::string("G21 G90 F100 ") + set_up + "\n" + cut);
        EXPECT_FALSE(says(made, "offset-unknown"));
        // Where it starts from is another matter.
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
    const Made untold = run(program);
    EXPECT_TRUE(says(untold, "offset-unknown"));
    EXPECT_EQ(last_line(untold.motions), "L6 feed X1 Y2 Z-3 F100\n");

    InterpreterOptions options;
    options.work_offsets[0] = at(-100, -50, -300);
    options.work_offsets[1] = at(100, -50, -310);
    options.work_offsets_told[0] = options.work_offsets_told[1] = true;
    const Made told = run(program, options);
    EXPECT_FALSE(says(told, "offset-unknown"));
    EXPECT_EQ(last_line(told.motions), "L6 feed X201 Y2 Z-13 F100\n");

    // Both set by the program: nobody else is needed.
    const Made set = run("G10 L2 P1 X-100 Y0 Z-300\nG10 L2 P2 X-80 Y0 Z-300\n" + program);
    EXPECT_FALSE(says(set, "offset-unknown"));
    EXPECT_EQ(last_line(set.motions), "L8 feed X21 Y2 Z-3 F100\n");

    // From a place that is known in one, another one is known, too.
    const Made from_there =
        run("G21 G90 F100\nG54 G0 X30 Y0 Z5\nG1 Z-1\nG10 L20 P2 X0 Y0 Z0\n"
            "G55 G0 Z5\nG1 X1\nM2\n");
    EXPECT_FALSE(says(from_there, "offset-unknown"));
    EXPECT_EQ(last_line(from_there.motions), "L6 feed X31 Y0 Z4 F100\n");
}

TEST(Workpiece, TakesExtendedSystemsThatAreTold) {
    InterpreterOptions options;
    options.work_offsets_told[0] = true;
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

// --- Tool lengths and the spindle ---------------------------------------------------------------

TEST(LengthRegister, IsTheOneThatIsActive) {
    std::vector<int> registers;
    InterpreterOptions options;
    options.observe_frame = [&](const Motion&, const ProgramFrame& frame) {
        registers.push_back(frame.length_register);
    };
    const Made made =
        run("G21 G90\nG0 X0\nT1 M6\nG43 H3\nG0 X1\nT2 M6\nG0 X2\nG43 G0 X3\nG49\n"
            "G0 X4\nG43.1 Z5\nG0 X5\nM2\n",
            options);
    EXPECT_TRUE(made.result.uses_length_offsets);
    EXPECT_EQ(registers, (std::vector<int>{0, 0, 3, 3, 3, 2, 0, kStatedLength}));
    EXPECT_FALSE(run("G0 X1\nG49\nG0 X2\nM2\n").result.uses_length_offsets);
}

TEST(GaugeLength, IsThatOfTheTableBeforeWhatTheProgramWrites) {
    const auto lengths_of = [](const std::string& program) {
        std::vector<std::optional<double>> lengths;
        InterpreterOptions options;
        options.observe_frame = [&](const Motion&, const ProgramFrame& frame) {
            lengths.push_back(frame.tool_length);
        };
        run(program, options);
        return lengths;
    };
    using Lengths = std::vector<std::optional<double>>;
    // T1 is 7 mm long, whatever is written into its register; nobody knows of T2 before that.
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
