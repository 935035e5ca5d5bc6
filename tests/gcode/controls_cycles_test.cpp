// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles and taps that controls execute in different ways. The paths of Rs274 are the output of
// rs274 of LinuxCNC 2.9.
#include "ncsim/gcode/interpreter.h"

#include "gcode/controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::gcode {
namespace {

using controls::expect_path;
using controls::kHead;
using controls::Made;
using controls::run_body;

// --- Cycles under G51, limits of G22 -------------------------------------------------------------

TEST(Controls, G51ScalesTheHeightsOfCyclesExceptOnHaas) {
    // Factor 2 about Z1: R2 is at Z3, and Z-4 at Z-9. The plane alone does not change the heights.
    const std::string cycle = "G81 X1 Z-4 R2\nG80\nG50\n";
    const std::string before = "G0 X0 Y0 Z20\n";
    const std::string scaled = before + "G51 X0 Y0 Z1 P2000\n" + cycle;
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Mach3}) {
        const Made made = run_body(scaled, dialect);
        EXPECT_NE(made.path.find("G0 2 0 3\nG1 2 0 -9\n"), std::string::npos) << made.path;
        EXPECT_TRUE(made.says("cycle-scaled"));
    }
    const Made haas = run_body(scaled, Dialect::Haas);
    EXPECT_NE(haas.path.find("G0 2 0 2\nG1 2 0 -4\n"), std::string::npos) << haas.path;
    EXPECT_TRUE(haas.says("cycle-scaled"));
    const Made plane = run_body(before + "G51 X0 Y0 I2000 J2000 K1000\n" + cycle, Dialect::Fanuc);
    EXPECT_NE(plane.path.find("G0 2 0 2\nG1 2 0 -4\n"), std::string::npos) << plane.path;
    EXPECT_FALSE(plane.says("cycle-scaled"));
}

TEST(Controls, LimitsOfG22MoveNothing) {
    for (const std::string mode : {"G0", "G1", "G2 X5 R9", "G81 X1 Z-1 R1"}) {
        const std::string before = "G0 X0 Y0 Z5\n" + mode + "\n";
        const std::string after = "G80\nG1 X3\n";
        const Made with =
            run_body(before + "G22 X100 Y100 Z50 I-100 J-100 K-50\n" + after, Dialect::Fanuc);
        EXPECT_EQ(with.path, run_body(before + after, Dialect::Fanuc).path) << mode;
        EXPECT_FALSE(has_errors(with.result.diagnostics)) << mode;
    }
}

// --- Spindle -----------------------------------------------------------------------------------

TEST(Controls, TapsTurnTheSpindleThemselvesOutsideLinuxCnc) {
    constexpr auto kRight = SpindleTurning::Clockwise;
    constexpr auto kLeft = SpindleTurning::Counterclockwise;
    for (const Dialect dialect : {Dialect::Auto, Dialect::Rs274, Dialect::Fanuc, Dialect::Haas}) {
        for (const bool is_right : {true, false}) {
            for (const std::string before : {"M5\n", "M5\nM29 S100\n", "M5\nS100\n"}) {
                const std::string text = kHead + "G0 X0 Y0 Z5\n" + before +
                                         (is_right ? "G84" : "G74") +
                                         " X1 Z-5 R1 F100\nX2\nG80\nG1 X3\nM30\n";
                SCOPED_TRACE(std::string(name_of(dialect)) + "\n" + text);
                std::vector<SpindleTurning> found;
                InterpreterOptions options;
                options.dialect = dialect;
                interpret({"t.nc", text}, options, [&](const Motion& motion) {
                    if (end_of(motion) && motion.kind == MoveKind::Feed)
                        found.push_back(motion.spindle);
                });
                const SpindleTurning way_in = dialect == Dialect::Rs274 ? SpindleTurning::Stopped
                                              : is_right                ? kRight
                                                                        : kLeft;
                const SpindleTurning way_out = is_right ? kLeft : kRight;
                EXPECT_EQ(found,
                          (std::vector{way_in, way_out, way_in, way_out, SpindleTurning::Stopped}));
            }
        }
    }
}

