// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ncsim/verify/finding.h"

#include <string_view>

namespace ncsim::verify {

/// What people are told about a rule. The texts are static; ids are stable and kebab-case.
struct RuleInfo {
    std::string_view id;
    Category category;
    Severity severity;     ///< Unless the user or a finding says otherwise.
    std::string_view why;  ///< One sentence.
    std::string_view fix;  ///< One sentence.
};

}  // namespace ncsim::verify
