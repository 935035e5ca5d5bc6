// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of `ncsim merge`.
#pragma once

#include "options/report_options.h"

#include <string>
#include <utility>
#include <vector>

namespace ncsim::app {

struct MergeOptions : ReportOptions {
    std::vector<std::string> sources;  ///< Folders of results, and files.
    /// Options of `ncsim run` for the merged tiles, without dashes.
    std::vector<std::pair<std::string, std::string>> of_run;
};

/// Adds the options to `command`, which reads into `options`.
/// Requires: `options` outlives `command`.
void add_options(cli::App& command, MergeOptions& options);

}  // namespace ncsim::app
