// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tilted planes, and the words that turn the tool perpendicular to the planes, with a machine that
// is given by formulas.
#include "ncsim/base/angles.h"
#include "ncsim/gcode/interpreter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

// Machine with a table A that turns the part about a line along X through Y0 Z-10, with signs of
// ISO 841: relative to the part the tool turns by A.
class ATable : public JointSolver {
public:
    bool turns() const override { return true; }
    TipPose tip_pose(const Axes& joints, double /*length_mm*/) const override {
        const FeatureFrame turn = turn_about(0, joints[kA]);
        Triple tip = turn.direction_to_parent({joints[kX], joints[kY], joints[kZ] + 10.0});
        tip[2] -= 10.0;
        return {tip, turn.direction_to_parent({0, 0, 1})};
    }
    std::optional<Axes> joints_for(const Triple& tip, const Axes& joints,
                                   double /*length_mm*/) const override {
        const Triple at =
            turn_about(0, -joints[kA]).direction_to_parent({tip[0], tip[1], tip[2] + 10.0});
        Axes out = joints;
        out[kX] = at[0], out[kY] = at[1], out[kZ] = at[2] - 10.0;
        return out;
    }
    Triple rotate_with_table(const Triple& v, const Axes& from, const Axes& to) const override {
        return turn_about(0, from[kA] - to[kA]).direction_to_parent(v);
    }
    Solution joints_for_direction(const Triple& axis, const Axes& joints, Way way) const override {
        if (std::abs(axis[0]) > 1e-9) return {std::nullopt, false, "it turns about X alone"};
        Axes out = joints;
        out[kA] = angle_of(axis[2], -axis[1]);
        if (way == Way::Up && out[kA] < joints[kA]) out[kA] += 360.0;
        if (way == Way::Down && out[kA] > joints[kA]) out[kA] -= 360.0;
        return {out, false, {}};
    }
};

struct Made {
    std::vector<Motion> moves;
    Interpretation result;

    bool says(const std::string& code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [&](const Diagnostic& d) { return d.code == code; });
    }
    bool fails() const {
        return std::ranges::any_of(
            result.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::Error; });
    }
    const Position& end(std::size_t back = 0) const {
        return *end_of(moves[moves.size() - 1 - back]);
    }
};

Made run(const std::string& program, Dialect dialect = Dialect::Fanuc, bool specified = true,
         const TableOffsets& offsets = {}) {
    InterpreterOptions options;
    options.fixture_offsets = options.setting_errors = offsets;
    if (specified) options.joints = std::make_shared<ATable>();
    options.tip_control = {{{428, Coordinates::Tip}, {429, Coordinates::Axes}}, true, true};
    options.dialect = dialect;
    options.tools.push_back(
        {.number = 1, .offset = {}, .length_specified = true, .diameter = Length::from_mm(4.0)});
    Made made;
    made.result = interpret({"t.nc", "G21 G90 G17 G94 F100\nG0 X0 Y0 Z0\n" + program}, options,
                            [&](const Motion& motion) {
                                if (start_of(motion)) made.moves.push_back(motion);
                            });
    return made;
}

void expect_at(const Position& p, double x, double y, double z, double near = 1e-9) {
    EXPECT_NEAR(p.x.mm(), x, near);
    EXPECT_NEAR(p.y.mm(), y, near);
    EXPECT_NEAR(p.z.mm(), z, near);
}

// Origin of a plane, and the positions of X1, Y1 and Z1 relative to the origin: the axes.
struct Seen {
    Triple origin, x, y, z;
};
Seen seen(const std::string& plane, Dialect dialect = Dialect::Fanuc) {
    // LinuxCNC combines the plane with the word that turns the tool, which only a rotation by A
    // would permit here.
    const Made made = run(plane + "\nG0 X0 Y0 Z0\nG0 X1\nG0 X0 Y1\nG0 Y0 Z1\n", dialect);
    EXPECT_FALSE(made.fails()) << plane;
    const auto at = [&](std::size_t back) {
        const Position& p = made.end(back);
        return Triple{p.x.mm(), p.y.mm(), p.z.mm()};
    };
    Seen all{at(3), at(2), at(1), at(0)};
    for (Triple* axis : {&all.x, &all.y, &all.z}) {
        for (std::size_t i = 0; i < 3; ++i)
            (*axis)[i] -= all.origin[i];
    }
    return all;
}

void expect_triple(const Triple& a, const Triple& b, double near = 1e-9) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], near) << i;
}

TEST(TiltedPlane, OfEulerAnglesAboutZThenXThenZ) {
    const Seen plane = seen("G68.2 X10 Y20 Z-5 I30 J40 K-20");
    expect_triple(plane.origin, {10, 20, -5});
    expect_triple(plane.x, {0.944798996, 0.242945377, -0.219846310});
    expect_triple(plane.z, {0.321393805, -0.556670399, 0.766044443});
}

