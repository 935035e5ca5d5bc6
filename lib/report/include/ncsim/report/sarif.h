// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings for code hosting services.
#pragma once

#include "ncsim/report/entry.h"

#include <iosfwd>

namespace ncsim::report {

/// Writes SARIF 2.1.0 for code hosting services: a single run, rules with stable ids, paths
/// relative to the working directory, and fingerprints that survive insertions elsewhere in the
/// program. If there are more results than a service accepts, the results of the lowest severity
/// are omitted, and a notification states their number.
void write_sarif(std::ostream& out, const Entries& all);

}  // namespace ncsim::report
