// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/simulation/solid.h"

#include "ncsim/export/step.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"

#include <gtest/gtest.h>

namespace ncsim::simulation {
namespace {

// Facets remain at first where the path of the ball bends. The zigzag moves, 3 µm off a line, are
// merged in the draft but not in cuts with a quarter of the tolerance.
TEST(RefinedSolid, JoinsFewerMovesInFinerCuts) {
    Plan plan;
    plan.job = setup::job_of(
        {"corner.nc",
         "(T1 D=6. CR=3. - ball end mill)\n(STOCK/BLOCK,100.,100.,40.,0.,0.,40.)\nG21 G90\n"
         "T1 M6 S5000 M3\nG0 X0. Y0. Z20.\nG1 X83.333 Y0. Z-4.168 F1500.\nX100. Y0. Z-6.265\n"
         "X100. Y25. Z-6.265\nG0 Z20.\nX20. Y60.\nG1 Z-1.\nX22. Y60.003\nX24. Y60.\n"
         "X26. Y60.003\nX28. Y60.\nG0 Z20.\nM30\n"});
    plan.draft = true;
    plan.keep_boundary = true;
    plan.threads = 1;
    const Survey seen = survey(plan);
    ASSERT_TRUE(seen.is_ready());
    coarsen(plan, seen, true, true);
    Verification nothing;
    nothing.keep_cuts = true;
    const Simulation milled = simulate(plan, seen, nothing, {});
    const Solid once = refined_solid(plan, seen, milled, exporter::kStepTolerance, 0);
    EXPECT_GT(once.recognised.facets_kept, 0U);
    EXPECT_EQ(once.arc_tolerance_mm, plan.tolerance);
    EXPECT_EQ(once.provenance.entries.size(), milled.provenance.entries.size());
    const Solid finer = refined_solid(plan, seen, milled, exporter::kStepTolerance, 1);
    EXPECT_LT(finer.recognised.facets_kept, once.recognised.facets_kept);
    EXPECT_LT(finer.arc_tolerance_mm, plan.tolerance);
    EXPECT_EQ(finer.provenance.entries.size(), milled.provenance.entries.size() + 3);
}

}  // namespace
}  // namespace ncsim::simulation
