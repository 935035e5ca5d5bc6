// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as tests that passed or failed.
#pragma once

#include "ncsim/report/entry.h"

#include <iosfwd>

namespace ncsim::report {

/// JUnit XML: a suite for each program, a case for each rule that was selected and one for what
/// keeps the program from being proven; skipped rules are skipped cases. Warnings fail a case only
/// if they are to count as errors.
void write_junit(std::ostream& out, const Entries& all);

}  // namespace ncsim::report
