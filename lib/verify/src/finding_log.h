// SPDX-License-Identifier: GPL-3.0-or-later
//
// Log that collects the observations of the rules and combines a row of the same fault into one
// finding.
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

/// Observation of a rule in one motion.
struct Occurrence {
    std::string message;
    std::optional<Quantity> quantity = std::nullopt;
    bool sums = false;  ///< In a row, quantities add up; otherwise the largest counts.
    /// The row continues over motions without an observation, until end_row(). Otherwise the row
    /// contains only successive motions.
    bool lasts = false;
    Certainty certainty = Certainty::Certain;
    bool is_note = false;  ///< The severity is Note.
    /// Reasons for doubt (ids) without which the fault would be certain. An error becomes a warning
    /// and each reason a doubt, except for reasons that the user accepted.
    std::vector<std::string_view> rests_on = {};
    std::optional<Vec3> point = std::nullopt;
    Box box = {};
    std::vector<std::string> bodies = {};                  ///< As in Finding.
    std::optional<machine::Values> joints = std::nullopt;  ///< As in Finding.
    std::vector<std::string> assumptions = {};
    std::string hint = {};  ///< Replaces the remedy of the rule.
};

class FindingLog {
public:
    /// Creates an empty log.
    /// Requires: `setup` outlives the log.
    explicit FindingLog(const Setup& setup);

    void add(std::string_view rule, const Move& move, Occurrence sighting);
    void end_row(std::string_view rule);
    /// Marks the open rows of `rule`: there may be more motions, which are not searched.
    void mark_incomplete(std::string_view rule);
    /// Adds a reason that keeps the program from being proven. Repetitions of the same reason and
    /// message are counted.
    void doubt(std::string_view reason, std::string message, const Place& place = {});
    /// Adds a finding that is complete except for category, severity, hint and suppression. If an
    /// error rests on reasons for doubt, it becomes a warning, and each reason a doubt.
    void add(Finding finding, std::vector<std::string_view> rests_on = {});

    /// Moves everything into `verdict`, sorted by file, line and column.
    void finish(Verdict& verdict);

private:
    /// Sets category, severity, hint and suppression. `weakened`: an error becomes a warning.
    /// Returns: true if the finding is an error by its rule or by the user's severity.
    bool settle(Finding& finding, bool weakened) const;
    /// Settles `finding` without the reasons that the user accepted, and logs the remaining reasons
    /// as doubts.
    void settle(Finding& finding, std::vector<std::string_view>& rests_on);
    bool store(Finding finding);

    const Setup* setup_;
    // Finding of an open row, and the hash of the row's first motion.
    struct Row {
        std::size_t finding = 0;
        std::uint64_t print = 0;
    };

    std::vector<Finding> findings_;
    std::map<std::string, Row, std::less<>> rows_;  // rule + message: the open row
    std::map<std::string, std::uint64_t, std::less<>> stored_;
    std::map<std::string, std::uint64_t> unlisted_;
    std::vector<Doubt> doubts_;
    std::map<std::pair<std::string, std::string>, std::size_t> doubt_index_;  // reason, message
};

}  // namespace ncsim::verify
