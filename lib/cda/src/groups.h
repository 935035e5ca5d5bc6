// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Lists that are counted first and filled then: items of group g are at begin[g] … begin[g + 1].
template <class Item>
struct Groups {
    std::vector<std::size_t> begin;
    std::vector<Item> items;

    explicit Groups(std::size_t groups) : begin(groups + 1, 0) {}
    void count(std::uint32_t group) { ++begin[group + 1]; }
    void reserve() {
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        items.resize(begin.back());
        at_ = begin;
    }
    void add(std::uint32_t group, const Item& item) { items[at_[group]++] = item; }
    std::span<Item> of(std::size_t group) {
        return std::span(items).subspan(begin[group], begin[group + 1] - begin[group]);
    }

private:
    std::vector<std::size_t> at_;
};

}  // namespace ncsim::cda
