// SPDX-License-Identifier: GPL-3.0-or-later
//
// Share of a verified program in the reports.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/length_unit.h"

namespace ncsim::report {

/// Choice of reports and of their content.
struct EntryOptions {
    bool notes = false;  ///< Adds notes and accepted doubts to text, annotations and SARIF.
    bool quiet = false;  ///< Text has only findings and doubts.
    bool many = false;   ///< There are several programs; the summary has their common text.
    bool warnings_as_errors = false;
    bool json = true, sarif = true, junit = true, github = true, csv = false;
    bool known = false;                            ///< Adds findings for a baseline.
    LengthUnit unit = LengthUnit::Millimetre;      ///< Unit of text and annotations.
    LengthUnit csv_unit = LengthUnit::Millimetre;  ///< Unit of CSV, the same for all programs.
};

/// Returns the shares of `checked`. `code` is the exit status.
Entry entry_of(const Checked& checked, int code, const EntryOptions& options);

}  // namespace ncsim::report
