// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the options of programs and their set-up.
#include "options/program_options.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/setup/stock_file.h"
#include "ncsim/simulation/models.h"
#include "ncsim/toolpath/stock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace ncsim::app {

namespace {

double read_tolerance(const char* name, double mm) {
    if (!(mm >= 1e-4 && mm <= 10.0)) {
        throw Refusal{fmt::format("{}: expected 0.0001 to 10 mm, not {}", name, mm)};
    }
    return mm;
}

toolpath::ToolSpec read_tool(const std::string& text) {
    std::string message;
    auto spec = toolpath::parse_tool_option(text, message);
    if (!spec) throw Refusal{"--tool " + message};
    return std::move(*spec);
}

std::vector<toolpath::ToolSpec> read_tools(const std::vector<std::string>& texts) {
    std::vector<toolpath::ToolSpec> tools;
    for (const std::string& text : texts) {
        tools.push_back(read_tool(text));
        const int number = tools.back().number;
        if (std::count_if(tools.begin(), tools.end(),
                          [number](const auto& t) { return t.number == number; }) > 1) {
            throw Refusal{fmt::format("--tool: T{} is described twice", number)};
        }
    }
    return tools;
}

toolpath::ToolSpec read_assumed_tool(const std::string& text) {
    // Accepts a tool with or without a number, which does not matter.
    const std::size_t equals = text.find('=');
    auto tool = read_tool("T1=" + text.substr(equals == std::string::npos ? 0 : equals + 1));
    tool.number = 0;
    return tool;
}

toolpath::Stock read_stock(const std::string& text) {
    std::string message;
    const auto stock = setup::specified_stock(text, message);
    if (!stock) throw Refusal{"--stock " + message};
    return *stock;
}

std::string read_turn(const std::string& text) {
    try {
        (void)setup::parse_any_turn(text);
    } catch (const std::invalid_argument& e) {
        throw Refusal{fmt::format("--stock-turn {}", e.what())};
    }
    return text;
}

std::map<std::string, double> read_variables(const std::vector<std::string>& texts) {
    std::map<std::string, double> variables;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const auto name = setup::variable_name(std::string_view(text).substr(0, equals));
        const char* const end = text.data() + text.size();
        double value = 0.0;
        const bool is_read = equals != std::string::npos && name &&
                             std::from_chars(text.data() + equals + 1, end, value) ==
                                 std::from_chars_result{end, std::errc{}};
        if (!is_read || !std::isfinite(value)) {
            throw Refusal{
                fmt::format("--variable '{}': expected #500=1, #<_name>=1, R5=1 or Q5=1", text)};
        }
        variables[*name] = value;
    }
    return variables;
}

std::map<int, double> read_compensation(const std::vector<std::string>& texts) {
    std::map<int, double> radii;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const auto number = setup::compensation_register(std::string_view(text).substr(0, equals));
        const char* const end = text.data() + text.size();
        double radius = 0.0;
        const bool is_read = equals != std::string::npos && number &&
                             std::from_chars(text.data() + equals + 1, end, radius) ==
                                 std::from_chars_result{end, std::errc{}};
        if (!is_read || !std::isfinite(radius))
            throw Refusal{fmt::format("--compensation '{}': expected D1=0.05, in mm", text)};
        radii[*number] = radius;
    }
    return radii;
}

cda::Vec3 read_triple(const char* option, const std::string& text) {
    const auto triple = toolpath::parse_triple(text);
    if (!triple) throw Refusal{fmt::format("{} '{}': expected x,y,z in mm", option, text)};
    return *triple;
}

gcode::Dialect read_dialect(const std::string& name) {
    using gcode::Dialect;
    for (const Dialect dialect : gcode::kDialectList) {
        if (name == gcode::name_of(dialect)) return dialect;
    }
    throw Refusal{
        fmt::format("--dialect '{}': expected auto, rs274, fanuc, haas, grbl, mach3, heidenhain, "
                    "sinumerik or sinumerik-iso",
                    name)};
}

bool read_inches(const std::string& unit) {
    if (unit != "mm" && unit != "inch") {
        throw Refusal{fmt::format("--units '{}': expected mm or inch", unit)};
    }
    return unit == "inch";
}

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

