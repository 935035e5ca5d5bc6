// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts parts of a text.
#pragma once

#include <cstddef>
#include <string_view>

namespace ncsim::test {

/// Returns the number of non-overlapping occurrences of `part` in `text`.
inline std::size_t count(std::string_view text, std::string_view part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + 1))
        ++n;
    return n;
}

}  // namespace ncsim::test
