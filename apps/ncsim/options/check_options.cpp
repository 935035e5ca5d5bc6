// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim check` and `ncsim rules`.
#include "options/check_options.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

namespace ncsim::app {

namespace {

using CheckArgs = CheckOptions;

std::vector<std::string_view> ids_of(const char* option, const std::string& name) {
    auto ids = verify::rules_named(name);
    if (ids.empty()) {
        throw Refusal{fmt::format("{} '{}': no rule or category of this name; see ncsim rules",
                                  option, name)};
    }
    return ids;
}

void select(const char* option, const std::vector<std::string>& names, CheckOptions& o) {
    for (const verify::RuleInfo& rule : verify::rules())
        o.selection.ignored.emplace(rule.id, option);
    for (const std::string& name : names) {
        for (const std::string_view id : ids_of(option, name))
            o.selection.ignored.erase(std::string(id));
    }
}

void ignore(const char* option, const std::vector<std::string>& names, CheckOptions& o) {
    for (const std::string& name : names) {
        for (const std::string_view id : ids_of(option, name))
            o.selection.ignored.emplace(id, option);
    }
}

constexpr Choice<gcode::Severity> kSeverities[] = {{"note", gcode::Severity::Note},
                                                   {"warning", gcode::Severity::Warning},
                                                   {"error", gcode::Severity::Error}};

void select_severities(const char* option, const std::vector<std::string>& texts, CheckOptions& o) {
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
        const auto* const known = std::ranges::find(
            kSeverities, value, [](const auto& severity) { return severity.word; });
        for (const std::string_view id : ids_of(option, text.substr(0, equals))) {
            if (known == std::end(kSeverities))
                throw Refusal{fmt::format("{} '{}': expected rule=note, rule=warning or rule=error",
                                          option, text)};
            o.selection.severities.insert_or_assign(
                std::string(id), verify::Selection::Weight{known->value, option});
        }
    }
}

void accept(const char* option, const std::vector<std::string>& names, CheckOptions& o) {
    for (const std::string& name : names) {
        if (name != "all" && !verify::find_reason(name))
            throw Refusal{fmt::format("{} '{}': no reason for doubt of this name; see ncsim rules",
                                      option, name)};
        o.accept.push_back(name);
    }
}

void require(const char* option, const std::vector<std::string>& names, CheckOptions& o) {
    for (const std::string& name : names) {
        if (std::ranges::find(verify::kRequirements, name) == std::end(verify::kRequirements))
            throw Refusal{fmt::format(
                "{} '{}': expected {}", option, name,
                any_of({std::begin(verify::kRequirements), std::end(verify::kRequirements)}))};
        o.require.push_back(name);
    }
}

constexpr Choice<bool> kRapidPaths[] = {{"linear", false}, {"dog-leg", true}};

constexpr OptionRow<CheckArgs> kCheckPrograms[] = {
    {"programs", "FILES", kWork, "NC programs, folders with programs, or a job file",
     store<&CheckArgs::programs>}};

constexpr OptionRow<CheckArgs> kRuleRows[] = {
    {"--select", "RULES", kResult, "Only these rules or categories", act_on_list<select>},
    // Applied after --select, whatever the order on the command line.
    {"--ignore", "RULES", kResult, "All rules except these", act_on_list<ignore>},
    {"--severity", "RULE=S", kResult, "Severity of a rule: note, warning, error",
     act_on_list<select_severities>},
    {"--accept", "REASONS", kResult, "Doubts that do not count: stock-guess,…; all",
     act_on_list<accept>},
    {"--require", "THINGS", kResult,
     "Required: holder,fixtures,travels,offsets,links,lengths,modes", act_on_list<require>},
    {"--baseline", "FILE", kResult, "Known findings, which do not count",
     store<&CheckArgs::baseline>},
    {"--warnings-as-errors", "", kResult, "Warnings fail, too",
     store<&CheckArgs::warnings_as_errors>},
    {"--design", "FILE", kResult, "Compare the part: STL (mm), GLB or STEP in G54",
     store<&CheckArgs::design>},
    {"--design-tol", "MM", kResult, "Permitted deviation, mm [0.1]",
     store<&CheckArgs::design_tolerance>, kDesignTolerances},
    {"--rapid", "PATH", kResult, "Path of rapid moves: linear, dog-leg [linear]",
     choose<&CheckArgs::dog_leg, kRapidPaths>},
    {"--cut-free", "", kResult, "Find pieces that are cut free, too; slower",
     store<&CheckArgs::detached_pieces>},
    {"--air-cuts", "", kResult, "Find feed moves that remove nothing, too; slower",
     store<&CheckArgs::air_cuts>}};

constexpr OptionRow<CheckArgs> kCheckOutputs[] = {
    {"--csv", "FILE", kWork, "Volume and time of each block, CSV; slower", store<&CheckArgs::csv>},
    {"--html", "FILE", kWork, "Page with the part; DIR/: pages with an index",
     store<&CheckArgs::html>}};

constexpr OptionRow<CheckArgs> kCheckPictures[] = {
    {"--png", "FILE", kWork, "The gravest finding: the tool where it meets",
     store<&CheckArgs::png>},
    {"--finding", "N", kWork, "Finding of --png, by its number in the text",
     store<&CheckArgs::finding>, within(1, 1e9, "--png")}};

constexpr OptionRow<CheckArgs> kBatchRows[] = {
    {"--list", "FILE", kWork, "File with a path per line; -: standard input",
     store<&CheckArgs::list>},
    {"--jobs,-j", "N", kWork, "Programs at a time; no effect on results", store<&CheckArgs::jobs>,
     within(1, 1024)},
    {"--isolate", "", kWork, "One process per program: a crash stops no other",
     store<&CheckArgs::isolate>},
    {"--cache", "DIR", kWork, "Folder that keeps verdicts of unchanged programs",
     store<&CheckArgs::cache>},
    {"--shard", "I/N", kWork, "Share I of N of the programs, from 0; auto: as CI says",
     store<&CheckArgs::shard>},
    {"--out", "DIR", kWork, "Folder for the result of a shard, for ncsim merge",
     store<&CheckArgs::out>},
    {"--tile", "I/N", kWork, "Verify tile I of N of the part, from 0; auto: as CI says",
     store<&CheckArgs::tile>},
    {"--tile-out", "DIR", kWork, "Folder for the result of a tile, for ncsim merge",
     store<&CheckArgs::tile_out>}};

// Returns the long name without dashes.
std::string long_name(const cli::Option& option) {
    return option.long_names().empty() ? option.name() : option.long_names().front();
}

}  // namespace

