// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts for other programs. All of them depend on the programs and the options only: no times,
// no absolute paths, no order of work.
#pragma once

#include "checked.h"

#include <iosfwd>
#include <span>
#include <string>

namespace ncsim::app {

/// Everything, as JSON (docs/check.schema.json). Lengths in mm, volumes in mm³. Keys are only ever
/// added within a version.
void write_check_json(std::ostream& out, std::span<const Checked> all);

/// SARIF 2.1.0 as code hosting services take it in: one run, rules with their stable ids, paths
/// relative to the working directory, fingerprints that survive insertions elsewhere in the
/// program, and no more results than are accepted, the heaviest first; what was left out is said.
void write_sarif(std::ostream& out, std::span<const Checked> all);

/// JUnit XML: a suite for each program, a case for each rule that was selected and one for what
/// keeps the program from being proven; skipped rules are skipped cases. Warnings fail a case only
/// if they are to count as errors.
void write_junit(std::ostream& out, std::span<const Checked> all, const CheckOptions& options);

/// The ledger: one line for each execution of a block, after a line of names.
void write_ledger_csv(std::ostream& out, std::span<const Checked> all);

/// Workflow commands that GitHub Actions shows beside the lines of a change; a line each.
std::string github_annotations(const Checked& checked);

/// `path` as seen from the working directory, with '/' and without "./"; as it is if it is not
/// below it.
std::string relative_path(const std::string& path);

/// The file a finding is in, relative.
std::string file_of(const Checked& checked, const verify::Place& place);

/// "rapid move through material: removed 12.5 mm3": message and quantity.
std::string headline(const verify::Finding& finding);

}  // namespace ncsim::app
