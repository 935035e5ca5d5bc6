// SPDX-License-Identifier: GPL-3.0-or-later
//
// Completes command lines from ncsim.toml.
#include "commands/project.h"

#include "ncsim/setup/input.h"
#include "ncsim/setup/stock_file.h"

#include "system/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

std::runtime_error error_at(const setup::OptionSetting& setting, const std::string& what) {
    return std::runtime_error(fmt::format("{}: {}", setting.where, what));
}

// Returns a setting as words of a command line; file names are relative to the folder of the
// project.
std::vector<std::string> setting_words(const setup::OptionSetting& setting,
                                       const std::string& folder) {
    const std::optional<OptionKind> kind = kind_of_check_option(setting.option);
    if (!kind) {
        throw error_at(setting, fmt::format("'{}': no option of ncsim check that decides verdicts",
                                            setting.option));
    }
    if (setting.is_flag != kind->is_flag) {
        throw error_at(setting, fmt::format("'{}': expected {}", setting.option,
                                            kind->is_flag ? "true or false" : "a value"));
    }
    const std::string name = "--" + setting.option;
    if (kind->is_switch) return {name + (setting.is_on ? "=on" : "=off")};
    if (setting.is_flag) return setting.is_on ? std::vector{name} : std::vector<std::string>();
    std::vector<std::string> words;
    // Reading a FIFO without a writer would block.
    const auto refuse_stream = [&](const std::string& file) {
        std::error_code ignored;
        const std::filesystem::file_status status = std::filesystem::status(file, ignored);
        if (std::filesystem::exists(status) && std::filesystem::is_other(status)) {
            throw error_at(setting,
                           fmt::format("{} '{}': it is no regular file", setting.option, file));
        }
    };
    for (const std::string& value : setting.values) {
        const bool is_file =
            kind->is_file || (setting.option == "stock" && setup::is_stock_file(value));
        const bool is_path = is_file && !value.empty();
        if (is_path) refuse_stream(setup::seen_in(folder, value));
        words.push_back(name + '=' + (is_path ? setup::seen_in(folder, value) : value));
    }
    return words;
}

// Returns the key of a job file with the same meaning as an option.
std::string key_of(std::string option) {
    std::ranges::replace(option, '-', '_');
    return option;
}

bool is_regular(const std::string& path) {
    std::error_code ignored;
    return !path.empty() && std::filesystem::is_regular_file(path, ignored);
}

bool is_quiet(const std::vector<std::string>& words) {
    return std::ranges::any_of(
        words, [](const std::string& word) { return word == "-q" || word == "--quiet"; });
}

// Prints where each value of a completed command line comes from.
void print_sources(const std::vector<std::string>& arguments, const JobValues& job,
                   const std::vector<setup::OptionSetting>& settings,
                   const std::function<bool(const std::string&)>& given) {
    std::string text;
    const auto end = std::ranges::find(arguments, "--");
    for (auto word = arguments.begin(); word != end; ++word) {
        if (!word->starts_with("--") || *word == "--verbose") continue;
        std::string value;
        const bool has_value = word->find('=') == std::string::npos && word + 1 != end &&
                               !(word + 1)->starts_with("-");
        if (has_value) value = " " + *(word + 1);
        text += fmt::format("setting  {}{}  (command line)\n", *word, value);
    }
    for (const std::string& line : job.lines(given))
        text += fmt::format("setting  {}\n", line);
    for (const setup::OptionSetting& setting : settings)
        if (!given(setting.option)) text += fmt::format("setting  {}\n", line_of(setting));
    print_error(text);
}

// Reads the options of the new job of a comparison. `words` are the options of the command line.
void read_new_job(DiffOptions& options, std::vector<std::string> words) {
    if (!setup::is_job_file(options.new_program) || options.new_program == options.job) return;
    words.insert(words.end(), {"--", options.new_program, options.new_program});
    options.of_new_job =
        std::make_shared<DiffOptions>(std::get<DiffOptions>(options_with_project(words)));
}

// True if the command line has the option `name`.
bool is_given(const std::vector<std::string>& words, const std::string& name) {
    const auto end = std::ranges::find(words, "--");
    const std::string option = "--" + name;
    return std::any_of(words.begin(), end, [&](const std::string& word) {
        return word == option || word.starts_with(option + "=");
    });
}

}  // namespace

std::string job_of(const ProgramOptions& options, const std::vector<setup::OptionSetting>& settings,
                   const std::string& folder) {
    if (!options.job.empty()) return options.job;
    for (const setup::OptionSetting& setting : settings) {
        if (setting.option == "job" && setting.values.size() == 1)
            return setup::seen_in(folder, setting.values[0]);
    }
    return {};
}

std::vector<std::string> words_of_setting(const setup::OptionSetting& setting,
                                          const std::string& folder) {
    std::vector<std::string> words = setting_words(setting, folder);
    // Each setting is tried separately, so a message can name the place of a fault.
    std::vector<std::string> all{"check", "-"};
    all.insert(all.end(), words.begin(), words.end());
    try {
        (void)parsed_again(all);
    } catch (const std::runtime_error& e) {
        throw error_at(setting, e.what());
    }
    return words;
}

std::vector<std::string> with_settings(std::vector<std::string> words,
                                       const std::vector<setup::OptionSetting>& settings,
                                       const std::string& folder,
                                       const std::function<bool(const std::string&)>& accepts) {
    // Inserted before "--": a list option would otherwise take the following program as a value.
    auto end = std::ranges::find(words, "--");
    for (const setup::OptionSetting& setting : settings) {
        // A fault is an error of every command, also of those without the option.
        const std::vector<std::string> more = words_of_setting(setting, folder);
        if (!accepts(setting.option)) continue;
        end =
            words.insert(end, more.begin(), more.end()) + static_cast<std::ptrdiff_t>(more.size());
    }
    return words;
}