void add_options(cli::App& check, CheckOptions& o) {
    add_rows(check, "", kCheckPrograms, o);
    add_language_options(check, o);
    add_setup_options(check, o);
    add_rows(check, "Rules and verdict", kRuleRows, o);
    add_rows(check, "Outputs", report_options(), static_cast<ReportOptions&>(o));
    add_report_unit(check, o);
    add_watch(check, o);
    add_rows(check, "Outputs", kCheckOutputs, o);
    add_rows(check, "Pictures", kCheckPictures, o);
    add_rows(check, "Pictures", picture_options(), static_cast<PictureOptions&>(o));
    add_rows(check, "Many programs", kBatchRows, o);
    add_simulation_options(check, o, Models::Verifying);
}

std::vector<std::string> inputs_of(const CheckOptions& o) {
    std::vector<std::string> paths = inputs_of(static_cast<const ProgramOptions&>(o));
    paths.insert(paths.end(), o.programs.begin(), o.programs.end());
    for (const std::string* path : {&o.list, &o.design}) {
        if (!path->empty()) paths.push_back(*path);
    }
    if (!o.baseline.empty() && !rewrites_baseline(o)) paths.push_back(o.baseline);
    return paths;
}

bool rewrites_baseline(const CheckOptions& o) {
    namespace fs = std::filesystem;
    const auto whole = [](const std::string& path) {
        std::error_code ignored;
        return fs::absolute(path, ignored).lexically_normal();
    };
    return !o.baseline.empty() && !o.write_baseline.empty() && o.baseline != "-" &&
           whole(o.baseline) == whole(o.write_baseline);
}

