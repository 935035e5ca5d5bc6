// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every command that reads an NC program can be told about it. Commands add theirs to it, each
// in a file of its own.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/dialect.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_spec.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace ncsim::app {

/// Exit codes of the program; in --help, too.
enum ExitCode : int {
    kClean = 0,
    kFindings = 1,     ///< The NC program has faults.
    kEnvironment = 2,  ///< Wrong usage, unreadable input, a failing world.
    kBug = 3,
    kNotProven = 4,  ///< No fault was found, but something nobody told stands before "clean".
};

/// A value that the parser of the command line cannot judge. Thrown and caught while it is read,
/// inside parse_options() only.
struct Refusal {
    std::string text;  ///< "--stock '1x2': expected …"
};

/// The program, and what it does not say itself. Lengths in mm.
struct ProgramOptions {
    std::string program;
    std::optional<toolpath::Stock> stock;
    /// Of stock that comes from a file.
    std::optional<std::string> stock_turn;
    std::optional<cda::Vec3> stock_move;
    std::vector<toolpath::ToolSpec> tools;
    /// For tools that nobody describes; its number is 0.
    std::optional<toolpath::ToolSpec> assumed_tool;
    std::string job;                       ///< A job file, empty: none.
    std::vector<std::string> tool_tables;  ///< Files with tools.
    std::string holders;                   ///< A file with what holds them, empty: none.
    std::string save_job;                  ///< Where to write a job file, empty: nowhere.
    std::optional<cda::Vec3> start;        ///< Where the tool stands at the beginning, in G54.
    /// Origins of coordinate systems in the machine, by gcode::MachineState::system.
    std::map<int, cda::Vec3> offsets;
    std::optional<bool> inches;            ///< For programs that say neither G20 nor G21; mm.
    bool increments = false;               ///< Numbers without a point count least increments.
    std::vector<std::string> subprograms;  ///< Folders, besides that of the program.
    bool block_delete = false;
    gcode::Dialect dialect = gcode::Dialect::Auto;
    bool strict = false;             ///< RS274/NGC as LinuxCNC runs it.
    std::vector<std::string> allow;  ///< Words declared harmless: "G187".
    /// For a verdict: reasons for doubt that do not count, and what has to be told.
    std::vector<std::string> accept, require;
};

/// What commands that simulate are told as well. Lengths in mm.
struct SimulationOptions {
    std::string model;             ///< "cda" or "cda-flat"; empty: the one that suits.
    double tolerance = 0.005;      ///< Of chords and of turning tools.
    double tool_tolerance = 0.05;  ///< Of round tools.
    bool tolerance_told = false, tool_tolerance_told = false;
    unsigned threads = 0;        ///< 0: as many as the machine has.
    double max_memory_gb = 0.0;  ///< 10^9 bytes; 0: as much as there is.
    double max_seconds = 0.0;    ///< 0: as long as it takes.
};

/// Lets `command` read them into `options`, which must outlive it. What makes no sense throws
/// Refusal while the command line is parsed.
void add_program_options(CLI::App& command, ProgramOptions& options);
/// All of them but the program itself.
void add_language_options(CLI::App& command, ProgramOptions& options);
/// The stock and the assumed tool, which matter only where something is cut.
void add_setup_options(CLI::App& command, ProgramOptions& options);
/// The paths of all files that are named to be read; none of them is empty.
std::vector<std::string> inputs_of(const ProgramOptions& options);
/// What can be judged only when all options were read: throws Refusal if no program is named.
void complete(const ProgramOptions& options);
void add_simulation_options(CLI::App& command, SimulationOptions& options);

}  // namespace ncsim::app