/// M29 lasts until the cycle ends, whatever M3, M4 or M5 is between, and leaves the spindle
/// stopped.
TEST(Controls, M29LastsUntilTheCycleEnds) {
    constexpr auto kRight = SpindleTurning::Clockwise;
    constexpr auto kLeft = SpindleTurning::Counterclockwise;
    const auto feeds = [](const std::string& body) {
        std::vector<SpindleTurning> found;
        InterpreterOptions options;
        options.dialect = Dialect::Fanuc;
        interpret({"t.nc", kHead + "G0 X0 Y0 Z5\n" + body}, options, [&](const Motion& motion) {
            if (end_of(motion) && motion.kind == MoveKind::Feed) found.push_back(motion.spindle);
        });
        return found;
    };
    const std::string cycle = " X1 Z-5 R1 F100\nX2\nG80\nG1 X3\nM30\n";
    for (const bool is_right : {true, false}) {
        const auto in = is_right ? kRight : kLeft;
        const auto out = is_right ? kLeft : kRight;
        for (const std::string between : {"", "M3\n", "M4\n", "M5\n", "S200 M3\n", "G4 P100\n"}) {
            const std::string text = "M29 S100\n" + between + (is_right ? "G84" : "G74") + cycle;
            const std::vector<SpindleTurning> found = feeds(text);
            ASSERT_EQ(found.size(), 5U) << text;
            EXPECT_EQ(found[0], in) << text;
            EXPECT_EQ(found[1], out) << text;
            EXPECT_EQ(found[2], in) << text;
            EXPECT_EQ(found[3], out) << text;
            EXPECT_EQ(found[4], SpindleTurning::Stopped) << text;
        }
    }
    // The next cycle taps with the direction of M4 again.
    EXPECT_EQ(feeds("M29 S100\nG84 X1 Z-5 R1 F100\nG80\nM4\nG84 X2 Z-5 R1\nG80\n")[2], kLeft);
}

/// G33.1 leaves the thread with the spindle reversed.
TEST(Controls, G33ReversesTheSpindleOnItsWayOut) {
    for (const auto& [code, way_in] : {std::pair{"M3", SpindleTurning::Clockwise},
                                       std::pair{"M4", SpindleTurning::Counterclockwise}}) {
        std::vector<SpindleTurning> found;
        InterpreterOptions options;
        options.dialect = Dialect::Rs274;
        const std::string text =
            kHead + "G0 X0 Y0 Z5\nS400 " + code + "\nG33.1 Z-5 K1\nG1 X9 F100\nM2\n";
        interpret({"t.nc", text}, options, [&](const Motion& motion) {
            if (end_of(motion) && motion.kind == MoveKind::Feed) found.push_back(motion.spindle);
        });
        const bool is_right = way_in == SpindleTurning::Clockwise;
        const auto out = is_right ? SpindleTurning::Counterclockwise : SpindleTurning::Clockwise;
        EXPECT_EQ(found, (std::vector{way_in, out, way_in})) << code;
    }
}

TEST(Controls, TapsOfHaasTurnAsTheCycleSays) {
    for (const std::string before : {"M3\n", "M4\n", "M5\n"}) {
        for (const std::string code : {"G84", "G74"}) {
            std::vector<SpindleTurning> found;
            InterpreterOptions options;
            options.dialect = Dialect::Haas;
            const std::string text =
                kHead + "G0 X0 Y0 Z5\n" + before + code + " X1 Z-5 R1 F100\nM30\n";
            interpret({"t.nc", text}, options, [&](const Motion& motion) {
                if (end_of(motion) && motion.kind == MoveKind::Feed)
                    found.push_back(motion.spindle);
            });
            std::vector<SpindleTurning> expected{SpindleTurning::Clockwise,
                                                 SpindleTurning::Counterclockwise};
            if (code == "G74") std::ranges::reverse(expected);
            EXPECT_EQ(found, expected) << text;
        }
    }
}

// --- Cycles ------------------------------------------------------------------------------------