std::vector<std::string> outputs_of(const CheckOptions& o) {
    std::vector<std::string> paths = outputs_of(static_cast<const ReportOptions&>(o));
    for (const std::string* path : {&o.csv, &o.html, &o.png}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

namespace {

void complete_tile_of_check(CheckOptions& o) {
    o.number = tile_number(o.tile, o.tile_out);
    if (o.tile.empty()) return;
    if (!o.shard.empty()) throw Refusal{"--tile: a shard is of programs, a tile of one part"};
    if (o.github || !outputs_of(o).empty())
        throw Refusal{"--tile: reports are written by ncsim merge"};
    if (o.programs.size() != 1 || !o.list.empty() || o.programs[0] == "-")
        throw Refusal{"--tile: the part of one program, which has a name"};
    if (!o.cache.empty()) throw Refusal{"--tile: a tile has no verdict to be kept in a --cache"};
}

}  // namespace

namespace {

// Throws Refusal if several programs are named, or the program cannot be read twice.
void require_one_picture(const CheckOptions& o) {
    const bool is_job = o.programs.empty() && !o.job.empty();
    if (o.list.empty() && (is_job || o.programs.size() == 1) &&
        (is_job || o.programs.front() != "-"))
        return;
    throw Refusal{"--png: the picture is of a finding of one program, which has a name"};
}

// Makes a job file among the programs the job.
void take_job_of_check(CheckOptions& o) {
    const auto job = std::ranges::find_if(o.programs, setup::is_job_file);
    if (job != o.programs.end()) {
        if (o.programs.size() > 1 || !o.list.empty()) {
            throw Refusal{fmt::format(
                "'{}': a job is checked alone, without further programs and jobs", *job)};
        }
        take_job(o, *job);
        o.programs.clear();
    }
    if (!o.set_up.empty() && (o.job.empty() || !o.programs.empty() || !o.list.empty()))
        throw Refusal{"--setup selects a set-up of a job file, as in ncsim check job.toml"};
}

}  // namespace

void complete(CheckOptions& o) {
    require_verifying(o);
    take_job_of_check(o);
    std::error_code ignored;
    const bool is_project = std::filesystem::is_regular_file("ncsim.toml", ignored);
    if (o.programs.empty() && o.list.empty() && o.job.empty() && is_project) o.programs = {"."};
    if (o.programs.empty() && o.list.empty() && o.job.empty())
        throw Refusal{
            "no program is named, and the folder has no ncsim.toml; expected a program, a folder "
            "or --list"};
    if (!(o.html.empty() && o.png.empty()) && o.isolate)
        throw Refusal{
            "--isolate: what a page or picture shows does not come out of another process"};
    refuse_foreign_ending("--png", o.png, {".png"});
    if (!o.png.empty()) require_one_picture(o);
    require_pictures(o, !o.png.empty(), "--png");
    if (o.shard.empty() != o.out.empty())
        throw Refusal{o.out.empty() ? "--shard: where to is its result to go? --out DIR"
                                    : "--out: of which shard? --shard I/N"};
    complete_tile_of_check(o);
    if (!o.shard.empty() && (o.github || !outputs_of(o).empty()))
        throw Refusal{"--shard: reports are written by ncsim merge"};
    if (!o.shard.empty()) o.number = shard_number(o.shard, "--shard");
    require_watchable(o, inputs_of(o), !o.shard.empty() || !o.tile.empty());
}

std::string settings_of(const cli::App& command) {
    std::string specified;
    for (const cli::Option* option : command.options()) {
        const std::string name = long_name(*option);
        if (option->count() == 0 || !option->counts().cache) continue;
        specified += "--" + name;
        for (const std::string& value : option->values())
            specified += '\0' + value;
        specified += '\n';
    }
    return specified;
}

std::set<std::string> specified_options(const cli::App& command) {
    std::set<std::string> given;
    for (const cli::Option* option : command.options()) {
        if (option->count() > 0) given.insert(long_name(*option));
    }
    return given;
}

std::optional<OptionKind> kind_of_check_option(const std::string& name) {
    static const std::map<std::string, OptionKind> kinds_of_options = [] {
        cli::App app("", "");
        CheckOptions ignored;
        add_options(app, ignored);
        std::map<std::string, OptionKind> kinds;
        for (const cli::Option* option : app.options()) {
            if (!option->counts().project) continue;
            const std::string known = long_name(*option);
            const std::string type = option->type_name();
            kinds[known] = {option->is_flag(), app.is_switch("--" + known),
                            type.starts_with("FILE") || type.starts_with("DIR")};
        }
        return kinds;
    }();
    const auto found = kinds_of_options.find(name);
    return found == kinds_of_options.end() ? std::nullopt : std::optional(found->second);
}

void add_options(cli::App& rules, RulesOptions& options) {
    using R = RulesOptions;
    static constexpr OptionRow<R> kRows[] = {
        {"id", "NAME", kWork, "Rule, category or reason for doubt [all]", store<&R::id>},
        {"--json", "", kWork, "As JSON", store<&R::json>}};
    add_rows(rules, "Outputs", kRows, options);
}

}  // namespace ncsim::app
