// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as JUnit test cases.
#pragma once

#include "ncsim/report/entry.h"

#include <iosfwd>

namespace ncsim::report {

/// Writes JUnit XML: a suite for each program, with a case for each rule and a case "proven" for
/// all doubts. Rules that were not checked are skipped cases. Warnings fail a case only if they
/// count as errors.
void write_junit(std::ostream& out, const Entries& all);

}  // namespace ncsim::report
