// SPDX-License-Identifier: GPL-3.0-or-later
//
// Situations that controls execute in different ways. The paths of Rs274 are the output of rs274 of
// LinuxCNC 2.9.
#include "gcode/controls.h"

#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <string>
#include <variant>
#include <vector>

namespace ncsim::gcode {
namespace {

using controls::expect_path;
using controls::kHead;
using controls::Made;
using controls::run;
using controls::run_body;

// --- Arcs ---------------------------------------------------------------------------------------

TEST(Controls, RTakesPrecedenceOverTheCentreOnFanucAlone) {
    const std::string arc = "G0 X0 Y0 Z0\nG2 X10 Y0 I5 J0 R8\nG1 X0\n";
    const auto turned = [&](Dialect dialect) {
        InterpreterOptions options;
        options.dialect = dialect;
        double second = 0.0;
        interpret({"t.nc", kHead + arc + "M30\n"}, options, [&](const Motion& motion) {
            if (const auto* found = std::get_if<Arc>(&motion.action)) second = found->centre_2.mm();
        });
        return second;
    };
    EXPECT_NEAR(turned(Dialect::Fanuc), -std::sqrt(39.0), 1e-6);
    for (const Dialect dialect : {Dialect::Haas, Dialect::Mach3, Dialect::Auto})
        EXPECT_EQ(turned(dialect), 0.0);
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3})
        EXPECT_TRUE(run_body(arc, dialect).says("arc-two-forms"));
}

// --- ROUND --------------------------------------------------------------------------------------

TEST(Controls, RoundInAWordRoundsToTheLeastIncrementOnFanucAndHaas) {
    const auto x_of = [](const std::string& body, Dialect dialect) {
        InterpreterOptions options;
        options.dialect = dialect;
        double x = -1.0;
        interpret({"t.nc", kHead + "G0 X0 Y0 Z0\n" + body + "\nM30\n"}, options,
                  [&](const Motion& motion) {
                      if (const Position* end = end_of(motion)) x = end->x.mm();
                  });
        return x;
    };
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas}) {
        EXPECT_NEAR(x_of("#1=1.23456\nG1 X[ROUND[#1]]", dialect), 1.235, 1e-12);
        EXPECT_NEAR(x_of("#1=1.23456\nG1 X[ROUND[#1]*2]", dialect), 2.47, 1e-12);
        EXPECT_NEAR(x_of("G20\n#1=1.23456\nG1 X-ROUND[#1]", dialect), -1.2346 * 25.4, 1e-9);
        // In an assignment and in a condition, and in words of whole numbers: to whole numbers.
        EXPECT_EQ(x_of("#1=ROUND[1.6]\nG1 X#1", dialect), 2.0);
        EXPECT_EQ(x_of("IF [ROUND[1.6] EQ 2] GOTO 5\nG1 X7\nN5 G1 Y1", dialect), 0.0);
        EXPECT_EQ(x_of("G ROUND[0.6] X1", dialect), 1.0);
    }
    for (const Dialect dialect : {Dialect::Rs274, Dialect::Mach3, Dialect::Auto})
        EXPECT_EQ(x_of("#1=1.6\nG1 X[ROUND[#1]]", dialect), 2.0);
}

// --- Cutter compensation -----------------------------------------------------------------------

TEST(Controls, CancelAloneMovesBothAxesOnLinuxCncAndWaitsOnFanuc) {
    const std::string body =
        "G0 X-10 Y-10 Z0\nG42 D1\nG1 X5 Y5\nX35\nY20\nG40\nG0 Z5\nG0 X-10\nG0 Y-20\n";
    expect_path(body, Dialect::Rs274,
                "G0 -10 -10 0\nG1 5.828 3 0\nG1 35 3 0\nG1 37 5 0\nG1 37 20 0\nG0 35 20 5\n"
                "G0 -10 20 5\nG0 -10 -20 5\n");
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas}) {
        const std::string path = run_body(body, dialect).path;
        EXPECT_NE(path.find("G1 37 20 0\nG0 37 20 5\nG0 -10 20 5\nG0 -10 -20 5\n"),
                  std::string::npos)
            << path;
    }
}

