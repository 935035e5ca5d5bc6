// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of `ncsim check` and `ncsim rules`.
#include "options/check_options.h"

#include "ncsim/cda/tile_number.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/verify/doubt.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <system_error>

namespace ncsim::app {

namespace {

std::vector<std::string_view> ids_of(const char* option, const std::string& name) {
    auto ids = verify::rules_named(name);
    if (ids.empty()) {
        throw Refusal{fmt::format("{} '{}': no rule or category of this name; see ncsim rules",
                                  option, name)};
    }
    return ids;
}

void select(verify::Selection& selection, const std::vector<std::string>& names) {
    for (const verify::RuleInfo& rule : verify::rules())
        selection.ignored.emplace(rule.id, "--select");
    for (const std::string& name : names) {
        for (const std::string_view id : ids_of("--select", name))
            selection.ignored.erase(std::string(id));
    }
}

void ignore(verify::Selection& selection, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        for (const std::string_view id : ids_of("--ignore", name))
            selection.ignored.emplace(id, "--ignore");
    }
}

void select_rules(verify::Selection& selection, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
        for (const std::string_view id : ids_of("--severity", text.substr(0, equals))) {
            bool known = false;
            for (const auto severity :
                 {gcode::Severity::Note, gcode::Severity::Warning, gcode::Severity::Error}) {
                if (value != verify::name_of(severity)) continue;
                selection.severities.insert_or_assign(
                    std::string(id), verify::Selection::Weight{severity, "--severity"});
                known = true;
            }
            if (!known) {
                throw Refusal{fmt::format(
                    "--severity '{}': expected rule=note, rule=warning or rule=error", text)};
            }
        }
    }
}

std::string known_reason(const char* option, const std::string& name) {
    if (name == "all" || verify::find_reason(name)) return name;
    throw Refusal{
        fmt::format("{} '{}': no reason for doubt of this name; see ncsim rules", option, name)};
}

std::string known_requirement(const char* option, const std::string& name) {
    if (std::ranges::find(verify::kRequirements, name) != std::end(verify::kRequirements))
        return name;
    throw Refusal{
        fmt::format("{} '{}': expected holder, fixtures, travels, offsets, links, lengths or modes",
                    option, name)};
}

// Adds an option for a list: separated by commas, and repeatable.
cli::Option* add_list(cli::App& command, const char* name, const char* type, const char* what,
                      const std::function<void(const std::vector<std::string>&)>& take) {
    return command.add_option_function<std::vector<std::string>>(name, take, what)
        ->type_name(type)
        ->delimiter(',')
        ->accept_one_value();
}

// Returns the long name without dashes.
std::string long_name(const cli::Option& option) {
    return option.long_names().empty() ? option.name() : option.long_names().front();
}

// True if the option determines verdicts; the remaining options specify outputs, the division of
// work, or limits.
bool decides_verdicts(const std::string& name) {
    static const std::set<std::string, std::less<>> others{
        "programs",  "list",       "shard",          "shards",  "out",      "redo",
        "cache",     "jobs",       "json",           "sarif",   "junit",    "csv",
        "html",      "github",     "write-baseline", "isolate", "threads",  "max-time",
        "exit-zero", "max-memory", "no-project",     "tile",    "tile-out", "watch",
        "png",       "finding",    "view",           "views",   "size",     "background",
        "marks",     "cut-view"};
    return !others.contains(name);
}

}  // namespace

namespace {

void add_rule_options(cli::App& check, CheckOptions& o) {
    check.begin_group("Rules and verdict");
    add_list(check, "--select", "RULES", "Only these rules or categories",
             [&o](const auto& names) { select(o.selection, names); });
    // Applied after --select, whatever the order on the command line.
    add_list(check, "--ignore", "RULES", "All rules except these",
             [&o](const auto& names) { ignore(o.selection, names); });
    add_list(check, "--severity", "RULE=S", "Severity of a rule: note, warning, error",
             [&o](const auto& texts) { select_rules(o.selection, texts); });
    add_list(check, "--accept", "REASONS", "Doubts that do not count: stock-guess,…; all",
             [&o](const auto& names) {
                 for (const std::string& name : names)
                     o.accept.push_back(known_reason("--accept", name));
             });
    add_list(check, "--require", "THINGS",
             "Required: holder,fixtures,travels,offsets,links,lengths,modes",
             [&o](const auto& names) {
                 for (const std::string& name : names)
                     o.require.push_back(known_requirement("--require", name));
             });
    check.add_option("--baseline", o.baseline, "Known findings, which do not count")
        ->type_name("FILE");
    check.add_flag("--warnings-as-errors", o.warnings_as_errors, "Warnings fail, too");
    add_design(check, o.design, o.design_tolerance, "Compare the part");
    check
        .add_option_function<std::string>(
            "--rapid",
            [&o](const std::string& path) {
                if (path != "linear" && path != "dog-leg") {
                    throw Refusal{fmt::format("--rapid '{}': expected linear or dog-leg", path)};
                }
                o.dog_leg = path == "dog-leg";
            },
            "Path of rapid moves: linear, dog-leg [linear]")
        ->type_name("PATH");
    check.add_flag("--cut-free", o.detached_pieces, "Find pieces that are cut free, too; slower");
    check.add_flag("--air-cuts", o.air_cuts, "Find feed moves that remove nothing, too; slower");
}

void add_batch_options(cli::App& check, CheckOptions& o) {
    check.begin_group("Many programs");
    check.add_option("--list", o.list, "File with a path per line; -: standard input")
        ->type_name("FILE");
    check.add_option("--jobs,-j", o.jobs, "Programs at a time; no effect on results")
        ->type_name("N")
        ->range(1, 1024);
    check.add_flag("--isolate", o.isolate, "One process per program: a crash stops no other");
    check.add_option("--cache", o.cache, "Folder that keeps verdicts of unchanged programs")
        ->type_name("DIR");
    check.add_option("--shard", o.shard, "Share I of N of the programs, from 0; auto: as CI says")
        ->type_name("I/N");
    check.add_option("--shards", o.shards, "N for --shard auto, if CI does not say")
        ->type_name("N")
        ->range(1U, 1'000'000U);
    check.add_option("--out", o.out, "Folder for the result of a shard, for ncsim merge")
        ->type_name("DIR");
    check.add_option("--tile", o.tile, "Verify tile I of N of the part, from 0; auto: as CI says")
        ->type_name("I/N");
    check.add_option("--tile-out", o.tile_out, "Folder for the result of a tile, for ncsim merge")
        ->type_name("DIR");
    check.add_flag("--redo", o.redo, "Verify a shard or tile again although its result exists");
}

}  // namespace

