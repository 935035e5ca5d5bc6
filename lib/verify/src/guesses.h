// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a verdict would rest on that nobody told: told as doubts.
#pragma once

#include "ncsim/verify/setup.h"

#include "finding_log.h"
#include "move.h"
#include "watched.h"

#include <map>

namespace ncsim::verify {

/// Of one motion. `is_watched`: its tool is known; `needs_part`: a selected rule looks at the part.
void doubt_guesses_of_move(const Setup& setup, const Move& move, bool is_watched, bool needs_part,
                           FindingLog& log);
/// Doubts a motion if a fixture is nearer to its path than the control may miss the path by.
void doubt_blend(const Setup& setup, const Move& move, FindingLog& log);
/// Logs doubts about the set-up of a program that has run with `tools`, by number.
void doubt_guesses_of_setup(const Setup& setup, const std::map<int, Watched>& tools,
                            bool needs_part, FindingLog& log);

}  // namespace ncsim::verify
