// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outputs of verdicts, for `ncsim check` and `ncsim merge`.
#pragma once

#include "options/option_row.h"

#include <span>
#include <string>
#include <vector>

namespace ncsim::app {

struct ReportOptions {
    std::string json, sarif, junit;  ///< Output files; empty: none.
    std::string write_baseline;      ///< Output file; empty: none.
    bool github = false;             ///< Annotations for GitHub Actions instead of text.
    bool exit_zero = false;
    bool notes = false;  ///< Also show notes.
    bool quiet = false;  ///< Only findings.
};

/// Rows of the options of reports.
std::span<const OptionRow<ReportOptions>> report_options();
/// Returns the paths of all output files.
std::vector<std::string> outputs_of(const ReportOptions& options);

}  // namespace ncsim::app
