// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts options into a plan.
#include "options/plan_options.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::app {

namespace {

// Returns the assumptions that the user has not accepted.
std::vector<std::string> open_assumptions(std::vector<std::string> assumed,
                                          const std::vector<std::string>& accepted) {
    std::erase_if(assumed, [&](const std::string& text) {
        const std::string reason = text.substr(0, text.find(':'));
        return std::ranges::any_of(accepted, [&](const std::string& name) {
            return name == reason || (name == "all" && verify::find_reason(reason));
        });
    });
    return assumed;
}

// Cuts the steps before `step` and returns the part as stock of `step`.
toolpath::Stock left_stock(const ProgramOptions& options, const SimulationOptions& simulation,
                           const std::string& machine, std::size_t step, setup::InputSet& inputs,
                           const std::stop_token& stop) {
    const setup::JobFile file = setup::read_job_file(options.job, inputs);
    const std::string folder = std::filesystem::path(options.job).parent_path().string();
    const std::vector<setup::JobStep> steps = setup::steps_of(file, folder);
    const setup::JobStep& before = steps.at(step - 1);
    ProgramOptions earlier = options;
    earlier.program.clear();
    earlier.number_in_file.reset();
    earlier.job_step = step - 1;
    simulation::Plan plan = plan_for(earlier, simulation, machine, inputs, stop);
    plan.budget.stop_with(stop);
    plan.model = simulation::models().front().name;
    plan.keep_removed_cells = true;
    const auto described = machine_for(machine, plan.job, inputs);
    if (described) (void)simulation::apply_machine(plan, *described);
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready()) {
        throw std::runtime_error(fmt::format("{} ({}) leaves no part: {}", before.label,
                                             setup::name_of_input(before.program),
                                             simulation::reason_not_simulated(survey)));
    }
    const simulation::Simulation cut = simulation::simulate(plan, survey, {}, {});
    const std::vector<std::string> assumed = open_assumptions(
        simulation::assumptions_of(plan, survey, described.value_or(setup::MachineFile{})),
        plan.job.options.accept);
    std::stringstream text;
    setup::write_stock_file(text, toolpath::stock_shape(*survey.stock, plan.tool_tolerance),
                            cut.carved, assumed);
    toolpath::StockFile from;
    from.path = fmt::format("the part of {}", before.label);
    if (steps[step].begins_set_up) {
        const setup::JobSetUp& now = file.set_ups[steps[step].set_up - 1];
        from.turn = now.turn;
        from.move = now.move - now.zero;
    }
    toolpath::Stock left = setup::read_saved_stock(from, text.str());
    left.deflection_mm = std::max(left.deflection_mm, survey.stock->deflection_mm);
    return left;
}

}  // namespace

toolpath::Stock LeftStocks::of(std::size_t step, setup::InputSet& inputs, const Make& make) {
    const std::scoped_lock lock(mutex_);
    const auto known = left_.find(step);
    const auto is_unchanged = [&](const auto& file) {
        return setup::digest_of_file(file.first, inputs) == file.second;
    };
    if (known != left_.end() && std::ranges::all_of(known->second.files, is_unchanged))
        return known->second.stock;
    setup::RecordedInput read(inputs);
    toolpath::Stock stock = make(read);
    if (read.knows_all()) left_.insert_or_assign(step, Left{stock, read.files()});
    return stock;
}

bool add_fixtures(setup::MachineFile& machine, const setup::Job& job) {
    if (job.below_stock) machine.machine.below_stock = *job.below_stock;
    if (!job.fixtures_specified) return false;
    machine.machine.fixtures_specified = true;
    auto& fixtures = machine.machine.fixtures;
    fixtures.insert(fixtures.end(), job.fixtures.begin(), job.fixtures.end());
    return true;
}

std::optional<setup::MachineFile> machine_for(const std::string& path, const setup::Job& job,
                                              setup::InputSet& inputs) {
    std::optional<setup::MachineFile> machine;
    if (!path.empty()) machine = setup::read_machine(path, inputs);
    if (!machine && (job.fixtures_specified || job.below_stock)) machine.emplace();
    if (machine) add_fixtures(*machine, job);
    return machine;
}

simulation::Plan plan_for(const ProgramOptions& program, const SimulationOptions& simulation,
                          const std::string& machine, setup::InputSet& inputs,
                          const std::stop_token& stop) {
    simulation::Plan plan;
    // The budget includes reading.
    plan.budget = setup::Budget(simulation.max_memory_gb, simulation.max_seconds);
    auto job = static_cast<const setup::JobOptions&>(program);
    job.job_step = setup::selected_step(job, inputs);
    const std::size_t step = job.job_step.value_or(0);
    if (step > 0 && !job.left_stock) {
        job.left_stock = program.left_stocks->of(step, inputs, [&](setup::InputSet& read) {
            return left_stock(program, simulation, machine, step, read, stop);
        });
    }
    plan.job = setup::read_job(std::move(job), inputs);
    plan.model = simulation.model;
    plan.tolerance = simulation.tolerance;
    plan.tool_tolerance = simulation.tool_tolerance;
    plan.threads = simulation.threads;
    plan.tool_volumes = false;
    return plan;
}

simulation::Plan plan_for(const Options& options, setup::InputSet& inputs) {
    simulation::Plan plan = plan_for(options, options, options.machine, inputs);
    plan.draft = options.draft;
    plan.is_model_specified = options.model_specified;
    plan.needs_exact = needs_exact_part(options);
    plan.resolution = options.resolution;
    plan.rays = options.rays;
    plan.at_line = options.at_line;
    plan.keep_boundary = needs_surface(options);
    plan.keep_paths = options.shows_path;
    plan.keep_removed_cells = !options.save_stock.empty();
    plan.tool_volumes = !options.quiet || !options.report.empty();
    plan.block_volumes = options.block_volumes;
    plan.hull_times = !options.stats.empty();
    return plan;
}

}  // namespace ncsim::app
