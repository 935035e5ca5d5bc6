// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of Klartext and SINUMERIK that mill pockets, slots, studs, faces and threads: what a tool
// of 10 mm sweeps at the bottom is the area of the cycle, and nothing else.
#include "ncsim/base/angles.h"

#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"
#include "gcode/swept_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ncsim::gcode::area_cycles_test {
namespace {

using klartext_test::klartext;
using language_test::Made;
using sinumerik_test::sinumerik;
using namespace swept_area;

const std::string kDepths =
    " Q207=500 Q351=+1 Q201=-10 Q202=4 Q206=150 Q200=2 Q203=+0 Q204=20 Q338=0 Q385=400";

Made milled(const std::string& definition, const std::string& before = "") {
    return klartext_test::run(
        klartext(before + "CYCL DEF " + definition + kDepths + "\nL X+0 Y+0 FMAX M99"));
}

// --- Klartext ---

TEST(KlartextAreas, RectangularPocket) {
    for (const std::string plunge : {"0", "1", "2"}) {
        const Made r = milled(
            "251 POCKET Q215=0 Q218=60 Q219=40 Q220=8 Q368=0.3 Q369=0.2 Q224=30 "
            "Q367=0 Q370=1 Q366=" +
            plunge);
        expect_swept(r, rectangle(60.0, 40.0, 8.0, 30.0), -10.0, 40.0);
        expect_rapids_in_cut(r, 0.0);
    }
}

TEST(KlartextAreas, SquareCornersAreAsRoundAsTheTool) {
    for (const std::string overlap : {"0.5", "1.9999"}) {
        const Made r = milled(
            "251 POCKET Q215=0 Q218=30 Q219=50 Q220=0 Q368=0 Q369=0 Q224=0 "
            "Q367=0 Q366=0 Q370=" +
            overlap);
        expect_swept(r, rectangle(30.0, 50.0, kRadius), -10.0, 32.0);
    }
}

TEST(KlartextAreas, PositionOfAPocketIsACorner) {
    const std::string pocket =
        "251 POCKET Q215=0 Q218=40 Q219=30 Q220=6 Q368=0 Q369=0 Q224=0 Q370=1 Q366=0 Q367=";
    const std::vector<Point> centres{{20.0, 15.0}, {-20.0, 15.0}, {-20.0, -15.0}, {20.0, -15.0}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Made r = milled(pocket + std::to_string(i + 1));
        expect_swept(r, rectangle(40.0, 30.0, 6.0, 0.0, centres[i].x, centres[i].y), -10.0, 45.0);
        // The tool returns to the position of the call.
        EXPECT_NEAR(r.end().x.mm(), 0.0, 1e-9);
        EXPECT_NEAR(r.end().z.mm(), 20.0, 1e-9);
    }
}

TEST(KlartextAreas, RoughingLeavesTheAllowances) {
    const Made r = milled(
        "251 POCKET Q215=1 Q218=60 Q219=40 Q220=8 Q368=0.5 Q369=0.2 Q224=0 "
        "Q367=0 Q370=1 Q366=0");
    expect_swept(r, rectangle(59.0, 39.0, 7.5), -9.8, 40.0);
}

TEST(KlartextAreas, FinishingOnly) {
    const std::string pocket = " Q218=60 Q219=40 Q220=8 Q224=0 Q367=0 Q370=1 Q366=0";
    const Made r = milled("251 POCKET Q215=2 Q368=0.5 Q369=0.2" + pocket);
    expect_swept(r, rectangle(60.0, 40.0, 8.0), -10.0, 40.0);
    EXPECT_EQ(milled("251 POCKET Q215=2 Q368=0 Q369=0" + pocket).errors(),
              "5:1: cycle 251 needs an allowance (Q368, Q369) to finish; the program is stopped "
              "here [word-missing]\n");
}

TEST(KlartextAreas, CircularPocket) {
    const Made r = milled("252 POCKET Q215=0 Q223=44 Q368=0.3 Q369=0.2 Q370=1 Q366=1");
    expect_swept(r, rectangle(44.0, 44.0, 22.0), -10.0, 30.0);
    expect_rapids_in_cut(r, 0.0);
}

TEST(KlartextAreas, MiddleIsMilledIfThePassesAreFarApart) {
    // The innermost pass is farther from the middle than the radius.
    for (const std::string length : {"60", "23.8"}) {
        const Made r = milled(
            "251 POCKET Q215=0 Q219=23.8 Q220=0 Q368=0 Q369=0 Q370=1.9999 Q366=0 "
            "Q218=" +
            length);
        expect_swept(r, rectangle(std::stod(length), 23.8, kRadius), -10.0, 34.0);
    }
}

TEST(KlartextAreas, PocketsHardlyWiderThanTheTool) {
    const Made pocket = milled("252 POCKET Q215=0 Q223=10.001 Q368=0 Q369=0 Q370=1 Q366=1");
    expect_swept(pocket, rectangle(10.001, 10.001, 5.0005), -10.0, 8.0);
    const Made slot = milled("253 SLOT Q215=0 Q218=10.002 Q219=10.001 Q368=0 Q369=0 Q366=1");
    expect_swept(slot, rectangle(10.002, 10.001, 5.0005), -10.0, 8.0);
    EXPECT_LT(pocket.moves.size(), 500U);
    EXPECT_LT(slot.moves.size(), 500U);
}

TEST(KlartextAreas, ClimbMillingIsCounterClockwiseInAPocket) {
    const auto turns = [](const Made& r) {
        const auto* const arc = std::get_if<Arc>(&r.moves[r.moves.size() - 5].action);
        return arc ? arc->turns : 0;
    };
    const std::string pocket = "252 POCKET Q215=0 Q223=44 Q368=0 Q369=0 Q370=1 Q366=0";
    EXPECT_EQ(turns(milled(pocket)), 1);
    EXPECT_EQ(turns(milled(pocket, "L M4\n")), -1);
    std::string program = klartext("CYCL DEF " + pocket + kDepths + "\nL X+0 Y+0 FMAX M99");
    program.replace(program.find("Q351=+1"), 7, "Q351=-1");
    EXPECT_EQ(turns(klartext_test::run(program)), -1);
}

TEST(KlartextAreas, Slot) {
    for (const std::string width : {"10", "14", "24"}) {
        for (const std::string plunge : {"0", "1"}) {
            const Made r =
                milled("253 SLOT Q215=0 Q218=60 Q368=0 Q369=0 Q374=20 Q367=0 Q219=" + width +
                       " Q366=" + plunge);
            const double size = std::stod(width);
            expect_swept(r, rectangle(60.0, size, size / 2.0, 20.0), -10.0, 40.0);
            expect_rapids_in_cut(r, 0.0);
        }
    }
}

TEST(KlartextAreas, PositionOfASlot) {
    const std::vector<double> centres{30.0, 22.0, -22.0, -30.0};
    for (std::size_t i = 0; i < 4; ++i) {
        const Made r = milled(
            "253 SLOT Q215=0 Q218=60 Q219=16 Q368=0.2 Q369=0.1 Q374=90 Q366=0 "
            "Q367=" +
            std::to_string(i + 1));
        expect_swept(r, rectangle(60.0, 16.0, 8.0, 90.0, 0.0, centres[i]), -10.0, 62.0);
    }
}

TEST(KlartextAreas, CircularSlots) {
    for (const std::string width : {"10", "14"}) {
        const Made r = milled(
            "254 SLOT Q215=0 Q368=0 Q369=0.1 Q375=50 Q367=0 Q216=0 Q217=0 Q376=10 "
            "Q248=70 Q378=180 Q377=2 Q366=1 Q219=" +
            width);
        const Distance one = band(25.0, std::stod(width), 10.0, 70.0);
        const Distance other = band(25.0, std::stod(width), 190.0, 70.0);
        expect_swept(
            r, [&](double x, double y) { return std::min(one(x, y), other(x, y)); }, -10.0, 36.0);
        expect_rapids_in_cut(r, 0.0);
    }
    const Made middle = klartext_test::run(
        klartext("CYCL DEF 254 SLOT Q215=0 Q219=14 Q368=0 Q369=0 Q375=50 Q367=2 Q376=45 Q248=70 "
                 "Q378=0 Q377=1 Q366=0" +
                 kDepths + "\nL X+17.67766953 Y+17.67766953 FMAX M99"));
    expect_swept(middle, band(25.0, 14.0, 10.0, 70.0), -10.0, 36.0);
}

TEST(KlartextAreas, StudsStayAndTheBlankGoes) {
    const Distance stud = rectangle(40.0, 24.0, 5.0);
    const Distance blank = rectangle(56.0, 44.0, 0.0);
    const Made r = milled(
        "256 STUD Q218=40 Q424=56 Q219=24 Q425=44 Q220=5 Q368=0 Q224=0 Q367=0 "
        "Q370=1 Q437=0");
    EXPECT_TRUE(r.says("mills-outside"));
    std::vector<Point> path;
    for (const Motion& motion : r.moves)
        add_path(path, motion, -10.0);
    for (double x = -30.0; x <= 30.0; x += 0.71) {
        for (double y = -24.0; y <= 24.0; y += 0.71) {
            const bool is_swept = std::ranges::any_of(
                path, [&](const Point& p) { return hypotenuse(p.x - x, p.y - y) <= kRadius; });
            const bool is_blank = stud(x, y) > 0.02 && blank(x, y) < 0.0;
            if (is_blank || stud(x, y) < -0.02) {
                EXPECT_EQ(is_swept, is_blank) << x << ' ' << y;
            }
        }
    }
    const Made round = milled("257 STUD Q223=40 Q222=50 Q368=0 Q370=1");
    const auto outermost = [](const Made& made) {
        double most = 0.0;
        for (const Motion& motion : made.moves)
            most = std::max(most, end_of(motion)->x.mm());
        return most;
    };
    EXPECT_NEAR(outermost(round), 32.0, 1e-9);  // Outside of the blank.
}

/// An SL program: labels 1 (a rectangle, by RL counter-clockwise), 2 (a round island) and 3 (a
/// second pocket, by RR clockwise).
Made contours(const std::string& labels, const std::string& cycles,
              const std::string& data = "Q3=+0 Q4=+0") {
    return klartext_test::run(
        "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\nCYCL DEF 14.0 CONTOUR\n"
        "CYCL DEF 14.1 CONTOUR LABEL" +
        labels +
        "\nCYCL DEF 20 CONTOUR DATA ~\n Q1=-10 ~\n Q2=+1 ~\n Q5=+0 ~\n Q6=+2 ~\n Q7=+20 ~\n "
        "Q8=+0 ~\n Q9=+1 ~\n " +
        data + "\n" + cycles +
        "\nL Z+50 FMAX\nM30\nLBL 1\nL X-30 Y-20 RL\nL X+30\nRND R8\nL Y+20\nRND R8\nL X-30\n"
        "RND R8\nL Y-20\nLBL 0\nLBL 2\nCC X+0 Y+0\nL X+7 Y+0 RR\nC X+7 Y+0 DR+\nLBL 0\n"
        "LBL 3\nL X-30 Y+30 RR\nL Y+50\nL IX+40\nL Y+30\nL X-30\nLBL 0\nEND PGM T MM\n");
}

const std::string kRough = "CYCL DEF 22 ROUGH-OUT ~\n Q10=+4 ~\n Q11=+150 ~\n Q12=+500\nCYCL CALL";

TEST(KlartextContours, PocketWithAnIsland) {
    const Made r = contours("1 /2", kRough);
    EXPECT_FALSE(r.says("feed-missing"));
    // Three corners of the pocket are rounded by 8, one is as round as the tool.
    const Distance round = rectangle(60.0, 40.0, 8.0);
    const Distance square = rectangle(60.0, 40.0, kRadius);
    const Distance island = rectangle(14.0, 14.0, 7.0);
    expect_swept(
        r,
        [&](double x, double y) {
            const double pocket = x < 0.0 && y < 0.0 ? square(x, y) : round(x, y);
            return std::max(pocket, -island(x, y));
        },
        -10.0, 36.0);
    expect_rapids_in_cut(r, 0.0);
}

TEST(KlartextContours, TwoPockets) {
    const Made r = contours("2/3", kRough);
    EXPECT_EQ(r.errors(),
              "19:1: cycle 14 needs islands inside of pockets; the program is stopped here "
              "[word-missing]\n");
    const Distance first = rectangle(60.0, 40.0, 8.0);
    const Distance square = rectangle(60.0, 40.0, kRadius);
    const Distance other = rectangle(40.0, 20.0, kRadius, 0.0, -10.0, 40.0);
    expect_swept(
        contours("1/3", kRough),
        [&](double x, double y) {
            const double pocket = x < 0.0 && y < 0.0 ? square(x, y) : first(x, y);
            return std::min(pocket, other(x, y));
        },
        -10.0, 56.0);
}

TEST(KlartextContours, AllowancesAndFinishing) {
    const std::string allowances = "Q3=+0.5 Q4=+0.2";
    const Distance other = rectangle(40.0, 20.0, kRadius, 0.0, -10.0, 40.0);
    expect_swept(contours("3", kRough, allowances),
                 rectangle(39.0, 19.0, kRadius, 0.0, -10.0, 40.0), -9.8, 56.0);
    const std::string finish =
        "\nCYCL DEF 23 FLOOR ~\n Q11=+150 ~\n Q12=+500\nCYCL CALL\nCYCL DEF 24 SIDE ~\n Q9=+1 ~\n "
        "Q10=+5 ~\n Q11=+150 ~\n Q12=+400 ~\n Q14=+0\nL FMAX M99";
    expect_swept(contours("3", kRough + finish, allowances), other, -10.0, 56.0);
}

TEST(KlartextContours, DirectionOfTheCutIsThatOfCycle20) {
    const auto turns = [](const std::string& circle, const std::string& direction) {
        const Made r = klartext_test::run(klartext(
            "CYCL DEF 14.1 LABEL 7\nCYCL DEF 20 DATA Q1=-5 Q2=1 Q5=0 Q6=2 Q7=20 Q9=" + direction +
            "\nCYCL DEF 24 A Q10=5 Q11=100 Q12=500\nL FMAX M99\nM30\nLBL 7\n"
            "CC X+0 Y+0\nL X+8 Y+0 " +
            circle + "\nLBL 0"));
        EXPECT_EQ(r.errors(), "");
        int found = 0;
        for (const Motion& motion : r.moves) {
            if (const auto* const arc = std::get_if<Arc>(&motion.action)) found = arc->turns;
        }
        return found;
    };
    // Climb milling in a pocket is counter-clockwise, whatever the direction of the subprogram.
    EXPECT_EQ(turns("RL\nC X+8 Y+0 DR+", "+1"), 1);
    EXPECT_EQ(turns("RR\nC X+8 Y+0 DR-", "+1"), 1);
    EXPECT_EQ(turns("RL\nC X+8 Y+0 DR+", "-1"), -1);
}

TEST(KlartextContours, ShiftAndParametersAct) {
    const Made r = klartext_test::run(
        klartext("Q5 = 8\nCYCL DEF 7.0\nCYCL DEF 7.1 X+40\nCYCL DEF 14.0\nCYCL DEF 14.1 LABEL 7\n"
                 "CYCL DEF 20.0 DATA Q1=-5 Q2=1 Q5=0 Q6=2 Q7=20 Q9=+1\nQ5 = 8\n"
                 "CYCL DEF 22 A Q10=5 Q11=100 Q12=500\nL FMAX M99\nM30\nLBL 7\nCC X+0 Y+0\n"
                 "L X+Q5 Y+0 RL\nC X+Q5 Y+0 DR+\nLBL 0"));
    expect_swept(r, rectangle(16.0, 16.0, 8.0, 0.0, 40.0, 0.0), -5.0, 50.0);
}

TEST(KlartextContours, Faults) {
    EXPECT_EQ(contours("9", kRough).errors(),
              "19:1: there is no LBL 9; the program is stopped here [label-missing]\n");
    EXPECT_EQ(contours("1/1", kRough).errors(),
              "19:1: cycle 14 with contours that overlap is not read; the program is stopped here "
              "[klartext-verb]\n");
    const Made r = klartext_test::run(klartext(kRough));
    EXPECT_EQ(r.errors(),
              "8:1: cycle 22 needs cycle 14 (contours) before; the program is stopped "
              "here [word-missing]\n");
    EXPECT_TRUE(contours("3", kRough, "Q8=+1").says("inner-radius"));
}

TEST(KlartextAreas, CyclesOfPatterns) {
    const Made r = klartext_test::run(
        klartext("CYCL DEF 252 POCKET Q215=0 Q223=16 Q368=0 Q369=0 Q370=1 Q366=1" + kDepths +
                 "\nCYCL DEF 221 PATTERN Q225=-20 Q226=0 Q237=40 Q238=0 Q242=2 Q243=1 Q224=0 "
                 "Q200=2 Q203=0 Q204=20 Q301=1"));
    const Distance left = rectangle(16.0, 16.0, 8.0, 0.0, -20.0, 0.0);
    const Distance right = rectangle(16.0, 16.0, 8.0, 0.0, 20.0, 0.0);
    expect_swept(
        r, [&](double x, double y) { return std::min(left(x, y), right(x, y)); }, -10.0, 32.0);
}

TEST(KlartextAreas, UnknownToolsLeaveTheCycleOut) {
    const Made r = klartext_test::run(
        klartext("TOOL CALL 5 Z S100\nCYCL DEF 252 POCKET Q215=0 Q223=16 Q368=0 Q369=0 Q370=1 "
                 "Q366=1" +
                 kDepths + "\nL X+0 Y+0 FMAX M99\nL X+7 FMAX"));
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("compensation-radius-unknown"));
    EXPECT_FALSE(r.result.refused);
    EXPECT_NEAR(r.end().x.mm(), 7.0, 1e-9);
}

