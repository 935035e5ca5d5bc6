// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a program that was verified to its share of the reports.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"

namespace ncsim::report {

/// What shares are made of, and which.
struct EntryOptions {
    bool notes = false;  ///< In text, annotations and SARIF: notes and accepted doubts, too.
    bool quiet = false;  ///< In text only findings.
    bool many = false;   ///< There are others: what they have in common is told in the end.
    bool warnings_as_errors = false;
    bool json = true, sarif = true, junit = true, github = true, csv = false;
    bool known = false;  ///< For a baseline.
};

/// `code`: the exit code.
Entry entry_of(const Checked& checked, int code, const EntryOptions& options);

}  // namespace ncsim::report
