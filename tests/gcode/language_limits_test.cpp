// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values at the limits of blocks and cycles of Klartext and SINUMERIK, and cycles in pairs with
// modes. The expected paths are programs by hand.
#include "gcode/cradle.h"
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using klartext_test::klartext;
using language_test::Files;
using language_test::Made;
using sinumerik_test::sinumerik;

// --- Klartext ---

TEST(KlartextLimits, FmaxWithoutABlank) {
    klartext_test::expect_same("L X+5 FMAXM3\nL X+6 FMAX M3", "G0 X5.\nG0 X6.");
}

TEST(KlartextLimits, TangentialArcStraightAheadIsALine) {
    klartext_test::expect_same("L X+10 F100\nCT X+25 Y+0\nCT X+30 Y+0 Z+48",
                               "G1 X10. F100\nG1 X25.\nG1 X30. Z48.");
}

TEST(KlartextLimits, ApproachOfAHalfCircle) {
    // The radius is half of the chord: the tangent is square to the chord.
    for (const char* radius : {"R10", "R-10"}) {
        klartext_test::expect_close(
            "L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 RL F100\nCR X+30 Y+10 " +
                std::string(radius) + " DR-\nL X+30 Y-10",
            "G0 X-10. Y-10.\nG0 X5. Y-5.\nG1 Y10. F100\nG2 X35. Y10. I15. J0.\nG1 Y-10.");
    }
}

TEST(KlartextLimits, ModeOfClimbMillingZeroIsClimb) {
    // Q351: +1 climb, -1 up-cut; 0 as +1.
    const std::vector<std::string> cycles{
        "CYCL DEF 262 Q335=20 Q239=1.5 Q201=-6 Q355=0 Q253=750 Q200=2 Q203=0 Q204=20 Q207=500",
        "CYCL DEF 267 Q335=20 Q239=1.5 Q201=-6 Q355=0 Q253=750 Q200=2 Q203=0 Q204=20 Q207=500",
        "CYCL DEF 208 Q200=2 Q201=-6 Q206=300 Q334=3 Q203=0 Q204=20 Q335=30",
        "CYCL DEF 252 Q215=0 Q223=40 Q368=0 Q207=500 Q201=-4 Q202=4 Q206=150 Q200=2 Q203=0 Q204=20 "
        "Q370=1 Q366=0"};
    for (const std::string& cycle : cycles) {
        const auto texts = [&](const std::string& mode) {
            const Made made = language_test::run(klartext(cycle + " Q351=" + mode + "\nM99"));
            EXPECT_EQ(made.errors(), "") << cycle;
            return made.texts;
        };
        EXPECT_EQ(texts("0"), texts("+1")) << cycle;
        EXPECT_NE(texts("-1"), texts("+1")) << cycle;
        EXPECT_EQ(texts("-1"), texts("-0.5")) << cycle;
    }
}