TEST(Controls, CompensationBeginsWithAnArcOnLinuxCncAlone) {
    const std::string body =
        "G0 X-10 Y10 Z0\nG41 D1\nG1 X20 Y10\nX20 Y30\nG3 X10 Y40 I-10 J0\n"
        "G1 X0 Y20\nG40\nG0 X-20 Y-20\n";
    expect_path(body, Dialect::Rs274,
                "G0 -10 10 0\nG1 18 12 0\nG1 18 30 0\nG1 11.191 37.911 0\nG1 1.789 19.106 0\n"
                "G0 -20 -20 0\n");
    const std::string by_arc = "G0 X0 Y0 Z0\nG41 D1\nG3 X20 Y0 I10 J0\nG1 X40\nG40\nG0 Y5\n";
    EXPECT_FALSE(has_errors(run_body(by_arc, Dialect::Rs274).result.diagnostics));
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas})
        EXPECT_TRUE(run_body(by_arc, dialect).says("compensation-entry"));
}

TEST(Controls, LinuxCncLosesItsLookAheadAtAStop) {
    const std::string body = "G0 X0 Y10 Z0\nG41 D1\nG1 X20\nM0\nG1 X40 Y30\nG40\nG1 X40 Y35\n";
    const std::string end = "G1 38.586 31.414 0\nG1 40 35 0\n";
    expect_path(body, Dialect::Rs274, "G0 0 10 0\nG1 20 12 0\n" + end);
    EXPECT_NE(run_body(body, Dialect::Mach3).path, "G0 0 10 0\nG1 20 12 0\n" + end);
}

TEST(Controls, WhatInterruptsCompensationIsAnErrorWhereTheControlRefusesIt) {
    const std::string before = "G0 X0 Y0 Z0\nG41 D1\nG1 X20\nX40\n";
    const std::string after = "G1 X60\nG40\nG1 Y5\n";
    constexpr std::array kAll{Dialect::Auto, Dialect::Rs274, Dialect::Fanuc, Dialect::Haas,
                              Dialect::Mach3};
    for (const std::string block : {"T2 M6", "G53 G0 Z0", "G28 Z5", "G30 Z5", "G18", "G92 X0",
                                    "G10 L2 P1 X5", "G55", "G43 H1", "G81 Z-1 R1 X5"}) {
        for (const Dialect dialect : kAll) {
            SCOPED_TRACE(block + " " + std::string(name_of(dialect)));
            const Made made = run_body(before + block + "\n" + after, dialect);
            EXPECT_TRUE(made.says("forbidden-with-compensation"));
            const bool is_refused =
                dialect == Dialect::Rs274 ||
                (block == "G18" && (dialect == Dialect::Fanuc || dialect == Dialect::Haas));
            EXPECT_EQ(has_errors(made.result.diagnostics), is_refused);
        }
    }
    // Words without effect do not interrupt the compensation.
    for (const std::string block : {"G17", "G54", "G49", "G90", "G10 L2 P2 X5", "M8", "G4 P1"}) {
        for (const Dialect dialect : kAll) {
            SCOPED_TRACE(block);
            EXPECT_FALSE(run_body(before + block + "\n" + after, dialect)
                             .says("forbidden-with-compensation"));
        }
    }
}

TEST(Controls, G53IsAllowedByLinuxCncWhileTheRadiusIsZero) {
    const Made made = run_body("G41.1 D0\nG53 G0 Z5\nG40\n", Dialect::Rs274);
    EXPECT_FALSE(has_errors(made.result.diagnostics));
}

TEST(Controls, ARepeatedG41ChangesNothing) {
    const std::string before = "G0 X-20 Y0 Z0\nG41 D1\nG1 X0\nX20\n";
    const std::string after = "X30\nY20\nG40\nG1 X40\n";
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3, Dialect::Auto}) {
        EXPECT_EQ(run_body(before + "G41 D1\n" + after, dialect).path,
                  run_body(before + after, dialect).path);
        EXPECT_EQ(run_body(before + "G41 " + after, dialect).path,
                  run_body(before + after, dialect).path);
    }
}

TEST(Controls, DataOfOtherSystemsAndToolsLeaveCompensationAlone) {
    const std::string before = "G0 X80 Y-20 Z0\nG42 D1\nG1 X70\nY30\n";
    const std::string after = "Y50\nX10\nG40 Y70\n";
    for (const Dialect dialect :
         {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3, Dialect::Auto, Dialect::Rs274}) {
        const std::string path = run_body(before + after, dialect).path;
        for (const std::string block : {"G10 L2 P2 X100", "G10 L1 P5 Z3", "#5241=3", "#100=3"}) {
            SCOPED_TRACE(block);
            EXPECT_EQ(run_body(before + block + "\n" + after, dialect).path, path);
        }
    }
}

