// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects what the rules see, and makes one finding of a row of the same fault.
#pragma once

#include "ncsim/verify/move.h"
#include "ncsim/verify/rule.h"
#include "ncsim/verify/suppression.h"
#include "ncsim/verify/verdict.h"

#include <map>
#include <string>
#include <vector>

namespace ncsim::verify {

/// What a rule saw in one motion.
struct Sighting {
    std::string message;
    std::optional<Quantity> quantity = std::nullopt;
    bool sums = false;  ///< In a row, quantities add up; else the largest counts.
    /// A row goes on over motions that the rule has nothing to say about, until end_row();
    /// else it takes motions that follow one another.
    bool lasts = false;
    Certainty certainty = Certainty::Certain;
    bool is_note = false;  ///< Weighs no more than a note.
    /// Weighs less than the rule: a warning instead of an error.
    bool weakened = false;
    std::optional<cda::Vec3> point = std::nullopt;
    cda::Box box = {};
    std::vector<std::string> assumptions = {};
    std::string hint = {};  ///< Instead of the rule's own.
};

class FindingLog {
public:
    FindingLog(const Selection& selection, const Suppressions& suppressions);

    void add(std::string_view rule, const Move& move, Sighting sighting);
    void end_row(std::string_view rule);
    /// A finding that is complete as it is, but for category, weight, hint and suppression.
    void add(Finding finding);

    /// Hands everything over, sorted by file, line, column and rule.
    void finish(Verdict& verdict);

private:
    void settle(Finding& finding, bool weakened);
    bool store(Finding finding);

    const Selection* selection_;
    const Suppressions* suppressions_;
    std::vector<Finding> findings_;
    std::map<std::string, std::size_t, std::less<>> rows_;  // rule + message: the open one
    std::map<std::string, std::uint64_t, std::less<>> stored_;
    std::map<std::string, std::uint64_t> unlisted_;
};

}  // namespace ncsim::verify
