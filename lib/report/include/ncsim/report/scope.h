// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accounts for every file that a check met: judged, judged with its caller, or left out.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/setup/program_folder.h"

#include <string>
#include <vector>

namespace ncsim::report {

using setup::ExcludedEntry;

/// A subprogram in a file of its own, judged with the program that calls it.
struct CalledFile {
    std::string path;
    std::string caller;  ///< The first caller in the list.
};

/// Files that a check met but did not judge on their own.
struct Scope {
    std::vector<ExcludedEntry> excluded;
    std::vector<CalledFile> called;
    std::string job{};  ///< Job file of all programs; empty: none.
};

/// Returns the worst verdict: "not-verified", "failed", "not-proven", "accepted", "clean".
std::string worst_verdict(const Entries& all);

/// Returns the subprograms of `all` that a judged program reads, in the order of the list. Only an
/// entry with `is_subprogram` can be called. A subprogram that no judged program reads is judged as
/// a program, together with the files that this subprogram reads.
std::vector<CalledFile> called_files(const Entries& all);

/// Returns `all` without `called`; subprograms that are judged as programs come last.
/// Requires: `all` outlives the result.
Entries remove_called(const Entries& all, const std::vector<CalledFile>& called);

/// Returns one line for each kind of `excluded` with a count and the first names; empty if there is
/// none.
std::string text_of(const std::vector<ExcludedEntry>& excluded);

/// Returns "; 1 subprogram, judged with its caller; 3 files left out"; empty if there are none.
std::string counts_of(const Scope& scope);

}  // namespace ncsim::report
