// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes set-up sheets.
#include "commands/sheet_command.h"

#include "ncsim/report/describe.h"
#include "ncsim/report/set_up_sheet.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/survey.h"

#include "options/job_steps.h"
#include "options/option_row.h"
#include "options/plan_options.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <ostream>
#include <vector>

namespace ncsim::app {

namespace {

std::string text_of(Vec3 v) {
    return fmt::format("X{:g} Y{:g} Z{:g}", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

// Returns the set-up of a step; `facts` outlives the result.
report::SheetSetUp sheet_of(const simulation::Plan& plan, const simulation::Survey& facts,
                            const std::optional<setup::MachineFile>& machine,
                            const ChosenStep* step, const setup::JobFile& file) {
    report::SheetSetUp sheet;
    sheet.title = plan.job.label;
    sheet.program = plan.job.program.name;
    sheet.facts = &facts;
    sheet.described = plan.job.tools;
    if (machine && !machine->machine.name.empty())
        sheet.values.emplace_back("machine", machine->machine.name);
    if (step && !file.set_ups.empty()) {
        const setup::JobSetUp& set_up = file.set_ups[step->set_up - 1];
        if (step->set_up > 1) {
            sheet.values.emplace_back(
                "part", fmt::format("of the last set-up, {}, moved by {}",
                                    set_up.turn.empty() ? "not turned" : "turned " + set_up.turn,
                                    text_of(set_up.move)));
        }
        sheet.values.emplace_back(
            "zero", fmt::format("{} in the frame of part and fixtures", text_of(set_up.zero)));
    }
    const int system = facts.interpretation.workpiece_system;
    if (const auto origin = setup::origin_of(plan.job.interpreter, system)) {
        sheet.values.emplace_back(setup::name_of_system(system),
                                  text_of(*origin) + " in machine coordinates");
    } else {
        sheet.assumed.push_back(fmt::format("origin of {} in machine coordinates",
                                            setup::name_of_system(system == 0 ? 1 : system)));
    }
    if (plan.job.start) sheet.values.emplace_back("start", text_of(*plan.job.start) + " in G54");
    if (machine) {
        for (const verify::Fixture& fixture : machine->machine.fixtures)
            sheet.fixtures.push_back(
                fmt::format("{}: {}", fixture.name, report::describe(fixture.box)));
    }
    for (std::string& assumed :
         simulation::assumptions_of(plan, facts, machine.value_or(setup::MachineFile{})))
        sheet.assumed.push_back(std::move(assumed));
    return sheet;
}

}  // namespace

void add_options(cli::App& sheet, SheetOptions& o) {
    using S = SheetOptions;
    static constexpr OptionRow<S> kRows[] = {
        {"--html", "FILE", kWork, "Sheet, HTML; a page on paper for each set-up", store<&S::html>}};
    add_program_options(sheet, o);
    add_setup_options(sheet, o);
    add_rows(sheet, "Outputs", kRows, o);
    add_report_unit(sheet, o);
}

void complete(SheetOptions& o) {
    complete(static_cast<ProgramOptions&>(o));
    if (o.html.empty()) throw Refusal{"sheet: name the file to write: --html sheet.html"};
}

int run(const SheetOptions& options) {
    setup::InputSet inputs(inputs_of(options));
    OutputSet outputs(inputs);
    outputs.reserve(options.html);
    const std::vector<ChosenStep> steps = chosen_steps(options, inputs);
    setup::JobFile file;
    if (!steps.empty()) file = setup::read_job_file(options.job, inputs);
    std::deque<simulation::Survey> surveys;
    std::vector<report::SheetSetUp> sheets;
    bool faulty = false;
    const auto add = [&](const SheetOptions& one, const ChosenStep* step) {
        const SimulationOptions usual;
        simulation::Plan plan = plan_for(one, usual, inputs);
        const auto machine = simulation::machine_for(one.machine, plan.job, inputs);
        if (machine) (void)simulation::apply_machine(plan, *machine);
        const simulation::Survey& facts = surveys.emplace_back(simulation::survey(plan));
        print_findings(plan.job.program, facts.diagnostics);
        faulty |= gcode::has_errors(facts.diagnostics);
        sheets.push_back(sheet_of(plan, facts, machine, step, file));
    };
    if (steps.empty()) add(options, nullptr);
    for (const ChosenStep& step : steps) {
        SheetOptions one = options;
        one.job_step = step.number;
        add(one, &step);
    }
    const std::string name = setup::name_of_input(steps.empty() ? options.program : options.job);
    outputs.write(options.html, [&](std::ostream& out) {
        report::write_set_up_sheet(out, name, sheets, options.report_unit);
    });
    outputs.commit();
    return faulty ? kFindings : kClean;
}

}  // namespace ncsim::app
