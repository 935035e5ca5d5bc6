// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of two texts line by line.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace ncsim::report {

/// Consecutive lines of both texts, counted from 0: equal lines, or lines that differ. A stretch of
/// lines that differ may have no lines of one text.
struct LineStretch {
    bool equal = false;
    std::size_t old_first = 0, old_count = 0;
    std::size_t new_first = 0, new_count = 0;
    bool operator==(const LineStretch&) const = default;
};

/// Returns the stretches of both texts in order; equal and different stretches alternate. The
/// number of equal lines is the largest possible, unless more than a thousand lines differ between
/// equal stretches.
/// Cost: O(n + d²) for n lines and d differences, at most O(1000 n).
/// Source: Myers 1986, An O(ND) Difference Algorithm and Its Variations, section 3.
std::vector<LineStretch> compare_lines(std::span<const std::string_view> old_lines,
                                       std::span<const std::string_view> new_lines);

}  // namespace ncsim::report
