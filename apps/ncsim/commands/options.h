// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line: argv → one of the commands. A pure function: it reads no files and prints
// nothing.
#pragma once

#include "commands/diff.h"
#include "commands/machine_command.h"
#include "commands/measure_command.h"
#include "commands/parse_command.h"
#include "commands/tools_command.h"
#include "options/check_options.h"
#include "options/merge_options.h"
#include "options/run_options.h"

#include <string>
#include <variant>
#include <vector>

namespace ncsim::app {

/// Nothing to run: something to say, and the exit code.
struct Farewell {
    int exit_code = kClean;
    std::string text;  ///< To stdout if the exit code is kClean, else to stderr.
};

/// What can be asked for: for each command its options. For each of them there is a run().
using Command = std::variant<Options, ParseOptions, ToolsOptions, CheckOptions, MergeOptions,
                             DiffOptions, MachineOptions, MeasureOptions, RulesOptions, Farewell>;

/// Total: any arguments give one of them.
Command parse_options(const std::vector<std::string>& arguments);

}  // namespace ncsim::app
