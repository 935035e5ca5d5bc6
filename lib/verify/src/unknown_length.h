// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unspecified tool lengths, where positions of the tip and of the machine meet.
#pragma once

#include "ncsim/verify/setup.h"

#include "finding_log.h"
#include "move.h"

namespace ncsim::verify {

/// True if the program uses length offsets, and neither the length of the tool nor the active
/// offset is specified.
bool has_unknown_length(const Setup& setup, const Move& move);

/// Logs a doubt `length-offset` if a possible length of the tool takes Z out of its travel, or
/// takes the tip into the stock or a fixture at a position given in machine coordinates. Possible
/// lengths are the length of the specified part of the tool plus 0 to 60 mm for an unspecified
/// holder.
void doubt_unknown_length(const Setup& setup, const Move& move, FindingLog& log);

}  // namespace ncsim::verify
