// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simulates the program up to a finding, and draws the result as `ncsim run` does.
#include "check/finding_picture.h"

#include "ncsim/report/check_text.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/plan_reader.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/shading.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/stock_history.h"

#include "check/check_program.h"
#include "run/outcome.h"
#include "run/picture.h"
#include "run/placed_fixtures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace ncsim::app {

namespace {

// Returns the finding to be drawn; null if there is none.
const verify::Finding* chosen_finding(const CheckOptions& options, const verify::Verdict& verdict) {
    const auto& findings = verdict.findings;
    if (options.finding) {
        const std::vector<std::size_t> listed = report::listed_findings(verdict, options.notes);
        if (*options.finding > listed.size()) {
            throw std::runtime_error(
                fmt::format("--finding {}: the text lists {} finding{} of the program{}",
                            *options.finding, listed.size(), listed.size() == 1 ? "" : "s",
                            options.notes ? "" : "; --notes lists the notes too"));
        }
        return &findings[listed[*options.finding - 1]];
    }
    const auto weight = [](const verify::Finding& f) {
        return std::tuple(f.counts(), f.severity, f.category == verify::Category::Collision);
    };
    const auto found = std::ranges::max_element(findings, {}, weight);
    return found == findings.end() ? nullptr : &*found;
}

// Returns options of `ncsim run` that draw a finding.
Options drawing_options(const std::string& program, const CheckOptions& check,
                        const verify::Finding* finding) {
    Options options;
    static_cast<ProgramOptions&>(options) = static_cast<const ProgramOptions&>(check);
    static_cast<SimulationOptions&>(options) = static_cast<const SimulationOptions&>(check);
    static_cast<PictureOptions&>(options) = static_cast<const PictureOptions&>(check);
    options.program = program;
    options.machine = check.machine;
    options.png = check.png;
    options.shows_fixtures = true;
    options.shows_tool = finding != nullptr && finding->first_motion > 0;
    return options;
}

}  // namespace

exporter::Image finding_picture(const std::string& program, const CheckSettings& settings,
                                const report::Checked& checked, setup::InputSet& inputs) {
    const CheckOptions& check = settings.options;
    const verify::Finding* const finding = chosen_finding(check, checked.verdict);
    Options options = drawing_options(program, check, finding);
    simulation::Plan plan = plan_to_check(program, check, check.threads, inputs);
    plan.keep_boundary = true;
    std::optional<setup::MachineFile> machine =
        simulation::machine_for(options.machine, plan.job, inputs);
    if (machine) (void)simulation::apply_machine(plan, *machine);
    options.model = plan.model;
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready())
        throw std::runtime_error("--png: no picture, because the program was not simulated");
    require_cut_view(options, survey.stock->box, "stock");

    simulation::Verification verification;
    verification.rapid = simulation::rapid_path(settings.verification_options);
    verification.keep_cuts = true;
    verification.history = simulation::read_stock_history(*survey.stock);
    if (options.shows_tool) {
        verification.only_motion = finding->first_motion;
        verification.nearest_to = verify::point_of(*finding);
        verification.last_removes_nothing = finding->rule == "rapid-in-material";
    }
    const simulation::Simulation simulation = simulation::simulate(plan, survey, verification, {});
    const brep::Shading shading =
        simulation::shading_of(plan, survey, simulation, *simulation.boundary);
    Outcome outcome{options, plan, survey, &simulation, &*simulation.boundary, &shading};
    outcome.machine = machine ? &*machine : nullptr;
    outcome.fixtures = placed_fixtures(plan, survey, machine);
    outcome.finding = finding;
    options.shows_machine = finding && finding->joints && machine && !machine->bodies.empty();
    return picture(outcome);
}

}  // namespace ncsim::app
