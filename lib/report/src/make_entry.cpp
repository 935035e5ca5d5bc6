// SPDX-License-Identifier: GPL-3.0-or-later
//
// Share of a verified program in the reports.
#include "ncsim/report/make_entry.h"

#include "ncsim/report/check_text.h"

#include "annotations.h"
#include "json.h"
#include "shares.h"

namespace ncsim::report {

Entry entry_of(const Checked& checked, int code, const EntryOptions& options) {
    Entry entry;
    entry.path = checked.path;
    entry.program = checked.program;
    entry.word = checked.word;
    entry.code = code;
    entry.text = text_of(checked, {options.notes, options.quiet, options.many, options.unit});
    entry.settings = checked.settings;
    entry.counts = counts_of(checked);
    entry.scope = scope_of(checked);
    entry.remedy_text = remedies_of(checked);
    entry.skipped = skipped_rules_text(checked);
    if (options.json) entry.json = to_line(check_json_share(checked));
    if (options.sarif) entry.sarif = to_line(sarif_share(checked, options.notes));
    if (options.junit) entry.junit = to_line(junit_share(checked, options.warnings_as_errors));
    entry.baseline = checked.baseline;
    if (options.known) entry.known = to_line(baseline_share(checked));
    if (options.github) entry.github = github_annotations(checked, options.notes, options.unit);
    if (options.csv) entry.csv = ledger_csv_share(checked, options.csv_unit);
    return entry;
}

}  // namespace ncsim::report
