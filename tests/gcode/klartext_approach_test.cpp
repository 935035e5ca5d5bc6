// SPDX-License-Identifier: GPL-3.0-or-later
//
// APPR and DEP of Klartext: each form, compared with the path of the tool centre in G-code. The
// tool has a radius of 5 mm.
#include "gcode/klartext_made.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::gcode::klartext_test {
namespace {

// A contour along +Y at X10, then along +X at Y50, with the tool on its left.
const std::string kContour = "L Y+50\nL X+50\n";
const std::string kPath = "G1 Y50.\nG2 X10. Y55. I5. J0.\nG1 X50.\n";

TEST(KlartextApproach, TangentialLine) {
    expect_close("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 RL F100\n" + kContour + "DEP LT LEN20",
                 "G0 X-10. Y-10.\nG0 X5. Y-5.\nG1 Y10. F100\n" + kPath + "G1 X70.");
}

TEST(KlartextApproach, PerpendicularLine) {
    expect_close("L X-30 Y-10 FMAX\nAPPR LN X+10 Y+10 LEN15 RL F100\n" + kContour + "DEP LN LEN12",
                 "G0 X-30. Y-10.\nG0 X-10. Y10.\nG1 X5. F100\n" + kPath + "G1 Y67.");
}

TEST(KlartextApproach, Arc) {
    // RL and a positive radius: counter-clockwise, the arc is on the side of the tool.
    expect_close(
        "L X-30 Y-10 FMAX\nAPPR CT X+10 Y+10 CCA90 R+8 RL F100\n" + kContour + "DEP CT CCA90 R+8",
        "G0 X-30. Y-10.\nG0 X-3. Y2.\nG3 X5. Y10. I0. J8. F100\n" + kPath + "G3 X58. Y63. I0. J8.");
    // A negative radius: from the side of the part.
    expect_close("L X-30 Y-10 FMAX\nAPPR CT X+10 Y+10 CCA90 R-8 RL F100\nL Y+50",
                 "G0 X-30. Y-10.\nG0 X13. Y2.\nG2 X5. Y10. I0. J8. F100\nG1 Y50.");
    // RR: clockwise.
    expect_close("L X-30 Y-10 FMAX\nAPPR CT X+10 Y+10 CCA180 R+8 RR F100\nL Y+50",
                 "G0 X-30. Y-10.\nG0 X31. Y10.\nG2 X15. Y10. I-8. J0. F100\nG1 Y50.");
}

TEST(KlartextApproach, LineAndArc) {
    // The tool of radius 5 ends with its centre over X0 Y5.
    const Made r = run(klartext("L X-10 Y-10 FMAX\nAPPR LCT X+5 Y+5 R5 RL F100\nL Y+95"));
    EXPECT_EQ(r.errors(), "");
    ASSERT_EQ(r.moves.size(), 5U);
    const Arc& arc = std::get<Arc>(r.moves[3].action);
    EXPECT_NEAR(arc.to.x.mm(), 0.0, 1e-9);
    EXPECT_NEAR(arc.to.y.mm(), 5.0, 1e-9);
    EXPECT_NEAR(arc.centre_1.mm(), -5.0, 1e-9);
    EXPECT_EQ(arc.turns, 1);
    // The line is tangent to the arc.
    const Position h = *end_of(r.moves[2]);
    const double along =
        (h.x.mm() + 10.0) * (h.x.mm() + 5.0) + (h.y.mm() + 10.0) * (h.y.mm() - 5.0);
    EXPECT_NEAR(along, 0.0, 1e-9);
    EXPECT_NEAR(r.end().x.mm(), 0.0, 1e-9);
    EXPECT_NEAR(r.end().y.mm(), 95.0, 1e-9);
}

TEST(KlartextApproach, ArcAndLine) {
    const Made r = run(klartext("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 RL F100\n" + kContour +
                                "DEP LCT X+90 Y+80 R10"));
    EXPECT_EQ(r.errors(), "");
    const Arc& arc = std::get<Arc>(r.moves[r.moves.size() - 2].action);
    EXPECT_NEAR(arc.centre_1.mm(), 50.0, 1e-9);
    EXPECT_NEAR(arc.centre_2.mm(), 65.0, 1e-9);
    EXPECT_EQ(arc.turns, 1);
    const double along = (90.0 - arc.to.x.mm()) * (arc.to.x.mm() - 50.0) +
                         (80.0 - arc.to.y.mm()) * (arc.to.y.mm() - 65.0);
    EXPECT_NEAR(along, 0.0, 1e-9);
    expect_end(r, 90, 80, 50);
}

TEST(KlartextApproach, PolarForms) {
    expect_close("CC X+0 Y+0\nL X-10 Y-10 FMAX\nAPPR PLT PR+10 PA+0 LEN15 RL F100\nL Y+50",
                 "G0 X-10. Y-10.\nG0 X5. Y-15.\nG1 Y0. F100\nG1 Y50.");
    expect_close(
        "L X-10 Y-10 FMAX\nAPPR LT X+10 Y+0 LEN15 RL F100\nL Y+50\nCC X+0 Y+0\n"
        "DEP PLCT PR+100 PA+90 R5",
        "G0 X-10. Y-10.\nG0 X5. Y-15.\nG1 Y0. F100\nG1 Y50.\n"
        "G3 X4.974937186 Y50.5 I-5. J0.\nG1 X0. Y100.");
}

TEST(KlartextApproach, HeightAfterTheAuxiliaryPoint) {
    expect_close("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 Z-5 LEN15 RL F100\nL Y+50\nDEP LT LEN20 Z+5",
                 "G0 X-10. Y-10.\nG0 X5. Y-5.\nG1 Z-5. F100\nG1 Y10.\nG1 Y50.\nG1 Y70.\nG1 Z5.");
}

TEST(KlartextApproach, BeforeAnArc) {
    // The contour begins with an arc about X20 Y10: its tangent at X10 Y10 is along +Y.
    expect_close("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 RL F100\nCC X+20 Y+10\nC X+20 Y+20 DR-",
                 "G0 X-10. Y-10.\nG0 X5. Y-5.\nG1 Y10. F100\nG2 X20. Y25. I15. J0.");
    expect_close("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 RL F100\nCR X+20 Y+20 R10 DR-",
                 "G0 X-10. Y-10.\nG0 X5. Y-5.\nG1 Y10. F100\nG2 X20. Y25. I15. J0.");
}

TEST(KlartextApproach, LineToTheAuxiliaryPointHasTheLastFeed) {
    expect_close("L X-10 Y-10 F500\nAPPR LT X+10 Y+10 LEN15 RL F100\nL Y+50",
                 "G1 X-10. Y-10. F500\nG1 X5. Y-5.\nG1 Y10. F100\nG1 Y50.");
}

TEST(KlartextApproach, WithoutCompensation) {
    expect_close("L X-10 Y-10 FMAX\nAPPR LT X+10 Y+10 LEN15 R0 F100\nL Y+50\nDEP LT LEN5",
                 "G0 X-10. Y-10.\nG0 X10. Y-5.\nG1 Y10. F100\nG1 Y50.\nG1 Y55.");
}

TEST(KlartextApproach, Refusals) {
    const auto expect_error = [](const std::string& blocks, const std::string& error) {
        const Made r = run(klartext(blocks));
        EXPECT_EQ(r.errors().substr(0, error.size()), error) << blocks;
        EXPECT_TRUE(r.result.refused) << blocks;
    };
    expect_error("APPR LT X+1 Y+1 RL F100\nL Y+9", "4:1: APPR LT needs a length (LEN)");
    expect_error("APPR CT X+1 Y+1 R5 RL F100\nL Y+9",
                 "4:1: APPR CT needs a centre angle (CCA) up to 360");
    expect_error("APPR CT X+1 Y+1 CCA90 R+5 F100\nL Y+9", "4:1: APPR CT needs RL or RR");
    expect_error("APPR LN LEN5 RL F100\nL Y+9",
                 "4:1: APPR LN needs the first point of the contour");
    expect_error("APPR LT X+1 Y+1 LEN5 RL F100\nTOOL CALL 2 Z",
                 "4:1: APPR without a path block after it is not read");
    expect_error("APPR LCT X+1 Y+5 R500 RL F100\nL Y+9",
                 "4:1: APPR LCT needs a start outside the arc");
    expect_error("L X+9 RL F100\nAPPR LT X+20 Y+1 LEN5 RL F100\nL Y+9",
                 "5:1: APPR under RL or RR is not read");
    expect_error("DEP LT LEN5", "4:1: DEP LT needs a move in the plane before");
    expect_error("L X+9 F100\nDEP LN LEN5", "5:1: DEP LN needs cutter compensation (RL, RR)");
}

}  // namespace
}  // namespace ncsim::gcode::klartext_test
