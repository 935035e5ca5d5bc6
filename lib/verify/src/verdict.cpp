// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/verify/verdict.h"

#include "ncsim/verify/rule.h"

#include <algorithm>

namespace ncsim::verify {

std::uint64_t Verdict::count(Severity severity) const {
    std::uint64_t n = 0;
    for (const Finding& f : findings) {
        if (f.severity == severity && !f.suppressed) ++n;
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
    return open_doubts() > 0 ? Outcome::NotProven : Outcome::Clean;
}

std::string_view name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::Clean: return "clean";
        case Outcome::NotProven: return "not proven";
        case Outcome::Failed: break;
    }
    return "failed";
}

std::uint64_t Verdict::suppressed() const {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(findings, [](const Finding& f) { return f.suppressed; }));
}

}  // namespace ncsim::verify