void add_program_options(cli::App& command, ProgramOptions& options) {
    command.add_option("program", options.program, "NC program, or job file (.toml)")
        ->type_name("FILE");
    add_language_options(command, options);
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

void add_report_unit(cli::App& command, ProgramOptions& o) {
    command
        .add_option_function<std::string>(
            "--report-units",
            [&o](const std::string& unit) {
                if (unit != "mm" && unit != "inch")
                    throw Refusal{fmt::format("--report-units '{}': expected mm or inch", unit)};
                o.report_unit =
                    unit == "inch" ? report::LengthUnit::Inch : report::LengthUnit::Millimetre;
            },
            "Unit of lengths in texts, pictures and CSV: mm, inch [mm]")
        ->type_name("UNIT");
}

void refuse_foreign_ending(const char* option, const std::string& path,
                           const std::vector<std::string>& endings) {
    static const std::set<std::string, std::less<>> formats{
        ".png",  ".apng", ".jpg",  ".jpeg", ".webp", ".bmp", ".tif", ".tiff", ".pdf",
        ".gif",  ".gltf", ".glb",  ".wrl",  ".vrml", ".stl", ".ply", ".3mf",  ".obj",
        ".step", ".stp",  ".iges", ".igs",  ".dxf",  ".dwg", ".svg"};
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!formats.contains(ending) || std::ranges::find(endings, ending) != endings.end()) return;
    throw Refusal{
        fmt::format("{} '{}': the ending is that of another format; '{}'", option, path,
                    std::filesystem::path(path).replace_extension(endings.front()).string())};
}

void add_design(cli::App& command, std::string& path, double& tolerance_mm,
                const std::string& purpose) {
    command.add_option("--design", path, purpose + ": STL (mm), GLB or STEP in G54")
        ->type_name("FILE");
    command.add_option("--design-tol", tolerance_mm, "Permitted deviation, mm [0.1]")
        ->type_name("MM")
        ->number_range(1e-4, 1e4);
}

void add_watch(cli::App& command, ProgramOptions& o) {
    command.add_flag("--watch", o.watch, "Run again when a file changes that was read");
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
    for (const std::string* path : {&o.program, &o.job, &o.holders}) {
        if (!path->empty()) paths.push_back(*path);
    }
    if (o.stock && o.stock->from) paths.push_back(o.stock->from->path);
    return paths;
}

void add_language_options(cli::App& command, ProgramOptions& options) {
    using Text = const std::string&;
    ProgramOptions& o = options;
    command.begin_group("Input");
    command.add_option("--job", o.job, "Job file (TOML): tools, stock and set-up")
        ->type_name("FILE");
    command.add_option("--setup", o.set_up, "Set-up of the job, by number or name")
        ->type_name("SETUP");
    command.add_flag("--verbose", o.verbose, "Print the source of each setting: file and line");
    command.add_flag("--no-project", o.no_project, "Ignore ncsim.toml");
    command
        .add_option_function<std::string>(
            "--dialect", [&o](Text name) { o.dialect = read_dialect(name); },
            "Control: rs274, fanuc, haas, grbl, heidenhain, sinumerik … [auto]")
        ->type_name("NAME");
    command.add_flag("--strict", o.strict, "Refuse what LinuxCNC refuses");
    command
        .add_option_function<std::string>(
            "--units", [&o](Text unit) { o.inches = read_inches(unit); },
            "Unit if the program has no G20 and no G21: mm, inch")
        ->type_name("UNIT");
    command
        .add_option_function<std::string>(
            "--start", [&o](Text text) { o.start = read_triple("--start", text); },
            "Position of the tool at the start in G54, mm")
        ->type_name("X,Y,Z");
    command
        .add_option_function<std::vector<std::string>>(
            "--variable", [&o](const auto& texts) { o.variables = read_variables(texts); },
            "Value of a variable at the start, as #500=1")
        ->type_name("NAME=VALUE")
        ->accept_one_value();
    command
        .add_option_function<std::vector<std::string>>(
            "--compensation",
            [&o](const auto& texts) { o.compensation = read_compensation(texts); },
            "Radius of G41, G42 in register D1, mm; 0: wear only")
        ->type_name("D1=R")
        ->accept_one_value();
    command
        .add_option("--subprograms", o.subprograms,
                    "Folder with subprograms, after the program's own")
        ->type_name("DIR")
        ->accept_one_value();
    command.add_switch("--block-delete", o.block_delete,
                       "Skip blocks that start with '/': on, off");
    command.add_switch("--increments", o.increments,
                       "Read numbers without a point as 0.001 mm: on, off");
    command.add_option("--allow", o.allow, "Ignore these words without a message: G187,M198")
        ->type_name("WORDS")
        ->delimiter(',');
    command.begin_group("Tools and stock");
    command
        .add_option_function<std::vector<std::string>>(
            "--tool", [&o](const auto& texts) { o.tools = read_tools(texts); },
            "Tool, as T1=flat:D10:L22 (below); repeatable")
        ->type_name("TOOL")
        ->accept_one_value();
    command
        .add_option("--tool-table", o.tool_tables,
                    "Tools: tool.tbl, .json, .tools, .fctl, .hsmlib, .camotics")
        ->type_name("FILE")
        ->accept_one_value();
    command.add_option("--holders", o.holders, "Tool holders (TOML)")->type_name("FILE");
}

