// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program is interpreted once for all results.
#include "motions.h"

#include "ncsim/gcode/print.h"
#include "ncsim/simulation/machine_time.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/shading.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ncsim::simulation {
namespace {

// A slot whose cut is in another file: each interpretation of the program reads it once.
Plan plan_of_call(int& reads) {
    setup::JobOptions options;
    options.start = Vec3{0, 0, 50};
    Plan plan;
    plan.job = setup::job_of({"slot.nc",
                              "(T1 D=6. CR=0. - flat end mill)\n"
                              "(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)\n"
                              "G21 G90 T1 M6 S8000 M3\nG0 X-5. Y20. Z5.\nG0 Z-5.\n"
                              "M98 P200\nG0 Z5.\nM30\n"},
                             std::move(options));
    plan.job.interpreter.read_file = [&reads](std::string_view) {
        ++reads;
        return gcode::SourceFile{"200.nc", "O200\nG1 X45. F300.\nM99\n"};
    };
    return plan;
}

TEST(Motions, OfOneInterpretationServeAllResults) {
    int reads = 0;
    Plan plan = plan_of_call(reads);
    plan.keep_boundary = true;
    plan.at_line = 7;
    const Survey seen = survey(plan);
    ASSERT_TRUE(seen.is_ready());
    Verification verification;
    verification.keep_cuts = true;
    const Simulation part = simulate(plan, seen, verification, {});
    EXPECT_NEAR(part.part_volume, 16000.0 - 6 * 40 * 5, 1e-6);
    (void)shading_of(plan, seen, part, *part.boundary);
    EXPECT_FALSE(refined_solid(plan, seen, part, 1e-4, {}).recognised.part.faces.empty());
    (void)assumptions_of(plan, seen, {});
    EXPECT_GT(machining_times(plan, seen, {}).feed_mm, 0.0);
    EXPECT_EQ(reads, 1);
}

TEST(Motions, AreTheSameFromTheRecordAndFromTheProgram) {
    int reads = 0;
    Plan plan = plan_of_call(reads);
    (void)survey(plan);
    const auto lines = [&] {
        std::vector<std::string> all;
        for_each_motion(plan, [&](const gcode::Motion& motion) {
            all.emplace_back();
            gcode::print(all.back(), motion);
        });
        return all;
    };
    const std::vector<std::string> recorded = lines();
    EXPECT_EQ(reads, 1);
    EXPECT_EQ(recorded.size(), 5U);
    plan.motions = nullptr;
    EXPECT_EQ(lines(), recorded);
    EXPECT_EQ(reads, 2);
}

TEST(Motions, AreNotKeptIfTheyAreVeryMany) {
    MotionRecorder recorder;
    for (int i = 0; i < 100'000; ++i)
        recorder.take({});
    MotionRecorder longer = recorder;
    EXPECT_EQ(std::move(recorder).result()->size(), 100'000U);
    longer.take({});
    longer.take({});
    EXPECT_EQ(std::move(longer).result(), nullptr);
}

}  // namespace
}  // namespace ncsim::simulation
