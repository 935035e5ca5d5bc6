// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the known word nearest to a mistyped word.
#include "options/suggestion.h"

#include "ncsim/setup/nearest_word.h"

namespace ncsim::app {

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
    return setup::nearest_word(word, known);
}

}  // namespace ncsim::app
