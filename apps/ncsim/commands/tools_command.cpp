// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the tool sheet of a program.
#include "commands/tools_command.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/report/tool_sheet.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/job_writer.h"
#include "ncsim/setup/tool_library.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/plunges.h"
#include "ncsim/simulation/survey.h"

#include "options/job_steps.h"
#include "options/option_row.h"
#include "options/plan_options.h"
#include "run/save_job.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

void add_options(cli::App& tools, ToolsOptions& o) {
    using T = ToolsOptions;
    static constexpr OptionRow<T> kRows[] = {
        {"--json", "", kWork, "JSON", store<&T::json>},
        {"--convert", "FILE", kWork,
         "Tools of --tool-table as a job (.toml) or for LinuxCNC (.tbl)", store<&T::convert>},
        {"--quiet,-q", "", kText, "With --save-job or --convert: no text", store<&T::quiet>}};
    add_program_options(tools, o);
    add_setup_options(tools, o);
    add_save_job(tools, o);
    add_rows(tools, "Outputs", kRows, o);
    add_report_unit(tools, o);
}

namespace {

constexpr std::string_view kTableEnding = ".tbl";

// Prints the sheet of one program. Returns the exit code; with `json`, adds the sheet to this text
// instead.
int print_sheet(const ToolsOptions& options, const std::string& set_up, setup::InputSet& inputs,
                OutputSet& outputs, std::string* json) {
    const SimulationOptions usual;
    simulation::Plan plan = plan_for(options, usual, inputs);
    // Counted without the machine.
    const report::Plunges plunges = simulation::plunges_of(plan);
    if (const auto machine = simulation::machine_for(options.machine, plan.job, inputs))
        (void)simulation::apply_machine(plan, *machine);
    outputs.reserve(options.save_job);
    const simulation::Survey survey = simulation::survey(plan);
    const setup::Job& job = plan.job;
    if (options.json) {
        std::string sheet =
            report::tool_sheet_json(job.program.name, set_up, survey, job.tools, plunges);
        if (json) {
            while (sheet.ends_with('\n'))
                sheet.pop_back();
            *json += (json->empty() ? "" : ",\n") + sheet;
        } else {
            write_stdout(sheet);
        }
    } else if (!options.quiet) {
        put_text(report::tool_sheet(survey, job.tools, plunges, options.report_unit),
                 outputs.takes_standard_output());
    }
    print_findings(job.program, survey.diagnostics);
    outputs.write(options.save_job, [&](std::ostream& out) {
        save_job(out, job, survey, options.machine, options.save_job);
    });
    return gcode::has_errors(survey.diagnostics) ? kFindings : kClean;
}

// Writes the tools of the tables to options.convert.
int convert(const ToolsOptions& options) {
    setup::InputSet inputs(options.tool_tables);
    OutputSet outputs(inputs);
    outputs.reserve(options.convert);
    setup::JobFile file;
    file.units_assumed = file.dialect_assumed = true;
    setup::JobRemarks remarks;
    for (const std::string& path : options.tool_tables) {
        const toolpath::ToolFile table =
            setup::read_tool_library(path, inputs, options.inches.value_or(false));
        print_findings({setup::name_of_input(path), {}}, table.diagnostics);
        if (gcode::has_errors(table.diagnostics)) return kEnvironment;
        for (const toolpath::ToolEntry& entry : table.tools) {
            if (toolpath::find_tool(file.tools, entry.spec.number)) continue;
            file.tools.push_back(entry);
            remarks.tools.push_back({fmt::format("{}, {}", table.format, entry.file)});
        }
    }
    const bool is_table = options.convert.ends_with(kTableEnding);
    outputs.write(options.convert, [&](std::ostream& out) {
        if (is_table) {
            setup::write_tool_table(out, file.tools, options.inches.value_or(false));
        } else {
            setup::write_job_file(out, file, remarks);
        }
    });
    outputs.commit();
    if (options.quiet) return kClean;
    put_text(fmt::format("{}: {} tools\n", printable_path(options.convert), file.tools.size()));
    return kClean;
}

}  // namespace

void complete(ToolsOptions& o) {
    // Without a file, the sheet is the result.
    if (o.convert.empty() && o.save_job.empty()) o.quiet = false;
    if (o.convert.empty()) return complete(static_cast<ProgramOptions&>(o));
    if (!o.convert.ends_with(kTableEnding) && !setup::is_job_file(o.convert))
        throw Refusal{fmt::format("--convert '{}': expected a file .toml or .tbl", o.convert)};
    if (!o.program.empty() || !o.job.empty())
        throw Refusal{
            "--convert is about --tool-table alone; --save-job writes the tools of a program"};
    if (o.json || !o.save_job.empty() || !o.tools.empty())
        throw Refusal{
            "--convert is about --tool-table alone; expected no --json, --save-job, --tool"};
    if (o.tool_tables.empty()) throw Refusal{"--convert: name the tools: --tool-table FILE"};
}

int run(const ToolsOptions& options) {
    if (!options.convert.empty()) return convert(options);
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    if (options.json) outputs.claim_standard_output("--json");
    const std::vector<ChosenStep> steps = chosen_steps(options, inputs);
    if (steps.size() < 2) {
        ToolsOptions one = options;
        if (!steps.empty()) one.job_step = steps[0].number;
        const std::string set_up = steps.empty() ? std::string() : steps[0].label;
        const int code = print_sheet(one, set_up, inputs, outputs, nullptr);
        outputs.commit();
        return code;
    }
    if (!options.save_job.empty())
        throw std::runtime_error("--save-job: the job has several set-ups; select one: --setup 1");
    int worst = kClean;
    std::string sheets;
    for (const ChosenStep& step : steps) {
        ToolsOptions one = options;
        one.job_step = step.number;
        if (!options.json)
            put_text(fmt::format("{}: {}\n", step.label, printable_path(step.program)));
        worst = worse_code(worst, print_sheet(one, step.label, inputs, outputs, &sheets));
    }
    if (options.json) write_stdout("{\"programs\": [\n" + sheets + "\n]}\n");
    outputs.commit();
    return worst;
}

}  // namespace ncsim::app
