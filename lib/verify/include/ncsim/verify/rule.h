// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules: what each one is called, why it matters and how to satisfy it.
#pragma once

#include "ncsim/verify/rule_info.h"

#include <span>
#include <string_view>
#include <vector>

namespace ncsim::verify {

/// All rules, by category; the order never depends on anything.
std::span<const RuleInfo> rules();

/// Null if there is no rule of this id.
const RuleInfo* find_rule(std::string_view id);

/// The ids that `name` stands for: a rule, all rules of a category, or "all". Empty if it is none
/// of these.
std::vector<std::string_view> rules_named(std::string_view name);

}  // namespace ncsim::verify
