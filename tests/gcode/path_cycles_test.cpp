// SPDX-License-Identifier: GPL-3.0-or-later
//
// Slots on a circle, faces, paths along contours, polygons, threads and deep holes of Klartext and
// SINUMERIK: the path or the area that is swept is the same as of a program by hand.
#include "gcode/klartext_made.h"
#include "gcode/sinumerik_made.h"
#include "gcode/swept_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ncsim::gcode::path_cycles_test {
namespace {

using klartext_test::klartext;
using language_test::Files;
using sinumerik_test::sinumerik;
using namespace swept_area;

Made cut(const std::string& blocks, const Files& files = {}) {
    return sinumerik_test::run(sinumerik(blocks), files);
}

/// Compares the moves of a cycle with those of a program by hand.
void expect_by_hand(const std::string& cycle, const std::string& by_hand, const Files& files = {}) {
    language_test::expect_close(cut(cycle, files), cut(by_hand));
}

Distance smallest(std::vector<Distance> areas) {
    return [areas = std::move(areas)](double x, double y) {
        double least = std::numeric_limits<double>::max();
        for (const Distance& area : areas)
            least = std::min(least, area(x, y));
        return least;
    };
}

// --- SINUMERIK: slots ---

/// Slots that point outwards; `inner`: distance of their inner ends from (2, 1).
Distance star(double length, double width, double inner, double first, int count) {
    std::vector<Distance> slots;
    for (int i = 0; i < count; ++i) {
        const double angle = first + i * 360.0 / count;
        const SinCos at = sin_cos(angle);
        const double middle = inner + length / 2.0;
        slots.push_back(rectangle(length, width, width / 2.0, angle, 2.0 + middle * at.cos,
                                  1.0 + middle * at.sin));
    }
    return smallest(std::move(slots));
}

TEST(SinumerikSlots, Slot1) {
    const Distance slots = star(20.0, 14.0, 8.0, 20.0, 3);
    // VARI: complete with infeeds at feed, along ramps; roughing, then finishing.
    const std::string slot = "SLOT1(20,0,2,-10,,3,20,14,2,1,8,20,120,150,500,4,0,0.3,";
    expect_swept(cut(slot + "10,10,400,1200)"), slots, -10.0, 32.0);
    expect_swept(cut(slot + "30,10,400,1200,0.2)"), slots, -10.0, 32.0);
    expect_swept(cut(slot + "11)\n" + slot + "12)"), slots, -10.0, 32.0);
    expect_swept(cut(slot + "11)"), star(19.4, 13.4, 8.3, 20.0, 3), -10.0, 32.0);
    const Made r = cut(slot + "10)");
    EXPECT_TRUE(r.says("slot-position"));
    EXPECT_NEAR(r.end().z.mm(), 20.0, 1e-9);
    // Without INDA the slots share the circle.
    EXPECT_EQ(r.texts, cut("SLOT1(20,0,2,,10,3,20,14,2,1,8,20,,150,500,4,0,0.3,10)").texts);
}

TEST(SinumerikSlots, Slot1OfNewerVersionsHasItsMiddle) {
    const std::string modes = "150,500,4,0,0,10,0,,,0,30,0,0,0,0,";
    const Made r = cut("SLOT1(20,0,2,-10,,1,30,14,3,-2,0,25,0," + modes + "0,1,2)");
    expect_swept(r, rectangle(30.0, 14.0, 7.0, 25.0, 3.0, -2.0), -10.0, 30.0);
    EXPECT_EQ(cut("SLOT1(20,0,2,-10,,2,30,14,3,-2,9,25,0," + modes + "0,1,2)").errors(),
              "5:1: SLOT1 with _GMODE and several slots is not read; the program is stopped here "
              "[not-read]\n");
}

TEST(SinumerikSlots, LongholeIsASlotAsWideAsTheTool) {
    expect_swept(cut("LONGHOLE(20,0,2,-10,,4,20,2,1,8,20,0,150,500,4)"),
                 star(20.0, 10.0, 8.0, 20.0, 4), -10.0, 32.0);
    expect_by_hand("LONGHOLE(20,0,2,-5,,1,30,0,0,10,0,0,100,500,0)",
                   "G0 X25\nZ2\nG1 Z-5 F100\nX15 F500\nX35\nX25\nG0 Z-3\nZ2\nZ20");
}

TEST(SinumerikSlots, Slot2) {
    const std::string slot = "SLOT2(20,0,2,-10,,2,70,14,0,0,25,10,180,150,500,4,2,0.2,";
    const Distance slots = smallest({band(25.0, 14.0, 10.0, 70.0), band(25.0, 14.0, 190.0, 70.0)});
    expect_swept(cut(slot + "0,0,400)"), slots, -10.0, 36.0);
    // The tool moves from slot to slot along the circle, above the part.
    const Made arcs = cut(slot + "10,0,400,,600)");
    expect_swept(arcs, slots, -10.0, 36.0);
    EXPECT_TRUE(std::ranges::any_of(arcs.moves, [](const Motion& motion) {
        return std::holds_alternative<Arc>(motion.action) && end_of(motion)->z.mm() == 20.0;
    }));
}

TEST(SinumerikSlots, Faults) {
    const auto errors = [](const std::string& block) { return cut(block).errors(); };
    EXPECT_EQ(errors("SLOT1(20,0,2,-10,,0,30,14,2,1,12,20,120,150,500,4,0,0,10)"),
              "5:1: SLOT1 needs a number of slots (NUM) from 1 to 10000; the program is stopped "
              "here [word-missing]\n");
    EXPECT_EQ(errors("SLOT1(20,0,2,-10,,1,30,8,2,1,12,20,120,150,500,4,0,0,10)"),
              "5:1: SLOT1 needs a width of at least the tool and the allowances; the program is "
              "stopped here [word-missing]\n");
    EXPECT_EQ(errors("SLOT1(20,0,2,-10,,1,30,14,2,1,12,20,120,150,500,4,0,0,24)"),
              "5:1: SLOT1 with this VARI is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(errors("SLOT1(20,0,2,-10,,1,30,14,2,1,12,20,120,150,500,4,5,0,10)"),
              "5:1: SLOT1 needs a direction (CDIR) from 0 to 3; the program is stopped here "
              "[word-missing]\n");
    EXPECT_EQ(errors("SLOT1(20,0,2,-10,,9000,30,14,2,1,12,20,1,150,500,0.01,0,0,10)"),
              "5:1: the number of repeats must be 1 or more, and not without end "
              "[cycle-repeats]\n");
    EXPECT_EQ(errors("LONGHOLE(20,0,2,-10,,1,9,2,1,12,20,0,150,500,4)"),
              "5:1: LONGHOLE needs a length (LENG) of at least the width of the slot; the program "
              "is stopped here [word-missing]\n");
    EXPECT_EQ(errors("SLOT2(20,0,2,-10,,2,0,14,0,0,25,10,180,150,500,4,2,0,0)"),
              "5:1: SLOT2 needs an angle (AFSL), a width (WID) and a radius (RAD) above 0; the "
              "program is stopped here [word-missing]\n");
}

// --- SINUMERIK: faces ---

TEST(SinumerikFaces, VariantsOfCycle71) {
    EXPECT_TRUE(cut("CYCLE71(20,0,2,-2,0,0,10,8,0,1,10,3,0.5,500,22,0)").says("mills-outside"));
    EXPECT_EQ(cut("CYCLE71(20,0,2,-2,0,0,10,8,0,1,10,3,0.5,500,51,0)").errors(),
              "5:1: CYCLE71 with this _VARI is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(cut("CYCLE71(20,0,2,-2,0,0,0,8)").errors(),
              "5:1: CYCLE71 with this _VARI is not read; the program is stopped here [not-read]\n");
}

// --- SINUMERIK: contours ---

/// An open contour: right, up, an arc to the left.
const Files kOpen{{"K1.SPF", "G1 X10 Y10\nX30\nY25\nG3 X22 Y33 CR=8\nM17\n"}};

std::string path(const std::string& arguments) {
    return "CYCLE72(\"K1\",20,0,2,-4," + arguments + ")";
}

TEST(SinumerikContours, Cycle72EqualsG41) {
    const std::string contour = "X30\nY25\nG3 X22 Y33 CR=8\nG40 G1 X9 ";
    for (const auto& [side, start, end] :
         {std::array{"41", "15", "28"}, std::array{"42", "5", "38"}}) {
        const Made cycle = cut(path("0,0,0,300,100,2," + std::string(side) + ",1,8,500"), kOpen);
        const Made by_hand = cut("G0 X-3 Y" + std::string(start) + "\nZ2\nG1 Z-4 F100\nG" + side +
                                 " X10 Y10 F300\n" + contour + "Y" + end + "\nG0 Z20");
        const auto ends = [](const Made& made) {
            std::vector<std::array<double, 3>> all;
            for (const Motion& motion : made.moves) {
                const Position& p = *end_of(motion);
                const std::array<double, 3> at{std::round(p.x.mm() * 1e6) + 0.0,
                                               std::round(p.y.mm() * 1e6) + 0.0,
                                               std::round(p.z.mm() * 1e6) + 0.0};
                if (all.empty() || all.back() != at) all.push_back(at);
            }
            return all;
        };
        EXPECT_EQ(by_hand.errors(), "");
        EXPECT_EQ(ends(cycle), ends(by_hand)) << side;
    }
}

TEST(SinumerikContours, RoughingLeavesTheAllowances) {
    const Made r = cut(path("2,0.3,0.5,300,100,101,42,2,8,500"), kOpen);
    EXPECT_EQ(r.errors(), "");
    EXPECT_TRUE(r.says("contour-lead"));
    double lowest = 0.0;
    double nearest = 1e9;
    std::vector<Point> points;
    for (const Motion& motion : r.moves) {
        lowest = std::min(lowest, end_of(motion)->z.mm());
        add_path(points, motion, -3.5);
    }
    EXPECT_NEAR(lowest, -3.5, 1e-9);
    for (const Point& p : points) {
        if (p.x < 10.0 || p.x > 30.0 || p.y > 9.0) continue;
        nearest = std::min(nearest, 10.0 - p.y);
    }
    EXPECT_NEAR(nearest, 5.3, 1e-9);
}

TEST(SinumerikContours, BlocksBetweenLabelsAreAContour) {
    const std::string arguments = ",20,0,2,-4,2,0,0,300,100,102,41,1,8,500)\n";
    const std::string labels = "CYCLE72(\"FIRST:LAST\"" + arguments +
                               "GOTOF BEHIND\nFIRST: G1 X10 Y10\nX30\nY25\nLAST: G3 X22 Y33 "
                               "CR=8\nX99 Y99\nBEHIND:";
    const Made made = cut(labels);
    EXPECT_EQ(made.errors(), "");
    EXPECT_EQ(made.texts, cut("CYCLE72(\"K1\"" + arguments, kOpen).texts);
    // Variables of the program are known, and a contour may start at the zero.
    expect_by_hand(
        "R1=20\nGOTOF BEHIND\nFIRST: G1 X0 Y0\nLAST: X=R1\nBEHIND:\n"
        "CYCLE72(\"FIRST:LAST\",20,0,2,-4,0,0,0,300,100,2,40,1,8,500)",
        "R1=20\nG0 X-8\nZ2\nG1 Z-4 F100\nX0 F300\nX20\nX28\nG0 Z20");
}

TEST(SinumerikContours, MissingContourIsLeftOutWithADoubt) {
    const Made r = cut("G1 X1 F100\n" + path("0,0,0,300,100,2,41,1,8,500") + "\nY1");
    language_test::expect_end(r, 1, 1, 50);
    EXPECT_TRUE(r.says("program-not-found"));
}

TEST(SinumerikContours, Faults) {
    const auto errors = [](const std::string& block, const std::string& contour) {
        return cut(block, {{"K1.SPF", contour}}).errors();
    };
    const std::string good = "G1 X10 Y10\nX30\n";
    const auto error = [&](const std::string& rest) {
        return errors(path("0,0,0,300,100," + rest), good);
    };
    EXPECT_EQ(error("2,41,4,8,500"),
              "5:1: CYCLE72 with this approach (_AS1, _AS2) is not read; the program is stopped "
              "here [not-read]\n");
    EXPECT_EQ(error("2,40,2,8,500"),
              "5:1: CYCLE72 needs lines (_AS1 1) with _RL 40; the program is stopped here "
              "[word-missing]\n");
    EXPECT_EQ(error("2,43,2,8,500"),
              "5:1: CYCLE72 needs _RL of 40, 41 or 42; the program is stopped here "
              "[word-missing]\n");
    EXPECT_EQ(error("5,41,2,8,500"),
              "5:1: CYCLE72 with this _VARI is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(error("2,41,2,0,500"),
              "5:1: CYCLE72 needs a length of the approach (_LP1) above 0; the program is stopped "
              "here [word-missing]\n");
    EXPECT_EQ(errors("CYCLE72(1,20,0,2,-4)", good),
              "5:1: CYCLE72 needs the name of a contour (_KNAME); the program is stopped here "
              "[word-missing]\n");
    const std::string cycle = path("0,0,0,300,100,2,41,1,8,500");
    EXPECT_EQ(errors(cycle, "G1 X10\nY10\nX30\n"),
              "5:1: K1 needs a line to a point, and lines or arcs behind; the program is stopped "
              "here [word-missing]\n");
    EXPECT_EQ(errors(cycle, "G1 X10 Y10\nTRANS X5\nX30\n"),
              "2:1: a frame in a contour is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(errors(cycle, "G1 X10 Y10\n" + cycle + "\n"),
              "2:1: CYCLE72 in a contour is not read; the program is stopped here [not-read]\n");
    EXPECT_EQ(errors("CYCLE72(\"A:B\",20,0,2,-4,0,0,0,300,100,2,41,1,8,500)", good),
              "5:1: there is no label A; the program is stopped here [label-missing]\n");
    EXPECT_TRUE(cut(cycle, {{"K1.SPF", "G1 X10 Y10\nA: X30\nGOTOB A\n"}}).says("step-limit"));
}

// --- Klartext ---

Made milled(const std::string& definition) {
    return klartext_test::run(klartext("CYCL DEF " + definition + "\nL X+0 Y+0 FMAX M99"));
}

TEST(KlartextPaths, PolygonStud) {
    const std::string depths =
        " Q207=500 Q351=+1 Q201=-10 Q202=4 Q206=150 Q200=2 Q203=+0 Q204=20 Q370=1 Q368=0";
    const auto hexagon = [](double inner, double corner, double degrees) {
        return [=](double x, double y) {
            // Sides are at the angles between the corners.
            double most = -1e9;
            double sharp = 1e9;
            for (int i = 0; i < 6; ++i) {
                const SinCos side = sin_cos(degrees + 30.0 + 60.0 * i);
                most = std::max(most, x * side.cos + y * side.sin - (inner - corner));
                const SinCos at = sin_cos(degrees + 60.0 * i);
                const double to = (inner - corner) / sin_cos(30.0).cos;
                // Outside of two sides the corner is nearest.
                const SinCos before = sin_cos(degrees + 60.0 * i - 30.0);
                const SinCos behind = sin_cos(degrees + 60.0 * i + 30.0);
                const double u = x - to * at.cos;
                const double v = y - to * at.sin;
                const bool is_at_corner = before.cos * v - before.sin * u >= 0.0 &&
                                          behind.cos * v - behind.sin * u <= 0.0;
                if (is_at_corner) sharp = std::min(sharp, hypotenuse(u, v));
            }
            return (sharp < 1e9 ? sharp : most) - corner;
        };
    };
    for (const std::string corner : {"0", "3"}) {
        const Made r =
            milled("258 STUD Q573=0 Q571=40 Q222=60 Q572=6 Q224=10 Q220=" + corner + depths);
        EXPECT_EQ(r.errors(), "");
        EXPECT_TRUE(r.says("mills-outside"));
        EXPECT_TRUE(r.says("corner-direction"));
        const Distance stud = hexagon(20.0, std::stod(corner), 10.0);
        std::vector<Point> path;
        for (const Motion& motion : r.moves)
            add_path(path, motion, -10.0);
        double nearest = 1e9;
        for (const Point& p : path)
            nearest = std::min(nearest, stud(p.x, p.y));
        EXPECT_NEAR(nearest, kRadius, 1e-3);
        // The blank is gone.
        for (double x = -30.0; x <= 30.0; x += 0.93) {
            for (double y = -30.0; y <= 30.0; y += 0.93) {
                if (stud(x, y) < 0.02 || hypotenuse(x, y) > 30.0) continue;
                EXPECT_TRUE(std::ranges::any_of(
                    path, [&](const Point& p) { return hypotenuse(p.x - x, p.y - y) <= kRadius; }))
                    << x << ' ' << y;
            }
        }
    }
    // The circle through the corners: the sides are nearer.
    const Made outer = milled("258 STUD Q573=1 Q571=40 Q222=60 Q572=4 Q224=0 Q220=0" + depths);
    double nearest = 1e9;
    for (const Motion& motion : outer.moves) {
        const Position& end = *end_of(motion);
        if (end.z.mm() == -10.0)
            nearest = std::min(nearest, std::abs(end.x.mm()) + std::abs(end.y.mm()));
    }
    EXPECT_NEAR(nearest, 20.0 + kRadius, 1e-6);  // A corner.
    EXPECT_EQ(milled("258 STUD Q571=40 Q222=45 Q572=6 Q220=0" + depths).errors(),
              "5:1: cycle 258 needs a blank (Q222) of at least the size of the stud; the program "
              "is stopped "
              "here [word-missing]\n");
    EXPECT_EQ(milled("258 STUD Q571=40 Q222=60 Q572=2 Q220=0" + depths).errors(),
              "5:1: cycle 258 needs a number of corners (Q572) from 3 to 1000; the program is "
              "stopped here [word-missing]\n");
    EXPECT_EQ(milled("258 STUD Q571=40 Q222=60 Q572=6 Q220=-1" + depths).errors(),
              "5:1: cycle 258 with a chamfer (Q220) is not read; the program is stopped here "
              "[klartext-verb]\n");
}

TEST(KlartextPaths, OutsideThreadWithoutADepth) {
    const std::string thread = "267 THREAD Q335=20 Q239=+1.5 Q200=2 Q207=500 Q355=0 Q201=";
    EXPECT_TRUE(milled(thread + "+6").says("depth-positive"));
    EXPECT_TRUE(milled(thread + "0").says("depth-zero"));
}

/// A program with cycle 25 and the contour LBL 1.
std::string train(const std::string& values, const std::string& contour) {
    return "BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\nCYCL DEF 14.0 CONTOUR\n"
           "CYCL DEF 14.1 CONTOUR LABEL1\nCYCL DEF 25 CONTOUR TRAIN ~\n Q1=-4 ~\n Q5=+0 ~\n Q7=+20 "
           "~\n Q11=100 ~\n Q12=300 ~\n " +
           values + "\nCYCL CALL\nM30\nLBL 1\n" + contour + "\nLBL 0\nEND PGM T MM\n";
}

TEST(KlartextPaths, ContourTrainFaults) {
    const auto errors = [](const std::string& program) {
        return klartext_test::run(program).errors();
    };
    const std::string contour = "L X+10 Y+10 RL\nL X+30";
    EXPECT_EQ(errors(train("Q3=+0 Q18=1", contour)),
              "13:1: cycle 25 with a coarse tool (Q18) is not read; the program is stopped here "
              "[klartext-verb]\n");
    EXPECT_EQ(errors(train("Q3=+0", "APPR LT X+10 Y+10 LEN5 RL\nL X+30")),
              "16:1: APPR LT in a contour is not read; the program is stopped here "
              "[klartext-verb]\n");
    EXPECT_EQ(errors(train("Q3=+0", "L X+10 Y+10 RL\nL X+30\nDEP LT LEN5")),
              "18:1: DEP LT in a contour is not read; the program is stopped here "
              "[klartext-verb]\n");
    EXPECT_EQ(milled("25 TRAIN Q1=-4 Q5=0 Q7=20 Q12=300").errors(),
              "5:1: cycle 25 needs cycle 14 with one contour before; the program is stopped here "
              "[word-missing]\n");
}

}  // namespace
}  // namespace ncsim::gcode::path_cycles_test
