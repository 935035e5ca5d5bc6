// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of a batch into stretches of two kinds, in order: tools that are open above the stock,
// which rays along z process in blocks (open_cutter.h), and all remaining bodies, which are
// processed individually. Thus a single body of the second kind does not slow down the whole batch.
#pragma once

#include <cstddef>
#include <vector>

namespace ncsim::dexel {

/// Bodies [begin, end).
struct Stretch {
    std::size_t begin, end;
    bool is_open;
    bool operator==(const Stretch&) const = default;
};

/// Least number of consecutive open tools for a block. Fewer tools take the same time individually.
inline constexpr std::size_t kFewOpen = 32;

/// Divides `count` bodies into non-empty stretches; consecutive stretches have different kinds.
template <class IsOpen>
std::vector<Stretch> stretches_of(std::size_t count, const IsOpen& is_open) {
    std::vector<Stretch> stretches;
    for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
        const bool open = is_open(begin);
        for (end = begin + 1; end < count && is_open(end) == open;)
            ++end;
        const bool many = open && (end - begin >= kFewOpen || (begin == 0 && end == count));
        if (!stretches.empty() && stretches.back().is_open == many)
            stretches.back().end = end;
        else
            stretches.push_back({begin, end, many});
    }
    return stretches;
}

}  // namespace ncsim::dexel
