// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests which surfaces a motion can leave, by the element of the tool's profile and the path.
#include "ncsim/brep/swept_surfaces.h"

#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/setup/job.h"
#include "ncsim/toolpath/tool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

namespace ncsim::brep {
namespace {

// Returns the candidates of the last motion of `moves`, which starts in X0 Y0 Z0.
SweptSurfaces last_of(const toolpath::Tool& tool, const std::string& moves) {
    const setup::Job job =
        setup::job_of({"path.nc", "G21 G90 G17 F300\nG0 X0 Y0 Z0 A0\n" + moves + "\nM30\n"});
    SweptSurfaces last;
    gcode::interpret(job.program, job.interpreter, [&](const gcode::Motion& motion) {
        if (gcode::start_of(motion)) last = surfaces_of(motion, tool, nullptr);
    });
    return last;
}

// Returns the number of moved surfaces by the name of their form; `at_rest` for those at rest.
std::map<std::string_view, int> counts(const SweptSurfaces& source, bool at_rest = false) {
    std::map<std::string_view, int> result;
    for (const CandidateSurface& candidate : source.candidates) {
        if (candidate.is_at_rest == at_rest) ++result[kForms.at(candidate.surface.form.index())];
    }
    return result;
}

using Counts = std::map<std::string_view, int>;

const toolpath::Tool kFlat = toolpath::flat_end_mill(10, 30);
const toolpath::Tool kBall = toolpath::ball_end_mill(8, 30);
const toolpath::Tool kBull = toolpath::bull_nose_end_mill(12, 2, 30);

// Each tool closes its profile above by a disc, whose plane is listed on level paths, too.
TEST(SweptSurfaces, OfLines) {
    EXPECT_EQ(counts(last_of(kFlat, "G1 X20")), (Counts{{"plane", 4}}));
    EXPECT_EQ(counts(last_of(kBall, "G1 X20")), (Counts{{"cylinder", 1}, {"plane", 3}}));
    EXPECT_EQ(counts(last_of(kBull, "G1 X20")), (Counts{{"cylinder", 2}, {"plane", 4}}));
    EXPECT_EQ(counts(last_of(kFlat, "G1 X20 Z-5")), (Counts{{"extrusion", 2}, {"plane", 2}}));
    EXPECT_EQ(counts(last_of(kBall, "G1 X20 Z-5"))["cylinder"], 1);
    EXPECT_EQ(counts(last_of(kBull, "G1 X20 Z-5"))["envelope"], 1);
}

TEST(SweptSurfaces, OfArcsAboutTheToolsDirection) {
    EXPECT_EQ(counts(last_of(kFlat, "G3 X40 I20 J0")), (Counts{{"cylinder", 2}, {"plane", 2}}));
    EXPECT_EQ(counts(last_of(kBall, "G3 X40 I20 J0"))["torus"], 1);
    EXPECT_EQ(counts(last_of(kBull, "G3 X40 I20 J0"))["torus"], 2);
    // The corners below and above the side.
    EXPECT_EQ(counts(last_of(kFlat, "G3 X40 Z-2 I20 J0"))["coil"], 2);
    EXPECT_EQ(counts(last_of(kBall, "G3 X40 Z-2 I20 J0"))["envelope"], 1);
    // A path as narrow as the tool leaves no wall inside.
    EXPECT_EQ(counts(last_of(kFlat, "G3 X8 I4 J0"))["cylinder"], 1);
}

// On circles narrower than the ball, the torus is a spindle.
TEST(SweptSurfaces, SpindlesOfArcsAndCircles) {
    for (const char* moves : {"G3 X4 I2 J0", "G3 X2 Y2 I2 J0", "G3 X0 Y0 I2 J0", "G19 G2 Y4 J2 K0",
                              "G19 G2 Y0 Z0 J2 K0"}) {
        const SweptSurfaces source = last_of(kBall, moves);
        EXPECT_EQ(counts(source)["torus"], 1) << moves;
        EXPECT_FALSE(source.may_leave_other_surfaces) << moves;
    }
    // The inner half of the tube of a bull nose.
    EXPECT_EQ(counts(last_of(kBull, "G3 X0 Y0 I5 J0"))["torus"], 2);
}

TEST(SweptSurfaces, OfArcsAcrossTheToolsDirection) {
    EXPECT_EQ(counts(last_of(kBall, "G19 G2 Y20 Z-20 J20 K0"))["torus"], 1);
    // Both corners, on both sides of the arc's centre.
    EXPECT_EQ(counts(last_of(kFlat, "G19 G2 Y20 Z-20 J20 K0"))["dome"], 4);
}

TEST(SweptSurfaces, AtRestAtBothEnds) {
    const SweptSurfaces flat = last_of(kFlat, "G1 X20");
    EXPECT_EQ(counts(flat, true), (Counts{{"cylinder", 2}, {"plane", 4}}));
    EXPECT_EQ(counts(last_of(kBall, "G1 X20"), true)["sphere"], 2);
    EXPECT_EQ(counts(last_of(kBull, "G1 X20"), true)["torus"], 2);
    // A corner radius of more than a quarter of the diameter is a spindle.
    EXPECT_EQ(counts(last_of(toolpath::bull_nose_end_mill(10, 3, 30), "G1 X20"), true)["torus"], 2);
}

// Facets parallel to the tool belong to the side, not to the round end below.
TEST(SweptSurfaces, RoundEndsAreBelowTheSide) {
    for (const CandidateSurface& candidate : last_of(kBull, "G3 X40 I20 J0").candidates) {
        const bool is_round = kForms.at(candidate.surface.form.index()) == "torus";
        EXPECT_EQ(candidate.below_side, is_round ? std::optional(Vec3{0, 0, 1}) : std::nullopt);
    }
}

// Rings around a bar: the ball stays at one distance from the axis and at one place along it.
TEST(SweptSurfaces, RingsAroundABar) {
    EXPECT_EQ(counts(last_of(kBall, "G0 Z30\nG1 A300"))["torus"], 1);
    EXPECT_EQ(counts(last_of(kBull, "G0 Z30\nG1 A300"))["torus"], 2);
    EXPECT_EQ(counts(last_of(kBall, "G0 Y5 Z30\nG1 A300"))["torus"], 1);
    // Off the axis, the corner radius touches its envelope elsewhere than in a circle.
    EXPECT_EQ(counts(last_of(kBull, "G0 Y5 Z30\nG1 A300"))["torus"], 0);
    // A spiral, and a ball that moves away from the axis.
    EXPECT_EQ(counts(last_of(kBall, "G0 Z30\nG1 X0.01 A90"))["torus"], 0);
    EXPECT_EQ(counts(last_of(kBall, "G0 Z30\nG1 X5 A90"))["torus"], 0);
    EXPECT_EQ(counts(last_of(kBall, "G0 Z30\nG1 Z30.01 A90"))["torus"], 0);
    // On a sphere, both axes turn at a fixed distance from the origin.
    EXPECT_EQ(counts(last_of(kBall, "G0 Z26\nG1 A60 C60"))["torus"], 0);
}

// Chords of arcs add to the deviation of facets; a straight move has none.
TEST(SweptSurfaces, ChordsOfPaths) {
    EXPECT_EQ(last_of(kFlat, "G1 X20").chords, 0.0);
    EXPECT_EQ(last_of(kFlat, "G3 X40 I20 J0").chords, 1.0);
    EXPECT_GT(last_of(kFlat, "G3 X40 Z-2 I20 J0").chords, 1.0);
}

TEST(SweptSurfaces, OfStock) {
    toolpath::Stock block;
    block.box = {{0, 0, -10}, {40, 30, 0}};
    EXPECT_EQ(surfaces_of(block).size(), 6U);
    for (const CandidateSurface& candidate : surfaces_of(block))
        EXPECT_FALSE(candidate.surface.is_hollow);
    block.is_round = true;
    block.axis = 2;
    EXPECT_EQ(surfaces_of(block).size(), 3U);
}

}  // namespace
}  // namespace ncsim::brep