TEST(TiltedPlane, OfRollPitchAndYawAboutAxesThatStay) {
    // PLANE SPATIAL A45 B0 C90 in the language of Heidenhain: rows (0 -s s)(1 0 0)(0 s s).
    const Seen plane = seen("G68.2 P1 Q123 I45 J0 K90");
    const double s = std::sqrt(0.5);
    expect_triple(plane.x, {0, 1, 0});
    expect_triple(plane.y, {-s, 0, s});
    expect_triple(plane.z, {s, 0, s});
    // In the reverse order, about Z first.
    const Seen other = seen("G68.2 P1 Q321 I45 J0 K90");
    expect_triple(other.x, {0, s, s});
    // In the syntax of Haas, whose default order is the same.
    expect_triple(seen("G268 X0 Y0 Z0 I45 J0 K90", Dialect::Haas).x, {0, s, s});
}

TEST(TiltedPlane, ThroughThreePoints) {
    const std::string points =
        "G68.2 P2 Q1 X1 Y2 Z3\nG68.2 P2 Q2 X1 Y12 Z3\nG68.2 P2 Q3 X1 Y2 Z8\n";
    const Seen plane = seen(points);
    expect_triple(plane.origin, {1, 2, 3});
    expect_triple(plane.x, {0, 1, 0});
    expect_triple(plane.y, {0, 0, 1});
    expect_triple(plane.z, {1, 0, 0});
    // With a shift and a rotation in the plane.
    const Seen shifted = seen("G68.2 P2 Q0 X4 Y5 Z6 R90\n" + points);
    expect_triple(shifted.origin, {7, 6, 8});
    expect_triple(shifted.x, {0, 0, 1});
}

TEST(TiltedPlane, OfTwoVectors) {
    const Seen plane = seen("G68.2 P3 Q1 X1 Y2 Z3 I0 J5 K0\nG68.2 P3 Q2 I3 J0 K0\n");
    expect_triple(plane.origin, {1, 2, 3});
    expect_triple(plane.x, {0, 1, 0});
    expect_triple(plane.z, {1, 0, 0});
    EXPECT_TRUE(run("G68.2 P3 Q1 I1 J1 K0\nG68.2 P3 Q2 I1 J0 K0\n").says("plane-form"));
}

TEST(TiltedPlane, OfProjectedAngles) {
    const Seen plane = seen("G68.2 P4 I0 J30 K0");
    expect_triple(plane.x, {1, 0, 0});
    expect_triple(plane.z, {0, -0.5, std::sqrt(0.75)});
    const Seen both = seen("G68.2 P4 I45 J45 K0");
    const double s = std::sqrt(0.5), third = std::sqrt(1.0 / 3);
    expect_triple(both.x, {s, 0, -s});
    expect_triple(both.z, {third, -third, third});
}

TEST(TiltedPlane, OfTheRemapsOfLinuxCnc) {
    const auto turned = [](const std::string& plane, double a) {
        const Made made = run(plane + "\nG53.1\n", Dialect::Rs274);
        EXPECT_FALSE(made.fails()) << plane;
        EXPECT_NEAR(made.end().a.degrees(), a, 1e-9) << plane;
    };
    turned("G68.2 Q121 I30 J0 K10", 40.0);
    turned("G68.2 P1 Q123 I-45 J0 K0", -45.0);
    turned("G68.2 P1 Q321 I0 J0 K-45", -45.0);  // the third rotation is about X
    turned("G68.2 I90 J20 K0 R-90", 20.0);      // R before all rotations, about Z
    turned("G68.2 P2 X1 Y2 Z3\nG68.2 P2 Q1\nG68.2 P2 Q2 X1\nG68.2 P2 Q3 Y1 Z1", 45.0);
    // The vector of X is given as a point.
    turned("G68.2 P3 Q0 X5 I6\nG68.2 P3 Q1 J-1 K1", 45.0);
    turned("G68.2 J20\nG68.4 J25", 45.0);
    EXPECT_TRUE(run("G68.2 Q123 I5", Dialect::Rs274).says("plane-form"));
    EXPECT_TRUE(run("G68.2 P4 I5", Dialect::Rs274).says("plane-form"));
    EXPECT_TRUE(run("G68.4 I5", Dialect::Rs274).says("plane-form"));
}

TEST(TiltedPlane, OfLinuxCncWaitsForTheWordThatTurnsTheTool) {
    const Made made = run("G68.2 Z5 J90\nG0 X1 Y2 Z3\nG53.6\nG0 X0 Y0 Z7\n", Dialect::Rs274);
    expect_at(made.end(2), 1, 2, 3);
    expect_at(made.end(1), 1, 2, 3);  // the tip stays
    EXPECT_EQ(made.end(1).a.degrees(), 90.0);
    expect_at(made.end(), 0, -7, 5);
    const Made moved = run("G68.2 Z5 J90\nG53.3 X1 Y2 Z7\n", Dialect::Rs274);
    ASSERT_EQ(moved.moves.size(), 2U);
    expect_at(moved.end(), 1, -7, 7);
    EXPECT_EQ(moved.end().a.degrees(), 90.0);
}