void add_setup_options(cli::App& command, ProgramOptions& options) {
    using Text = const std::string&;
    ProgramOptions& o = options;
    command.begin_group("Tools and stock");
    command
        .add_option_function<std::string>(
            "--assume-tool", [&o](Text text) { o.assumed_tool = read_assumed_tool(text); },
            "Tool for all tools that are not described: flat:D6")
        ->type_name("TOOL");
    command
        .add_option_function<std::string>(
            "--stock", [&o](Text text) { o.stock = read_stock(text); },
            "LxWxH, DdxH (below), .stl, .obj, .glb, .wrl, .step, .ncstock")
        ->type_name("STOCK");
    command
        .add_option_function<std::string>(
            "--stock-turn", [&o](Text text) { o.stock_turn = read_turn(text); },
            "Turn stock from a file about axes: X90,Z-37.5")
        ->type_name("TURNS");
    command
        .add_option_function<std::string>(
            "--stock-move", [&o](Text text) { o.stock_move = read_triple("--stock-move", text); },
            "Move stock from a file, after --stock-turn, mm")
        ->type_name("X,Y,Z");
    command.add_option("--save-job", o.save_job, "Write tools, stock and set-up as a job file")
        ->type_name("FILE");
}

void add_simulation_options(cli::App& command, SimulationOptions& options, Models models) {
    SimulationOptions& o = options;
    command.begin_group("Accuracy");
    command
        .add_option_function<double>(
            "--tolerance", [&o](double mm) { o.tolerance = read_tolerance("--tolerance", mm); },
            "Deviation of arcs and rotary moves, mm [0.005]")
        ->type_name("MM");
    command
        .add_option_function<double>(
            "--tool-tolerance",
            [&o](double mm) { o.tool_tolerance = read_tolerance("--tool-tolerance", mm); },
            "Deviation of round tools, mm [0.05]")
        ->type_name("MM");
    command
        .add_option_function<std::string>(
            "--model",
            [&o, models](const std::string& model) {
                if (!simulation::find_model(model)) {
                    throw Refusal{
                        fmt::format("--model '{}': expected {}", model, names_of(models))};
                }
                o.model = model;
            },
            fmt::format("Workpiece model: {} [{}]", names_of(models), simulation::models()[0].name))
        ->type_name("NAME");
    command.begin_group("Advanced");
    command.add_option("--threads", o.threads, "Number of threads; no effect on results")
        ->type_name("N")
        ->range(1, 1024);
    command.add_option("--max-memory", o.max_memory_gb, "Stop with a message above this, GB")
        ->type_name("GB")
        ->number_range(1e-6, 1e9);
    command.add_option("--max-time", o.max_seconds, "Stop with a message after this, s a program")
        ->type_name("S")
        ->number_range(1e-6, 1e9);
}

std::vector<std::string> words_of(const cli::App& command,
                                  const std::function<bool(const std::string&)>& matters) {
    std::vector<std::string> words{command.name()};
    std::vector<std::string> programs;
    for (const cli::Option* option : command.options()) {
        if (option->count() == 0) continue;
        if (option->is_positional()) {
            programs = option->values();
            continue;
        }
        const std::string name = option->long_names().front();
        if (!matters(name)) continue;
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

}  // namespace ncsim::app
