// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the settings of programs.
#include "check/check_settings.h"

#include "ncsim/base/plain_text.h"
#include "ncsim/base/version.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/machine_formats.h"
#include "ncsim/setup/recorded_input.h"
#include "ncsim/setup/stock_file.h"

#include "check/reports.h"
#include "commands/options.h"
#include "commands/project.h"
#include "system/console.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <system_error>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

std::function<bool(const std::string&)> is_in(const std::set<std::string>& given) {
    return [&given](const std::string& option) { return given.contains(option); };
}

CheckOptions parsed(const std::vector<std::string>& words) {
    return std::get<CheckOptions>(parsed_again(words));
}

std::string key_of(const CheckOptions& options, const setup::RecordedInput& read) {
    std::string key = fmt::format("ncsim {}\n{}", kVersion, options.specified);
    if (!options.csv.empty()) key += "csv\n";
    for (const auto& [file, digest] : read.files())
        key += absolute_name(file) + '\n' + digest.value_or("") + '\n';
    return key;
}

// Cached and sharded entries contain all formats, because later reports may need any.
report::EntryOptions entries_for(const CheckOptions& options, bool many) {
    const bool all = !options.cache.empty() || !options.shard.empty();
    report::EntryOptions entries;
    entries.many = many;
    entries.notes = options.notes;
    entries.quiet = options.quiet;
    entries.warnings_as_errors = options.warnings_as_errors;
    entries.json = all || !options.json.empty();
    entries.sarif = all || !options.sarif.empty();
    entries.junit = all || !options.junit.empty();
    entries.github = all || options.github;
    entries.csv = !options.csv.empty();
    entries.unit = options.report_unit;
    entries.known = all || !options.write_baseline.empty();
    return entries;
}

}  // namespace

SettingsOfPrograms::SettingsOfPrograms(const CheckOptions& specified,
                                       const std::vector<std::string>& programs,
                                       setup::InputSet& inputs)
    : specified_(specified), inputs_(inputs), many_(programs.size() > 1) {
    std::map<std::string, std::size_t> numbers;
    std::map<const setup::ProjectFile*, std::vector<std::string>> programs_of;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        // The settings of a job are those for the job file.
        const std::string& program = specified.steps.empty() ? programs[i] : specified.job;
        const setup::ProjectFile* project = specified.no_project ? nullptr : project_of(program);
        if (project) programs_of[project].push_back(program);
        std::vector<setup::OptionSetting> settings;
        if (project) settings = setup::settings_for(*project, program);
        std::optional<std::size_t> step;
        if (!specified.steps.empty()) step = specified.steps[i];
        std::string same = project ? project->name : "";
        for (const setup::OptionSetting& setting : settings)
            same += '\n' + setting.where;
        if (step) same += fmt::format("\nstep {}", *step);
        const auto [number, is_new] = numbers.try_emplace(same, settings_.size());
        if (is_new) fill(settings_.emplace_back(), project, settings, step);
        number_of_.push_back(number->second);
    }
    for (const auto& [name, project] : projects_)
        setup::expect_programs(project, programs_of[&project]);
}

std::string SettingsOfPrograms::notes() const {
    std::string text;
    for (const std::string& note : notes_)
        text += note;
    return text;
}

std::string SettingsOfPrograms::label_of_step(std::size_t step) const {
    const setup::JobFile file = setup::read_job_file(specified_.job, inputs_);
    return setup::steps_of(file, {}).at(step).label;
}

std::string SettingsOfPrograms::key() const {
    std::string key;
    for (const CheckSettings& settings : settings_)
        key += settings.key;
    for (const auto& [file, baseline] : baselines_) {
        for (const auto& [program, findings] : baseline->programs())
            key += baseline->key_of_program(program) + '\n';
    }
    for (const std::size_t number : number_of_)
        key += fmt::format("{},", number);
    return key;
}

std::string SettingsOfPrograms::lost_programs() const {
    std::string text;
    for (const auto& [file, baseline] : baselines_) {
        for (const auto& [program, findings] : baseline->programs()) {
            std::error_code ignored;
            if (std::filesystem::exists(program, ignored)) continue;
            text += fmt::format("ncsim: {}: {} known finding{} of '{}', which is not there\n",
                                printable_path(file), findings, findings == 1 ? "" : "s",
                                one_line(program));
        }
    }
    return text;
}