TEST(TiltedPlane, TurnsTheToolWithTheLinearAxesAtRest) {
    const Made made = run("G0 X5 Y0 Z40\nG68.2 Z0 J90\nG53.1\nG0 Z30\nG1 Z-2\nG69\nG0 X0\n");
    EXPECT_FALSE(made.fails());
    ASSERT_EQ(made.moves.size(), 6U);
    // A turns by 90: the linear axes do not move.
    EXPECT_EQ(made.moves[2].coordinates, Coordinates::Axes);
    expect_at(made.end(3), 5, 0, 40);
    EXPECT_EQ(made.end(3).a.degrees(), 90.0);
    // On the part the position is Y-50 Z-10 with X still 5; from there the tool moves along the
    // tool axis.
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.moves[3].known_start, (KnownAxes{true, true, true}));
    expect_at(*start_of(made.moves[3]), 5, -50, -10);
    expect_at(made.end(2), 5, -30, -10);
    expect_at(made.end(1), 5, 2, -10);
    // Afterwards the numbers are axis positions again: 12 mm below the axis of A, Y0.
    EXPECT_EQ(made.moves[5].coordinates, Coordinates::Axes);
    expect_at(*start_of(made.moves[5]), 5, 0, -12);
    EXPECT_TRUE(made.result.requested_tip_positions);
}

TEST(TiltedPlane, KeepsWhatWorksInAPlane) {
    const std::string tilted = "G0 X0 Y0 Z40\nG68.2 X1 Y2 Z3 J90\nG53.1\n";
    // A cycle drills along Z of the plane, which is -Y.
    const Made drilled = run(tilted + "G98 G81 X4 Y5 Z-6 R2\nG80\n");
    EXPECT_FALSE(drilled.fails());
    ASSERT_GE(drilled.moves.size(), 4U);
    expect_at(drilled.end(1), 5, 8, 8);
    // An arc in the plane.
    const Made round = run(tilted + "G0 X10 Y0 Z0\nG3 X0 Y10 I-10\nG2 I0 J-10 Z-1\n");
    const auto& arc = std::get<Arc>(round.moves[round.moves.size() - 2].action);
    ASSERT_TRUE(arc.tilted);
    expect_at(arc.to, 1, 2, 13);
    expect_triple(arc.tilted->origin, {1, 2, 3});
    EXPECT_EQ(arc.centre_1.mm(), 0.0);
    const Arc own = in_own_frame(arc);
    expect_at(own.from, 10, 0, 0);
    expect_at(own.to, 0, 10, 0);
    const Arc turn = in_own_frame(std::get<Arc>(round.moves.back().action));
    expect_at(turn.from, 0, 10, 0);
    expect_at(turn.to, 0, 10, -1);
    // Cutter compensation offsets by the radius within the plane.
    const Made aside = run(tilted + "G0 X-20 Y-20 Z0\nG41 D1 G1 X0 Y0\nX30\nG40 Y20\n");
    EXPECT_FALSE(aside.fails());
    EXPECT_TRUE(std::ranges::any_of(aside.moves, [](const Motion& m) {
        return std::abs(end_of(m)->z.mm() - 5.0) < 1e-9 && end_of(m)->x.mm() > 20.0;
    }));
    // A shift in the plane, and an earlier shift.
    expect_at(run(tilted + "G52 X3 Y4\nG0 X0 Y0 Z0\n").end(), 4, 2, 7);
    expect_at(run("G52 X100 Z7\n" + tilted + "G0 X0 Y0 Z0\n").end(), 101, 2, 10);
    expect_at(run(tilted + "G52 X3\nG53 G0 Z60\nG0 X0 Y0 Z0\nG69\nG52 X0\n").end(), 4, 2, 3);
    expect_at(run("G52 X100\n" + tilted + "G52 X3\nG69\nG0 A0\nG0 X0 Y0 Z0\n").end(), 100, 0, 0);
    // A rotation in the plane, and inches.
    expect_at(run(tilted + "G68 X0 Y0 R90\nG0 X3 Y0 Z0\n").end(), 1, 2, 6);
    expect_at(run(tilted + "G20\nG0 X1 Y0 Z0\n").end(), 26.4, 2, 3);
}

TEST(TiltedPlane, PlacesOfTheMachineAreThoseOfItsJoints) {
    const Made made = run("G0 X5 Y0 Z40\nG68.2 J90\nG53.1\nG0 X0 Y0 Z5\nG53 G0 Z60\nG0 X1 Y1 Z5\n");
    EXPECT_FALSE(made.fails());
    const Motion& up = made.moves[made.moves.size() - 2];
    EXPECT_EQ(up.coordinates, Coordinates::Axes);
    EXPECT_EQ(end_of(up)->z.mm(), 60.0);
    expect_at(made.end(), 1, -5, 1);
    const Made home = run("G0 X5 Y0 Z40\nG68.2 J90\nG53.1\nG0 X0 Y0 Z5\nG91 G28 Z0\nG90 G0 X1\n");
    EXPECT_EQ(home.moves[home.moves.size() - 2].coordinates, Coordinates::Axes);
    EXPECT_EQ(home.end(1).z.mm(), 0.0);
    EXPECT_EQ(home.moves.back().known_start, (KnownAxes{true, true, true}));
}

