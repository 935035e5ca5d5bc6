// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of verification, for those who want to know them.
#pragma once

#include <string>

namespace ncsim::report {

/// Every rule with its category, weight, reason and remedy, and every reason for doubt.
std::string rules_text();
std::string rules_json();

}  // namespace ncsim::report
