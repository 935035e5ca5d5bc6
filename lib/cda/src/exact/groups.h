// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists of items by group in a single array.
#pragma once

#include "ncsim/base/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A list for each of many groups, all in one array. Items are counted first, then added.
template <class Item>
class Groups {
public:
    explicit Groups(std::size_t groups) : begin_(groups + 2, 0) {}

    void count(std::uint32_t group) { ++begin_[group + 2]; }
    /// Allocates the lists. Call after all items are counted.
    void reserve() {
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        items_.resize(begin_.back());
    }
    /// Adds an item. Requires: not more items than counted.
    void add(std::uint32_t group, const Item& item) { items_[begin_[group + 1]++] = item; }

    // Valid after all items are added.

    std::span<Item> of(std::size_t group) {
        return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
    }
    std::span<const Item> of(std::size_t group) const {
        return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
    }
    std::span<const Item> all() const { return items_; }
    /// Replaces each list by the items that change(group, list, result) adds to `result`.
    /// Requires: `result` is not longer than the list. All threads process runs of groups, each run
    /// with a separate `change` from make_change().
    template <class MakeChange>
    void replace(const Runs& runs, std::size_t threads, const MakeChange& make_change) {
        // Works in place, run by run; afterwards the runs move together.
        std::vector<std::size_t> end(runs.tasks());
        in_parallel(threads, runs.tasks(), [&](std::size_t task) {
            auto change = make_change();
            std::vector<Item> result;
            std::size_t to = begin_[runs.begin(task)];
            for (std::size_t group = runs.begin(task); group < runs.end(task); ++group) {
                const std::span<Item> list = of(group);
                result.clear();
                change(static_cast<std::uint32_t>(group), list, result);
                assert(result.size() <= list.size());
                // The task of the previous run reads the first begin of this run.
                if (group != runs.begin(task)) begin_[group] = to;
                std::ranges::copy(result, items_.begin() + static_cast<std::ptrdiff_t>(to));
                to += result.size();
            }
            end[task] = to;
        });
        std::size_t to = 0;
        for (std::size_t task = 0; task < runs.tasks(); ++task) {
            const std::size_t from = begin_[runs.begin(task)];
            std::copy(items_.begin() + static_cast<std::ptrdiff_t>(from),
                      items_.begin() + static_cast<std::ptrdiff_t>(end[task]),
                      items_.begin() + static_cast<std::ptrdiff_t>(to));
            for (std::size_t group = runs.begin(task); group < runs.end(task); ++group)
                begin_[group] -= from - to;
            to += end[task] - from;
        }
        begin_[begin_.size() - 2] = to;
        items_.resize(to);
    }

private:
    // Group g is [begin_[g], begin_[g + 1]). Until all items are added, begin_[g + 1] is the
    // position of the group's next item.
    std::vector<std::size_t> begin_;
    std::vector<Item> items_;
};

}  // namespace ncsim::cda
