// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// Numbers that belong together; the least one stands for a set. Sets grow together in whatever
/// order, and come out the same.
class DisjointSets {
public:
    /// Each number below `size` by itself.
    explicit DisjointSets(std::size_t size);
    /// Expected O(log size).
    std::uint32_t find(std::uint32_t i);
    void unite(std::uint32_t a, std::uint32_t b);
    /// How many sets there are.
    std::size_t sets() const { return sets_; }

private:
    std::vector<std::uint32_t> parent_;
    std::size_t sets_;
};

}  // namespace ncsim::cda
