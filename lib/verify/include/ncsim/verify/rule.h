// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules, with name, rationale and remedy.
#pragma once

#include "ncsim/verify/rule_info.h"

#include <span>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// Returns all rules, always in the same order.
std::span<const RuleInfo> rules();

/// Returns the rule with this id; null if there is none.
const RuleInfo* find_rule(std::string_view id);

/// Returns the ids that `name` stands for: a rule, all rules of a category, or "all". Empty for an
/// unknown name.
std::vector<std::string_view> rules_named(std::string_view name);

}  // namespace ncsim::verify