TEST(TiltedPlane, RotaryWordsInItMoveTheJoints) {
    // In place of G53.1.
    const Made made = run("G0 X5 Y0 Z40\nG68.2 J90\nG0 A90\nG0 X0 Y0 Z5\n");
    EXPECT_EQ(made.moves[2].coordinates, Coordinates::Axes);
    expect_at(made.end(1), 5, 0, 40);
    expect_at(made.end(), 0, -5, 0);
    const Made both = run("G0 X5 Y0 Z40\nG68.2 J90\nG0 X0 Y0 Z5 A90\nG1 Z4\n");
    EXPECT_EQ(both.moves[2].coordinates, Coordinates::Axes);
    expect_at(*start_of(both.moves[3]), 0, -5, 0);
    expect_at(both.end(), 0, -4, 0);
}

TEST(TiltedPlane, FollowsTheToolWhereItStands) {
    const Made made = run("G0 X5 Y0 Z40 A90\nG68.3\nG0 X0 Y0 Z1\n");
    EXPECT_FALSE(made.fails());
    expect_at(made.end(), 5, -51, -10);
    // X horizontal: along +X of the part, because Z points to -Y. R rotates X.
    expect_at(run("G0 X5 Y0 Z40 A90\nG68.3 X0 Y0 Z0\nG0 X2 Y0 Z0\n").end(), 2, 0, 0);
    expect_at(run("G0 X5 Y0 Z40 A90\nG68.3 X0 Y0 Z0 R90\nG0 X2 Y0 Z0\n").end(), 0, 0, 2);
    EXPECT_TRUE(run("G68.3 X0\n").says("plane-form"));
}

TEST(TiltedPlane, WhatCannotBeIsAnErrorByName) {
    EXPECT_TRUE(run("G68.2 J90\n", Dialect::Fanuc, false).says("kinematics"));
    EXPECT_TRUE(run("G68.2 J90\n", Dialect::Fanuc, false).result.stopped);
    EXPECT_TRUE(run("G53.1\n", Dialect::Fanuc, false).says("kinematics"));
    EXPECT_TRUE(run("G53.1\n").says("plane-form"));
    EXPECT_TRUE(run("G68.2 I90 J30\nG53.1\n").says("unreachable-orientation"));
    EXPECT_TRUE(run("G68.2 P7\n").says("plane-form"));
    EXPECT_TRUE(run("G68.2 P1 Q7 I5\n").says("plane-form"));
    EXPECT_TRUE(run("G68.2 J20 R5\n").says("plane-form"));
    const std::string line = "G68.2 P2 Q1 X1\nG68.2 P2 Q2 X2\nG68.2 P2 Q3 X3\n";
    EXPECT_TRUE(run(line).says("plane-form"));
    for (const char* block : {"G55", "G92.1", "G10 L2 P1 X5", "G5 X1 Y1 I0 J1 P1 Q1"})
        EXPECT_TRUE(run(std::string("G68.2 J90\nG53.1\n") + block + "\n").says("plane-form"))
            << block;
    EXPECT_FALSE(run("G68.2 J90\nG53.1\nG54\nG0 X1\n").fails());
    EXPECT_TRUE(run("G0 X-20\nG41 D1 G1 X5\nG68.2 J90\n").says("forbidden-with-compensation"));
}

TEST(TiltedPlane, EndsWithTheProgram) {
    const Made made = run("G68.2 J90\nG53.1\nM30\n");
    EXPECT_FALSE(made.fails());
    EXPECT_TRUE(made.result.ended);
}

// --- Offsets that rotate with the table ---

TEST(CarriedZero, GoesWithTheTableAndItsAxesDoNot) {
    // Haas: after A90 the zero is 10 mm in front of the axis: at Y10 Z-10 of the machine.
    const Made made =
        run("G0 Z40\nG0 A90\nG254\nG0 X1 Y0 Z5\nG1 Z-2\nG53 G0 Z60\nG255\nG0 X1 Y0 Z5\n",
            Dialect::Haas);
    EXPECT_FALSE(made.fails());
    ASSERT_EQ(made.moves.size(), 7U);
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Axes);
    expect_at(made.end(3), 1, 10, -5);
    expect_at(made.end(2), 1, 10, -12);
    expect_at(made.end(1), 1, 10, 60);
    expect_at(made.end(0), 1, 0, 5);
    EXPECT_TRUE(run("G0 A90\nG254\nG0 A0\n", Dialect::Haas).says("plane-form"));
    EXPECT_TRUE(run("G0 A90\nG254\n", Dialect::Haas, false).says("kinematics"));
    EXPECT_FALSE(run("G254\nG1 X5\nG255\n", Dialect::Haas).fails());
}

// Returns an offset 20 mm behind the centre of the table at A0; specified at A90, where the offset
// is below the centre.
TableOffsets behind(bool moves) {
    return {{{1, {{0, 0, -20}, {90, 0, 0}, {}}}}, moves};
}

