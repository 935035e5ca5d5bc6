// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the tool sheet of a program.
#include "commands/tools_command.h"

#include "ncsim/report/tool_sheet.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/plunges.h"
#include "ncsim/simulation/survey.h"

#include "run/save_job.h"
#include "system/console.h"
#include "system/output.h"

#include <ostream>

namespace ncsim::app {

cli::App* add_tools(cli::App& app, ToolsOptions& options) {
    cli::App* tools =
        app.add_subcommand("tools", "List the tools of a program: shape, source, use, conflicts");
    add_program_options(*tools, options);
    add_setup_options(*tools, options);
    tools->begin_group("Outputs");
    tools->add_flag("--json", options.json, "JSON");
    return tools;
}

int run(const ToolsOptions& options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (options.json) outputs.claim_standard_output("--json");
    for (const std::string& path : inputs_of(options))
        inputs.expect(path);
    simulation::Plan plan;
    plan.job = setup::read_job(static_cast<const setup::JobOptions&>(options), inputs);
    outputs.reserve(options.save_job);
    const simulation::Survey survey = simulation::survey(plan);
    const report::Plunges plunges = simulation::plunges_of(plan);
    const setup::Job& job = plan.job;
    if (options.json) {
        write_stdout(report::tool_sheet_json(job.program.name, survey, job.tools, plunges));
    } else {
        put_text(report::tool_sheet(survey, job.tools, plunges), outputs.takes_standard_output());
    }
    print_findings(job.program, survey.diagnostics);
    outputs.write(options.save_job,
                  [&](std::ostream& out) { save_job(out, job, survey, options.save_job); });
    outputs.commit();
    return gcode::has_errors(survey.diagnostics) ? kFindings : kClean;
}

}  // namespace ncsim::app
