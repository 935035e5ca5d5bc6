// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes first job files and project files.
#include "commands/init_command.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/setup/coordinate_systems.h"
#include "ncsim/setup/job.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/job_writer.h"
#include "ncsim/setup/program_folder.h"
#include "ncsim/setup/project_file.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/survey.h"

#include "options/option_row.h"
#include "run/save_job.h"
#include "system/console.h"
#include "system/output.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

namespace ncsim::app {

namespace {

namespace fs = std::filesystem;

// Adds the tools of a further program. Returns the numbers of tools that both describe differently.
std::vector<int> merge_tools(DescribedJob& all, DescribedJob more) {
    std::vector<int> different;
    for (std::size_t i = 0; i < more.file.tools.size(); ++i) {
        const toolpath::ToolEntry& entry = more.file.tools[i];
        const toolpath::ToolEntry* const known =
            toolpath::find_tool(all.file.tools, entry.spec.number);
        if (known) {
            if (!(known->spec.kind == entry.spec.kind &&
                  known->spec.diameter == entry.spec.diameter))
                different.push_back(entry.spec.number);
            continue;
        }
        all.file.tools.push_back(entry);
        all.remarks.tools.push_back(std::move(more.remarks.tools[i]));
        all.remarks.unknown_tools.erase(entry.spec.number);
    }
    for (const auto& [number, line] : more.remarks.unknown_tools) {
        if (!toolpath::find_tool(all.file.tools, number))
            all.remarks.unknown_tools.emplace(number, line);
    }
    return different;
}

std::string first_job(const InitOptions& options, setup::InputSet& inputs) {
    DescribedJob all;
    std::vector<setup::FirstSetUp> set_ups;
    std::string notes;
    for (std::size_t i = 0; i < options.programs.size(); ++i) {
        setup::JobOptions one;
        one.program = options.programs[i];
        simulation::Plan plan;
        plan.draft = true;  // guesses tools that are not described
        plan.job = setup::read_job(std::move(one), inputs);
        const simulation::Survey survey = simulation::survey(plan);
        print_findings(plan.job.program, survey.diagnostics);
        DescribedJob described = describe_job(plan.job, survey, options.output);
        constexpr double kAbove = 100.0;  // mm above the stock
        constexpr int kG54 = 1;
        setup::FirstSetUp set_up;
        set_up.name = fs::path(options.programs[i]).stem().string();
        set_up.program = path_from(options.output, options.programs[i]);
        const int system = survey.interpretation.workpiece_system;
        set_up.zero = setup::name_of_system(system == 0 ? kG54 : system);
        set_up.start_is_specified = plan.job.start.has_value();
        set_up.start = plan.job.start.value_or(
            Vec3{0.0, 0.0, kAbove + (survey.stock ? survey.stock->box.max.z : 0.0)});
        if (i == 0) {
            all = std::move(described);
        } else {
            for (const int number : merge_tools(all, std::move(described)))
                notes += fmt::format("note: T{} has another shape in {}; the first counts\n",
                                     number, printable_path(options.programs[i]));
        }
        if (all.file.stock) set_up.height = all.file.stock->box.size().z;
        set_ups.push_back(std::move(set_up));
    }
    if (!options.quiet) print_error(notes);
    std::ostringstream out;
    setup::write_first_job(out, all.file, all.remarks, set_ups);
    return out.str();
}

std::string first_project(const std::string& folder) {
    const setup::ProgramFolder found = setup::programs_in_folder(folder);
    std::set<std::string> folders;
    for (const std::string& program : found.programs) {
        const std::string below =
            fs::path(program).lexically_relative(folder).parent_path().generic_string();
        if (!below.empty()) folders.insert(below);
    }
    std::ostringstream out;
    setup::write_first_project(out, folders);
    return out.str();
}

}  // namespace

void add_options(cli::App& init, InitOptions& o) {
    using I = InitOptions;
    static constexpr OptionRow<I> kRows[] = {
        {"programs", "FILES", kWork, "NC programs, a set-up each; with --repo a folder",
         store<&I::programs>},
        {"--output,-o", "FILE", kWork, "File to write [job.toml]", store<&I::output>},
        {"--repo", "", kWork, "Write ncsim.toml for a folder instead", store<&I::repo>},
        {"--quiet,-q", "", kText, "Print errors and warnings only", store<&I::quiet>}};
    add_rows(init, "Outputs", kRows, o);
}

void complete(InitOptions& o) {
    if (!o.repo && o.programs.empty()) throw Refusal{"init: name the NC programs of the job"};
    if (o.repo && o.programs.size() > 1) throw Refusal{"--repo: expected one folder"};
    for (const std::string& program : o.programs) {
        if (program == "-") throw Refusal{"init: the program has to have a name"};
        if (setup::is_job_file(program))
            throw Refusal{fmt::format("'{}' is a job file already; name NC programs", program)};
    }
    if (o.output == "-") throw Refusal{"--output: expected the name of a file"};
    if (o.repo) {
        const std::string folder = o.programs.empty() ? "." : o.programs[0];
        if (o.output.empty()) o.output = (fs::path(folder) / setup::kProjectFileName).string();
    } else if (o.output.empty()) {
        o.output = "job.toml";
    } else if (!setup::is_job_file(o.output)) {
        throw Refusal{fmt::format("--output '{}': the name of a job file ends in .toml", o.output)};
    }
}

int run(const InitOptions& options) {
    setup::InputSet inputs;
    OutputSet outputs(inputs);
    if (!options.repo) {
        for (const std::string& program : options.programs)
            inputs.expect(program);
    }
    outputs.reserve_new(options.output);
    const std::string text =
        options.repo ? first_project(options.programs.empty() ? "." : options.programs[0])
                     : first_job(options, inputs);
    outputs.write(options.output, [&](std::ostream& out) { out << text; });
    outputs.commit();
    if (options.quiet) return kClean;
    const std::string name = printable_path(options.output);
    if (options.repo) {
        put_text(fmt::format("{} written: remove the # before what applies\n", name));
    } else {
        put_text(fmt::format("{0} written\n  next     complete it, then: ncsim check {0}\n", name));
    }
    return kClean;
}

}  // namespace ncsim::app