// --- Tools -------------------------------------------------------------------------------------

TEST(Controls, D0AndH0AreTheToolInTheSpindleOnLinuxCncAlone) {
    const std::string compensated = "G0 X0 Y0 Z0\nG41 D0\nG1 X20\nX40\nG40\nG1 X41 Y0\n";
    expect_path(compensated, Dialect::Rs274, "G0 0 0 0\nG1 20 2 0\nG1 40 2 0\nG1 41 0 0\n");
    const std::string lifted = "G0 X0 Y0 Z0\nG43 H0\nG53 G0 Z-1\n";
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3}) {
        expect_path(compensated, dialect, "G0 0 0 0\nG1 20 0 0\nG1 40 0 0\nG1 41 0 0\n");
        EXPECT_EQ(run_body(lifted, dialect).result.uses_length_offsets, false);
    }
    EXPECT_EQ(run_body(lifted, Dialect::Rs274).result.uses_length_offsets, true);
}

TEST(Controls, RegistersOfCompensationComeBeforeTheDiameterOfTheTool) {
    const std::string body = kHead + "G0 X0 Y0 Z0\nG41 D1\nG1 X20\nX40\nM30\n";
    const auto radius = [&](std::optional<double> mm, const std::string& text) {
        InterpreterOptions options;
        options.dialect = Dialect::Fanuc;
        options.tools.push_back({.number = 1,
                                 .offset = {},
                                 .length_specified = true,
                                 .diameter = Length::from_mm(4.0)});
        if (mm) options.compensation[1] = Length::from_mm(*mm);
        double y = 0.0;
        const Interpretation made = interpret({"t.nc", text}, options, [&](const Motion& motion) {
            if (const Position* end = end_of(motion)) y = end->y.mm();
        });
        EXPECT_FALSE(has_errors(made.diagnostics));
        return y;
    };
    EXPECT_EQ(radius({}, body), 2.0);
    EXPECT_EQ(radius(0.0, body), 0.0);
    EXPECT_EQ(radius(0.25, body), 0.25);
    EXPECT_EQ(radius(-0.25, body), -0.25);
    // G10 in the program has priority: L12 sets the radius, L13 the wear.
    EXPECT_EQ(radius(0.25, "G90 G10 L12 P1 R1.5\n" + body), 1.5);
    EXPECT_EQ(radius(0.25, "G90 G10 L13 P1 R0.5\n" + body), 0.75);
}

TEST(Controls, G28CancelsTheToolLengthOnHaasAlone) {
    const auto last_register = [](Dialect dialect) {
        int last = -99;
        InterpreterOptions options;
        options.dialect = dialect;
        (void)interpret({"t.nc", kHead + "G43 H1 G0 X0 Y0 Z50\nG28 Z60\nG0 Z50\nM30\n"}, options,
                        [&](const Motion& motion) { last = motion.frame->length_register; });
        return last;
    };
    EXPECT_EQ(last_register(Dialect::Haas), kNoLength);
    EXPECT_EQ(last_register(Dialect::Fanuc), 1);
}

TEST(Controls, ARapidIsStraightAcrossAnOutsideCornerOnLinuxCncAlone) {
    const std::string body = "G0 X0 Y0 Z0\nG42 D1\nG1 X20\nG0 Y20\nG40\nG0 X30 Y30\n";
    const auto arcs = [&](Dialect dialect) {
        int count = 0;
        InterpreterOptions options;
        options.dialect = dialect;
        options.compensation[1] = Length::from_mm(2.0);
        (void)interpret({"t.nc", kHead + body + "M30\n"}, options, [&](const Motion& motion) {
            count += std::holds_alternative<Arc>(motion.action) ? 1 : 0;
        });
        return count;
    };
    EXPECT_EQ(arcs(Dialect::Rs274), 0);
    EXPECT_EQ(arcs(Dialect::Mach3), 1);
}

// --- Offsets -----------------------------------------------------------------------------------