TEST(FixtureOffset, IsTheZeroWhereverTheTableTurnsTo) {
    const auto go = [](const std::string& program, bool moves = true) {
        const Made made = run(program, Dialect::Fanuc, true, behind(moves));
        EXPECT_FALSE(made.fails()) << program;
        return made;
    };
    // The first cut is at X1 Y0 Z5 of the part, which is at Y20 of the machine.
    const Made made = go("G54.2 P1\nG0 X1 Y0 Z5\nG1 Z-2\nG0 A90\nG1 X3\n");
    // W is the position of the part at A0.
    expect_at(made.end(2), 1, 0, -2);
    // The table turns the part by A from Y20 to Z-20, and the tool stays above the part.
    expect_at(made.end(1), 1, -20, -22);
    EXPECT_NEAR(made.end(1).a.degrees(), 90.0, 1e-12);
    expect_at(made.end(0), 3, -20, -22);
    EXPECT_EQ(made.moves.back().coordinates, Coordinates::Axes);
    // If the tool does not follow, its coordinates change: here Z stays at -2.
    const Made stays = go("G54.2 P1\nG0 X1 Y0 Z5\nG1 Z-2\nG0 A90\nG0 X3\nG0 Y0 Z0\n", false);
    expect_at(stays.end(2), 1, 0, -2);
    expect_at(stays.end(1), 3, 0, -2);
    expect_at(stays.end(0), 3, -20, -20);
    // Increments start at the current position.
    expect_at(go("G54.2 P1\nG1 X1 Y0 Z5\nG91 G0 A90 Z1\n").end(), 1, -20, -14);
    expect_at(go("G54.2 P1\nG1 X1 Y0 Z5\nG91 G0 A90 Z1\n", false).end(), 1, 0, 6);
    // Further words in the block of the rotation are relative to the part.
    expect_at(go("G54.2 P1\nG1 X1 Y0 Z5\nG0 A90 Y4\n").end(), 1, -16, -15);
    expect_at(go("G54.2 P1\nG1 X1 Y0 Z5\nG0 A90 Y4\n", false).end(), 1, -16, 5);
    // Inches; and P0 returns to the zero of the system.
    expect_at(go("G54.2 P1\nG20\nG1 X1 Y0 Z0\nG0 A90\n").end(), 25.4, -20, -20);
    expect_at(go("G54.2 P1\nG1 X1 Y0 Z5\nA90\nG54.2 P0\nG1 Y0\n").end(), 1, -20, 5);
}

TEST(FixtureOffset, MovesTheToolByItselfWhereTheControlDoes) {
    const Made moves =
        run("G1 X1 Y0 Z5\nG54.2 P1\nG1 X2\nG54.2 P0\n", Dialect::Fanuc, true, behind(true));
    EXPECT_FALSE(moves.fails());
    ASSERT_EQ(moves.moves.size(), 5U);
    expect_at(moves.end(2), 1, 20, 5);
    EXPECT_EQ(moves.moves[2].kind, MoveKind::Feed);
    expect_at(moves.end(1), 2, 20, 5);
    expect_at(moves.end(0), 2, 0, 5);
    const Made stays =
        run("G1 X1 Y0 Z5\nG54.2 P1\nG1 X2\nG1 Y0\n", Dialect::Fanuc, true, behind(false));
    ASSERT_EQ(stays.moves.size(), 4U);
    expect_at(stays.end(1), 2, 0, 5);
    expect_at(stays.end(0), 2, 20, 5);
}

TEST(FixtureOffset, NothingOfItIsGuessed) {
    TableOffsets nobody;
    EXPECT_TRUE(run("G54.2 P1\n", Dialect::Fanuc, false, behind(true)).says("kinematics"));
    EXPECT_TRUE(run("G54.2 P1\n", Dialect::Fanuc, true, nobody).says("kinematics"));
    EXPECT_TRUE(run("G54.2 P2\n", Dialect::Fanuc, true, behind(true)).says("kinematics"));
    nobody = behind(true);
    nobody.moves.reset();
    EXPECT_TRUE(run("G54.2 P1\n", Dialect::Fanuc, true, nobody).says("kinematics"));
    for (const char* words :
         {"G68.2 J20", "G43.4 H1", "M428", "G53.1", "G28 A0", "G28", "G53 G0 A0",
          "G2 X5 Y0 I2 J0 A3", "G81 X3 Y3 Z-3 R2 A5", "G254", "G12.1", "G41 D1 A5", "G7.1 C20"}) {
        EXPECT_TRUE(
            run(std::string("G54.2 P1\nG1 Z1\n") + words + "\n", Dialect::Fanuc, true, behind(true))
                .fails())
            << words;
    }
    // A cycle that turns the table would not move the zero.
    EXPECT_TRUE(run("G0 A90\nG254\nG81 X3 Y3 Z-3 R2 A5\n", Dialect::Haas).says("plane-form"));
}

