// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line: argv → one of the commands. A pure function, which reads no files and prints
// nothing.
#pragma once

#include "commands/diff.h"
#include "commands/explain_command.h"
#include "commands/init_command.h"
#include "commands/machine_command.h"
#include "commands/measure_command.h"
#include "commands/parse_command.h"
#include "commands/sheet_command.h"
#include "commands/tools_command.h"
#include "options/check_options.h"
#include "options/merge_options.h"
#include "options/run_options.h"

#include <set>
#include <string>
#include <variant>
#include <vector>

namespace ncsim::app {

/// Text and exit code of a command line without a command to run.
struct EarlyExit {
    int exit_code = kClean;
    std::string text;  ///< For stdout if the exit code is kClean, otherwise for stderr.
};

/// Options of the chosen command, in the order of help. For each type there is a run().
using Command = std::variant<Options, ParseOptions, ToolsOptions, CheckOptions, MergeOptions,
                             DiffOptions, MachineOptions, MeasureOptions, InitOptions, SheetOptions,
                             ExplainOptions, RulesOptions, EarlyExit>;

/// Returns the long names of the options of a command, without dashes.
/// Requires: `command` is the name of a command.
std::set<std::string> option_names(const std::string& command);

/// Parses the command line. Accepts any arguments.
Command parse_options(const std::vector<std::string>& arguments);

}  // namespace ncsim::app
