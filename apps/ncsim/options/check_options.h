// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `ncsim check` and `ncsim rules` are asked for.
#pragma once

#include "ncsim/report/file_digests.h"
#include "ncsim/simulation/check.h"
#include "ncsim/verify/selection.h"

#include "options/program_options.h"
#include "options/report_options.h"
#include "options/shard_number.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// `program`, `save_job` and `model` are not used: there may be many programs.
struct CheckOptions : ProgramOptions, SimulationOptions, ReportOptions {
    std::vector<std::string> programs;
    std::string list;                     ///< More programs, a path a line.
    std::string shard;                    ///< "3/200", "auto"; empty: all of them.
    std::uint32_t shards = 0;             ///< How many there are, where "auto" cannot know.
    ShardNumber number;                   ///< What these say, or `tile`.
    std::string out;                      ///< Folder for the results of a shard.
    bool isolate = false;                 ///< Each program in a process of its own.
    bool redo = false;                    ///< Though the result of the shard or tile is there.
    std::string tile;                     ///< "17/64", "auto"; empty: all of the part.
    std::string tile_out;                 ///< Folder for its result.
    std::vector<std::string> tile_words;  ///< What decides it, in one way to say it.
    /// All tiles, which were seen before, and the files they were made of; null: the part is cut
    /// now.
    std::shared_ptr<const simulation::SeenTiles> tiles;
    report::FileDigests tile_files;
    std::string cache;               ///< Folder of verdicts that are known already; empty: none.
    bool no_project = false;         ///< Pass over ncsim.toml.
    std::vector<std::string> words;  ///< Of the command line, the name of the command first.
    std::set<std::string> given;     ///< Options that stand there, without dashes.
    std::string told;                ///< What of them decides verdicts, in one way to say it.
    std::string machine;             ///< A machine.toml.
    std::string design;              ///< STL, GLB or STEP.
    double design_tolerance = 0.1;   ///< mm
    std::string baseline;            ///< Findings that are known; empty: none.
    verify::Selection selection;
    std::string csv, html;  ///< Files to write; empty: not asked for.
    bool dog_leg = false;
    bool cut_free = false;  ///< Look for pieces that are cut free.
    bool air_cuts = false;  ///< Look for feed moves that remove nothing.
    unsigned jobs = 0;      ///< Programs at a time; 0: as many as the machine has cores.
    bool warnings_as_errors = false;
};

struct RulesOptions {
    bool json = false;
};

/// The paths of all files that were asked for.
std::vector<std::string> outputs_of(const CheckOptions& options);
/// The paths of all files that are named to be read.
std::vector<std::string> inputs_of(const CheckOptions& options);

/// Is the baseline that is read the one that is written? It is read before.
bool rewrites_baseline(const CheckOptions& options);

/// The commands `check` and `rules` of `app`. They read into `options`, which must outlive it.
cli::App* add_check(cli::App& app, CheckOptions& options);
cli::App* add_rules(cli::App& app, RulesOptions& options);

/// What an option takes that decides verdicts and may stand in an ncsim.toml.
struct OptionKind {
    bool is_flag = false;
    bool is_file = false;  ///< Or a folder.
};
/// By its long name without dashes; nothing if there is none.
std::optional<OptionKind> kind_of_check_option(const std::string& name);

/// What was told `command` that decides its verdicts: neither where results go nor how the work is
/// shared. And the options that stand on the command line, without dashes.
std::string told_to(const cli::App& command);
/// The command line that asks the same, whoever shares the work.
std::vector<std::string> words_of_check(const cli::App& command);
std::set<std::string> given_to(const cli::App& command);

/// What can be judged only when all options were read; throws Refusal.
void complete(CheckOptions& options);

}  // namespace ncsim::app
