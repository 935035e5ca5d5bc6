// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `ncsim merge` is asked for.
#pragma once

#include "options/report_options.h"

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
cli::App* add_merge(cli::App& app, MergeOptions& options);

}  // namespace ncsim::app
