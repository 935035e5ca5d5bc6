// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of every command that reads an NC program. Each command adds its own options in a
// separate file.
#pragma once

#include "ncsim/report/length_unit.h"
#include "ncsim/setup/job_options.h"
#include "ncsim/simulation/plan_reader.h"

#include "options/cli.h"
#include "options/refusal.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

using simulation::LeftStocks;
using simulation::SimulationOptions;

/// Description of the program and its set-up, and the output file for the description.
struct ProgramOptions : setup::JobOptions {
    std::string machine;      ///< Machine file: offsets and kinematics; empty: none.
    std::string save_job;     ///< Job file to write; empty: none.
    bool no_project = false;  ///< Ignore ncsim.toml.
    std::string project;      ///< The ncsim.toml with settings for the program; empty: none.
    std::string set_up;       ///< Number or name of a set-up of the job; empty: all set-ups.
    bool verbose = false;     ///< Print the source of each setting.
    bool watch = false;       ///< Run again when a file changes.
    /// Unit of lengths in texts, pictures and CSV.
    report::LengthUnit report_unit = report::LengthUnit::Millimetre;
    std::shared_ptr<LeftStocks> left_stocks = std::make_shared<LeftStocks>();
};

// The following functions add options to `command`, which reads into `options`. Unusable values
// throw Refusal during parsing.
// Requires: `options` outlives `command`.

/// Adds the program and all options about its language and its tools.
void add_program_options(cli::App& command, ProgramOptions& options);
/// Adds all program options except the program itself.
void add_language_options(cli::App& command, ProgramOptions& options);
/// Adds the stock, the assumed tool and the machine, for commands that use stock.
void add_setup_options(cli::App& command, ProgramOptions& options);
/// Adds --save-job.
void add_save_job(cli::App& command, ProgramOptions& options);
/// Adds the unit of the texts, for commands that print lengths.
void add_report_unit(cli::App& command, ProgramOptions& options);
/// Adds --watch, for commands that run again when a file changes.
void add_watch(cli::App& command, ProgramOptions& options);
/// Models that `--model` offers in the help of a command.
enum class Models : std::uint8_t { All, Exact, Verifying };
void add_simulation_options(cli::App& command, SimulationOptions& options, Models models);

/// Throws: Refusal if `path` has the ending of another format, because viewers trust endings. The
/// message proposes the first of `endings`.
void refuse_foreign_ending(const char* option, const std::string& path,
                           const std::vector<std::string>& endings);
/// Checks --watch after all options were read. `is_share`: the command is a shard or a tile.
/// Throws: Refusal if one of the `inputs` is the standard input, or for a share.
void require_watchable(const ProgramOptions& options, const std::vector<std::string>& inputs,
                       bool is_share);
/// Returns the paths of all input files that are named; no path is empty.
std::vector<std::string> inputs_of(const ProgramOptions& options);
/// Checks `options` after all options were read.
/// Throws: Refusal if no program is named.
void complete(ProgramOptions& options);
/// Throws: Refusal if a set-up is selected without a job, or together with a program, which selects
/// its set-up.
void require_job_of_set_up(const ProgramOptions& options);
/// Makes a positional `program` with the ending .toml the job. Throws: Refusal if there is a job.
void take_job(ProgramOptions& options, std::string& program);
/// Returns the words of `command` in canonical form: its name, the options for which `matters` is
/// true, and the positional words.
std::vector<std::string> words_of(const cli::App& command,
                                  const std::function<bool(const cli::Option&)>& matters);
/// Returns a command line that makes the same tiles, for any division of work.
std::vector<std::string> words_of_tile(const cli::App& command);
/// Throws Refusal if the selected model does not support verification.
void require_verifying(const SimulationOptions& options);
/// Throws Refusal if the selected model has no exact parts, which `what` needs.
void require_exact(const SimulationOptions& options, std::string_view what);

}  // namespace ncsim::app