cli::App* add_check(cli::App& app, CheckOptions& o) {
    cli::App* check =
        app.add_subcommand("check", "Verify that programs are safe; exit code 1 if not");
    check->add_option("programs", o.programs, "NC programs, folders with programs, or a job file")
        ->type_name("FILES");
    add_language_options(*check, o);
    add_setup_options(*check, o);
    check->begin_group("Machine");
    check
        ->add_option("--machine", o.machine,
                     "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm, Fusion")
        ->type_name("FILE");
    add_rule_options(*check, o);
    add_report_options(*check, o);
    add_report_unit(*check, o);
    add_watch(*check, o);
    check->add_option("--csv", o.csv, "Volume and time of each block, CSV; slower")
        ->type_name("FILE");
    check->add_option("--html", o.html, "Page with the part; DIR/: pages with an index")
        ->type_name("FILE");
    check->begin_group("Picture of a finding");
    check->add_option("--png", o.png, "Picture of the gravest finding: the tool where it meets")
        ->type_name("FILE");
    check
        ->add_option_function<std::size_t>(
            "--finding", [&o](std::size_t number) { o.finding = number; },
            "Finding of --png, by its number in the text")
        ->type_name("N")
        ->range(std::size_t{1}, std::size_t{1'000'000'000})
        ->needs("--png");
    add_picture_options(*check, o);
    add_batch_options(*check, o);
    add_simulation_options(*check, o, Models::Verifying);
    return check;
}

std::vector<std::string> inputs_of(const CheckOptions& o) {
    std::vector<std::string> paths = inputs_of(static_cast<const ProgramOptions&>(o));
    paths.insert(paths.end(), o.programs.begin(), o.programs.end());
    for (const std::string* path : {&o.list, &o.machine, &o.design}) {
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
    if (o.tile.empty() != o.tile_out.empty()) {
        throw Refusal{o.tile.empty() ? "--tile-out: of which tile? --tile I/N"
                                     : "--tile: where to is its result to go? --tile-out DIR"};
    }
    if (o.tile.empty()) return;
    if (!o.shard.empty()) throw Refusal{"--tile: a shard is of programs, a tile of one part"};
    o.number = shard_number(o.tile, o.shards, "--tile");
    if (o.number.of > cda::kMostTiles)
        throw Refusal{fmt::format("--tile '{}': {} tiles at most", o.tile, cda::kMostTiles)};
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
    if (!o.save_job.empty()) throw Refusal{"--save-job: ncsim run and ncsim tools write job files"};
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
    if (o.shard.empty() && o.tile.empty() && (o.redo || o.shards > 0))
        throw Refusal{"--redo and --shards are about a --shard or a --tile"};
    complete_tile_of_check(o);
    if (!o.shard.empty() && (o.github || !outputs_of(o).empty()))
        throw Refusal{"--shard: reports are written by ncsim merge"};
    if (!o.shard.empty()) o.number = shard_number(o.shard, o.shards);
    require_watchable(o, inputs_of(o), !o.shard.empty() || !o.tile.empty());
}

std::string settings_of(const cli::App& command) {
    std::string specified;
    for (const cli::Option* option : command.options()) {
        const std::string name = long_name(*option);
        if (option->count() == 0 || !decides_verdicts(name)) continue;
        specified += "--" + name;
        for (const std::string& value : option->values())
            specified += '\0' + value;
        specified += '\n';
    }
    return specified;
}

std::vector<std::string> words_of_check(const cli::App& command) {
    return words_of(command, [](const std::string& name) {
        return name == "no-project" ||
               (decides_verdicts(name) && name != "quiet" && name != "notes");
    });
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
        const std::set<std::string, std::less<>> of_one_run{"help", "notes", "quiet", "save-job"};
        const std::set<std::string, std::less<>> limits{"max-time", "max-memory"};
        cli::App app("", "");
        CheckOptions ignored;
        std::map<std::string, OptionKind> kinds;
        for (const cli::Option* option : add_check(app, ignored)->options()) {
            const std::string known = long_name(*option);
            if (of_one_run.contains(known)) continue;
            if (!decides_verdicts(known) && !limits.contains(known)) continue;
            const std::string type = option->type_name();
            kinds[known] = {option->is_flag(), app.is_switch("--" + known),
                            type.starts_with("FILE") || type.starts_with("DIR")};
        }
        return kinds;
    }();
    const auto found = kinds_of_options.find(name);
    return found == kinds_of_options.end() ? std::nullopt : std::optional(found->second);
}

cli::App* add_rules(cli::App& app, RulesOptions& options) {
    cli::App* rules = app.add_subcommand("rules", "Explain the rules of ncsim check");
    rules->add_option("id", options.id, "Rule, category or reason for doubt [all]")
        ->type_name("NAME");
    rules->add_flag("--json", options.json, "As JSON");
    return rules;
}

}  // namespace ncsim::app
