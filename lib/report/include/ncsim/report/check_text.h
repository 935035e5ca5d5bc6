// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts for people: findings with the line and a caret, what was skipped, a summary.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/scope.h"

#include <string>

namespace ncsim::report {

/// How much is said.
struct TextOptions {
    bool notes = false;  ///< Notes and accepted doubts, too.
    bool quiet = false;  ///< Only findings.
    bool many = false;   ///< Only findings and doubts: summary_of() tells the rest.
};

/// All there is to say about one program, ending in a newline; empty if that is nothing.
std::string text_of(const Checked& checked, const TextOptions& options);

/// How many findings and doubts it has; empty if it was not verified.
std::string counts_of(const Checked& checked);
/// What would prove it: for each reason for doubt its name, ": " and what to tell, a line each.
std::string remedies_of(const Checked& checked);
/// Returns "RULE: severity note by --severity".
std::string demotion_text(const verify::Demotion& demotion);
/// Returns what the user switched off or accepted, for the line of the verdict: "34 of 36 rules by
/// --ignore; accepted stock-guess"; empty if nothing.
std::string scope_of(const Checked& checked);
/// Returns the rules that were not asked, a line a reason; empty if there are none.
std::string skipped_of(const Checked& checked);

/// After the programs, each of which has told its own. Of one: what was not asked. Of many: what
/// to tell and what was not asked, once for all, which ones failed and which are not proven, and
/// how many of each, with the counts of `scope`.
std::string summary_of(const Entries& all, const TextOptions& options, const Scope& scope);

}  // namespace ncsim::report
