// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules: what each one is called, why it matters and how to satisfy it.
#pragma once

#include "ncsim/verify/finding.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// What people are told about a rule. The texts are static; ids are stable and kebab-case.
struct RuleInfo {
    std::string_view id;
    Category category;
    Severity severity;     ///< Unless the user or a finding says otherwise.
    std::string_view why;  ///< One sentence.
    std::string_view fix;  ///< One sentence.
};

/// All rules, by category; the order never depends on anything.
std::span<const RuleInfo> rules();

/// Null if there is no rule of this id.
const RuleInfo* find_rule(std::string_view id);

/// Which rules are asked, and how much they weigh.
struct Selection {
    std::set<std::string, std::less<>> ignored;
    std::map<std::string, Severity, std::less<>> severities;

    bool includes(std::string_view id) const { return !ignored.contains(id); }
};

/// The ids that `name` stands for: a rule, all rules of a category, or "all". Empty if it is none
/// of these.
std::vector<std::string_view> rules_named(std::string_view name);

}  // namespace ncsim::verify
