// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is told of programs that were verified, now or before: of each, as soon as those before it
// are known, and of all of them in the end.
#pragma once

#include "ncsim/report/entry.h"

#include "output.h"
#include "report_options.h"

namespace ncsim::app {

class Reports {
public:
    /// Both must outlive it. `many`: there is more than one program.
    Reports(const ReportOptions& options, OutputSet& outputs, bool many)
        : options_(options), outputs_(outputs), many_(many) {}

    void tell(const report::Entry& entry) const;
    /// The summary, and the files that were asked for.
    void write(const report::Entries& all) const;

private:
    const ReportOptions& options_;
    OutputSet& outputs_;
    bool many_;
};

/// The worst of all, in the order clean, not proven, findings, a failing world, a bug of ours.
int exit_code_of(const report::Entries& all, bool exit_zero);

}  // namespace ncsim::app
