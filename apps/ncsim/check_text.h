// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts for people: findings with the line and a caret, what was skipped, a summary.
#pragma once

#include "checked.h"

#include <span>
#include <string>

namespace ncsim::app {

/// All there is to say about one program, ending in a newline; empty if that is nothing.
std::string text_of(const Checked& checked, const CheckOptions& options);

/// One line about all of them.
std::string summary_of(std::span<const Checked> all);

/// Every rule with its category, weight, reason and remedy.
std::string rules_text();
std::string rules_json();

}  // namespace ncsim::app
