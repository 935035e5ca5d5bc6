// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as text: findings with the line and a caret, skipped rules, a summary.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/report/scope.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ncsim::report {

/// Amount of text.
struct TextOptions {
    bool notes = false;  ///< Adds notes and accepted doubts.
    bool quiet = false;  ///< Only findings and doubts.
    /// Only findings, doubts and findings that are no longer found; summary_of() gives the rest.
    bool many = false;
    LengthUnit unit = LengthUnit::Millimetre;
};

/// Returns the text about one program, ending in a newline; may be empty.
std::string text_of(const Checked& checked, const TextOptions& options);

/// Returns the places in `verdict.findings` of the findings that text_of() lists, in its order.
std::vector<std::size_t> listed_findings(const verify::Verdict& verdict, bool notes);

/// Returns the numbers of findings and doubts; empty if the program was not verified.
std::string counts_of(const Checked& checked);
/// Returns a line for each open reason for doubt: its name, ": " and the remedy.
std::string remedies_of(const Checked& checked);
/// Returns "RULE: severity note by --severity".
std::string demotion_text(const verify::Demotion& demotion);
/// Returns the rules and doubts that the user switched off or accepted, for the line of the
/// verdict: "34 of 36 rules by --ignore; accepted stock-guess"; empty if there are none.
std::string scope_of(const Checked& checked);
/// Returns the rules that were not checked, a line for each reason; empty if there are none.
std::string skipped_rules_text(const Checked& checked);

/// Returns the text after the texts of all programs. For a single program (`many` is false): the
/// skipped rules. For many programs: remedies and skipped rules of all programs, the programs that
/// failed or are not proven, and the number of programs for each verdict, with the counts of
/// `scope`.
std::string summary_of(const Entries& all, const TextOptions& options, const Scope& scope);

}  // namespace ncsim::report