TEST(KlartextAreas, Faults) {
    const auto expect_fault = [](const std::string& definition, const std::string& message) {
        EXPECT_EQ(milled(definition).errors(), "5:1: " + message + "\n");
    };
    expect_fault("252 POCKET Q215=0 Q223=9 Q368=0 Q369=0 Q370=1 Q366=1",
                 "cycle 252 needs a width of at least the tool and the allowances; the program is "
                 "stopped here [word-missing]");
    expect_fault("252 POCKET Q215=0 Q223=20 Q368=0 Q369=0 Q370=2 Q366=1",
                 "cycle 252 needs a path overlap (Q370) from 0.1 to 1.9999; the program is stopped "
                 "here [word-missing]");
    expect_fault("251 POCKET Q215=0 Q218=20 Q219=20 Q220=0 Q368=0 Q369=10 Q370=1 Q366=1",
                 "cycle 251 needs a depth below the allowance; the program is stopped here "
                 "[word-missing]");
    expect_fault("254 SLOT Q215=0 Q219=14 Q368=0 Q369=0 Q375=50 Q367=1 Q376=0 Q248=70",
                 "cycle 254 with the position (Q367) of an end is not read; the program is stopped "
                 "here [klartext-verb]");
    expect_fault(
        "256 STUD Q218=40 Q424=30 Q219=24 Q425=44 Q220=5 Q370=1",
        "cycle 256 needs a blank of at least the size of the stud; the program is stopped here "
        "[word-missing]");
    expect_fault("251 POCKET Q215=0 Q218=20000 Q219=20000 Q220=0 Q370=0.1 Q202=0.001 Q366=0",
                 "the number of repeats must be 1 or more, and not without end [cycle-repeats]");
}

