// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts and defaults of a rule.
#pragma once

#include "ncsim/verify/finding.h"

#include <string_view>

namespace ncsim::verify {

/// Texts and default severity of a rule. The texts are static; ids are stable and kebab-case.
struct RuleInfo {
    std::string_view id;
    Category category;
    Severity severity;      ///< Default; the user or a finding may change the severity.
    std::string_view what;  ///< Fault that the rule finds: a noun phrase with a full stop.
    std::string_view why;   ///< Effect of the fault: a sentence.
    std::string_view fix;   ///< Remedy: an imperative sentence.
};

}  // namespace ncsim::verify
