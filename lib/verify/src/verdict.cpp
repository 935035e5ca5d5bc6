// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts findings and doubts and derives the outcome.
#include "ncsim/verify/verdict.h"

#include "ncsim/verify/rule.h"

#include <algorithm>

namespace ncsim::verify {

std::uint64_t Verdict::count(Severity severity) const {
    std::uint64_t n = 0;
    for (const Finding& f : findings) {
        if (f.severity == severity && f.counts()) ++n;
    }
    for (const auto& [rule, more] : unlisted) {
        const RuleInfo* info = find_rule(rule);
        if (info && info->severity == severity) n += more;
    }
    return n;
}

std::uint64_t Verdict::open_doubts() const {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(doubts, [](const Doubt& d) { return !d.accepted; }));
}

Outcome Verdict::outcome() const {
    if (count(Severity::Error) > 0) return Outcome::Failed;
    if (open_doubts() > 0) return Outcome::NotProven;
    return is_accepted() ? Outcome::Accepted : Outcome::Clean;
}

bool Verdict::is_accepted() const {
    const auto is_waived = [](const Finding& f) {
        return f.demoted || (!f.counts() && f.severity == Severity::Error);
    };
    return std::ranges::any_of(findings, is_waived) ||
           std::ranges::any_of(doubts, [](const Doubt& d) { return d.accepted; });
}

std::uint64_t Verdict::deselected() const {
    return static_cast<std::uint64_t>(std::ranges::count_if(skipped, &Skipped::deselected));
}

std::string_view name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::Clean: return "clean";
        case Outcome::Accepted: return "accepted";
        case Outcome::NotProven: return "not proven";
        case Outcome::Failed: break;
    }
    return "failed";
}

std::uint64_t Verdict::suppressed() const {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(findings, [](const Finding& f) { return f.suppressed; }));
}

std::uint64_t Verdict::accepted() const {
    return static_cast<std::uint64_t>(std::ranges::count_if(
        findings, [](const Finding& f) { return f.accepted && !f.suppressed; }));
}

}  // namespace ncsim::verify
