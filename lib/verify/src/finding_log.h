// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects what the rules see, and makes one finding of a row of the same fault.
#pragma once

#include "ncsim/verify/setup.h"
#include "ncsim/verify/verdict.h"

#include "move.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
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
    /// Reasons for doubt (ids) without which it would be certain: an error becomes a warning, and
    /// the doubt is told; but for those that somebody accepted.
    std::vector<std::string_view> rests_on = {};
    std::optional<cda::Vec3> point = std::nullopt;
    cda::Box box = {};
    std::vector<std::string> assumptions = {};
    std::string hint = {};  ///< Instead of the rule's own.
};

class FindingLog {
public:
    /// `setup` must outlive it.
    explicit FindingLog(const Setup& setup);

    void add(std::string_view rule, const Move& move, Sighting sighting);
    void end_row(std::string_view rule);
    /// There may be more of the row, which nobody looks at.
    void go_on(std::string_view rule);
    /// Something that keeps a program from being proven. The same reason and message count once.
    void doubt(std::string_view reason, std::string message, const Place& place = {});
    /// Adds a finding that is complete except for category, severity, hint and suppression. An
    /// error that rests on reasons for doubt becomes a warning, and a doubt of each.
    void add(Finding finding, std::vector<std::string_view> rests_on = {});

    /// Hands everything over, sorted by file, line, column and rule.
    void finish(Verdict& verdict);

private:
    void settle(Finding& finding, bool weakened) const;
    /// Settles it without the reasons that the user accepted, and logs doubts of the others.
    void settle(Finding& finding, std::vector<std::string_view>& rests_on);
    bool store(Finding finding);

    const Setup* setup_;
    // The finding that a row becomes, and the print of its first motion.
    struct Row {
        std::size_t finding = 0;
        std::uint64_t print = 0;
    };

    std::vector<Finding> findings_;
    std::map<std::string, Row, std::less<>> rows_;  // rule + message: the open one
    std::map<std::string, std::uint64_t, std::less<>> stored_;
    std::map<std::string, std::uint64_t> unlisted_;
    std::vector<Doubt> doubts_;
    std::map<std::pair<std::string, std::string>, std::size_t> doubt_index_;  // reason, message
};

}  // namespace ncsim::verify