TEST(Controls, CyclesBeginWithG99OnLinuxCncAlone) {
    const std::string body = "G0 X10 Y10 Z10\nG81 X10 Y10 Z-12 R-6\nX50\nG80\n";
    const std::string first = "G0 10 10 10\nG0 10 10 10\nG0 10 10 -6\nG1 10 10 -12\n";
    expect_path(body, Dialect::Rs274,
                first + "G0 10 10 -6\nG0 50 10 -6\nG1 50 10 -12\nG0 50 10 -6\n");
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Mach3}) {
        expect_path(body, dialect,
                    first + "G0 10 10 10\nG0 50 10 10\nG0 50 10 -6\nG1 50 10 -12\nG0 50 10 10\n");
    }
}

TEST(Controls, HolesUnderG91KeepTheirHeightsOnFanucAndHaas) {
    const std::string body = "G0 X10 Y10 Z20\nG99 G81 X10 Y10 Z-5 R2\nG91 X10 L2\nG90\nG80\n";
    const std::string first = "G0 10 10 20\nG0 10 10 20\nG0 10 10 2\nG1 10 10 -5\nG0 10 10 2\n";
    const std::string rest =
        "G0 20 10 2\nG1 20 10 -5\nG0 20 10 2\nG0 30 10 2\nG1 30 10 -5\n"
        "G0 30 10 2\n";
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas})
        expect_path(body, dialect, first + rest);
    EXPECT_NE(run_body(body, Dialect::Rs274).path, first + rest);
    // Heights under G91 are relative to the initial plane and to R.
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas, Dialect::Rs274}) {
        expect_path("G0 X0 Y0 Z20\nG91 G99 G81 X5 Z-7 R-18\nG80\n", dialect,
                    "G0 0 0 20\nG0 5 0 20\nG0 5 0 2\nG1 5 0 -5\nG0 5 0 2\n");
    }
}

TEST(Controls, IJKOfHaasArePecksThatShrink) {
    const std::string path =
        run_body("G0 X0 Y0 Z5\nG99 G73 X0 Y0 Z-10 R0 I4 J1 K2\nG80\n", Dialect::Haas).path;
    std::vector<double> depths;
    std::istringstream lines(path);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("G1")) depths.push_back(std::stod(line.substr(line.rfind(' '))));
    }
    EXPECT_EQ(depths, (std::vector<double>{-4, -7, -9, -10}));
    EXPECT_FALSE(run_body("G0 X0 Y0 Z5\nG83 X0 Y0 Z-10 R0 I4 J1 K2\n", Dialect::Haas)
                     .says("cycle-word-missing"));
    // Q ends the I, J, K pecks, and further cycles of Haas do not use K.
    const std::string by_q =
        run_body("G0 X0 Y0 Z5\nG99 G73 X0 Y0 Z-10 R0 I4 J1 K2\nG73 X5 Q5\nG80\n", Dialect::Haas)
            .path;
    EXPECT_NE(by_q.find("G1 5 0 -5\n"), std::string::npos) << by_q;
    EXPECT_TRUE(run_body("G0 X0 Y0 Z5\nG81 X0 Y0 Z-1 R1 K3\n", Dialect::Haas).says("word-unused"));
    // The cycles of Mach3 do not use K.
    EXPECT_TRUE(run_body("G0 X0 Y0 Z5\nG81 X0 Y0 Z-1 R1 K3\n", Dialect::Mach3).says("word-unused"));
    EXPECT_FALSE(
        run_body("G0 X0 Y0 Z5\nG81 X0 Y0 Z-1 R1 K3\n", Dialect::Fanuc).says("word-unused"));
}

TEST(Controls, TheWayToAHigherRIsOneSlantingRapidOnLinuxCnc) {
    const std::string body = "G0 X20 Y6 Z5\nG99 G81 X20 Y6 Z-8 R-3\nX40 Y6 Z-6 R2\nG80\n";
    const std::string first = "G0 20 6 5\nG0 20 6 5\nG0 20 6 -3\nG1 20 6 -8\nG0 20 6 -3\n";
    expect_path(body, Dialect::Rs274, first + "G0 40 6 2\nG1 40 6 -6\nG0 40 6 2\n");
    expect_path(body, Dialect::Fanuc, first + "G0 20 6 2\nG0 40 6 2\nG1 40 6 -6\nG0 40 6 2\n");
}

