// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports about verified programs: for each program as soon as all earlier programs are known, and
// a summary at the end.
#pragma once

#include "ncsim/report/baseline.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/scope.h"

#include "options/report_options.h"
#include "system/output.h"

#include <optional>
#include <string>

namespace ncsim::app {

class Reports {
public:
    /// Prepares reports and reads the baseline that will be overwritten. `many`: there is more than
    /// one program.
    /// Requires: `options` and `outputs` outlive the object.
    /// Throws: std::runtime_error if the file is no baseline.
    Reports(const ReportOptions& options, OutputSet& outputs, bool many);

    void add(const report::Entry& entry) const;
    /// Writes the summary and the output files.
    void write(const report::Entries& all, const report::Scope& scope) const;

private:
    const ReportOptions& options_;
    OutputSet& outputs_;
    bool many_;
    std::optional<report::Baseline> before_;
};

/// Reads the baseline at `path` before this run overwrites the file; empty if the file does not
/// exist.
std::optional<report::Baseline> overwritten_baseline(const std::string& path);

/// Returns the worst exit code, in the order clean, not proven, findings, environment failure, bug.
int exit_code_of(const report::Entries& all, bool exit_zero);

}  // namespace ncsim::app