// --- SINUMERIK ---

Made cut(const std::string& blocks) {
    return sinumerik_test::run(sinumerik(blocks));
}

TEST(SinumerikAreas, Pocket3) {
    const std::string pocket = "POCKET3(20,0,2,-10,60,40,8,3,-2,30,4,0.3,0.2,500,150,";
    const Distance area = rectangle(60.0, 40.0, 8.0, 30.0, 3.0, -2.0);
    const Made r = cut(pocket + "0,11,5)\n" + pocket + "0,12,5)");
    expect_swept(r, area, -10.0, 42.0);
    EXPECT_NEAR(r.end().x.mm(), 3.0, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), -2.0, 1e-9);
    EXPECT_NEAR(r.end().z.mm(), 20.0, 1e-9);
    expect_swept(cut(pocket + "0,11,5)"), rectangle(59.4, 39.4, 7.7, 30.0, 3.0, -2.0), -9.8, 42.0);
    expect_swept(cut(pocket + "1,21,5,,,,4,1)\n" + pocket + "3,12,0)"), area, -10.0, 42.0);
    expect_swept(cut(pocket + "2,31,5)\n" + pocket + "2,12,5)"), area, -10.0, 42.0);
}

TEST(SinumerikAreas, Pocket4HasARadiusOrWithModesADiameter) {
    const Distance circle = rectangle(40.0, 40.0, 20.0);
    const Made old = cut("POCKET4(20,0,2,-10,20,0,0,4,0,0,500,150,0,11,6)");
    EXPECT_FALSE(old.says("pocket-size"));
    expect_swept(old, circle, -10.0, 30.0);
    const Made with_modes =
        cut("POCKET4(10,0,2,10,40,0,0,2,0.1,0.1,2000,2000,0,21,50,9,15,6,1,0,1,2,10100,111,111)\n"
            "POCKET4(10,0,2,10,40,0,0,15,0.1,0.1,1000,2000,0,22,50,9,15,6,2,0,1,2,10100,111,111)");
    EXPECT_TRUE(with_modes.says("pocket-size"));
    expect_swept(with_modes, circle, -10.0, 30.0);
    expect_rapids_in_cut(with_modes, 0.0);
}

