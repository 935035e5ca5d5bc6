// SPDX-License-Identifier: GPL-3.0-or-later
//
// Completes command lines from ncsim.toml.
#include "commands/project.h"

#include "ncsim/setup/input.h"
#include "ncsim/setup/stock_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

namespace ncsim::app {

namespace {

std::runtime_error error_at(const setup::ProjectSetting& setting, const std::string& what) {
    return std::runtime_error(fmt::format("{}: {}", setting.where, what));
}

// Returns a setting as words of a command line; file names are relative to the folder of the
// project.
std::vector<std::string> setting_words(const setup::ProjectSetting& setting,
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

// Returns the long names of the options that `add_command` adds.
template <class Of, class AddCommand>
std::set<std::string> names_of(AddCommand add_command) {
    cli::App app("", "");
    Of ignored;
    std::set<std::string> names;
    for (const cli::Option* option : add_command(app, ignored)->options()) {
        for (const std::string& name : option->long_names())
            names.insert(name);
    }
    return names;
}

std::set<std::string> names_of(const Options&) {
    return names_of<Options>(add_run);
}
std::set<std::string> names_of(const ParseOptions&) {
    return names_of<ParseOptions>(add_parse);
}
std::set<std::string> names_of(const ToolsOptions&) {
    return names_of<ToolsOptions>(add_tools);
}
std::set<std::string> names_of(const DiffOptions&) {
    return names_of<DiffOptions>(add_diff);
}
std::set<std::string> names_of(const MeasureOptions&) {
    return names_of<MeasureOptions>(add_measure);
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

std::vector<std::string> words_of_setting(const setup::ProjectSetting& setting,
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
                                       const std::vector<setup::ProjectSetting>& settings,
                                       const std::string& folder,
                                       const std::function<bool(const std::string&)>& accepts) {
    // Inserted before "--": a list option would otherwise take the following program as a value.
    auto end = std::ranges::find(words, "--");
    for (const setup::ProjectSetting& setting : settings) {
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

Command options_with_project(const std::vector<std::string>& arguments) {
    Command command = parse_options(arguments);
    std::visit(
        [&](auto& options) {
            using Of = std::remove_cvref_t<decltype(options)>;
            if constexpr (std::is_base_of_v<ProgramOptions, Of> &&
                          !std::is_same_v<Of, CheckOptions>) {
                const std::string& program =
                    options.program.empty() ? options.job : options.program;
                if (options.no_project) return;
                const auto path = setup::find_project_file(program);
                if (!path) return;
                setup::InputSet inputs;
                const setup::ProjectFile project = setup::read_project_file(*path, inputs);
                const std::set<std::string> known = names_of(options);
                const std::vector<std::string> words =
                    with_settings(arguments, setup::settings_for(project, program), project.folder,
                                  [&](const std::string& option) {
                                      return known.contains(option) && !is_given(arguments, option);
                                  });
                options = std::get<Of>(parsed_again(words));
                options.project = *path;
            }
        },
        command);
    return command;
}

}  // namespace ncsim::app
