// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suggestions for mistyped words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ncsim::setup {

/// Returns the word of `known` with the fewest changed, missing, additional and swapped letters.
/// Empty if more than a third of the letters differ.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace ncsim::setup