TEST(Controls, G10P0IsTheExternalOffsetOnFanucAndHaas) {
    const std::string body =
        "G10 L2 P1 X-100 Y-100 Z-200\nG10 L2 P2 X-50 Y-100 Z-200\n"
        "G0 X0 Y0 Z5\nG1 Z-1\nG0 Z5\nG10 L2 P0 Z0.5\nG1 Z-1\nG0 Z5\n"
        "G55 X0\nG91 G10 L2 P0 Z1 X1\nG90 G0 X0 Z5\n";
    const std::string path =
        "G0 0 0 5\nG1 0 0 -1\nG0 0 0 5\nG1 0 0 -0.5\nG0 0 0 5.5\n"
        "G0 50 0 5.5\nG0 51 0 6.5\n";
    expect_path(body, Dialect::Fanuc, path);
    expect_path(body, Dialect::Haas, path);
    // A later change of the origin keeps the external offset, and variables show the offset.
    expect_path(
        "G10 L2 P1 X0 Y0 Z0\nG0 X0 Y0 Z0\nG1 X1\nG10 L2 P0 X5\nG10 L2 P1 X10\n"
        "G0 X[#5221+#5201]\n#5201=7\n#5221=20\nG0 X0\n",
        Dialect::Fanuc, "G0 0 0 0\nG1 1 0 0\nG0 30 0 0\nG0 27 0 0\n");
    // P0 is the active system on LinuxCNC.
    expect_path("G0 X0 Y0 Z0\nG1 X1\nG10 L2 P1 X0\nG10 L2 P0 X5\nG0 X0\n", Dialect::Rs274,
                "G0 0 0 0\nG1 1 0 0\nG0 5 0 0\n");
}

TEST(Controls, G10InG91AddsOnFanucAlone) {
    const std::string body = "G10 L2 P1 X10\nG0 X0 Y0 Z0\nG1 X1\nG91\nG10 L2 P1 X15\nG90\nG1 X0\n";
    expect_path(body, Dialect::Fanuc, "G0 0 0 0\nG1 1 0 0\nG1 15 0 0\n");
    expect_path(body, Dialect::Rs274, "G0 0 0 0\nG1 1 0 0\nG1 5 0 0\n");
}

// --- Language ----------------------------------------------------------------------------------

TEST(Controls, M73RestoresModesOutsideFanuc) {
    const std::string body = "G0 X10 Y10 Z1\no100 call\nG0 X20 Y10\n";
    const std::string sub = "o100 sub\nM73\nG91\nG1 Z-4\nG0 Z4\no100 endsub\n";
    EXPECT_EQ(run(sub + kHead + body + "M2\n", Dialect::Rs274).path,
              "G0 10 10 1\nG1 10 10 -3\nG0 10 10 1\nG0 20 10 1\n");
}

TEST(Controls, GeComparesExactlyOnLinuxCnc) {
    const std::string body =
        "G0 X0 Y0 Z5\n#1=-0.1\no1 while [#1 GE -0.3]\nG1 X#1\n"
        "#1=[#1-0.1]\no1 endwhile\n";
    expect_path(body, Dialect::Rs274, "G0 0 0 5\nG1 -0.1 0 5\nG1 -0.2 0 5\n");
}

TEST(Controls, ADwellWithoutAPointIsInMillisecondsOnFanuc) {
    const auto seconds = [](const std::string& block, Dialect dialect) {
        double sum = 0.0;
        InterpreterOptions options;
        options.dialect = dialect;
        (void)interpret({"t.nc", kHead + "G0 X0 Y0 Z5\n" + block + "\nM30\n"}, options,
                        [&](const Motion& motion) {
                            if (const auto* dwell = std::get_if<Dwell>(&motion.action))
                                sum += dwell->seconds;
                        });
        return sum;
    };
    for (const std::string block : {"G4 P500", "G82 X0 Z-1 R1 P500"}) {
        EXPECT_EQ(seconds(block, Dialect::Fanuc), 0.5);
        EXPECT_EQ(seconds(block, Dialect::Haas), 0.5);
        EXPECT_EQ(seconds(block, Dialect::Rs274), 500.0);
        EXPECT_EQ(seconds(block, Dialect::Mach3), 500.0);
    }
    EXPECT_EQ(seconds("G4 P1.5", Dialect::Fanuc), 1.5);
}

