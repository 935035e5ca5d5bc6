// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the verdicts of programs go, whoever found them.
#pragma once

#include "options/cli.h"

#include <string>
#include <vector>

namespace ncsim::app {

struct ReportOptions {
    std::string json, sarif, junit;  ///< Files to write; empty: not asked for.
    std::string write_baseline;      ///< The same.
    bool github = false;             ///< Annotations for GitHub Actions instead of text.
    bool exit_zero = false;
    bool notes = false;  ///< Show notes, too.
    bool quiet = false;  ///< Only findings.
};

/// Lets `command` read them into `options`, which must outlive it.
void add_report_options(cli::App& command, ReportOptions& options);
/// The paths of all files that were asked for.
std::vector<std::string> outputs_of(const ReportOptions& options);

}  // namespace ncsim::app
