// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings for code hosting services.
#pragma once

#include "ncsim/report/entry.h"

#include <iosfwd>

namespace ncsim::report {

/// SARIF 2.1.0 as code hosting services take it in: one run, rules with their stable ids, paths
/// relative to the working directory, fingerprints that survive insertions elsewhere in the
/// program, and no more results than are accepted, the heaviest first; what was left out is said.
void write_sarif(std::ostream& out, const Entries& all);

}  // namespace ncsim::report
