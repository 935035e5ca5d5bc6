// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the set-ups of a job.
#include "run/run_job.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/machine_formats.h"

#include "system/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace ncsim::app {

namespace {

// Returns the place of an output of the job file in the options.
std::string& output_of(Options& o, const std::string& format) {
    const std::string option = "--" + (format == "stock" ? "save-stock" : format);
    return o.*std::ranges::find(output_files(), option, &OutputFile::option)->path;
}

// Removes all outputs of the command line.
void clear_outputs(Options& o) {
    for (const OutputFile& file : output_files())
        (o.*file.path).clear();
    o.frames.clear();
    o.mesh_folder.clear();
    o.sections.clear();
}

// Adds outputs of the job file unless the command line has them.
void add_outputs(Options& o, const std::map<std::string, std::string>& outputs,
                 const std::string& folder) {
    for (const auto& [format, name] : outputs) {
        std::string& path = output_of(o, format);
        if (path.empty()) path = setup::output_below(folder, name, o.job);
    }
    if (!o.step.empty()) require_exact(o, "--step");
    if (!o.save_stock.empty()) require_exact(o, "--save-stock");
}

}  // namespace

int run_job(const Options& options, const std::vector<ChosenStep>& steps,
            const std::function<int(Options)>& run_step) {
    if (steps.size() > 1 && !options.tile.empty())
        throw std::runtime_error("--tile: a tile is of one part; select it with --setup");
    if (steps.size() > 1 && !options.save_job.empty())
        throw std::runtime_error("--save-job: the job has several set-ups; select one: --setup 1");
    setup::InputSet inputs;
    const setup::JobFile file = setup::read_job_file(options.job, inputs);
    const std::string folder = std::filesystem::path(options.job).parent_path().string();
    read_ahead(options, steps, inputs);
    if (!options.machine.empty()) (void)setup::read_machine(options.machine, inputs);
    int worst = kClean;
    for (const ChosenStep& step : steps) {
        const bool is_last = &step == &steps.back();
        const bool ends_set_up = is_last || (&step + 1)->begins_set_up;
        Options one = options;
        one.job_step = step.number;
        if (!is_last) clear_outputs(one);
        if (ends_set_up && !file.set_ups.empty())
            add_outputs(one, file.set_ups[step.set_up - 1].outputs, folder);
        if (is_last) add_outputs(one, file.outputs, folder);
        if (steps.size() > 1 && !options.quiet) {
            const bool takes_stdout = std::ranges::count(outputs_of(options), "-") > 0;
            put_text(fmt::format("{}: {}\n", step.label, printable_path(step.program)),
                     takes_stdout);
        }
        worst = worse_code(worst, run_step(std::move(one)));
    }
    return worst;
}

}  // namespace ncsim::app
