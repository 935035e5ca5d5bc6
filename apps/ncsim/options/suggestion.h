// SPDX-License-Identifier: GPL-3.0-or-later
//
// What somebody may have meant who mistyped a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::app {

/// The one of `known` that is nearest to `word`, by letters left out, put in, changed or swapped
/// with their neighbour (Damerau 1964); empty if none is within a third of its length.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace ncsim::app
