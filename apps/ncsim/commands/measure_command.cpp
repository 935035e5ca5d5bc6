// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the dimensions of a part.
#include "commands/measure_command.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/export/step.h"
#include "ncsim/report/measure_sheet.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/part_measures.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/stock_history.h"

#include "options/job_steps.h"
#include "options/option_row.h"
#include "options/plan_options.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <ostream>
#include <vector>

namespace ncsim::app {

namespace {

// Measures the part after each step. The JSON is of the last step.
int measure_job(const MeasureOptions& options, const std::vector<ChosenStep>& steps) {
    setup::InputSet inputs;
    read_ahead(options, steps, inputs);
    int worst = kClean;
    for (const ChosenStep& step : steps) {
        MeasureOptions one = options;
        one.job_step = step.number;
        if (&step != &steps.back()) one.json.clear();
        if (steps.size() > 1 && !options.quiet)
            put_text(fmt::format("{}: {}\n", step.label, printable_path(step.program)),
                     options.json == "-");
        worst = worse_code(worst, run(one));
    }
    return worst;
}

}  // namespace

void add_options(cli::App& measure, MeasureOptions& o) {
    using M = MeasureOptions;
    static constexpr OptionRow<M> kRows[] = {
        {"--json", "FILE", kWork, "Dimensions, JSON", store<&M::json>},
        {"--quiet,-q", "", kText, "With --json: no text", store<&M::quiet>}};
    add_program_options(measure, o);
    add_setup_options(measure, o);
    add_rows(measure, "Outputs", kRows, o);
    add_report_unit(measure, o);
    add_simulation_options(measure, o, Models::Exact);
}

void complete(MeasureOptions& o) {
    complete(static_cast<ProgramOptions&>(o));
    require_exact(o, "measure");
    // Without a file, the dimensions are the result.
    if (o.json.empty()) o.quiet = false;
}

int run(const MeasureOptions& options) {
    if (has_steps_to_do(options)) {
        setup::InputSet aside;
        const std::vector<ChosenStep> steps = chosen_steps(options, aside);
        if (!steps.empty()) return measure_job(options, steps);
    }
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    simulation::Plan plan = plan_for(options, options, inputs);
    if (const auto machine = simulation::machine_for(options.machine, plan.job, inputs))
        simulation::apply_machine(plan, *machine);
    if (plan.model.empty()) plan.model = simulation::models().front().name;
    plan.keep_boundary = true;
    outputs.reserve(options.json);
    simulation::Survey survey = simulation::survey(plan);
    print_findings(plan.job.program, survey.diagnostics);
    if (!survey.is_ready()) {
        print_error("ncsim: the program was not simulated\n");
        return kFindings;
    }
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    nothing.history = simulation::read_stock_history(*survey.stock);
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    print_findings(plan.job.program, milled.diagnostics);
    constexpr simulation::Refinement kRefinement{2};
    const simulation::Solid solid =
        simulation::refined_solid(plan, survey, milled, exporter::kStepTolerance, kRefinement);
    report::MeasureSheet sheet = simulation::measures_of(plan, survey, solid, *milled.boundary);
    sheet.program = plan.job.program.name;
    if (!options.quiet)
        put_text(report::text_of(sheet, options.report_unit), outputs.takes_standard_output());
    outputs.write(options.json, [&](std::ostream& out) { report::write_measures(out, sheet); });
    outputs.commit();
    const bool faulty =
        gcode::has_errors(survey.diagnostics) || gcode::has_errors(milled.diagnostics);
    if (faulty)
        print_error("ncsim: the part is not what the blocks with errors would make of it\n");
    return faulty ? kFindings : kClean;
}

}  // namespace ncsim::app
