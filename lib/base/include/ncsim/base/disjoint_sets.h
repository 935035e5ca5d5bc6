// SPDX-License-Identifier: GPL-3.0-or-later
//
// A union-find structure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim {

/// A partition of the numbers below `size` into sets; the least number represents a set. The result
/// does not depend on the order of unite() calls.
class DisjointSets {
public:
    /// Starts with each number in a separate set.
    explicit DisjointSets(std::size_t size);
    /// Returns the least number of the set of `i`. Cost: expected O(log size).
    std::uint32_t find(std::uint32_t i);
    void unite(std::uint32_t a, std::uint32_t b);
    /// Returns the number of sets.
    std::size_t sets() const { return sets_; }

private:
    std::vector<std::uint32_t> parent_;
    std::size_t sets_;
};

}  // namespace ncsim
