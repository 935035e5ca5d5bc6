// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of programs and their set-up.
#include "options/program_options.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/number_text.h"
#include "ncsim/setup/job_file.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/stock.h"

#include "options/option_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ncsim::app {

namespace {

using ProgramArgs = ProgramOptions;

toolpath::ToolSpec read_tool(const char* option, const std::string& text) {
    std::string message;
    auto spec = toolpath::parse_tool_option(text, message);
    if (!spec) throw Refusal{fmt::format("{} {}", option, message)};
    return std::move(*spec);
}

void read_tools(const char* option, const std::vector<std::string>& texts, ProgramOptions& o) {
    std::vector<toolpath::ToolSpec>& tools = o.tools;
    for (const std::string& text : texts) {
        tools.push_back(read_tool(option, text));
        const int number = tools.back().number;
        if (std::count_if(tools.begin(), tools.end(),
                          [number](const auto& t) { return t.number == number; }) > 1) {
            throw Refusal{fmt::format("{}: T{} is described twice", option, number)};
        }
    }
}

toolpath::ToolSpec read_assumed_tool(const char*, const std::string& text) {
    // Accepts a tool with or without a number, which does not matter.
    const std::size_t equals = text.find('=');
    auto tool =
        read_tool("--tool", "T1=" + text.substr(equals == std::string::npos ? 0 : equals + 1));
    tool.number = 0;
    return tool;
}

toolpath::Stock read_stock(const char* option, const std::string& text) {
    std::string message;
    const auto stock = setup::specified_stock(text, message);
    if (!stock) throw Refusal{fmt::format("{} {}", option, message)};
    return *stock;
}

std::string read_turn(const char* option, const std::string& text) {
    try {
        (void)setup::parse_any_turn(text);
    } catch (const std::invalid_argument& e) {
        throw Refusal{fmt::format("{} {}", option, e.what())};
    }
    return text;
}

// Reads the number behind the first '=' of `text`.
std::optional<double> number_behind_equals(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return std::nullopt;
    const auto value = number_in<double>(std::string_view(text).substr(equals + 1));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

void read_variables(const char* option, const std::vector<std::string>& texts, ProgramOptions& o) {
    for (const std::string& text : texts) {
        const auto name = setup::variable_name(std::string_view(text).substr(0, text.find('=')));
        const auto value = number_behind_equals(text);
        if (!name || !value)
            throw Refusal{
                fmt::format("{} '{}': expected #500=1, #<_name>=1, R5=1 or Q5=1", option, text)};
        o.variables[*name] = *value;
    }
}

void read_compensation(const char* option, const std::vector<std::string>& texts,
                       ProgramOptions& o) {
    for (const std::string& text : texts) {
        const auto number =
            setup::compensation_register(std::string_view(text).substr(0, text.find('=')));
        const auto radius = number_behind_equals(text);
        if (!number || !radius)
            throw Refusal{fmt::format("{} '{}': expected D1=0.05, in mm", option, text)};
        o.compensation[*number] = *radius;
    }
}

Vec3 read_triple(const char* option, const std::string& text) {
    const auto triple = toolpath::parse_triple(text);
    if (!triple) throw Refusal{fmt::format("{} '{}': expected x,y,z in mm", option, text)};
    return *triple;
}

gcode::Dialect read_dialect(const char* option, const std::string& name) {
    std::vector<Choice<gcode::Dialect>> dialects;
    dialects.reserve(std::size(gcode::kDialectList));
    for (const gcode::Dialect dialect : gcode::kDialectList)
        dialects.push_back({gcode::name_of(dialect), dialect});
    return chosen(option, name, dialects);
}

constexpr Choice<bool> kUnits[] = {{"mm", false}, {"inch", true}};
constexpr Choice<report::LengthUnit> kReportUnits[] = {{"mm", report::LengthUnit::Millimetre},
                                                       {"inch", report::LengthUnit::Inch}};

// Returns "cda or cda-flat".
std::string names_of(Models models) {
    using Info = simulation::ModelInfo;
    switch (models) {
        case Models::All: return simulation::model_names();
        case Models::Exact:
            return simulation::model_names([](const Info& model) { return model.exact; });
        case Models::Verifying: break;
    }
    return simulation::model_names([](const Info& model) { return model.verifies; });
}

}  // namespace

void require_verifying(const SimulationOptions& options) {
    if (options.model.empty() || simulation::find_model(options.model)->verifies) return;
    throw Refusal{fmt::format("--model {}: programs are verified, and parts compared, with {}",
                              options.model,
                              simulation::model_names([](const simulation::ModelInfo& model) {
                                  return model.verifies;
                              }))};
}

void require_exact(const SimulationOptions& options, std::string_view what) {
    if (options.model.empty() || simulation::find_model(options.model)->exact) return;
    throw Refusal{fmt::format(
        "{}: --model {} is not exact; use {}", what, options.model,
        simulation::model_names([](const simulation::ModelInfo& model) { return model.exact; }))};
}

void take_job(ProgramOptions& options, std::string& program) {
    if (!setup::is_job_file(program)) return;
    if (!options.job.empty())
        throw Refusal{fmt::format("'{}' and --job '{}': expected one job", program, options.job)};
    options.job = std::exchange(program, {});
}

void require_job_of_set_up(const ProgramOptions& options) {
    if (options.set_up.empty()) return;
    if (options.job.empty()) throw Refusal{"--setup selects a set-up of a job file"};
    if (!options.program.empty())
        throw Refusal{
            fmt::format("--setup selects a set-up of '{}', and '{}' another; expected the "
                        "job alone",
                        options.job, options.program)};
}

void complete(ProgramOptions& options) {
    take_job(options, options.program);
    require_job_of_set_up(options);
    if (options.program.empty() && options.job.empty()) {
        throw Refusal{"an NC program is needed, or a job file that names one (job.toml)"};
    }
    if (!options.save_job.empty() && options.stock && options.stock->from &&
        options.stock->from->path == "-") {
        throw Refusal{"--save-job: stock from the standard input has no name that could be kept"};
    }
}

void refuse_foreign_ending(const char* option, const std::string& path,
                           const std::vector<std::string>& endings) {
    static const std::set<std::string, std::less<>> formats{
        ".png",  ".apng", ".jpg",  ".jpeg", ".webp", ".bmp", ".tif", ".tiff", ".pdf",
        ".gif",  ".gltf", ".glb",  ".wrl",  ".vrml", ".stl", ".ply", ".3mf",  ".obj",
        ".step", ".stp",  ".iges", ".igs",  ".dxf",  ".dwg", ".svg"};
    const std::string ending = lowercase(std::filesystem::path(path).extension().string());
    if (!formats.contains(ending) || std::ranges::find(endings, ending) != endings.end()) return;
    throw Refusal{
        fmt::format("{} '{}': the ending is that of another format; '{}'", option, path,
                    std::filesystem::path(path).replace_extension(endings.front()).string())};
}

void require_watchable(const ProgramOptions& options, const std::vector<std::string>& inputs,
                       bool is_share) {
    if (!options.watch) return;
    if (is_share) throw Refusal{"--watch: shards and tiles are not watched"};
    if (std::ranges::find(inputs, "-") != inputs.end())
        throw Refusal{"--watch: the standard input cannot be watched; save it as a file"};
}

std::vector<std::string> inputs_of(const ProgramOptions& o) {
    std::vector<std::string> paths = o.tool_tables;
    for (const std::string* path : {&o.program, &o.job, &o.holders, &o.machine}) {
        if (!path->empty()) paths.push_back(*path);
    }
    if (o.stock && o.stock->from) paths.push_back(o.stock->from->path);
    return paths;
}

namespace {

constexpr OptionRow<ProgramArgs> kProgramRows[] = {
    {"program", "FILE", kWork, "NC program, or job file (.toml)", store<&ProgramArgs::program>}};

constexpr OptionRow<ProgramArgs> kInputRows[] = {
    {"--job", "FILE", kResult, "Job file (TOML): tools, stock and set-up",
     store<&ProgramArgs::job>},
    {"--setup", "SETUP", kResult, "Set-up of the job, by number or name",
     store<&ProgramArgs::set_up>},
    {"--verbose", "", kResult, "Print the source of each setting: file and line",
     store<&ProgramArgs::verbose>},
    {"--no-project", "", kInTiles, "Ignore ncsim.toml", store<&ProgramArgs::no_project>},
    {"--dialect", "NAME", kResult,
     "Control: rs274, fanuc, haas, grbl, heidenhain, sinumerik … [auto]",
     read<&ProgramArgs::dialect, read_dialect>},
    {"--strict", "", kResult, "Refuse what LinuxCNC refuses", store<&ProgramArgs::strict>},
    {"--units", "UNIT", kResult, "Unit if the program has no G20 and no G21: mm, inch",
     choose<&ProgramArgs::inches, kUnits>},
    {"--start", "X,Y,Z", kResult, "Position of the tool at the start in G54, mm",
     read<&ProgramArgs::start, read_triple>},
    {"--variable", "NAME=VALUE", kResult, "Value of a variable at the start, as #500=1",
     act<read_variables>},
    {"--compensation", "D1=R", kResult, "Radius of G41, G42 in register D1, mm; 0: wear only",
     act<read_compensation>},
    {"--subprograms", "DIR", kResult, "Folder with subprograms, after the program's own",
     store<&ProgramArgs::subprograms>},
    {"--block-delete", "", kResult, "Skip blocks that start with '/': on, off",
     store<&ProgramArgs::block_delete>},
    {"--increments", "", kResult, "Read numbers without a point as 0.001 mm: on, off",
     store<&ProgramArgs::increments>},
    {"--allow", "WORDS", kResult, "Ignore these words without a message: G187,M198",
     store_list<&ProgramArgs::allow>}};

constexpr OptionRow<ProgramArgs> kToolRows[] = {
    {"--tool", "TOOL", kResult, "Tool, as T1=flat:D10:L22 (below); repeatable", act<read_tools>},
    {"--tool-table", "FILE", kResult, "Tools: tool.tbl, .json, .tools, .fctl, .hsmlib, .camotics",
     store<&ProgramArgs::tool_tables>},
    {"--holders", "FILE", kResult, "Tool holders (TOML)", store<&ProgramArgs::holders>}};

constexpr OptionRow<ProgramArgs> kStockRows[] = {
    {"--assume-tool", "TOOL", kResult, "Tool for all tools that are not described: flat:D6",
     read<&ProgramArgs::assumed_tool, read_assumed_tool>},
    {"--stock", "STOCK", kResult, "LxWxH, DdxH (below), .stl, .obj, .glb, .wrl, .step, .ncstock",
     read<&ProgramArgs::stock, read_stock>},
    {"--stock-turn", "TURNS", kResult, "Turn stock from a file about axes: X90,Z-37.5",
     read<&ProgramArgs::stock_turn, read_turn>},
    {"--stock-move", "X,Y,Z", kResult, "Move stock from a file, after --stock-turn, mm",
     read<&ProgramArgs::stock_move, read_triple>}};

constexpr OptionRow<ProgramArgs> kMachineRows[] = {
    {"--machine", "FILE", kResult, "Machine: TOML, URDF, LinuxCNC INI, FreeCAD .fcm, Fusion",
     store<&ProgramArgs::machine>}};

constexpr OptionRow<ProgramArgs> kSaveJobRows[] = {{"--save-job", "FILE", kWork,
                                                    "Tools, stock and set-up as a job file",
                                                    store<&ProgramArgs::save_job>}};

constexpr OptionRow<ProgramArgs> kReportUnitRows[] = {
    {"--report-units", "UNIT", kResult, "Unit of lengths in texts, pictures and CSV: mm, inch [mm]",
     choose<&ProgramArgs::report_unit, kReportUnits>}};

constexpr OptionRow<ProgramArgs> kWatchRows[] = {{"--watch", "", kWork,
                                                  "Run again when a file changes that was read",
                                                  store<&ProgramArgs::watch>}};

void read_tolerance(const char*, const double& mm, SimulationOptions& o) {
    o.tolerance = mm;
    o.tolerance_specified = true;
}

void read_tool_tolerance(const char*, const double& mm, SimulationOptions& o) {
    o.tool_tolerance = mm;
    o.tool_tolerance_specified = true;
}

// Adds --model, whose text has the names of the models of a command.
template <Models Offered>
cli::Option* add_model(cli::App& command, const OptionRow<SimulationOptions>& row,
                       SimulationOptions& o) {
    const auto take = [&o, option = row.names](const std::string& model) {
        if (!simulation::find_model(model))
            throw Refusal{fmt::format("{} '{}': expected {}", option, model, names_of(Offered))};
        o.model = model;
    };
    const std::string text =
        fmt::format("{}: {} [{}]", row.text, names_of(Offered), simulation::models()[0].name);
    return command.add_option_function<std::string>(row.names, take, text);
}

constexpr OptionRow<SimulationOptions> kAccuracyRows[] = {
    {"--tolerance", "MM", kResult, "Deviation of arcs and rotary moves, mm [0.005]",
     act<read_tolerance>, within(1e-4, 10.0)},
    {"--tool-tolerance", "MM", kResult, "Deviation of round tools, mm [0.05]",
     act<read_tool_tolerance>, within(1e-4, 10.0)}};

template <Models Offered>
constexpr OptionRow<SimulationOptions> kModelRow{"--model", "NAME", kResult, "Workpiece model",
                                                 add_model<Offered>};

constexpr OptionRow<SimulationOptions> kAdvancedRows[] = {
    {"--threads", "N", kOfPart, "Number of threads; no effect on results",
     store<&SimulationOptions::threads>, within(1, 1024)},
    {"--max-memory", "GB", kLimit, "Stop with a message above this, GB",
     store<&SimulationOptions::max_memory_gb>, within(1e-6, 1e9)},
    {"--max-time", "S", kLimit, "Stop with a message after this, s a program",
     store<&SimulationOptions::max_seconds>, within(1e-6, 1e9)}};

}  // namespace

std::string any_of(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

void add_program_options(cli::App& command, ProgramOptions& options) {
    add_rows(command, "", kProgramRows, options);
    add_language_options(command, options);
}

void add_language_options(cli::App& command, ProgramOptions& options) {
    add_rows(command, "Input", kInputRows, options);
    add_rows(command, "Tools and stock", kToolRows, options);
}

void add_setup_options(cli::App& command, ProgramOptions& options) {
    add_rows(command, "Tools and stock", kStockRows, options);
    add_rows(command, "Machine", kMachineRows, options);
}

void add_save_job(cli::App& command, ProgramOptions& options) {
    add_rows(command, "Outputs", kSaveJobRows, options);
}

void add_report_unit(cli::App& command, ProgramOptions& options) {
    add_rows(command, "Outputs", kReportUnitRows, options);
}

void add_watch(cli::App& command, ProgramOptions& options) {
    add_rows(command, "Outputs", kWatchRows, options);
}

void add_simulation_options(cli::App& command, SimulationOptions& options, Models models) {
    const OptionRow<SimulationOptions>& model = models == Models::All ? kModelRow<Models::All>
                                                : models == Models::Exact
                                                    ? kModelRow<Models::Exact>
                                                    : kModelRow<Models::Verifying>;
    add_rows(command, "Accuracy", kAccuracyRows, options);
    add_rows(command, "Accuracy", std::span(&model, 1), options);
    add_rows(command, "Advanced", kAdvancedRows, options);
}

std::vector<std::string> words_of(const cli::App& command,
                                  const std::function<bool(const cli::Option&)>& matters) {
    std::vector<std::string> words{command.name()};
    std::vector<std::string> programs;
    for (const cli::Option* option : command.options()) {
        if (option->count() == 0) continue;
        if (option->is_positional()) {
            programs = option->values();
            continue;
        }
        if (!matters(*option)) continue;
        const std::string name = option->long_names().front();
        if (option->is_flag()) {
            words.push_back("--" + name + (option->is_on() ? "" : "=off"));
            continue;
        }
        for (const std::string& value : option->values())
            words.push_back(fmt::format("--{}={}", name, value));
    }
    if (!programs.empty()) words.emplace_back("--");
    words.insert(words.end(), programs.begin(), programs.end());
    return words;
}

std::vector<std::string> words_of_tile(const cli::App& command) {
    return words_of(command, [](const cli::Option& option) { return option.counts().tile; });
}

}  // namespace ncsim::app
