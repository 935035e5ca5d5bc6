// SPDX-License-Identifier: GPL-3.0-or-later
//
// Result of the verification of one program.
#pragma once

#include "ncsim/verify/doubt.h"
#include "ncsim/verify/finding.h"
#include "ncsim/verify/ledger.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// Outcome of a verification. Clean: no finding, and no assumption can change this. Accepted: clean
/// except for errors that the user accepted, suppressed or demoted, or doubts that the user
/// accepted. NotProven: no certain fault was found, but an assumption or an omission prevents
/// "clean". Failed: a certain fault was found.
enum class Outcome : std::uint8_t { Clean, Accepted, NotProven, Failed };

/// Returns "clean", "accepted", "not proven" or "failed".
std::string_view name_of(Outcome outcome);

/// Rule whose severity the user lowered.
struct Demotion {
    std::string rule;
    Severity severity = Severity::Note;
    std::string by;  ///< Option, or place in a file.
    bool operator==(const Demotion&) const = default;
};

/// Findings, skipped rules, doubts and the ledger of one program.
struct Verdict {
    std::vector<std::string> files;   ///< [0] is the program; called files follow.
    std::vector<Finding> findings;    ///< In the order of the lines of the program.
    std::vector<Skipped> skipped;     ///< In the order of rules().
    std::vector<Doubt> doubts;        ///< In the order of reasons().
    std::vector<Demotion> demotions;  ///< In the order of rules().
    /// Number of findings beyond kMaxFindings, by rule.
    std::map<std::string, std::uint64_t> unlisted;
    Ledger ledger;

    static constexpr std::size_t kMaxFindings = 1000;

    /// Returns the number of findings of `severity` that are neither suppressed nor accepted.
    /// Unlisted findings are included if the default severity of the rule is `severity`.
    std::uint64_t count(Severity severity) const;
    /// Returns the number of doubts that are not accepted.
    std::uint64_t open_doubts() const;
    Outcome outcome() const;
    /// True if the user accepted, suppressed or demoted an error, or accepted a doubt.
    bool is_accepted() const;
    /// Returns the number of rules that the user deselected.
    std::uint64_t deselected() const;
    std::uint64_t suppressed() const;
    std::uint64_t accepted() const;
};

}  // namespace ncsim::verify
