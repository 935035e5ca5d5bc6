// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tilted planes of Klartext, with a machine that is given by formulas, compared with G68.2.
#include "ncsim/base/angles.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/print.h"

#include "gcode/cradle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace ncsim::gcode {
namespace {

using language_test::Cradle;

struct Outcome {
    Interpretation result;
    std::vector<Motion> moves;
    std::vector<std::string> texts;  // Without line numbers.

    bool says(const std::string& code) const {
        return std::ranges::any_of(result.diagnostics,
                                   [&](const Diagnostic& d) { return d.code == code; });
    }
};

Outcome run(const std::string& text, Dialect dialect) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.joints = std::make_shared<Cradle>();
    Outcome out;
    out.result = interpret({"t.h", text}, options, [&](const Motion& motion) {
        if (!start_of(motion)) return;
        out.moves.push_back(motion);
        std::string line;
        print(line, motion);
        out.texts.push_back(line.substr(line.find(' ') + 1));
    });
    for (const Diagnostic& d : out.result.diagnostics) {
        if (d.severity == Severity::Error) ADD_FAILURE() << d.message;
    }
    return out;
}

Outcome klartext(const std::string& blocks) {
    return run("BEGIN PGM T MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 FMAX M3\n" + blocks +
                   "\nM30\nEND PGM T MM\n",
               Dialect::Auto);
}
Outcome iso(const std::string& blocks) {
    return run("O0001\nG21 G90 G17\nT1 M6\nG43 H1\nS1000 G0 X0. Y0. Z50. M3\n" + blocks + "\nM30\n",
               Dialect::Fanuc);
}

void expect_same(const std::string& of_klartext, const std::string& of_iso) {
    const Outcome a = klartext(of_klartext);
    EXPECT_EQ(a.texts, iso(of_iso).texts);
    EXPECT_GT(a.texts.size(), 2U);
}

TEST(KlartextPlane, SpatialTurn) {
    expect_same(
        "CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+20\nPLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN "
        "FMAX\nL X+5 Y+6 Z+7 FMAX\nL Z-1 F100\nPLANE RESET STAY",
        "G52 X10. Y20.\nG68.2 X0. Y0. Z0. I0. J-30. K0.\nG53.1\nG0 X5. Y6. Z7.\nG1 Z-1. F100\nG69");
}

TEST(KlartextPlane, SpatialStayWithAnglesOfTheControl) {
    const Outcome a = klartext(
        "PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL A+Q120 C+Q122 R0 FMAX\nL X+5 Y+6 Z+7 FMAX");
    const Outcome b = klartext("PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL X+5 Y+6 Z+7 FMAX");
    EXPECT_EQ(a.texts, b.texts);
}

TEST(KlartextPlane, EulerAndVectorGiveTheSamePlane) {
    const std::string moves = " TURN FMAX\nL X+5 Y+6 Z+7 FMAX";
    const Outcome spatial = klartext("PLANE SPATIAL SPA+90 SPB+0 SPC+0" + moves);
    EXPECT_EQ(klartext("PLANE EULER EULPR0 EULNU90 EULROT0" + moves).texts, spatial.texts);
    EXPECT_EQ(klartext("PLANE VECTOR BX1 BY0 BZ0 NX0 NY-1 NZ0" + moves).texts, spatial.texts);
}

TEST(KlartextPlane, SignOfTheAxisBySeq) {
    const auto a_of = [](const std::string& angle) {
        const Outcome r =
            klartext("PLANE SPATIAL SPA" + angle + " SPB+0 SPC+0 TURN FMAX SEQ" + angle[0]);
        return end_of(r.moves.back())->a.degrees();
    };
    EXPECT_NEAR(a_of("+30"), 30.0, 1e-9);
    EXPECT_NEAR(a_of("-30"), -30.0, 1e-9);
}

TEST(KlartextPlane, TableRotAndCoordRotChangeNothing) {
    const std::string plane = "PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX";
    const std::string move = "\nL X+5 Y+6 Z+7 FMAX";
    for (const char* word : {" TABLE ROT", " COORD ROT"})
        EXPECT_EQ(klartext(plane + word + move).texts, klartext(plane + move).texts);
}

TEST(KlartextPlane, AxialWithoutAnglesIsNoPlane) {
    EXPECT_EQ(klartext("PLANE AXIAL A+0 C+0 STAY\nL X+5 FMAX").texts, klartext("L X+5 FMAX").texts);
}

TEST(KlartextPlane, MoveKeepsTheTip) {
    const Outcome r = klartext("PLANE SPATIAL SPA+30 SPB+0 SPC+0 MOVE DIST20 F1000");
    ASSERT_EQ(r.moves.size(), 2U);
    EXPECT_NEAR(start_of(r.moves[1])->z.mm(), end_of(r.moves[1])->z.mm(), 1e-9);
    EXPECT_NE(end_of(r.moves[1])->a, Angle());
    EXPECT_EQ(r.moves[1].kind, MoveKind::Feed);
}

TEST(KlartextPlane, CycleInAPlaneDrillsAlongTheTool) {
    const Outcome r = klartext(
        "PLANE SPATIAL SPA+90 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 200 A Q200=2 Q201=-10 Q206=100 "
        "Q202=10 Q203=0 Q204=5\nL X+3 Y+4 Z+5 FMAX\nCYCL CALL");
    const auto feeds = std::ranges::find(r.moves, MoveKind::Feed, &Motion::kind);
    ASSERT_NE(feeds, r.moves.end());
    // Z of the plane is -Y of the part.
    EXPECT_NEAR(end_of(*feeds)->y.mm(), 10.0, 1e-9);
    EXPECT_NEAR(end_of(*feeds)->z.mm(), 4.0, 1e-9);
}

TEST(KlartextPlane, Cycle19) {
    const std::string moves = "\nL A+Q120 FMAX\nL X+5 Y+6 Z+7 FMAX";
    EXPECT_EQ(klartext("CYCL DEF 19.0 EBENE\nCYCL DEF 19.1 A-30 B+0 C+0" + moves +
                       "\nCYCL DEF 19.0\nCYCL DEF 19.1\nL X+1 Y+1 Z+1")
                  .texts,
              klartext("PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY" + moves +
                       "\nPLANE RESET STAY\nL X+1 Y+1 Z+1")
                  .texts);
}

TEST(KlartextPlane, ResetTurnTurnsBack) {
    const Outcome r = klartext(
        "PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nPLANE RESET TURN FMAX\nL X+1 Y+1 Z+1 FMAX");
    EXPECT_EQ(end_of(r.moves.back())->a, Angle());
}

TEST(KlartextPlane, RetractInAPlaneIsAlongTheTool) {
    const Outcome r =
        klartext("PLANE SPATIAL SPA+90 SPB+0 SPC+0 TURN FMAX\nL X+0 Y+0 Z+0 FMAX\nL M140 MB 50");
    EXPECT_NEAR(end_of(r.moves.back())->y.mm(), -50.0, 1e-9);
}

TEST(KlartextPlane, TipControlHasPositionsOfTheTip) {
    const Outcome r = klartext("M128\nL X+1 Y+2 Z+3 A+30 F100\nM129");
    EXPECT_EQ(r.moves.back().coordinates, Coordinates::Tip);
    EXPECT_NEAR(end_of(r.moves.back())->z.mm(), 3.0, 1e-9);
}

}  // namespace
}  // namespace ncsim::gcode