// A setting error rotates with the table, too; tip control and tilted planes refer to the part as
// clamped.
TEST(SettingError, IsTheZeroOfThePart) {
    const auto go = [](const std::string& program) {
        const Made made = run(program, Dialect::Fanuc, true, behind(true));
        EXPECT_FALSE(made.fails()) << program;
        return made;
    };
    const Made axes = go("G54.4 P1\nG0 X1 Y0 Z5\nG1 Z-2\nG0 A90\nG1 X3\nG54.4 P0\n");
    expect_at(axes.end(3), 1, 0, -2);
    expect_at(axes.end(2), 1, -20, -22);
    // Positions of the tip are positions on the part at any angle.
    const Made tip =
        go("G54.4 P1\nG1 X1 Y0 Z5\nG43.4 H1\nG1 X2 Y3 Z4 A90\nG1 A30\nG49\nG1 A90\nG1 Y0 Z0\n");
    expect_at(tip.end(3), 2, 3, 4);
    expect_at(tip.end(2), 2, 3, 4);
    EXPECT_EQ(tip.moves[tip.moves.size() - 3].coordinates, Coordinates::Tip);
    EXPECT_EQ(tip.moves.back().coordinates, Coordinates::Axes);
    expect_at(tip.end(0), 2, -20, -20);
    // After a change of mode the tool is at the same position.
    const Made back = go("G54.4 P1\nG1 X1 Y0 Z5 A90\nG43.4 H1\nG49\nG1 X2\n");
    EXPECT_EQ(start_of(back.moves.back())->y.mm(),
              end_of(back.moves[back.moves.size() - 2])->y.mm());
    expect_at(back.end(0), 2, -20, -15, 1e-9);
    const Made plane = go("G54.4 P1\nG1 X1 Y0 Z5\nG68.2 X5 Y6 Z7 J90\nG53.1\nG1 X1 Y2 Z3\nG69\n");
    expect_at(plane.end(0), 6, 3, 9);
    // The home position is a machine position, equal at A90 and at A0.
    expect_at(go("G1 X0 Y0 Z5\nG54.4 P1\nG1 Y0 A90\nG53 G0 Y7 Z8\n").end(), 0, 7, 8);
}

TEST(SettingError, ThatTurnsIsTold) {
    TableOffsets askew = behind(false);
    askew.by_number[1].turns = {0, 0, 0.25};
    const Made about_z = run("G54.4 P1\nG1 X1\n", Dialect::Fanuc, true, askew);
    EXPECT_FALSE(about_z.fails());
    EXPECT_TRUE(about_z.says("setting-error"));
    EXPECT_EQ(about_z.result.setting_askew, 0.25);
    askew.by_number[1].turns = {0, -0.5, 0.25};
    EXPECT_TRUE(run("G54.4 P1\n", Dialect::Fanuc, true, askew).fails());
    askew.axes_take_turns = true;
    const Made leans = run("G54.4 P1\nG1 X1\n", Dialect::Fanuc, true, askew);
    EXPECT_FALSE(leans.fails());
    EXPECT_EQ(leans.result.setting_askew, 0.75);
    EXPECT_EQ(run("G54.2 P1\nG1 X1\n", Dialect::Fanuc, true, behind(true)).result.setting_askew, 0);
    for (const char* words : {"G54.2 P1", "G43.4 H1\nG54.4 P1", "G254", "G28 A0", "G12.1",
                              "G2 X5 Y0 I2 J0 A3", "G41 D1 A5"}) {
        EXPECT_TRUE(
            run(std::string("G54.4 P1\nG1 Z1\n") + words + "\n", Dialect::Fanuc, true, behind(true))
                .fails())
            << words;
    }
    EXPECT_TRUE(run("G54.4 P1\n", Dialect::Fanuc, true).says("kinematics"));
    EXPECT_TRUE(run("G54.4 P1\n", Dialect::Fanuc, false, behind(true)).says("kinematics"));
}

TEST(TipControl, OfHaasIsFixedToTheTableAtZero) {
    const Made made = run("G0 X1 Y0 Z40 A90\nG234 H1\nG1 Z-3\nG49\nG1 X2\n", Dialect::Haas);
    EXPECT_FALSE(made.fails());
    EXPECT_EQ(made.moves[2].coordinates, Coordinates::Tip);
    expect_at(*start_of(made.moves[2]), 1, -50, -10);
    EXPECT_EQ(made.moves[3].coordinates, Coordinates::Axes);
}

// --- Polar and cylindrical interpolation ---

TEST(PolarInterpolation, XAndCTellPlacesAcrossTheAxis) {
    for (const char* words : {"G12.1", "G112"}) {
        const std::string end = words[2] == '2' ? "G13.1" : "G113";
        const Made made =
            run("G0 X20 Z-1\n" + std::string(words) +
                    "\nG1 X20 C10\nG3 X10 C20 I-10 J0\nG1 X-20 C0\n" + end + "\nG0 X30\n",
                Dialect::Fanuc, false);
        EXPECT_FALSE(made.fails()) << words;
        ASSERT_EQ(made.moves.size(), 6U);
        EXPECT_EQ(made.moves[2].coordinates, Coordinates::Tip);
        expect_at(made.end(3), 20, 10, -1);
        expect_at(std::get<Arc>(made.moves[3].action).to, 10, 20, -1);
        expect_at(made.end(1), -20, 0, -1);
        // After the end, X is the radius again, and C is the angle reached.
        EXPECT_EQ(made.moves[5].coordinates, Coordinates::Axes);
        expect_at(*start_of(made.moves[5]), 20, 0, -1);
        EXPECT_NEAR(start_of(made.moves[5])->c.degrees(), 180, 1e-9);
        expect_at(made.end(), 30, 0, -1);
    }
}