TEST(KlartextLimits, CyclesEndAtTheClearance) {
    // Without a second clearance a cycle ends Q200 above the surface, after each part of the cycle.
    const std::string tail = " Q200=2 Q203=+1 Q204=0";
    const std::vector<std::string> cycles{
        "CYCL DEF 200 Q201=-6 Q206=100 Q202=6 Q210=0 Q211=0.1",
        "CYCL DEF 201 Q201=-6 Q206=100 Q211=0.1 Q208=200",
        "CYCL DEF 202 Q201=-6 Q206=100 Q211=0.1 Q208=200 Q214=1",
        "CYCL DEF 203 Q201=-6 Q206=100 Q202=3 Q210=0 Q212=0 Q213=0 Q205=0 Q211=0.1 Q208=200 "
        "Q256=0.2",
        "CYCL DEF 205 Q201=-6 Q206=100 Q202=3 Q212=0 Q205=0 Q258=0 Q259=0 Q257=0 Q256=0 Q211=0.1",
        "CYCL DEF 206 Q201=-6 Q206=100 Q211=0",
        "CYCL DEF 207 Q201=-6 Q239=1",
        "CYCL DEF 209 Q201=-6 Q239=1 Q257=2 Q256=0.5",
        "CYCL DEF 240 Q343=0 Q201=-3 Q344=-10 Q206=100 Q211=0.2",
    };
    for (const std::string& cycle : cycles) {
        const Made made =
            language_test::run(klartext(cycle + tail + "\nL X+4 Y+5 FMAX M99\nL X+9 FMAX"));
        EXPECT_EQ(made.errors(), "") << cycle;
        ASSERT_GT(made.moves.size(), 3U) << cycle;
        const Position before = *end_of(made.moves[made.moves.size() - 2]);
        EXPECT_NEAR(before.z.mm(), 3.0, 1e-9) << cycle;
        EXPECT_NEAR(made.end().z.mm(), 3.0, 1e-9) << cycle;
        double lowest = 50.0;
        for (const Motion& move : made.moves)
            lowest = std::min(lowest, end_of(move)->z.mm());
        EXPECT_NEAR(lowest, cycle.find(" 240 ") != std::string::npos ? -2.0 : -5.0, 1e-9) << cycle;
    }
}

TEST(KlartextLimits, ChipBreakingByLessThanAMillimetre) {
    // Infeed 6 in one, chips broken every 0.8: 0.8, 1.6, 2.4, and the rest to 3.
    const Made made = language_test::run(
        klartext("CYCL DEF 205 Q200=2 Q201=-3 Q206=100 Q202=3 Q203=0 Q204=0 Q212=0 Q205=0 Q258=0 "
                 "Q259=0 Q257=0.8 Q256=0.2 Q211=0\nL X+1 FMAX M99"));
    EXPECT_EQ(made.errors(), "");
    std::vector<double> fed;
    for (const Motion& move : made.moves) {
        if (move.kind == MoveKind::Feed) fed.push_back(end_of(move)->z.mm());
    }
    ASSERT_EQ(fed.size(), 4U);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(fed[i], -0.8 * static_cast<double>(i + 1), 1e-9);
    EXPECT_NEAR(fed[3], -3.0, 1e-9);
}

TEST(KlartextLimits, LinesThatGoOn) {
    const std::string cycle =
        "CYCL DEF 200 ~\n Q200=2 ~\n Q201=-6 ~\n Q206=100 ~\n Q202=6 ~\n Q203=0 ~\n Q204=20";
    const std::string call = "\nL X+1 FMAX M99";
    EXPECT_EQ(language_test::run(klartext(cycle + call)).texts,
              language_test::run(klartext("CYCL DEF 200 Q200=2 Q201=-6 Q206=100 Q202=6 Q203=0 "
                                          "Q204=20" +
                                          call))
                  .texts);
    // A program that ends within a block ends.
    for (const char* end : {"L X+5 ~", "CYCL DEF 200 ~\n", "CYCL DEF 200 Q200=2"}) {
        const Made made = language_test::run("BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+1 FMAX\n" +
                                             std::string(end));
        EXPECT_GE(made.moves.size(), 1U) << end;
    }
}

TEST(KlartextLimits, PlaneByVectors) {
    const auto errors = [](const std::string& plane) {
        return language_test::run(
                   "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 FMAX\nPLANE VECTOR " +
                       plane + " STAY\nM30\nEND PGM T MM\n",
                   {}, Dialect::Auto, false, "t.h", std::make_shared<language_test::Cradle>())
            .errors();
    };
    EXPECT_EQ(errors("BX1 BY0 BZ0 NX0 NY-1 NZ0"), "");
    EXPECT_EQ(errors("BX0.5 BY0.5 BZ0 NX0 NY-1 NZ0"), "");
    EXPECT_NE(errors("BX0 BY1 BZ0 NX0 NY-1 NZ0").find("a base that is not the normal"),
              std::string::npos);
    // Nothing moves after the error.
    EXPECT_EQ(language_test::run("BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 FMAX\n"
                                 "PLANE VECTOR BX0 BY1 BZ0 NX0 NY-1 NZ0 STAY\nL X+9 FMAX\nM30\n"
                                 "END PGM T MM\n",
                                 {}, Dialect::Auto, false, "t.h",
                                 std::make_shared<language_test::Cradle>())
                  .moves.size(),
              1U);
    EXPECT_NE(errors("BX1 BY0 BZ0 NX0 NY0 NZ0").find("NX NY NZ"), std::string::npos);
}

