// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every command that reads an NC program can be told about it. Commands add theirs to it, each
// in a file of its own.
#pragma once

#include "ncsim/setup/job_options.h"

#include "options/cli.h"

#include <functional>
#include <string>
#include <vector>

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

/// What is told of the program and its set-up, and where that is written.
struct ProgramOptions : setup::JobOptions {
    std::string save_job;  ///< Where to write a job file, empty: nowhere.
};

/// What commands that simulate are told as well. Lengths in mm.
struct SimulationOptions {
    std::string model;             ///< Of simulation::models(); empty: the one that suits.
    double tolerance = 0.005;      ///< Of chords and of turning tools.
    double tool_tolerance = 0.05;  ///< Of round tools.
    bool tolerance_told = false, tool_tolerance_told = false;
    unsigned threads = 0;        ///< 0: as many as the machine has.
    double max_memory_gb = 0.0;  ///< 10^9 bytes; 0: as much as there is.
    double max_seconds = 0.0;    ///< 0: as long as it takes.
};

/// Lets `command` read them into `options`, which must outlive it. What makes no sense throws
/// Refusal while the command line is parsed.
void add_program_options(cli::App& command, ProgramOptions& options);
/// All of them but the program itself.
void add_language_options(cli::App& command, ProgramOptions& options);
/// The stock and the assumed tool, which matter only where something is cut.
void add_setup_options(cli::App& command, ProgramOptions& options);
/// The paths of all files that are named to be read; none of them is empty.
std::vector<std::string> inputs_of(const ProgramOptions& options);
/// What can be judged only when all options were read: throws Refusal if no program is named.
void complete(const ProgramOptions& options);
void add_simulation_options(cli::App& command, SimulationOptions& options);
/// What was told `command`, in one way to say it: its name, the options that matter, by their long
/// names without dashes, and what stands alone.
std::vector<std::string> words_of(const cli::App& command,
                                  const std::function<bool(const std::string&)>& matters);
/// Throws Refusal if a model was asked for that programs are not verified with.
void require_verifying(const SimulationOptions& options);
/// Throws Refusal if a model was asked for whose parts are not exact, as `what` needs them.
void require_exact(const SimulationOptions& options, std::string_view what);

}  // namespace ncsim::app