TEST(PolarInterpolation, LiesWhereCStands) {
    const Made made = run("G0 X20 C90\nG12.1\nG1 X15 C5\nG13.1\n", Dialect::Fanuc, false);
    // With C at 90 the tool is at Y20 of the part, which is X of the face.
    expect_at(made.end(), -5, 15, 0);
    EXPECT_TRUE(run("G0 A5\nG12.1\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G12.1\nG1 X5 A5\n", Dialect::Fanuc, false).says("plane-form"));
}

TEST(PolarInterpolation, OfLinuxCncTheWordChoosesTheKinematics) {
    InterpreterOptions options;
    options.dialect = Dialect::Rs274;
    options.tip_control.kinematics = {Coordinates::Tip, Coordinates::Axes};
    std::vector<Coordinates> seen;
    const auto take = [&](const Motion& motion) { seen.push_back(motion.coordinates); };
    const std::string program =
        "G21 G90 G0 X0 Y0 Z0\nG12.1 P0\nG0 X1\nG12.1 P1\nX2\nG12.1\nX3\nG13.1\nX4\n";
    interpret({"t.nc", program}, options, take);
    using enum Coordinates;
    EXPECT_EQ(seen, (std::vector<Coordinates>{Axes, Tip, Axes, Tip, Axes}));
    EXPECT_TRUE(run("G12.1 P1\nG0 X1\n", Dialect::Rs274).says("kinematics"));
}