Command parsed_again(const std::vector<std::string>& words) {
    Command command = parse_options(words);
    if (const auto* exit = std::get_if<EarlyExit>(&command)) {
        std::string what = exit->text.substr(0, exit->text.find('\n'));
        constexpr std::string_view kName = "ncsim: ";
        if (what.starts_with(kName)) what.erase(0, kName.size());
        throw std::runtime_error(what);
    }
    return command;
}

JobValues::JobValues(const std::string& path, setup::InputSet& inputs) {
    if (!is_regular(path)) return;
    file_ = setup::read_job_file(path, inputs);
    folder_ = std::filesystem::path(path).parent_path().string();
}

// Returns the value of the job that replaces `value` of `option`; null if there is none.
const setup::PlacedValue* JobValues::value_of(const std::string& option,
                                              const std::string& value) const {
    const auto found = [this](const std::string& key) {
        const auto at = file_.values.find(key);
        return at == file_.values.end() ? nullptr : &at->second;
    };
    const std::string name = value.substr(0, value.find('='));
    if (option == "tool") return name.size() > 1 ? found("tool " + name.substr(1)) : nullptr;
    if (option == "variable") return found("variables " + name);
    if (option == "compensation") return found("compensation " + name);
    if (option == "stock-turn" || option == "stock-move") return found("stock");
    if (option == "units" && file_.units_assumed) return nullptr;
    if (option == "dialect" && file_.dialect_assumed) return nullptr;
    return found(key_of(option));
}

std::vector<setup::OptionSetting> JobValues::without_own(
    std::vector<setup::OptionSetting> settings, std::vector<std::string>& overridden) const {
    std::vector<setup::OptionSetting> rest;
    for (setup::OptionSetting& setting : settings) {
        const auto note = [&](const setup::PlacedValue& own, const std::string& value) {
            const bool is_same = own.text == value || own.text == '"' + value + '"';
            if (is_same) return;
            overridden.push_back(fmt::format("'{}'{} of {} counts; {} has {}", setting.option,
                                             own.text.empty() ? "" : " = " + own.text, own.where,
                                             setting.where, value));
        };
        if (setting.is_flag) {
            const setup::PlacedValue* const own = value_of(setting.option, {});
            if (own) note(*own, setting.is_on ? "true" : "false");
            if (!own) rest.push_back(std::move(setting));
            continue;
        }
        std::erase_if(setting.values, [&](const std::string& value) {
            const setup::PlacedValue* const own = value_of(setting.option, value);
            if (own) note(*own, value);
            return own != nullptr;
        });
        if (!setting.values.empty()) rest.push_back(std::move(setting));
    }
    return rest;
}

std::vector<std::string> JobValues::lines(
    const std::function<bool(const std::string&)>& given) const {
    std::vector<std::string> lines;
    for (const auto& [key, value] : file_.values) {
        std::string option = key;
        std::ranges::replace(option, '_', '-');
        if (given(option) || key == "version" || key == "tool") continue;
        lines.push_back(fmt::format("{}{}  {}", key, value.text.empty() ? "" : " = " + value.text,
                                    value.where));
    }
    return lines;
}

std::string line_of(const setup::OptionSetting& setting) {
    const std::string value = setting.is_flag ? (setting.is_on ? "true" : "false")
                                              : fmt::format("{}", fmt::join(setting.values, ", "));
    return fmt::format("{} = {}  {}", setting.option, value, setting.where);
}

Command options_with_project(const std::vector<std::string>& arguments) {
    Command command = parse_options(arguments);
    auto* const comparison = std::get_if<DiffOptions>(&command);
    const std::vector<std::string> own_words =
        comparison ? comparison->words : std::vector<std::string>();
    std::visit(
        [&](auto& options) {
            using Of = std::remove_cvref_t<decltype(options)>;
            if constexpr (std::is_base_of_v<ProgramOptions, Of>) {
                constexpr bool kIsCheck = std::is_same_v<Of, CheckOptions>;
                setup::InputSet inputs;
                std::optional<setup::ProjectFile> project;
                std::vector<setup::OptionSetting> settings;
                const std::string& program =
                    options.program.empty() ? options.job : options.program;
                if (!options.no_project && !kIsCheck && !program.empty()) {
                    if (const auto path = setup::find_project_file(program)) {
                        project = setup::read_project_file(*path, inputs);
                        settings = setup::settings_for(*project, program);
                    }
                }
                const std::string folder = project ? project->folder : std::string();
                const JobValues job(job_of(options, settings, folder), inputs);
                if (!project && job.settings().empty() && !options.verbose) return;
                const std::set<std::string> known = option_names(arguments.front());
                const auto given = [&](const std::string& option) {
                    return is_given(arguments, option);
                };
                const auto accepts = [&](const std::string& option) {
                    return known.contains(option) && !given(option);
                };
                std::vector<std::string> overridden;
                settings = job.without_own(std::move(settings), overridden);
                std::vector<std::string> words =
                    with_settings(arguments, job.settings(), job.folder(), accepts);
                words = with_settings(std::move(words), settings, folder, accepts);
                options = std::get<Of>(parsed_again(words));
                if (project) options.project = project->name;
                if (!is_quiet(arguments)) {
                    for (const std::string& line : overridden)
                        print_error("note: " + line + '\n');
                }
                if (options.verbose) print_sources(arguments, job, settings, given);
            }
        },
        command);
    if (comparison) read_new_job(*comparison, own_words);
    return command;
}

}  // namespace ncsim::app
