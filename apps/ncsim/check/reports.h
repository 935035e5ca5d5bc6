// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is told of programs that were verified, now or before: of each, as soon as those before it
// are known, and of all of them in the end.
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
    /// Both must outlive it. `many`: there is more than one program. Reads the baseline that will
    /// be overwritten; throws std::runtime_error if it is none.
    Reports(const ReportOptions& options, OutputSet& outputs, bool many);

    void tell(const report::Entry& entry) const;
    /// The summary, and the files that were asked for.
    void write(const report::Entries& all, const report::Scope& scope) const;

private:
    const ReportOptions& options_;
    OutputSet& outputs_;
    bool many_;
    std::optional<report::Baseline> before_;
};

/// A baseline that is going to be overwritten, and may be read all the same: what it says is known
/// before. Nothing if it is not there.
std::optional<report::Baseline> overwritten_baseline(const std::string& path);

/// The worst of all, in the order clean, not proven, findings, a failing world, a bug of ours.
int exit_code_of(const report::Entries& all, bool exit_zero);

}  // namespace ncsim::app