TEST(Cylinder, HasArcsOfItsCircumference) {
    const double degree = 25.0 * 3.14159265358979323846 / 180.0;
    const Made made =
        run("G0 X30 C0\nG19 G7.1 C25\nG1 X24 F100\nG1 Z-10 F100\nC10\n"
            "G2 Z-15 C" +
                std::to_string(10 + 5 / degree) + " R5\nG7.1 C0\nG0 X30\n",
            Dialect::Fanuc, false);
    EXPECT_FALSE(made.fails());
    // 100 mm/min on the surface, in degrees.
    EXPECT_NEAR(made.moves[4].feed, 100 / degree, 1e-9);
    // A quarter of a circle of 5 mm, in the plane of C (for Y) and Z.
    std::size_t chords = 0;
    for (const Motion& m : made.moves) {
        const Position& p = *end_of(m);
        if (p.z.mm() > -10.0 - 1e-9 || p.z.mm() < -15.0 + 1e-9) continue;
        ++chords;
        const double u = (p.c.degrees() - 10) * degree, v = p.z.mm() + 10;
        EXPECT_NEAR(std::hypot(u, v + 5), 5.0, 1e-5);
        EXPECT_GT(u, 0.0);
    }
    EXPECT_GT(chords, 20U);
    EXPECT_TRUE(run("G7.1 X25\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G7.1 C0.0000001\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G7.1 C-5\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G19 G7.1 C25\nG2 Z-5 C10 J5\n", Dialect::Fanuc, false).says("plane-form"));
    // The arc would need more chords than the limit.
    const std::string start = "G0 X30 Z0 C0\nG19 G7.1 C25\nG1 X24 F100\nG2 C10 ";
    EXPECT_FALSE(run(start + "Z-1900. R1000.\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run(start + "Z-190000. R100000.\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G17 G7.1 C25\nG2 Z-5 C10 R9\n", Dialect::Fanuc, false).says("plane-form"));
    EXPECT_TRUE(run("G107 C25\n", Dialect::Haas, false).result.stopped);
}

TEST(WorkOffset, ThePOfG64IsNotItsOwn) {
    EXPECT_FALSE(run("G54 G90 G64 P0.01\nG0 X1\n").fails());
}

// --- Directions of rotary axes ---

// Returns the successive values of C.
std::vector<double> places(RotaryWay way, const std::vector<std::string>& words) {
    InterpreterOptions options;
    options.rotary_ways[2] = way;
    options.dialect = Dialect::Fanuc;
    std::string program = "G21 G90 G0 X0 C0\n";
    for (const std::string& word : words)
        program += word + "\n";
    std::vector<double> all;
    interpret({"t.nc", program}, options, [&](const Motion& motion) {
        if (const Position* end = end_of(motion)) all.push_back(end->c.degrees());
    });
    all.erase(all.begin());
    return all;
}

TEST(RotaryWay, OfFanucsRollOver) {
    // Moves of -150, -30, -80, +380 and -840.
    EXPECT_EQ(places(RotaryWay::Shortest, {"C-150", "C540", "C-620", "G91 C380", "C-840"}),
              (std::vector<double>{-150, -180, -260, 120, -720}));
    EXPECT_EQ(places(RotaryWay::Linear, {"C-150", "C540", "C-620", "G91 C380", "C-840"}),
              (std::vector<double>{-150, 540, -620, -240, -1080}));
}

TEST(RotaryWay, OfHeidenhainsM126) {
    EXPECT_EQ(places(RotaryWay::Shortest, {"G91 C350", "G90 C10", "C340"}),
              (std::vector<double>{350, 370, 340}));
    EXPECT_EQ(places(RotaryWay::Linear, {"C350", "C10", "C340"}),
              (std::vector<double>{350, 10, 340}));
}

TEST(RotaryWay, OfASignAndAlwaysUp) {
    EXPECT_EQ(places(RotaryWay::Sign, {"C90", "C-45", "C-0", "C0", "C10", "C-10", "C-20"}),
              (std::vector<double>{90, 45, 0, 0, 10, 10, -340}));
    EXPECT_EQ(places(RotaryWay::Positive, {"C90", "C45", "C45", "C-10"}),
              (std::vector<double>{90, 405, 405, 710}));
}

// A repeated position must not differ by rounding; a difference of 1e-14 degrees would become a
// full turn for an axis that always turns in the positive direction.
TEST(RotaryWay, APlaceThatIsNamedAgainIsNoMove) {
    for (const RotaryWay way :
         {RotaryWay::Linear, RotaryWay::Shortest, RotaryWay::Sign, RotaryWay::Positive}) {
        for (const std::string from : {"C-345.249", "C345.249", "C0.1", "G91 C1234.567\nG90"}) {
            for (const std::string to : {"C-43.723", "C43.723", "C0.3"}) {
                const auto all = places(way, {from, to, to, to});
                const double place = all[all.size() - 3];
                EXPECT_EQ(all[all.size() - 2], place) << from << " " << to;
                EXPECT_EQ(all[all.size() - 1], place) << from << " " << to;
                if (way != RotaryWay::Linear) continue;
                EXPECT_EQ(place, std::stod(to.substr(1)));
            }
        }
    }
}

TEST(RotaryClamp, IsToldWhereAnAxisTurnsThatIsHeld) {
    InterpreterOptions options;
    options.clamps = {{'B', 10, 11}, {'C', 70, 71}};
    std::vector<bool> clamped;
    const auto result = interpret(
        {"t.nc", "G21 G90 G0 X0 Y0 Z0\nG0 B10\nM10\nG0 X1\nG0 B20\nC5\nM11 M70\nB0\nC0\n"}, options,
        [&](const Motion& motion) {
            if (start_of(motion)) clamped.push_back(motion.turns_clamped);
        });
    EXPECT_EQ(clamped, (std::vector<bool>{false, false, false, true, false, false, true}));
    EXPECT_FALSE(std::ranges::any_of(result.diagnostics,
                                     [](const Diagnostic& d) { return d.code == "unknown-m"; }));
}

// --- Tip control ---

TEST(TipControl, OnAMachineThatIsToldTheTipIsKnownAfterASwitch) {
    const Made made = run("G0 X1 Y0 Z40 A90\nM428\nG1 Z-3\nM429\nG1 X2\nG53 G0 Z0\n");
    EXPECT_FALSE(made.fails());
    ASSERT_EQ(made.moves.size(), 5U);
    expect_at(*start_of(made.moves[2]), 1, -50, -10);
    EXPECT_EQ(made.moves[2].known_start, (KnownAxes{true, true, true}));
    expect_at(made.end(2), 1, -50, -3);
    expect_at(*start_of(made.moves[3]), 1, 7, 40);
    // Under tip control a machine position is a joint position.
    const Made home = run("G0 X1 Y0 Z40 A90\nM428\nG53 G0 Z60\nG1 X7\n");
    EXPECT_EQ(home.moves[2].coordinates, Coordinates::Axes);
    expect_at(home.end(1), 1, 0, 60);
    expect_at(home.end(), 7, -70, -10);
}

TEST(TipControl, OfG43_5HasTheDirectionOfTheTool) {
    const Made made = run("G43.5 H1\nG1 X1 Y2 Z3 J-1 K1\nX5\nI0 J0 K1\nG43.4 H1\nG1 A10\nG49\n");
    EXPECT_FALSE(made.fails());
    ASSERT_EQ(made.moves.size(), 5U);
    EXPECT_EQ(made.moves[1].coordinates, Coordinates::Tip);
    EXPECT_EQ(made.end(3).a.degrees(), 45.0);
    expect_at(made.end(3), 1, 2, 3);
    EXPECT_EQ(made.end(2).a.degrees(), 45.0);
    EXPECT_EQ(made.end(1).a.degrees(), 0.0);
    EXPECT_EQ(made.end().a.degrees(), 10.0);
    EXPECT_TRUE(run("G43.5 H1\nG1 X1 J-1 K1 A5\n").fails());
    EXPECT_TRUE(run("G43.5 H1\nG1 X1 I1\n").says("unreachable-orientation"));
    EXPECT_TRUE(run("G43.5 H1\nG2 X1 I1\n").fails());
    EXPECT_TRUE(run("G43.5 H1\n", Dialect::Fanuc, false).says("kinematics"));
    // Without tip control I, J and K have no meaning.
    EXPECT_EQ(run("G43.4 H1\nG1 X1 Y2 Z3 J-1 K1\n").end().a.degrees(), 0.0);
}

}  // namespace
}  // namespace ncsim::gcode
