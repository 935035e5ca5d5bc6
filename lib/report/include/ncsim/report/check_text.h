// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts for people: findings with the line and a caret, what was skipped, a summary.
#pragma once

#include "ncsim/report/checked.h"

#include <span>
#include <string>

namespace ncsim::report {

/// How much is said.
struct TextOptions {
    bool notes = false;  ///< Notes and accepted doubts, too.
    bool quiet = false;  ///< Only findings.
};

/// All there is to say about one program, ending in a newline; empty if that is nothing.
std::string text_of(const Checked& checked, const TextOptions& options);

/// One line about all of them.
std::string summary_of(std::span<const Checked> all);

}  // namespace ncsim::report