TEST(Controls, AVariableWithoutAValueIsVacantOnFanucAndZeroElsewhere) {
    EXPECT_EQ(run_body("G0 X5 Y5 Z5\nG0 X#120 Y7\n", Dialect::Fanuc).path, "G0 5 5 5\nG0 5 7 5\n");
    EXPECT_EQ(run_body("G0 X5 Y5 Z5\nG0 X#120 Y7\n", Dialect::Rs274).path, "G0 5 5 5\nG0 0 7 5\n");
    expect_path("G0 X[FIX[-2.8]] Y[1 AND 2] Z0\n", Dialect::Fanuc, "G0 -2 0 0\n");
    expect_path("G0 X[FIX[-2.8]] Y[1 AND 2] Z0\n", Dialect::Rs274, "G0 -3 1 0\n");
}

TEST(Controls, G10L20IsAnExtendedSystemOnFanucAndThePlaceOfNowElsewhere) {
    const std::string body = "G10 L2 P1 X0 Y0 Z0\nG0 X5 Y0 Z0\nG1 X6\nG10 L20 P1 X10\nG0 X10\n";
    expect_path(body, Dialect::Rs274, "G0 5 0 0\nG1 6 0 0\nG0 6 0 0\n");
    expect_path(body, Dialect::Fanuc, "G0 5 0 0\nG1 6 0 0\nG0 10 0 0\n");
}

TEST(Controls, ADwellWithPLeavesItsBlockTheMove) {
    for (const Dialect dialect : {Dialect::Rs274, Dialect::Fanuc, Dialect::Auto})
        expect_path("G0 X0 Y0 Z5\nG4 P1 G1 X30\nG4 F2\nG1 X31\n", dialect,
                    "G0 0 0 5\nG1 30 0 5\nG1 31 0 5\n");
}

TEST(Controls, MovesOfAMacroCallItNotAgain) {
    const std::string sub = "O10\nG90 G0 Z#18\nG1 Z#26\nG0 Z5\nM99\n";
    const std::string body = "G0 X0 Y0 Z5\nG66 P10 R2. Z-3.\nG0 X10\nX20\nG67\nX30\n";
    EXPECT_EQ(run(kHead + body + "M30\n" + sub, Dialect::Fanuc).path,
              "G0 0 0 5\nG0 10 0 5\nG0 10 0 2\nG1 10 0 -3\nG0 10 0 5\nG0 20 0 5\nG0 20 0 2\n"
              "G1 20 0 -3\nG0 20 0 5\nG0 30 0 5\n");
}

TEST(Controls, WordsBeforeAMacroCallAreExecutedAndNoArguments) {
    const std::string sub = "O10\nG0 X#1 Y#2\nM99\n";
    const std::string body = "G0 X1 Y1 Z5\nG91\nG90 G65 P10 A30. B20.\n";
    for (const Dialect dialect : {Dialect::Auto, Dialect::Fanuc, Dialect::Haas})
        EXPECT_EQ(run(kHead + body + "M30\n" + sub, dialect).path, "G0 1 1 5\nG0 30 20 5\n");
}

// --- Arcs --------------------------------------------------------------------------------------

TEST(Controls, AllArcsDecideHowCentresAreRead) {
    // The first arc fits both interpretations; the second arc fits absolute centres only.
    const std::string body =
        "G0 X-40 Y40 Z-1\nG1 X-42\nG3 X-42.3 Y39.7 I-42 J39.7\nG1 Y37\n"
        "G3 X-42 Y36.7 I-42 J37\nG1 X-40\nG3 X-39.7 Y37 I-40 J37\n";
    Made made;
    std::vector<double> radii;
    InterpreterOptions options;
    made.result = interpret({"t.nc", kHead + body + "M2\n"}, options, [&](const Motion& motion) {
        if (const auto* arc = std::get_if<Arc>(&motion.action))
            radii.push_back(std::hypot(arc->to.x.mm() - arc->centre_1.mm(),
                                       arc->to.y.mm() - arc->centre_2.mm()));
    });
    ASSERT_EQ(radii.size(), 3U);
    for (const double radius : radii)
        EXPECT_NEAR(radius, 0.3, 1e-6);
    EXPECT_TRUE(made.says("arc-centre-mode"));
    // Incremental centres are the default: a single arc that fits absolute centres by chance does
    // not outweigh two arcs.
    const Made usual = run_body(
        "G0 X10 Y0 Z0\nG2 X-10 Y0 I-10 J0\nG2 X10 Y0 I10 J0\n"
        "G1 X20 Y0\nG2 X0 Y20 I-3 J-3\n",
        Dialect::Auto);
    EXPECT_FALSE(usual.says("arc-centre-mode"));
}

