// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the files of a job, and cuts its earlier steps.
#include "ncsim/simulation/plan_reader.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/apply_machine.h"
#include "ncsim/simulation/fixtures.h"
#include "ncsim/simulation/left_shape.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/stock_history.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/doubt.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ncsim::simulation {

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
toolpath::Stock left_stock(const setup::JobOptions& job, const SimulationOptions& options,
                           const std::string& machine, std::size_t step, LeftStocks& left_stocks,
                           setup::InputSet& inputs, const std::stop_token& stop) {
    const setup::JobFile file = setup::read_job_file(job.job, inputs);
    const std::string folder = std::filesystem::path(job.job).parent_path().string();
    const std::vector<setup::JobStep> steps = setup::steps_of(file, folder);
    const setup::JobStep& before = steps.at(step - 1);
    setup::JobOptions earlier = job;
    earlier.program.clear();
    earlier.number_in_file.reset();
    earlier.job_step = step - 1;
    Plan plan = read_plan(std::move(earlier), options, machine, left_stocks, inputs, stop);
    plan.budget.stop_with(stop);
    plan.model = models().front().name;
    plan.keep_removed_cells = true;
    const auto described = machine_for(machine, plan.job, inputs);
    if (described) (void)apply_machine(plan, *described);
    const Survey seen = survey(plan);
    if (!seen.is_ready()) {
        throw std::runtime_error(fmt::format("{} ({}) leaves no part: {}", before.label,
                                             setup::name_of_input(before.program),
                                             reason_not_simulated(seen)));
    }
    Verification nothing;
    nothing.keep_cuts = true;
    nothing.history = read_stock_history(*seen.stock);
    Simulation cut = simulate(plan, seen, nothing, {});
    const std::vector<std::string> assumed =
        open_assumptions(assumptions_of(plan, seen, described.value_or(setup::MachineFile{})),
                         plan.job.options.accept);
    std::stringstream text;
    cda::write_shape(text, take_left_shape(plan, seen, cut, assumed));
    toolpath::StockFile from;
    from.path = fmt::format("the part of {}", before.label);
    if (steps[step].begins_set_up) {
        const setup::JobSetUp& now = file.set_ups[steps[step].set_up - 1];
        from.turn = now.turn;
        from.move = now.move - now.zero;
    }
    toolpath::Stock left = setup::read_saved_stock(from, text.str());
    left.deflection_mm = std::max(left.deflection_mm, seen.stock->deflection_mm);
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

std::optional<setup::MachineFile> machine_for(const std::string& path, const setup::Job& job,
                                              setup::InputSet& inputs) {
    std::optional<setup::MachineFile> machine;
    if (!path.empty()) machine = setup::read_machine(path, inputs);
    if (!machine && (job.fixtures_specified || job.below_stock)) machine.emplace();
    if (machine) add_fixtures(*machine, job);
    return machine;
}

Plan read_plan(setup::JobOptions job, const SimulationOptions& options, const std::string& machine,
               LeftStocks& left_stocks, setup::InputSet& inputs, const std::stop_token& stop) {
    Plan plan;
    // The budget includes reading.
    plan.budget = setup::Budget(options.max_memory_gb, options.max_seconds);
    job.job_step = setup::selected_step(job, inputs);
    const std::size_t step = job.job_step.value_or(0);
    if (step > 0 && !job.left_stock) {
        job.left_stock = left_stocks.of(step, inputs, [&](setup::InputSet& read) {
            return left_stock(job, options, machine, step, left_stocks, read, stop);
        });
    }
    plan.job = setup::read_job(std::move(job), inputs);
    plan.model = options.model;
    plan.tolerance = options.tolerance;
    plan.tool_tolerance = options.tool_tolerance;
    plan.threads = options.threads;
    plan.tool_volumes = false;
    return plan;
}

}  // namespace ncsim::simulation
