// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts for other programs, as JSON. Like all of these formats it depends on the programs and
// the options only: no times, no absolute paths, no order of work.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/report/scope.h"

#include <iosfwd>

namespace ncsim::report {

/// Everything (docs/check.schema.json). Lengths in mm, volumes in mm³. Keys are only ever added
/// within a version.
void write_check_json(std::ostream& out, const Entries& all, const Scope& scope);

}  // namespace ncsim::report
