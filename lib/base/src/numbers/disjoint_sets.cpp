// SPDX-License-Identifier: GPL-3.0-or-later
//
// Union-find with path halving.
#include "ncsim/base/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace ncsim {

DisjointSets::DisjointSets(std::size_t size) : parent_(size), sets_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::find(std::uint32_t i) {
    while (parent_[i] != i)
        i = parent_[i] = parent_[parent_[i]];
    return i;
}

void DisjointSets::unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --sets_;
}

}  // namespace ncsim
