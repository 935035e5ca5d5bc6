// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the rules of verification.
#pragma once

#include <string>

namespace ncsim::report {

/// Returns every rule with category, severity, reason and remedy, and every reason for doubt.
std::string rules_text();
/// Returns the rules, categories and reasons for doubt named `id`, with purpose, suppression and
/// remedy; empty if no rule, category or reason has this name. A rule has an example of a program
/// that fails, and of a program that passes.
std::string rule_text(const std::string& id);
/// Returns the same data as JSON.
std::string rules_json();

}  // namespace ncsim::report