TEST(Controls, PBelongsToTheCycleBesideG54) {
    const std::string cycle = "G0 X0 Y0 Z5\nG54 G82 X5 Y0 Z-1 R2 P500\nG80\n";
    const std::string apart = "G0 X0 Y0 Z5\nG54\nG82 X5 Y0 Z-1 R2 P500\nG80\n";
    for (const Dialect dialect : {Dialect::Auto, Dialect::Fanuc, Dialect::Haas, Dialect::Rs274}) {
        EXPECT_EQ(run_body(cycle, dialect).path, run_body(apart, dialect).path);
        EXPECT_FALSE(run_body(cycle, dialect).says("offset-unknown"));
    }
    EXPECT_TRUE(run_body("G0 X0 Y0 Z5\nG54 P5 X5\n", Dialect::Fanuc).says("offset-unknown"));
}

TEST(Controls, KRepeatsACycleOnFanucAlone) {
    const std::string body = "G0 X0 Y0 Z5\nG91 G99 G81 X10 Z-3 R-3 K2\nG80\n";
    const std::string hole_1 = "G0 10 0 5\nG0 10 0 2\nG1 10 0 -1\nG0 10 0 2\n";
    const std::string hole_2 = "G0 20 0 2\nG1 20 0 -1\nG0 20 0 2\n";
    expect_path(body, Dialect::Fanuc, "G0 0 0 5\n" + hole_1 + hole_2);
    EXPECT_EQ(run_body(body, Dialect::Haas).path, "G0 0 0 5\n" + hole_1);
    EXPECT_EQ(run_body(body, Dialect::Mach3).path, "G0 0 0 5\n" + hole_1);
}

/// Blocks of a modal cycle, and whether they drill at the place of now: on LinuxCNC, Fanuc, Haas.
TEST(Controls, RAloneDrillsAgainOnFanucAlone) {
    struct Case {
        std::string block;
        bool drills;
        std::string said_on_fanuc, said_on_haas;
    };
    const Case cases[] = {
        {"Z-3", true, "", "cycle-without-place"},
        {"Z-3 R2", true, "", "cycle-without-place"},
        {"Q1", false, "word-unused", "word-unused"},
        {"P100", false, "word-unused", "word-unused"},
        {"F50", false, "", ""},
        {"X10", true, "", ""},
        {"Y10 Z-3", true, "", ""},
        {"G0 X10 Y10 Z5", false, "", ""},
    };
    const std::string before = "G0 X10 Y10 Z5\nG99 G81 Z-2 R1\n";
    const auto depths = [&](const std::string& block, Dialect dialect) {
        std::ptrdiff_t feeds = 0;
        std::istringstream lines(run_body(before + block + "\nG80\n", dialect).path);
        for (std::string line; std::getline(lines, line);)
            feeds += line.starts_with("G1") ? 1 : 0;
        return feeds;
    };
    for (const Dialect dialect : {Dialect::Rs274, Dialect::Fanuc, Dialect::Haas, Dialect::Mach3}) {
        for (const Case& c : cases) {
            SCOPED_TRACE(c.block + " on " + std::string(name_of(dialect)));
            EXPECT_EQ(depths(c.block, dialect), c.drills ? 2 : 1);
            const Made made = run_body(before + c.block + "\nG80\n", dialect);
            const bool is_fanuc = dialect == Dialect::Fanuc;
            const bool is_haas = dialect == Dialect::Haas;
            EXPECT_EQ(made.says("cycle-without-place"),
                      is_haas && c.said_on_haas == "cycle-without-place");
            if (is_fanuc || is_haas) {
                EXPECT_EQ(made.says("word-unused"), c.said_on_fanuc == "word-unused");
            }
        }
        EXPECT_EQ(depths("R2", dialect), dialect == Dialect::Fanuc ? 2 : 1) << name_of(dialect);
        EXPECT_EQ(run_body(before + "R2\nG80\n", dialect).says("word-unused"),
                  dialect != Dialect::Fanuc);
    }
    // The new R counts at once, and for the holes behind it.
    expect_path(before + "R3\nX20\nG80\n", Dialect::Fanuc,
                "G0 10 10 5\nG0 10 10 5\nG0 10 10 1\nG1 10 10 -2\nG0 10 10 1\nG0 10 10 3\n"
                "G0 10 10 3\nG1 10 10 -2\n"
                "G0 10 10 3\nG0 20 10 3\nG1 20 10 -2\nG0 20 10 3\n");
    // R of a block with another meaning drills nothing.
    for (const std::string block : {"G68 X0 Y0 R0", "G10 L12 P1 R2"})
        EXPECT_EQ(depths(block, Dialect::Fanuc), 1) << block;
    // Q and P are kept only from a block that drills.
    const std::string pecks = "G0 X0 Y0 Z5\nG83 Q2 F100\nX10 Z-9 R1\nG80\n";
    EXPECT_TRUE(run_body(pecks, Dialect::Fanuc).says("cycle-words-lost"));
    EXPECT_TRUE(run_body(pecks, Dialect::Fanuc).says("cycle-word-missing"));
    EXPECT_FALSE(run_body(pecks, Dialect::Haas).says("cycle-word-missing"));
}

