// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suggestion for a mistyped word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// Returns the element of `known` nearest to `word`, by letters omitted, inserted, changed or
/// swapped with their neighbour; empty if none is within a third of the length of `word`.
/// Source: Damerau, 1964.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace ncsim::app
