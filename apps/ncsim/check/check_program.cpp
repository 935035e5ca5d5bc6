// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/check_program.h"

#include "ncsim/simulation/models.h"

#include "options/plan_options.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace ncsim::app {

namespace {

int exit_code_of(verify::Outcome outcome) {
    switch (outcome) {
        case verify::Outcome::Clean:
        case verify::Outcome::Accepted: return kClean;
        case verify::Outcome::Failed: return kFindings;
        case verify::Outcome::NotProven: break;
    }
    return kNotProven;
}

}  // namespace

simulation::Plan plan_to_check(const std::string& path, const CheckOptions& options,
                               unsigned threads, setup::InputSet& inputs) {
    ProgramOptions program = options;
    program.program = path;
    simulation::Plan plan = plan_for(program, options, inputs);
    if (plan.model.empty()) plan.model = simulation::verifying_model().name;
    plan.threads = threads;
    return plan;
}

int check_program(report::Checked& checked, const std::string& path, const CheckOptions& options,
                  const simulation::Questions& questions, unsigned threads, setup::InputSet& inputs,
                  std::stop_token stop) {
    checked.path = setup::name_of_input(path);
    int code = kEnvironment;
    try {
        simulation::Plan plan = plan_to_check(path, options, threads, inputs);
        plan.budget.stop_with(std::move(stop));
        simulation::check(std::move(plan), questions, checked);
        return exit_code_of(checked.outcome);
    } catch (const std::bad_alloc&) {
        checked.failure = "out of memory";
    } catch (const std::logic_error& e) {
        checked.failure = fmt::format("a bug of ours, please report it: {}", e.what());
        code = kBug;
    } catch (const std::exception& e) {
        checked.failure = e.what();
    }
    checked.verdict = {}, checked.lines.clear();
    return code;
}

}  // namespace ncsim::app
