// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work shared between threads, with results that do not depend on how many there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// Calls work(i) for each i below `tasks`, each once, in any order; 0 threads: as many as the
/// machine has. What one of them throws is thrown when all threads are done, and no more tasks are
/// begun.
void in_parallel(std::size_t threads, std::size_t tasks,
                 const std::function<void(std::size_t)>& work);

/// Calls take(i, make(i)) for each i below `tasks`: make() by all threads, take() in order and by
/// one at a time, whichever is there when the next one is ready, so that few of them have to be
/// kept.
template <class Make, class Take>
void make_in_parallel(std::size_t threads, std::size_t tasks, const Make& make, const Take& take) {
    using Made = decltype(make(std::size_t{}));
    std::mutex mutex;
    std::vector<std::optional<Made>> ready(tasks);
    std::size_t next = 0;
    bool is_taking = false;
    in_parallel(threads, tasks, [&](std::size_t i) {
        Made made = make(i);
        std::unique_lock lock(mutex);
        ready[i] = std::move(made);
        if (is_taking) return;
        is_taking = true;
        for (; next < tasks && ready[next]; ++next) {
            Made part = *std::exchange(ready[next], std::nullopt);
            lock.unlock();
            take(next, std::move(part));
            lock.lock();
        }
        is_taking = false;
    });
}

/// Numbers below `count` in runs of `size`, as tasks.
class Runs {
public:
    Runs(std::size_t count, std::size_t size) : count_(count), size_(size) {}
    std::size_t tasks() const { return (count_ + size_ - 1) / size_; }
    std::size_t begin(std::size_t task) const { return task * size_; }
    std::size_t end(std::size_t task) const { return std::min(count_, (task + 1) * size_); }

private:
    std::size_t count_, size_;
};

/// The numbers below `count` that are so, ascending. `is_so(i)` is asked by all threads.
template <class Predicate>
std::vector<std::uint32_t> those_that(std::size_t threads, std::uint32_t count,
                                      const Predicate& is_so) {
    const Runs runs(count, std::size_t{1} << 14);
    std::vector<std::uint32_t> all;
    make_in_parallel(
        threads, runs.tasks(),
        [&](std::size_t task) {
            std::vector<std::uint32_t> some;
            for (std::size_t i = runs.begin(task); i < runs.end(task); ++i) {
                if (is_so(static_cast<std::uint32_t>(i)))
                    some.push_back(static_cast<std::uint32_t>(i));
            }
            return some;
        },
        [&](std::size_t, const std::vector<std::uint32_t>& some) {
            all.insert(all.end(), some.begin(), some.end());
        });
    return all;
}

}  // namespace ncsim::cda