TEST(SinumerikAreas, Pocket1AndPocket2) {
    expect_swept(cut("POCKET1(20,0,2,-10,,60,40,8,0,0,15,150,500,4,2,0.2,0,10,400,4000)"),
                 rectangle(60.0, 40.0, 8.0, 15.0), -10.0, 40.0);
    expect_swept(cut("POCKET2(20,0,2,,10,20,1,2,150,500,4,3,0,0)"),
                 rectangle(40.0, 40.0, 20.0, 0.0, 1.0, 2.0), -10.0, 30.0);
}

TEST(SinumerikAreas, Spigots) {
    const auto stays = [](const Made& made, const Distance& spigot) {
        EXPECT_EQ(made.errors(), "");
        EXPECT_TRUE(made.says("mills-outside"));
        std::vector<Point> path;
        for (const Motion& motion : made.moves)
            add_path(path, motion, -10.0);
        double nearest = 1e9;
        for (const Point& p : path)
            nearest = std::min(nearest, spigot(p.x, p.y));
        EXPECT_NEAR(nearest, kRadius, 1e-3);
    };
    stays(cut("CYCLE76(20,0,2,-10,,50,30,5,1,2,10,4,,,500,150,0,1,70,60)"),
          rectangle(50.0, 30.0, 5.0, 10.0, 1.0, 2.0));
    stays(cut("CYCLE77(20,0,2,,10,40,0,0,4,0,0,500,150,1,2,60)"), rectangle(40.0, 40.0, 20.0));
}

