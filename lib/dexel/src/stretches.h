// SPDX-License-Identifier: GPL-3.0-or-later
//
// What waits in one batch, in its order: tools that are open above the stock, which rays along z
// take many at a time (open_cutter.h), and others, which they take one after the other. One tool
// of the second kind does not send the whole batch that way.
#pragma once

#include <cstddef>
#include <vector>

namespace ncsim::dexel {

/// Bodies from `begin` to before `end`.
struct Stretch {
    std::size_t begin, end;
    bool is_open;
    bool operator==(const Stretch&) const = default;
};

/// Of fewer open ones in a row than these, one after the other is as cheap.
inline constexpr std::size_t kFewOpen = 32;

/// All of `count` bodies, none of them empty and no two of one kind in a row.
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