TEST(Controls, ALongWayOfAHugeRadiusEndsAtTheProgrammedEnd) {
    const std::string before = "G0 X5.3 Y2.286 Z0\n";
    const std::string huge = "G3 X4.585 Y1.922 I-6544123.551 J1.204\n";
    expect_path(before + huge, Dialect::Auto, "G0 5.3 2.286 0\nG1 4.585 1.922 0\n");
    EXPECT_TRUE(run_body(before + huge, Dialect::Auto).says("arc-long-way"));
    // Both sides of the limit of 10 m: full turns of 9 m are executed, full turns of 11 m are not.
    for (const double radius : {9000.0, 11000.0}) {
        const std::string block = "G3 X1 Y0.0001 I-" + std::to_string(radius) + " J0\n";
        EXPECT_EQ(
            run_body("G0 X1 Y0 Z0\nG1 Y0.5\n" + std::string("Y0.0002\n") + block, Dialect::Auto)
                .says("arc-long-way"),
            radius > 10000.0);
    }
    // A full circle ends at the start and is executed at any size.
    EXPECT_FALSE(
        run_body("G0 X0 Y0 Z0\nG3 X0 Y0 I-11000 J0\n", Dialect::Auto).says("arc-long-way"));
    // The short arc of a large radius is an ordinary arc.
    EXPECT_FALSE(
        run_body("G0 X0 Y0 Z0\nG2 X10 Y0 I5 J-50000\n", Dialect::Auto).says("arc-long-way"));
}

TEST(Controls, AnArcByRadiusIsNeverAFullCircle) {
    for (const double chord : {1e-3, 1e-2, 1.0}) {
        for (const double radius : {1.0, 1e3, 1e5, 1e7, 1e9}) {
            for (const std::string code : {"G2", "G3"}) {
                const std::string block =
                    code + " X" + std::to_string(1.0 + chord) + " Y7 R" + std::to_string(radius);
                SCOPED_TRACE(block);
                double length = 0.0;
                (void)interpret({"t.nc", kHead + "G0 X1 Y7 Z0\n" + block + "\nM2\n"}, {},
                                [&](const Motion& motion) {
                                    const auto* arc = std::get_if<Arc>(&motion.action);
                                    if (!arc) return;
                                    const double r =
                                        std::hypot(arc->from.x.mm() - arc->centre_1.mm(),
                                                   arc->from.y.mm() - arc->centre_2.mm());
                                    const double side = (arc->to.x.mm() - arc->from.x.mm()) *
                                                        (arc->centre_2.mm() - arc->from.y.mm());
                                    // A short counter-clockwise arc has the centre on the left of
                                    // the chord.
                                    EXPECT_GT(side * arc->turns, 0.0);
                                    length = r;
                                });
                EXPECT_TRUE(length == 0.0 || std::abs(length - radius) < 1e-6 * radius);
            }
        }
    }
}

// --- What is not specified ---------------------------------------------------------------------

TEST(Controls, BlocksThatDependOnTheControlAreNoted) {
    const auto is_noted = [](const std::string& block) {
        return run(kHead + "G0 X0 Y0 Z5\n" + block + "\nM30\n", Dialect::Auto)
            .result.control_dependent.has_value();
    };
    for (const std::string block : {"G81 X5 Z-1 R2", "G41 D1", "G43 H0", "G10 L2 P1 X1", "G28 Z5",
                                    "M98 P7", "#1=2\nG1 X#1", "M70"})
        EXPECT_TRUE(is_noted(block)) << block;
    for (const std::string block :
         {"G1 X5", "G2 X5 R9", "G43 H1", "G92 X0", "G53 G0 Z0", "G4 P1", "M8", "G18"})
        EXPECT_FALSE(is_noted(block)) << block;
}

