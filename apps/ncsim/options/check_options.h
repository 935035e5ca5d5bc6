// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of `ncsim check` and `ncsim rules`.
#pragma once

#include "ncsim/report/file_digests.h"
#include "ncsim/simulation/program_check.h"
#include "ncsim/verify/selection.h"

#include "options/picture_options.h"
#include "options/program_options.h"
#include "options/report_options.h"
#include "options/shard_number.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ncsim::app {

/// Options of `ncsim check`. `program` is not used, because there may be many programs.
struct CheckOptions : ProgramOptions, SimulationOptions, ReportOptions, PictureOptions {
    std::vector<std::string> programs;
    /// Steps of the job for the programs of the list; empty if the programs are no job.
    std::vector<std::size_t> steps;
    std::string list;      ///< File with further programs, a path a line.
    std::string shard;     ///< "3/200", "auto"; empty: all programs.
    ShardNumber number;    ///< Value of `shard` or `tile`.
    std::string out;       ///< Folder for the results of a shard.
    bool isolate = false;  ///< Each program runs in a separate process.
    std::string tile;      ///< "17/64", "auto"; empty: the whole part.
    std::string tile_out;  ///< Folder for the result of a tile.
    /// Words that determine the result of a tile, in canonical form.
    std::vector<std::string> tile_words;
    /// Observations of all tiles, and the files from which the tiles were made; null: the part is
    /// cut in this run.
    std::shared_ptr<const simulation::TileResults> tiles;
    report::FileDigests tile_files;
    std::string cache;               ///< Folder of cached verdicts; empty: none.
    std::vector<std::string> words;  ///< Words of the command line; the command is first.
    /// Options on the command line and in the job of the command line, without dashes.
    std::set<std::string> given;
    std::string specified;          ///< Options that determine verdicts, in canonical form.
    std::string design;             ///< STL, GLB or STEP.
    double design_tolerance = 0.1;  ///< mm
    std::string baseline;           ///< File of known findings; empty: none.
    verify::Selection selection;
    std::string csv, html;  ///< Output files; empty: none.
    std::string png;        ///< Picture of a finding; empty: none.
    /// Number of the finding in `png`, from 1 in the order of the text; empty: the gravest.
    std::optional<std::size_t> finding;
    bool dog_leg = false;
    bool detached_pieces = false;  ///< Search for pieces that are cut free.
    bool air_cuts = false;         ///< Search for feed moves that remove nothing.
    unsigned jobs = 0;             ///< Number of programs at a time; 0: number of cores.
    bool warnings_as_errors = false;
};

struct RulesOptions {
    std::string id;  ///< Rule, category or reason for doubt; empty: all.
    bool json = false;
};

/// Returns the paths of all output files.
std::vector<std::string> outputs_of(const CheckOptions& options);
/// Returns the paths of all input files that are named.
std::vector<std::string> inputs_of(const CheckOptions& options);

/// True if the baseline is both read and written; reading comes first.
bool rewrites_baseline(const CheckOptions& options);

/// Add the options of `check` and `rules` to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, CheckOptions& options);
void add_options(cli::App& command, RulesOptions& options);

/// Kind of value of an option that determines verdicts and is permitted in ncsim.toml.
struct OptionKind {
    bool is_flag = false;
    bool is_switch = false;  ///< A flag whose `off` differs from its absence.
    bool is_file = false;    ///< A file or a folder.
};
/// Returns the kind of the option with this long name (without dashes); empty if there is none.
std::optional<OptionKind> kind_of_check_option(const std::string& name);

/// Returns the options of `command` that determine results, in canonical form: without outputs and
/// the division of work.
std::string settings_of(const cli::App& command);
std::set<std::string> specified_options(const cli::App& command);

/// Checks and completes `options` after all options were read.
/// Throws: Refusal.
void complete(CheckOptions& options);

}  // namespace ncsim::app
