// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies one program.
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
                               unsigned threads, setup::InputSet& inputs, std::size_t number,
                               const std::stop_token& stop) {
    ProgramOptions program = static_cast<const ProgramOptions&>(options);
    program.program = path;
    program.number_in_file = number;
    simulation::Plan plan = plan_for(program, options, inputs, stop);
    if (plan.model.empty()) plan.model = simulation::verifying_model().name;
    plan.threads = threads;
    return plan;
}

int check_program(report::Checked& checked, const std::string& path, const CheckOptions& options,
                  const simulation::VerificationOptions& verification_options, unsigned threads,
                  setup::InputSet& inputs, std::stop_token stop, std::size_t number,
                  std::size_t& programs) {
    checked.path = setup::name_of_input(path);
    int code = kEnvironment;
    try {
        simulation::Plan plan = plan_to_check(path, options, threads, inputs, number, stop);
        programs = plan.job.programs_in_file;
        checked.program = plan.job.label;
        if (programs > 1 && verification_options.tiles) {
            throw std::runtime_error(
                fmt::format("{} programs in one file: tiles are of a single one", programs));
        }
        plan.budget.stop_with(std::move(stop));
        simulation::VerificationOptions with_fixtures = verification_options;
        simulation::add_fixtures(with_fixtures, plan.job);
        simulation::check(std::move(plan), with_fixtures, checked);
        return exit_code_of(checked.outcome);
    } catch (const std::bad_alloc&) {
        checked.failure = "out of memory";
    } catch (const std::logic_error& e) {
        checked.failure = fmt::format("a bug of ours, please report it: {}", e.what());
        code = kInternalError;
    } catch (const std::exception& e) {
        checked.failure = e.what();
    }
    checked.verdict = {}, checked.lines.clear();
    return code;
}

}  // namespace ncsim::app
