// SPDX-License-Identifier: GPL-3.0-or-later
//
// Explains a block of a program.
#include "commands/explain_command.h"

#include "ncsim/base/number_text.h"
#include "ncsim/report/explain.h"
#include "ncsim/report/explanation.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/plan_reader.h"

#include "options/job_steps.h"
#include "options/option_row.h"
#include "options/plan_options.h"
#include "system/console.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace ncsim::app {

namespace {

// Takes the line from "part.nc:120".
void take_line(ExplainOptions& o) {
    const std::size_t colon = o.program.rfind(':');
    if (colon == std::string::npos) return;
    const auto line = number_in<std::uint32_t>(std::string_view(o.program).substr(colon + 1));
    if (line.value_or(0) == 0) return;
    if (o.line != 0 && o.line != *line)
        throw Refusal{fmt::format("'{}' and --line {} are two lines", o.program, o.line)};
    o.line = *line;
    o.program.resize(colon);
}

// Returns the options for the set-up of a job. Throws: std::runtime_error if there are several.
ExplainOptions of_set_up(const ExplainOptions& options, setup::InputSet& inputs) {
    ExplainOptions one = options;
    if (!has_steps_to_do(options)) return one;
    const std::vector<ChosenStep> steps = chosen_steps(options, inputs);
    if (steps.size() > 1)
        throw std::runtime_error("the job has several programs: choose a set-up (--setup 1)");
    if (steps.empty()) return one;
    read_ahead(options, steps, inputs);
    one.job_step = steps.front().number;
    return one;
}

}  // namespace

void add_options(cli::App& explain, ExplainOptions& o) {
    using E = ExplainOptions;
    static constexpr OptionRow<E> kBlockRows[] = {
        {"--line", "N", kWork, "Line of the block, as in part.nc:120", store<&E::line>},
        {"--in", "NAME", kWork, "Called file that has the line", store<&E::in>}};

    static constexpr OptionRow<E> kRows[] = {
        {"--no-volume", "", kWork, "Leave out the removed volume, which needs a simulation",
         store<&E::no_volume>},
        {"--json", "", kWork, "JSON", store<&E::json>}};
    add_program_options(explain, o);
    add_setup_options(explain, o);
    add_rows(explain, "Block", kBlockRows, o);
    add_rows(explain, "Outputs", kRows, o);
    add_simulation_options(explain, o, Models::Exact);
}

void complete(ExplainOptions& o) {
    take_line(o);
    complete(static_cast<ProgramOptions&>(o));
    require_exact(o, "explain");
    if (o.line == 0) throw Refusal{"name a line: ncsim explain part.nc:120, or --line 120"};
}

int run(const ExplainOptions& specified) {
    setup::InputSet aside;
    const ExplainOptions options = of_set_up(specified, aside);
    setup::InputSet inputs;
    simulation::Plan plan = plan_for(options, options, inputs);
    if (const auto machine = simulation::machine_for(options.machine, plan.job, inputs))
        simulation::apply_machine(plan, *machine);
    if (plan.model.empty()) plan.model = simulation::models().front().name;
    const simulation::Survey survey = simulation::survey(plan);
    const report::Explanation explanation =
        report::explain(plan, survey, options.line, options.in, !options.no_volume);
    const std::string text =
        options.json ? report::json_of(explanation) : report::text_of(explanation);
    if (options.json) {
        write_stdout(text);
    } else {
        put_text(text);
    }
    const bool is_faulty =
        explanation.executions == 0 || gcode::has_errors(explanation.diagnostics);
    return is_faulty ? kFindings : kClean;
}

}  // namespace ncsim::app