TEST(Controls, TheModeBeforeG90AndG91IsAGuessUnlessSomethingDecides) {
    const auto guess = [](const std::string& program, Dialect dialect) {
        return run("G21 F100\n" + program + "M30\n", dialect).result.distance_guess.has_value();
    };
    const std::string few = "G0 X0 Y0 Z5\nG1 Z-1\nX5\nG0 Z5\n";
    EXPECT_TRUE(guess(few, Dialect::Auto));
    EXPECT_TRUE(guess(few, Dialect::Fanuc));
    // The controls of this loop start with G90.
    for (const Dialect dialect : {Dialect::Rs274, Dialect::Haas, Dialect::Grbl})
        EXPECT_FALSE(guess(few, dialect));
    EXPECT_FALSE(guess("G90\n" + few, Dialect::Auto));
    EXPECT_FALSE(guess("G91\n" + few, Dialect::Auto));
    EXPECT_FALSE(guess(few + "G91\nG0 Z5\n", Dialect::Auto));
    // Pecks at ten positions: as increments they would move 40 mm up and 450 mm sideways.
    std::string holes;
    for (int i = 0; i < 10; ++i)
        holes += "G0 X" + std::to_string(10 * i) + " Z5\nG1 Z-1\nG0 Z5\n";
    EXPECT_FALSE(guess(holes, Dialect::Auto));
    // The same holes in increments.
    std::string steps;
    for (int i = 0; i < 10; ++i)
        steps += "G0 X10\nG1 Z-6\nG0 Z6\n";
    EXPECT_TRUE(guess(steps, Dialect::Auto));
    std::string row;
    for (int i = 0; i < 10; ++i)
        row += "G0 X10\n";
    EXPECT_TRUE(guess(row, Dialect::Auto));
    // The end of an arc lies on its circle in one reading only.
    const std::string quarter = "G0 X10 Y0 Z5\nG1 Z-1\nG3 X0 Y10 I-10\nG0 Z5\n";
    EXPECT_FALSE(guess(quarter, Dialect::Auto));
    EXPECT_FALSE(guess("G0 X30 Y0 Z5\nG1 Z-1\nG3 X20 Y10 R10\nG0 Z5\n", Dialect::Auto));
    EXPECT_FALSE(guess("G0 X30 Z5\nG18\nG3 X20 Z-5 I-10\nG0 Z5\n", Dialect::Auto));
    EXPECT_TRUE(guess("G0 X10 Y0 Z5\nG1 Z-1\nG3 X-10 Y10 I-10\nG0 Z5\n", Dialect::Auto));
    EXPECT_TRUE(guess("G3 X0 Y10 I0 J5\nG0 Z5\n", Dialect::Auto));  // fits both
    EXPECT_TRUE(guess("G0 X3\nG3 X1 Y1 R50\nG0 Z5\n", Dialect::Auto));
    EXPECT_TRUE(guess(quarter + "G3 X-10 Y10 I-10\n", Dialect::Auto));
}

TEST(Controls, AFeedWithG20IsInTheUnitsBeforeOnLinuxCncAlone) {
    const auto feed = [](Dialect dialect) {
        InterpreterOptions options;
        options.dialect = dialect;
        double last = 0.0;
        interpret({"t.nc", "G21 G90 F100\nG0 X0 Y0 Z0\nG20 F6\nG1 X.5\nM30\n"}, options,
                  [&last](const Motion& motion) { last = motion.feed; });
        return last;
    };
    EXPECT_NEAR(feed(Dialect::Rs274), 6.0, 1e-9);
    for (const Dialect dialect : {Dialect::Auto, Dialect::Fanuc, Dialect::Haas, Dialect::Grbl})
        EXPECT_NEAR(feed(dialect), 152.4, 1e-9) << name_of(dialect);
}

// --- Documentation -----------------------------------------------------------------------------

std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Controls, TheTableOfDifferencesNamesTestsThatExist) {
    const std::filesystem::path root = NCSIM_SOURCE_DIR;
    std::string tests;
    for (const auto& entry : std::filesystem::directory_iterator(root / "tests/gcode")) {
        if (entry.path().extension() == ".cpp") tests += text_of(entry.path());
    }
    const std::string docs = text_of(root / "docs/dialect.md");
    const std::size_t begin = docs.find("<!-- controls -->");
    const std::string table = docs.substr(begin, docs.find("<!-- /controls -->") - begin);
    const std::regex name("`([A-Z][A-Za-z0-9]+)\\.([A-Z][A-Za-z0-9]+)`");
    int count = 0;
    for (auto it = std::sregex_iterator(table.begin(), table.end(), name);
         it != std::sregex_iterator(); ++it, ++count) {
        const std::string test = "TEST(" + (*it)[1].str() + ", " + (*it)[2].str() + ")";
        EXPECT_NE(tests.find(test), std::string::npos) << test;
    }
    EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace ncsim::gcode