std::shared_ptr<const report::Baseline> SettingsOfPrograms::baseline_of(
    const CheckOptions& options) {
    if (options.baseline.empty()) return nullptr;
    const auto [known, is_new] = baselines_.try_emplace(options.baseline);
    if (is_new && rewrites_baseline(options)) {
        // The first run has no baseline yet.
        auto before = overwritten_baseline(options.baseline);
        known->second = std::make_shared<const report::Baseline>(
            before ? std::move(*before) : report::Baseline(options.baseline));
    } else if (is_new) {
        known->second = std::make_shared<const report::Baseline>(options.baseline,
                                                                 inputs_.read(options.baseline));
    }
    return known->second;
}

const setup::ProjectFile* SettingsOfPrograms::project_of(const std::string& program) {
    const std::string folder = std::filesystem::path(program).parent_path().string();
    const auto [above, is_new] = project_above_.try_emplace(folder);
    if (is_new) above->second = setup::find_project_file(program);
    if (!above->second) return nullptr;
    const auto known = projects_.find(*above->second);
    if (known != projects_.end()) return &known->second;
    const auto read =
        projects_.emplace(*above->second, setup::read_project_file(*above->second, inputs_));
    for (const auto& section : read.first->second.sections) {
        for (const setup::OptionSetting& setting : section.settings)
            (void)words_of_setting(setting, read.first->second.folder);
    }
    return &read.first->second;
}

void SettingsOfPrograms::fill(CheckSettings& made, const setup::ProjectFile* project,
                              const std::vector<setup::OptionSetting>& settings,
                              std::optional<std::size_t> step) {
    made.options = specified_;
    if (project) {
        made.project = project->name;
        std::vector<std::string> overridden;
        const auto is_free = [this](const std::string& option) {
            return !specified_.given.contains(option);
        };
        const JobValues job(job_of(specified_, settings, project->folder), inputs_);
        std::vector<std::string> words = specified_.words;
        if (specified_.job.empty())
            words = with_settings(std::move(words), job.settings(), job.folder(), is_free);
        const std::vector<setup::OptionSetting> rest = job.without_own(settings, overridden);
        words = with_settings(std::move(words), rest, project->folder, is_free);
        made.options = parsed(words);
        made.options.left_stocks =
            left_stocks_.try_emplace(words, made.options.left_stocks).first->second;
        if (!specified_.quiet) {
            for (const std::string& line : overridden)
                notes_.insert("note: " + line + '\n');
        }
        if (specified_.verbose) {
            for (const setup::OptionSetting& setting : rest)
                if (is_free(setting.option)) notes_.insert("setting  " + line_of(setting) + '\n');
            if (specified_.job.empty()) {
                for (const std::string& line : job.lines(is_in(specified_.given)))
                    notes_.insert("setting  " + line + '\n');
            }
        }
        for (const setup::OptionSetting& setting : settings) {
            if (!specified_.given.contains(setting.option))
                made.options.selection.set_origin("--" + setting.option, setting.where);
        }
    }
    made.options.job_step = step;
    if (step && specified_.steps.size() > 1) made.label = label_of_step(*step);
    const CheckOptions& options = made.options;
    // The standard input is already expected if the command line names it.
    for (const std::string& path : inputs_of(options)) {
        if (path != "-") inputs_.expect(path);
    }
    setup::RecordedInput read(inputs_);
    simulation::VerificationOptions& verification_options = made.verification_options;
    if (!options.machine.empty()) {
        verification_options.machine = setup::read_machine(options.machine, read);
        verification_options.bodies = simulation::bodies_of(verification_options.machine);
    }
    if (!options.design.empty()) {
        made.design = simulation::read_design(options.design, options.design_tolerance, read);
        simulation::require_tolerance(*made.design);
        verification_options.design = &*made.design;
    }
    made.baseline = baseline_of(options);
    verification_options.baseline = made.baseline.get();
    verification_options.selection = options.selection;
    verification_options.dog_leg = options.dog_leg;
    verification_options.is_rapid_specified = options.given.contains("rapid");
    verification_options.detached_pieces = options.detached_pieces;
    verification_options.air_cuts = options.air_cuts;
    verification_options.ledger = !options.csv.empty();
    verification_options.wants_page = !options.html.empty();
    verification_options.warnings_as_errors = options.warnings_as_errors;
    // With a single program, all specified tools are intended for this program.
    verification_options.tools_are_meant = !many_;
    made.entries = entries_for(options, many_);
    made.entries.csv_unit = specified_.report_unit;
    made.key = key_of(options, read);
    if (!many_) made.key += "one\n";
    if (step) made.key += fmt::format("step {}\n", *step);
    if (!options.cache.empty()) {
        made.cache.emplace(options.cache, made.key,
                           [](const std::string& what) { print_error("ncsim: " + what + '\n'); });
    }
}

}  // namespace ncsim::app
