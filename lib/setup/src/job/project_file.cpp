// SPDX-License-Identifier: GPL-3.0-or-later
//
// Project files and the patterns in these files.
#include "ncsim/setup/project_file.h"

#include "ncsim/setup/input_observer.h"
#include "ncsim/setup/program_folder.h"

#include "files/toml_reader.h"
#include "job/option_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace ncsim::setup {

namespace {

namespace fs = std::filesystem;

std::string next_name(std::string_view& path) {
    const std::size_t end = std::min(path.find('/'), path.size());
    std::string name(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
    return name;
}

std::vector<std::string> names_of(std::string_view path) {
    std::vector<std::string> names;
    while (!path.empty())
        names.push_back(next_name(path));
    return names;
}

class ProjectReader {
public:
    explicit ProjectReader(const TomlReader& reader) : r_(reader) {}

    std::vector<ProjectFile::Section> read() {
        std::vector<ProjectFile::Section> sections(1);
        for (const auto& [key, node] : r_.root()) {
            const std::string name(key.str());
            if (name == "version") {
                if (node.value_exact<std::int64_t>() != 1) r_.fail(node, "'version': expected 1");
            } else if (name == "program") {
                if (!node.is_array_of_tables()) r_.fail(node, "write [[program]]");
                for (const toml::node& one : *node.as_array())
                    sections.push_back(section(*one.as_table()));
            } else {
                sections[0].settings.push_back(read_option(r_, name, name, node));
            }
        }
        if (!r_.root().contains("version")) r_.fail(r_.root(), "expected version = 1");
        return sections;
    }

private:
    ProjectFile::Section section(const toml::table& table) {
        ProjectFile::Section section;
        for (const auto& [key, value] : table) {
            const std::string name(key.str());
            if (name == "files") {
                if (!value.is_array()) r_.fail(value, "'files': expected a list in brackets");
                for (const toml::node& pattern : *value.as_array()) {
                    section.files.push_back(checked_pattern(pattern));
                    section.places.push_back(r_.place_of(pattern));
                }
            } else {
                section.settings.push_back(read_option(r_, name, name, value));
            }
        }
        if (section.files.empty())
            r_.fail(table, "expected files, the programs that this is about: files = [\"a/**\"]");
        return section;
    }

    // Returns a pattern. Refuses a pattern that cannot match any path.
    std::string checked_pattern(const toml::node& node) const {
        if (!node.is_string()) r_.fail(node, "'files': expected a text in quotes");
        std::string pattern = node.as_string()->get();
        const auto is_no_name = [](const std::string& name) {
            return name.empty() || name == "." || name == "..";
        };
        const std::vector<std::string> names = names_of(pattern);
        if (names.empty() || std::ranges::any_of(names, is_no_name))
            r_.fail(node, fmt::format("'{}': expected a path below this file", pattern));
        return pattern;
    }

    const TomlReader& r_;
};

// True if `pattern` matches the sequence `things`. `is_many` marks parts that match any number of
// things. All possible ends of a part are kept, so no match is tried twice.
template <class Part, class Thing, class IsMany, class IsLike>
bool matches_row(const Part& pattern, const Thing& things, IsMany is_many, IsLike is_like) {
    std::vector<bool> reached(things.size() + 1, false);
    reached[0] = true;
    for (const auto& part : pattern) {
        std::vector<bool> next(things.size() + 1, false);
        for (std::size_t i = 0; i <= things.size(); ++i) {
            if (is_many(part)) {
                next[i] = reached[i] || (i > 0 && next[i - 1]);
            } else if (i > 0) {
                next[i] = reached[i - 1] && is_like(part, things[i - 1]);
            }
        }
        reached = std::move(next);
    }
    return reached.back();
}

bool name_matches(std::string_view pattern, std::string_view name) {
    return matches_row(
        pattern, name, [](char c) { return c == '*'; },
        [](char c, char is) { return c == '?' || c == is; });
}

// Returns the path of a program; a program from the standard input counts as a file in the current
// folder.
fs::path place_of(const std::string& program) {
    return fs::absolute(program == "-" ? "stdin" : program).lexically_normal();
}

/// Returns the path of a program relative to `folder`, for patterns.
std::string seen_below(const fs::path& folder, const std::string& program) {
    return place_of(program).lexically_relative(folder).generic_string();
}

bool has_own_project(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(folder / kProjectFileName, ignored)) ||
           fs::exists(folder / ".git", ignored);
}

/// Returns the folder before the first * or ? of `pattern`; empty if another project is there.
std::optional<fs::path> folder_of_pattern(const fs::path& folder, std::string_view pattern) {
    fs::path result = folder;
    std::vector<std::string> names = names_of(pattern);
    names.pop_back();
    for (const std::string& name : names) {
        if (name.find_first_of("*?") != std::string::npos) break;
        result /= name;
        if (has_own_project(result)) return std::nullopt;
    }
    return result;
}

bool finds_program(const std::string& pattern, const fs::path& folder) {
    const std::optional<fs::path> top = folder_of_pattern(folder, pattern);
    if (!top) return false;
    std::error_code error;
    fs::recursive_directory_iterator entry(*top, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_directory(ignored)) {
            if (has_own_project(entry->path())) entry.disable_recursion_pending();
            continue;
        }
        const std::string path = entry->path().lexically_relative(folder).generic_string();
        if (matches(pattern, path) && entry->is_regular_file(ignored) &&
            !why_no_program(entry->path().string()))
            return true;
    }
    return false;
}

}  // namespace

