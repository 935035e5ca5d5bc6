// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours of text on terminals.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// When text has colours. Auto: on a terminal, unless the environment has NO_COLOR or TERM=dumb.
enum class ColourMode : std::uint8_t { Auto, Always, Never };

/// Returns "auto", "always" or "never" as a mode.
std::optional<ColourMode> colour_mode(std::string_view name);

/// Removes `--color WHEN` and `--color=WHEN` before the word `--` from a command line and returns
/// the last value; "auto" without one.
std::string take_colour(std::vector<std::string>& words);

/// True if text for the open file `descriptor` has colours.
bool has_colours(ColourMode mode, int descriptor);

/// Returns `text` with escape sequences: places of findings are bold; severities, verdicts and
/// carets have colours. Requires: `text` has no escape sequences.
std::string coloured(std::string_view text);

}  // namespace ncsim::app
