// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects programs of a job.
#include "options/job_steps.h"

#include "ncsim/setup/job.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::app {

bool has_steps_to_do(const ProgramOptions& options) {
    std::error_code ignored;
    return !options.job.empty() && options.program.empty() && !options.job_step &&
           std::filesystem::is_regular_file(options.job, ignored);
}

std::vector<ChosenStep> chosen_steps(const ProgramOptions& options, setup::InputSet& inputs) {
    std::vector<ChosenStep> chosen;
    if (!has_steps_to_do(options)) return chosen;
    const setup::JobFile file = setup::read_job_file(options.job, inputs);
    const std::string folder = std::filesystem::path(options.job).parent_path().string();
    const std::vector<setup::JobStep> all = setup::steps_of(file, folder);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_meant = options.set_up.empty() || options.set_up == all[i].name ||
                              options.set_up == std::to_string(all[i].set_up);
        if (is_meant) chosen.push_back({all[i], i});
    }
    if (chosen.empty() && !options.set_up.empty()) {
        std::string known;
        for (const setup::JobStep& step : all) {
            if (!step.begins_set_up) continue;
            known += fmt::format("{}{}", known.empty() ? "" : ", ", step.set_up);
            if (!step.name.empty()) known += fmt::format(" ({})", step.name);
        }
        throw std::runtime_error(fmt::format("--setup '{}': {} has no such set-up; expected {}",
                                             options.set_up, options.job, known));
    }
    return chosen;
}

void read_ahead(const ProgramOptions& options, const std::vector<ChosenStep>& steps,
                setup::InputSet& inputs) {
    for (const ChosenStep& step : steps) {
        auto one = static_cast<const setup::JobOptions&>(options);
        one.job_step = step.number;
        one.program = step.program;
        (void)setup::read_job(std::move(one), inputs);
    }
}

int worse_code(int a, int b) {
    const auto rank = [](int code) { return code == kNotProven ? 0.5 : code; };
    return rank(a) < rank(b) ? b : a;
}

}  // namespace ncsim::app