void expect_programs(const ProjectFile& project, const std::vector<std::string>& programs) {
    const fs::path folder = fs::absolute(project.name).lexically_normal().parent_path();
    for (const ProjectFile::Section& section : project.sections) {
        for (std::size_t i = 0; i < section.files.size(); ++i) {
            const std::string& pattern = section.files[i];
            const auto is_meant = [&](const std::string& program) {
                return matches(pattern, seen_below(folder, program));
            };
            if (std::ranges::any_of(programs, is_meant) || finds_program(pattern, folder)) continue;
            throw std::runtime_error(
                fmt::format("{}: '{}' matches no NC program below the folder of this file; correct "
                            "the pattern, or remove it",
                            section.places[i], pattern));
        }
    }
}

std::optional<std::string> find_project_file(const std::string& program) {
    fs::path folder = place_of(program).parent_path();
    const fs::path here = fs::current_path();
    while (true) {
        const fs::path file = folder / kProjectFileName;
        const bool is_absolute = program != "-" && fs::path(program).is_absolute();
        std::string path = is_absolute ? file.string() : file.lexically_relative(here).string();
        note_input(path);
        std::error_code ignored;
        // A dangling link counts, too; reading it reports the error.
        if (fs::symlink_status(file, ignored).type() != fs::file_type::not_found) return path;
        if (fs::exists(folder / ".git", ignored) || folder == folder.parent_path())
            return std::nullopt;
        folder = folder.parent_path();
    }
}

ProjectFile read_project_file(const std::string& path, InputSet& inputs) {
    ProjectFile project;
    project.name = path;
    project.folder = fs::path(path).parent_path().string();
    const TomlReader reader(path, inputs.read(path, kMostSetUpBytes));
    project.sections = ProjectReader(reader).read();
    return project;
}

std::vector<OptionSetting> settings_for(const ProjectFile& project, const std::string& program) {
    const fs::path folder = fs::absolute(project.name).lexically_normal().parent_path();
    const std::string path = seen_below(folder, program);
    std::vector<OptionSetting> settings;
    for (const ProjectFile::Section& section : project.sections) {
        const auto is_meant = [&](const std::string& pattern) { return matches(pattern, path); };
        if (!section.files.empty() && std::ranges::none_of(section.files, is_meant)) continue;
        for (const OptionSetting& setting : section.settings) {
            std::erase_if(settings,
                          [&](const auto& earlier) { return earlier.option == setting.option; });
            settings.push_back(setting);
        }
    }
    return settings;
}

bool matches(std::string_view pattern, std::string_view path) {
    return matches_row(
        names_of(pattern), names_of(path), [](const std::string& part) { return part == "**"; },
        [](const std::string& part, const std::string& name) { return name_matches(part, name); });
}

}  // namespace ncsim::setup
