// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parallel work on several threads, with results in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace ncsim::app {

/// Calls work(i, stop) for all i below `count` on `jobs` threads. On the thread of the caller,
/// calls done(i) in the order of i, and noted(n) as soon as n pieces are finished. If `done` or
/// `noted` throws, no further piece begins, running pieces are asked to stop, and after their end
/// the exception propagates. A request of `stop` has the same effect without an exception.
/// Requires: `work` does not throw.
/// Returns: the number of pieces begun, which are the first ones; done(i) was called for each of
///   them.
template <class Work, class Done, class Noted>
std::size_t run_in_order(std::size_t count, unsigned jobs, const Work& work, const Done& done,
                         const Noted& noted, std::stop_source stop = {}) {
    std::vector<bool> ready(count, false);
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t next = 0, finished = 0;
    const auto take_next = [&] {
        const std::lock_guard lock(mutex);
        return stop.stop_requested() || next == count ? count : next++;
    };
    const std::stop_callback wake(stop.get_token(), [&] {
        const std::lock_guard lock(mutex);
        changed.notify_one();
    });
    std::vector<std::jthread> workers;
    try {
        for (unsigned j = 0; j < jobs; ++j) {
            workers.emplace_back([&] {
                for (std::size_t i = take_next(); i < count; i = take_next()) {
                    work(i, stop.get_token());
                    const std::lock_guard lock(mutex);
                    ready[i] = true;
                    ++finished;
                    changed.notify_one();
                }
            });
        }
        std::size_t specified = 0;
        std::unique_lock lock(mutex);
        for (std::size_t i = 0; i < count;) {
            const auto is_over = [&] { return stop.stop_requested() && i >= next; };
            changed.wait(lock, [&] { return ready[i] || finished != specified || is_over(); });
            const bool is_ready = ready[i], is_news = finished != specified;
            specified = finished;
            if (!is_ready && !is_news && is_over()) break;
            lock.unlock();
            if (is_news) noted(specified);
            if (is_ready) done(i++);
            lock.lock();
        }
    } catch (...) {
        stop.request_stop();
        throw;
    }
    return next;
}

}  // namespace ncsim::app