TEST(KlartextLimits, ContoursThatCrossAreRefused) {
    // Two squares of 40: apart, crossing at a corner, crossing as a T, and one in the other.
    const auto errors = [](double x, double y, double half) {
        const auto corner = [&](double dx, double dy) {
            return " X" + std::to_string(x + dx * half) + " Y" + std::to_string(y + dy * half);
        };
        return language_test::run(
                   "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\n"
                   "CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 1 /2\n"
                   "CYCL DEF 20 Q1=-4 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=20 Q8=0 Q9=1\n"
                   "CYCL DEF 22 Q10=-4 Q11=150 Q12=500 Q18=0 Q19=0\nCYCL CALL\nM30\n"
                   "LBL 1\nL X-20 Y-20 RL\nL X+20\nL Y+20\nL X-20\nL Y-20\nLBL 0\nLBL 2\nL" +
                   corner(-1, -1) + " RL\nL" + corner(1, -1) + "\nL" + corner(1, 1) + "\nL" +
                   corner(-1, 1) + "\nL" + corner(-1, -1) + "\nLBL 0\nEND PGM T MM\n")
            .errors();
    };
    for (const auto& [x, y] : std::vector<std::pair<double, double>>{
             {90, 0}, {-90, 0}, {0, 90}, {0, -90}, {60, 70}, {-60, -70}, {70, -60}, {-70, 60}})
        EXPECT_EQ(errors(x, y, 20), "") << x << ' ' << y;
    for (const auto& [x, y] : std::vector<std::pair<double, double>>{
             {30, 11}, {-30, 11}, {11, 30}, {11, -30}, {35, 35}, {-35, 35}, {35, -35}, {-35, -35}})
        EXPECT_NE(errors(x, y, 20).find("contours that overlap"), std::string::npos)
            << x << ' ' << y;
}

// --- SINUMERIK ---

TEST(SinumerikLimits, NameZeroOfCycle800TakesAllBack) {
    const auto end = [](const std::string& blocks) {
        return sinumerik_test::run(sinumerik(blocks + "\nG0 X1 Y2 Z3"));
    };
    sinumerik_test::expect_end(end("CYCLE800(0,\"A\",0,57,4,5,6,0,0,0,0,0,0,0)"), 5, 7, 9);
    sinumerik_test::expect_end(end("CYCLE800(0,\"0\",0,57,4,5,6,0,0,0,0,0,0,0)"), 1, 2, 3);
    sinumerik_test::expect_end(end("CYCLE800(0,\"A\",0,57,4,5,6,0,0,0,0,0,0,0)\nCYCLE800(0,\"0\",0,"
                                   "57,7,8,9,0,0,0,0,0,0,0)"),
                               1, 2, 3);
}

TEST(SinumerikLimits, BlanksBetweenANameAndItsArguments) {
    for (const char* block : {"MSG (\"A\")", "MSG(\"A\")", "MSG  (\"A(B\")", "CYCLE832 (0.1,1)",
                              "CYCLE832(0.1,1)", "CYCLE832", "CYCLE832 "}) {
        const Made made = sinumerik_test::run(sinumerik(std::string(block) + "\nG1 X5 F100"));
        EXPECT_EQ(made.errors(), "") << block;
        EXPECT_NEAR(made.end().x.mm(), 5.0, 1e-9) << block;
    }
}

