// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/solid.h"

#include "ncsim/export/step.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"

#include <gtest/gtest.h>

namespace ncsim::simulation {
namespace {

// Facets of the ring remain in cuts with finer tools alone. The zigzag moves, 3 µm off a line, are
// merged in the draft but not in cuts with a quarter of the tolerance.
TEST(RefinedSolid, JoinsFewerMovesInFinerCuts) {
    Plan plan;
    plan.job =
        setup::job_of({"ring.nc",
                       "G17 G21 G90 G94 G54\nG0 Z0.25\nX-0.5 Y0.\nZ0.1\nG01 Z0. F5.\n"
                       "G02 X0. Y0.5 I0.5 J0. F2.5\nX0.5 Y0. I0. J-0.5\nX0. Y-0.5 I-0.5 J0.\n"
                       "X-0.5 Y0. I0. J0.5\nG01 Z0.1 F5.\nG00 X0. Y0. Z0.25\nZ1.5\nG01 X-0.4 Y0.7\n"
                       "X-0.2 Y0.703\nX0. Y0.7\nX0.2 Y0.703\nX0.4 Y0.7\nG00 Z1.6\n"});
    plan.draft = true;
    plan.keep_boundary = true;
    plan.threads = 1;
    const Survey seen = survey(plan);
    ASSERT_TRUE(seen.is_ready());
    coarsen(plan, seen, true, true);
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
