// SPDX-License-Identifier: GPL-3.0-or-later
//
// List of the rules of verification.
#pragma once

#include <string>

namespace ncsim::report {

/// Returns every rule with its category, severity, reason and remedy, and every reason for doubt.
std::string rules_text();
/// Returns the rules, categories and reasons for doubt named `id`, with what they are for, how they
/// are switched off, and the remedy; empty if there is none. A rule has a program that fails and a
/// program that passes.
std::string rule_text(const std::string& id);
/// Returns the same data as JSON.
std::string rules_json();

}  // namespace ncsim::report
