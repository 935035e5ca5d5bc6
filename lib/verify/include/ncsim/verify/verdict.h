// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that is known about one program in the end.
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

/// Clean: nothing was found, and nothing had to be guessed to say so. Accepted: clean except for
/// errors that the user accepted, suppressed or demoted, or doubts that the user accepted. Not
/// proven: nothing was found that certainly is a fault, but a guess, or something left out, stands
/// between that and "clean".
enum class Outcome : std::uint8_t { Clean, Accepted, NotProven, Failed };

/// "clean", "accepted", "not proven", "failed".
std::string_view name_of(Outcome outcome);

/// A rule whose severity the user lowered.
struct Demotion {
    std::string rule;
    Severity severity = Severity::Note;
    std::string by;  ///< The option, or its place in a file.
    bool operator==(const Demotion&) const = default;
};

struct Verdict {
    std::vector<std::string> files;   ///< [0] the program; called files follow.
    std::vector<Finding> findings;    ///< In the order of the program's lines.
    std::vector<Skipped> skipped;     ///< In the order of rules().
    std::vector<Doubt> doubts;        ///< In the order of reasons().
    std::vector<Demotion> demotions;  ///< In the order of rules().
    /// Beyond kMaxFindings of a rule they are only counted, here.
    std::map<std::string, std::uint64_t> unlisted;
    Ledger ledger;

    static constexpr std::size_t kMaxFindings = 1000;

    /// Findings that are neither suppressed nor accepted, those that are only counted included
    /// where they have the rule's default weight.
    std::uint64_t count(Severity severity) const;
    /// Doubts that nobody accepted.
    std::uint64_t open_doubts() const;
    Outcome outcome() const;
    /// True if the user accepted, suppressed or demoted an error, or accepted a doubt.
    bool is_accepted() const;
    /// Rules that the user deselected.
    std::uint64_t deselected() const;
    std::uint64_t suppressed() const;
    std::uint64_t accepted() const;
};

}  // namespace ncsim::verify
