// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work shared between threads, with results that do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim {

/// Returns `threads`, or the number of hardware threads if `threads` is 0; at least 1.
std::size_t thread_count(std::size_t threads);

/// Tasks that other threads execute while the caller continues.
class Background {
public:
    /// Calls work(i) once for each i below `tasks`, in any order, on `others` additional threads.
    Background(std::size_t others, std::size_t tasks, std::function<void(std::size_t)> work);
    /// Begins no more tasks; returns when the running tasks are done.
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Executes remaining tasks on the calling thread until all are done. Call at most once.
    /// Throws: the exception of a task; no task begins after an exception.
    void finish();

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// Calls work(i) once for each i below `tasks`, in any order. `threads`: 0 means one per hardware
/// thread.
/// Throws: the exception of a task, after all threads are done; no task begins after an exception.
void in_parallel(std::size_t threads, std::size_t tasks,
                 const std::function<void(std::size_t)>& work);

/// Calls take(i, make(i)) for each i below `tasks`. All threads call make(). take() is called in
/// order and by one thread at a time: by any thread that finds the next result ready. So few
/// results are stored at a time.
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

/// Numbers below `count`, divided into runs of `size` numbers as tasks.
class Runs {
public:
    Runs(std::size_t count, std::size_t size) : count_(count), size_(size) {}
    std::size_t tasks() const { return (count_ + size_ - 1) / size_; }
    std::size_t begin(std::size_t task) const { return task * size_; }
    std::size_t end(std::size_t task) const { return std::min(count_, (task + 1) * size_); }

private:
    std::size_t count_, size_;
};

/// Sorts with all threads. Requires: no two items are equivalent, so that the order is unique.
template <class Item, class Less>
void sort_in_parallel(std::size_t threads, std::vector<Item>& items, const Less& less) {
    constexpr std::size_t kLeast = std::size_t{1} << 12;  // items per thread at least
    const std::size_t parts =
        std::clamp<std::size_t>(items.size() / kLeast, 1, thread_count(threads));
    const auto at = [&](std::size_t part) {
        return items.begin() + static_cast<std::ptrdiff_t>(items.size() * part / parts);
    };
    in_parallel(threads, parts, [&](std::size_t i) { std::sort(at(i), at(i + 1), less); });
    for (std::size_t width = 1; width < parts; width *= 2) {
        in_parallel(threads, (parts + width - 1) / (2 * width), [&](std::size_t i) {
            const std::size_t first = 2 * width * i;
            std::inplace_merge(at(first), at(first + width), at(std::min(first + 2 * width, parts)),
                               less);
        });
    }
}

/// Returns the numbers i below `count` for which is_so(i), ascending. All threads call `is_so`.
template <class Predicate>
std::vector<std::uint32_t> filter_indices(std::size_t threads, std::uint32_t count,
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

}  // namespace ncsim
