// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts as JSON for scripts. All formats of verdicts depend on the programs and the options
// only, not on time, absolute paths or the order of work.
#pragma once

#include "ncsim/report/entry.h"
#include "ncsim/report/scope.h"

#include <iosfwd>

namespace ncsim::report {

/// Writes all results (docs/schemas/check.schema.json). Lengths are in mm, volumes in mm³. Within a
/// version, keys are only added.
void write_check_json(std::ostream& out, const Entries& all, const Scope& scope);

}  // namespace ncsim::report