TEST(SinumerikLimits, ContoursInEachPlane) {
    // The contour is in the plane of the call: the same path with exchanged axes.
    struct Row {
        const char* plane;
        const char* contour;
        const char* by_hand;
    };
    const Row rows[] = {
        {"G17", "G1 X10 Y10\nX30\nG3 X38 Y18 CR=8\nM17\n",
         "G0 X2 Y10\nZ2\nG1 Z-4 F100\nX10 F300\nX30\nG3 X38 Y18 CR=8\nG1 Y26\nG0 Z20"},
        {"G18", "G1 Z10 X10\nZ30\nG3 Z38 X18 CR=8\nM17\n",
         "G0 Z2 X10\nY2\nG1 Y-4 F100\nZ10 F300\nZ30\nG3 Z38 X18 CR=8\nG1 X26\nG0 Y20"},
        {"G19", "G1 Y10 Z10\nY30\nG3 Y38 Z18 CR=8\nM17\n",
         "G0 Y2 Z10\nX2\nG1 X-4 F100\nY10 F300\nY30\nG3 Y38 Z18 CR=8\nG1 Z26\nG0 X20"}};
    for (const Row& row : rows) {
        const std::string head = std::string(row.plane) + "\nG0 X50 Y50 Z50\n";
        const Files files{{"K1.SPF", row.contour}};
        language_test::expect_close(
            sinumerik_test::run(
                sinumerik(head + "CYCLE72(\"K1\",20,0,2,-4,0,0,0,300,100,1,40,1,8,500)"), files),
            sinumerik_test::run(sinumerik(head + row.by_hand)));
    }
}

TEST(SinumerikLimits, TheWayOutOfACompensatedContourMayBeAnArc) {
    // LSB 2: a quarter circle leaves the contour; it follows G40 inside of the cycle.
    const Files files{{"K1.SPF", "G1 X10 Y10\nX30\nY25\nM17\n"}};
    for (const char* side : {"41", "42"}) {
        const Made made = sinumerik_test::run(
            sinumerik("CYCLE72(\"K1\",20,0,2,-4,0,0,0,300,100,1," + std::string(side) +
                      ",2,8,500,2,8)\nG2 X40 Y20 CR=40 F100"),
            files);
        EXPECT_EQ(made.errors(), "") << side;
        EXPECT_FALSE(made.says("compensation-exit")) << side;
    }
}

TEST(SinumerikLimits, AFinishingFeedBelowOne) {
    // FFP2 is the feed of finishing if it is above 0; else FFP1 counts.
    const auto feeds = [](const std::string& feed) {
        const Made made = sinumerik_test::run(
            sinumerik("POCKET2(20,0,2,-4,,20,0,0,150,500,4,3,0.2,2,2," + feed + ")"));
        EXPECT_EQ(made.errors(), "");
        std::vector<double> found;
        for (const Motion& move : made.moves) {
            if (std::holds_alternative<Arc>(move.action)) found.push_back(move.feed);
        }
        EXPECT_FALSE(found.empty());
        return found;
    };
    for (const double feed : feeds("0.5"))
        EXPECT_EQ(feed, 0.5);
    for (const double feed : feeds("0"))
        EXPECT_EQ(feed, 500.0);
}

TEST(SinumerikLimits, BranchesOfIfInLoops) {
    // IF with and without ELSE, five characters apart, as often as the loop repeats.
    const std::string loop =
        "FOR R1=1 TO 4\nIF R1>2\nX=IC(10)\nELSE\nY=IC(1)\nENDIF\nIF R1==3\n"
        "X=IC(100)\nENDIF\nENDFOR";
    sinumerik_test::expect_end(sinumerik_test::run(sinumerik("G1 F100\n" + loop)), 120, 2, 50);
}

}  // namespace
}  // namespace ncsim::gcode
