// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unspecified tool lengths, where positions of the tip and of the machine meet.
#pragma once

#include "ncsim/verify/setup.h"

#include "finding_log.h"
#include "move.h"

namespace ncsim::verify {

/// True if the program uses length offsets and neither the length of the tool nor the offset that
/// is active is specified.
bool has_unknown_length(const Setup& setup, const Move& move);

/// Logs a doubt `length-offset` if some length of the tool, that of its specified part or up to 60
/// mm more for a holder that is not specified, takes Z out of its travel, or the tip into the stock
/// or a fixture at a position that the program gives in machine coordinates.
void doubt_unknown_length(const Setup& setup, const Move& move, FindingLog& log);

}  // namespace ncsim::verify
