// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim merge`.
#pragma once

#include "report_options.h"

#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

struct MergeOptions : ReportOptions {
    std::vector<std::string> sources;  ///< Folders of results, and files.
    /// Options of `ncsim run` for what tiles are put together to, without dashes.
    std::vector<std::pair<std::string, std::string>> of_run;
};

/// The command `merge` of `app`. It reads into `options`, which must outlive it.
CLI::App* add_merge(CLI::App& app, MergeOptions& options);

/// Tells and writes what one `ncsim check` of the whole list would, or, of tiles, one `ncsim run`.
/// Returns its exit code. Throws std::runtime_error if a shard or a tile is missing, cut off or
/// foreign, or an output cannot be written.
int run(MergeOptions options);

}  // namespace ncsim::app