TEST(Controls, G60PositionsAtRapidOnFanucAndHaas) {
    for (const std::string mode : {"G1 X1 Y1", "G0 X1 Y1", "G2 X1 Y1 R9"}) {
        const std::string before = "G0 X0 Y0 Z5\n" + mode + "\n";
        for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas}) {
            const Made made = run_body(before + "G60 X5 Y5\nG1 X6\n", dialect);
            EXPECT_TRUE(made.path.ends_with("G0 5 5 5\nG1 6 5 5\n")) << made.path;
            // The mode stays.
            EXPECT_EQ(run_body(before + "G60 X5 Y5\nX6 R9\n", dialect).path.substr(0, 3),
                      run_body(before + "G0 X5 Y5\n", dialect).path.substr(0, 3));
            EXPECT_TRUE(made.says("one-sided-move"));
            EXPECT_FALSE(made.says("one-sided-feed"));
        }
        for (const Dialect dialect : {Dialect::Mach3, Dialect::Auto}) {
            const Made made = run_body(before + "G60 X5 Y5 R9\n", dialect);
            EXPECT_EQ(made.says("one-sided-feed"), mode[1] != '0') << mode;
        }
    }
    const std::string feed = "G0 X0 Y0 Z5\nG1 X1 Y1\n";
    EXPECT_TRUE(
        run_body(feed + "G60 X5\nX6\n", Dialect::Fanuc).path.ends_with("G0 5 1 5\nG1 6 1 5\n"));
    // Within a cycle, the way to the hole is from one side.
    EXPECT_EQ(run_body("G0 X0 Y0 Z5\nG81 X1 Z-1 R1\nG60 X2\nG80\n", Dialect::Fanuc).path,
              run_body("G0 X0 Y0 Z5\nG81 X1 Z-1 R1\nX2\nG80\n", Dialect::Fanuc).path);
}

TEST(Controls, FanucAndHaasHaveNoOperatorForPowers) {
    for (const std::string power : {"#1=2**3", "#1=[2**3]", "#2=3\n#1=[2^#2]", "G1 X[2**3]"}) {
        const std::string body = "G0 X0 Y0 Z5\n" + power + "\nG1 X8\n";
        for (const Dialect dialect : {Dialect::Fanuc, Dialect::Haas})
            EXPECT_TRUE(run_body(body, dialect).says("power-operator")) << power;
        for (const Dialect dialect : {Dialect::Rs274, Dialect::Mach3, Dialect::Auto})
            EXPECT_FALSE(run_body(body, dialect).says("power-operator")) << power;
    }
    EXPECT_FALSE(
        run_body("G0 X0 Y0 Z5\n#1=2*3\nG1 X[2*#1]\n", Dialect::Fanuc).says("power-operator"));
}

}  // namespace
}  // namespace ncsim::gcode