TEST(SinumerikAreas, Face) {
    const std::string face = "CYCLE61(50,0,2,-5,-30,-20,60,40,3,80,0.2,3000,";
    const Made rough = cut(face + "31,0,1,11010)");
    EXPECT_TRUE(rough.says("mills-outside"));
    double lowest = 0.0;
    std::vector<Point> path;
    for (const Motion& motion : rough.moves) {
        lowest = std::min(lowest, end_of(motion)->z.mm());
        add_path(path, motion, -4.8);
    }
    EXPECT_NEAR(lowest, -4.8, 1e-9);
    for (double x = -30.0; x <= 30.0; x += 1.3) {
        for (double y = -20.0; y <= 20.0; y += 1.3) {
            EXPECT_TRUE(std::ranges::any_of(
                path, [&](const Point& p) { return hypotenuse(p.x - x, p.y - y) <= kRadius; }))
                << x << ' ' << y;
        }
    }
    const Made finished = cut(face + "22,0,1,11010)");
    lowest = 0.0;
    for (const Motion& motion : finished.moves) {
        lowest = std::min(lowest, end_of(motion)->z.mm());
        if (motion.kind != MoveKind::Feed) continue;
        EXPECT_NEAR(end_of(motion)->x.mm(), start_of(motion)->x.mm(), 1e-9);
    }
    EXPECT_NEAR(lowest, -5.0, 1e-9);
}

