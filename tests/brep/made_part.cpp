// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a program through simulation, recognition and STEP export.
#include "brep/made_part.h"

#include "ncsim/export/step.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>

namespace ncsim::brep::test {

namespace {

std::string program(const std::string& moves, bool is_bar) {
    return "(T1 D=10. CR=0. - flat end mill)\n(T2 D=6. CR=0. TAPER=118deg - drill)\n"
           "(T3 D=8. CR=4. - ball end mill)\n(T4 D=12. CR=2. - bull nose end mill)\n"
           "(T5 D=10. CR=0. TAPER=45deg - chamfer mill)\n" +
           std::string(is_bar ? "" : "(STOCK/BLOCK,80.,60.,20.,0.,0.,20.)\n") +
           "G21 G90 G17 F300 S5000 M3\n" + moves + "M30\n";
}

}  // namespace

Made make_part(setup::Job job, double tool_tolerance, unsigned threads, bool is_draft) {
    simulation::Plan plan;
    plan.job = std::move(job);
    plan.keep_boundary = true;
    plan.tool_tolerance = tool_tolerance;
    plan.threads = threads;
    const simulation::Survey survey = simulation::survey(plan);
    EXPECT_TRUE(survey.is_ready());
    if (is_draft) {
        plan.draft = true;
        simulation::coarsen(plan, survey, true, true);
    }
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    Made made{simulation::solid_of(plan, survey, milled, exporter::kStepTolerance),
              milled.provenance,
              {},
              *milled.boundary};
    std::ostringstream out;
    exporter::write_step_solid(out, made.solid.part, milled.provenance);
    made.step = out.str();
    return made;
}

Made make_part(const std::string& name, const std::string& moves, double tool_tolerance,
               unsigned threads, bool is_bar) {
    setup::JobOptions options;
    std::string message;
    if (is_bar) options.stock = toolpath::parse_stock_option("D60x20", message);
    return make_part(setup::job_of({name + ".nc", program(moves, is_bar)}, options), tool_tolerance,
                     threads);
}

}  // namespace ncsim::brep::test
