// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of the motions that met the stock.
#include "ncsim/simulation/cut_record.h"

#include "ncsim/brep/recognise.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace ncsim::simulation {
namespace {

struct Cut {
    Plan plan;
    Survey seen;
    Simulation part;
};

// Cuts a block of 60 x 40 x 10 mm, X and Y from 0, top at Z0; the tool starts at X-10 Y20 Z5.
Cut cut(const std::string& moves, double join_tolerance = 0.0, bool keeps_cuts = true) {
    Cut made;
    made.plan.job = setup::job_of({"cut.nc",
                                   "(T1 D=6. CR=0. - flat end mill)\n"
                                   "(STOCK/BLOCK,60.,40.,10.,0.,0.,10.)\n"
                                   "G21 G90 G17 T1 M6 S8000 M3 F300\nG0 X-10. Y20. Z5.\n" +
                                       moves + "G0 Z5.\nM30\n"});
    made.plan.join_tolerance = join_tolerance;
    made.plan.keep_boundary = true;
    made.seen = survey(made.plan);
    EXPECT_TRUE(made.seen.is_ready());
    Verification verification;
    verification.keep_cuts = keeps_cuts;
    made.part = simulate(made.plan, made.seen, verification, {});
    return made;
}

// Motions: the tool change, two rapids, and the feed moves from number 4 on.
TEST(CutRecord, NamesTheMotionThatMetTheStock) {
    const Cut made = cut("G0 Z-2.\nG1 X-5.\nG1 X20.\nG0 Z5.\nG0 Y30.\nG0 X30.\nG1 Z-1.\n");
    const auto& cuts = made.part.cuts;
    ASSERT_EQ(cuts.size(), 5U);  // the stock, two cuts, and the way up out of each
    EXPECT_EQ(made.plan.motions->at(cuts[1].motion - 1).span.line, 7U);
    EXPECT_EQ(made.plan.motions->at(cuts[3].motion - 1).span.line, 11U);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        EXPECT_EQ(cuts[i].place.span, made.plan.motions->at(cuts[i].motion - 1).span);
        EXPECT_EQ(cuts[i].tool, 1);
        EXPECT_EQ(cuts[i].path, nullptr);
    }
}

TEST(CutRecord, IsKeptOnRequestOnly) {
    EXPECT_TRUE(cut("G0 Z-2.\nG1 X20.\n", 0.0, false).part.cuts.empty());
}

TEST(CutRecord, HasTheWholePathOfJoinedMoves) {
    const Cut made = cut("G0 Z-2.\nG1 X10. Y20.\nG1 X20. Y20.001\nG1 X30. Y20.\nG1 Y30.\n", 0.01);
    const auto& cuts = made.part.cuts;
    ASSERT_EQ(cuts.size(), 4U);
    ASSERT_TRUE(cuts[1].path);
    EXPECT_EQ(cuts[1].path->from, (Vec3{-10, 20, -2}));
    EXPECT_EQ(cuts[1].path->to, (Vec3{30, 20, -2}));
    EXPECT_FALSE(cuts[1].path->line_start);
    EXPECT_EQ(cuts[1].place.span.line, 6U);
    EXPECT_EQ(made.plan.motions->at(cuts[1].motion - 1).span.line, 6U);
    // The next record counts all motions of the program.
    EXPECT_EQ(made.plan.motions->at(cuts[2].motion - 1).span.line, 9U);
}

// The walk combines the cells of a line over at most the diameter of the tool.
TEST(CutRecord, HasTheStartOfTheLineThatItContinues) {
    const Cut made = cut("G0 Z-2.\nG1 X10.\nG1 X11.\nG1 X12.\nG1 X18.\nG1 X19. Y21.\n");
    const auto& cuts = made.part.cuts;
    ASSERT_EQ(cuts.size(), 7U);
    EXPECT_FALSE(cuts[1].path);
    EXPECT_FALSE(cuts[2].path);  // 21 mm from the start of the first move
    ASSERT_TRUE(cuts[3].path);
    EXPECT_EQ(cuts[3].path->line_start, (Vec3{10, 20, -2}));
    EXPECT_EQ(cuts[3].path->from, (Vec3{11, 20, -2}));
    EXPECT_FALSE(cuts[4].path);
    EXPECT_FALSE(cuts[5].path);  // another direction
}

TEST(CutRecord, HasMovedEndsInASlopingRun) {
    const Cut made = cut("G0 X10.\nG1 Z0.\nG1 X20. Y25.0005 Z-1.\nG1 X30. Y30. Z-1.5\n");
    const auto& cuts = made.part.cuts;
    ASSERT_EQ(cuts.size(), 5U);  // the stock, down to Z0, the run, up
    for (const std::size_t i : {2U, 3U}) {
        ASSERT_TRUE(cuts[i].path);
        EXPECT_NEAR(cuts[i].path->moved_mm, 0.0005 * 2 / std::sqrt(5.0), 1e-9);
    }
    EXPECT_EQ(cuts[2].path->to, cuts[3].path->from);
    EXPECT_NEAR(cuts[2].path->to.y - 20.0, (cuts[2].path->to.x - 10.0) / 2, 1e-12);
    EXPECT_EQ(cuts[2].path->to.z, -1.0);
    EXPECT_EQ(cuts[3].path->to, (Vec3{30, 30, -1.5}));
}

// A long program is interpreted again; the records name the same motions.
TEST(CutRecord, GivesTheSameSolidFromMotionsAndFromTheProgram) {
    Cut made = cut("G0 Z-2.\nG1 X10.\nG1 X11.\nG1 X12. Y20.\nG2 X20. Y12. I0. J-8.\nG1 Y-5.\n");
    const brep::Recognised first = solid_of(made.plan, made.seen, made.part, 1e-4);
    EXPECT_EQ(first.facets_kept, 0U);
    made.plan.motions = nullptr;
    const brep::Recognised again = solid_of(made.plan, made.seen, made.part, 1e-4);
    EXPECT_EQ(again.part.faces.size(), first.part.faces.size());
    EXPECT_EQ(again.facets_kept, 0U);
    // With records of other motions, the facets of the arc have no surface.
    for (CutRecord& record : made.part.cuts)
        record.motion += 100;
    EXPECT_GT(solid_of(made.plan, made.seen, made.part, 1e-4).part.faces.size(),
              first.part.faces.size());
}

}  // namespace
}  // namespace ncsim::simulation