TEST(SinumerikAreas, Faults) {
    const auto errors = [](const std::string& block) { return cut(block).errors(); };
    EXPECT_EQ(errors("MCALL POCKET4(20,0,2,-10,20,0,0,4,0,0,500,150,0,11,6)"),
              "5:1: MCALL POCKET4 is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(errors("POCKET4(20,0,2,-10,20,0,0,4,0,0,500,150,0,11,6,3)"),
              "5:1: POCKET4 with a blank (_AP1, _AD) is not read; the program is stopped here "
              "[not-read]\n");
    EXPECT_EQ(errors("POCKET4(20,0,2,-10,20,0,0,4,0,0,500,150,0,15,6)"),
              "5:1: POCKET4 with this VARI is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(errors("CYCLE90(20,0,2,-10,,20,18,0,500,2,0,0,0)"),
              "5:1: CYCLE90 needs a pitch (PIT); the program is stopped here [word-missing]\n");
    EXPECT_EQ(errors("CYCLE61(50,0,2,-5,-30,-20,60,40,3,80,0.2,3000,31,1,1,11010)"),
              "5:1: CYCLE61 with limits (_LIM) is not read; the program is stopped here "
              "[not-read]\n");
    EXPECT_EQ(
        errors("CYCLE76(.2362,2.728,.2362,2.5311,,3,,,,)"),
        "5:1: CYCLE76 needs a retraction plane (RTP) not below the reference plane (RFP); the "
        "program is stopped here [word-missing]\n");
    EXPECT_EQ(errors("POCKET3(1)"),
              "5:1: POCKET3 needs RTP, RFP and a depth; the program is stopped here "
              "[word-missing]\n");
    EXPECT_EQ(errors("D0\nPOCKET4(20,0,2,-10,20,0,0,4,0,0,500,150,0,11,6)"),
              "6:1: POCKET4 needs the radius of the tool (D1); the program is stopped here "
              "[word-missing]\n");
}

}  // namespace
}  // namespace ncsim::gcode::area_cycles_test
