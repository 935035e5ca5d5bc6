// SPDX-License-Identifier: GPL-3.0-or-later
//
// Doubts about unspecified values on which a verdict would rest.
#pragma once

#include "ncsim/verify/setup.h"

#include "finding_log.h"
#include "move.h"
#include "tool_monitors.h"

#include <map>

namespace ncsim::verify {

/// Logs doubts about one motion. `is_watched`: the tool is known; `needs_part`: a selected rule
/// needs the part.
void doubt_guesses_of_move(const Setup& setup, const Move& move, bool is_watched, bool needs_part,
                           FindingLog& log);
/// Logs a doubt if a fixture is nearer to the path of the motion than the distance by which the
/// control may miss the path.
void doubt_blend(const Setup& setup, const Move& move, FindingLog& log);
/// Logs doubts about the set-up of a program that ran with `tools` (by number).
void doubt_guesses_of_setup(const Setup& setup, const std::map<int, ToolMonitors>& tools,
                            bool needs_part, FindingLog& log);

}  // namespace ncsim::verify
