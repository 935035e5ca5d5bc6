// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/solid.h"

#include "ncsim/export/step.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"

#include <gtest/gtest.h>

namespace ncsim::simulation {
namespace {

// Two circular grooves leave a wall of 0.03 mm, thinner than the chords of the first cut are off:
// its facets remain in cuts with finer tools alone. The zigzag moves, 3 µm off a line, are merged
// in the draft but not in cuts with a quarter of the tolerance.
TEST(RefinedSolid, JoinsFewerMovesInFinerCuts) {
    Plan plan;
    plan.job = setup::job_of({"ring.nc",
                              "(T1 D=1. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,5.,0.,0.,5.)\n"
                              "G17 G21 G90 G94 G54\nT1 M6\nS5000 M3 F300\n"
                              "G0 X10 Y15 Z1\nG1 Z-1\nG3 X10 Y15 I5 J0\nG0 Z1\n"
                              "X8.97\nG1 Z-1\nG3 X8.97 Y15 I6.03 J0\nG0 Z1\n"
                              "X25 Y5\nG1 Z-1\nX26 Y5.003\nX27 Y5\nX28 Y5.003\nX29 Y5\nG0 Z1\n"});
    plan.draft = true;
    plan.keep_boundary = true;
    plan.threads = 1;
    const Survey seen = survey(plan);
    ASSERT_TRUE(seen.is_ready());
    coarsen(plan, seen, true, true);
    plan.tolerance = 0.05;
    Verification nothing;
    nothing.keep_cuts = true;
    const Simulation milled = simulate(plan, seen, nothing, {});
    const Solid once = refined_solid(plan, seen, milled, exporter::kStepTolerance, {0, false});
    EXPECT_GT(once.recognised.facets_kept, 0U);
    EXPECT_EQ(once.arc_tolerance_mm, plan.tolerance);
    EXPECT_EQ(once.provenance.entries.size(), milled.provenance.entries.size());
    const Solid finer = refined_solid(plan, seen, milled, exporter::kStepTolerance, {3, false});
    EXPECT_EQ(finer.cuts, 2);
    EXPECT_LT(finer.recognised.facets_kept, once.recognised.facets_kept);
    EXPECT_LT(finer.arc_tolerance_mm, plan.tolerance);
    // The small tool has more sides than the tolerance needs; the finer cut has still more.
    const double error = milled.cutters.begin()->second.error_mm;
    EXPECT_LT(error, 0.25 * plan.tool_tolerance);
    EXPECT_LE(finer.tool_tolerance_mm, 0.25 * error);
    EXPECT_EQ(finer.provenance.entries.size(), milled.provenance.entries.size() + 3);
}

}  // namespace
}  // namespace ncsim::simulation
