// SPDX-License-Identifier: GPL-3.0-or-later
//
// Review of a changed program as a self-contained page: pictures of both parts and of the
// difference, values of both programs, and the texts side by side.
#pragma once

#include "ncsim/report/difference.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/simulation/review.h"

#include <iosfwd>
#include <vector>

namespace ncsim::report {

/// Writes HTML 5, UTF-8, without external resources; several reviews are set-ups of a job.
/// Requires: at least one review.
void write_review(std::ostream& out, const std::vector<simulation::Review>& reviews,
                  LengthUnit unit = LengthUnit::Millimetre);

}  // namespace ncsim::report
