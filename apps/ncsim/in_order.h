// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many pieces of work on several threads, their results in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace ncsim::app {

/// Calls work(i, stop) for all i below `count` on `jobs` threads, and done(i) in the order of i on
/// the thread of the caller. `work` must not throw. If `done` throws, nothing more is begun, what
/// runs is asked to stop, and when it has, the exception goes on to the caller.
template <class Work, class Done>
void in_order(std::size_t count, unsigned jobs, const Work& work, const Done& done) {
    std::vector<bool> ready(count, false);
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t next = 0;
    std::stop_source stop;
    const auto take_next = [&] {
        const std::lock_guard lock(mutex);
        return stop.stop_requested() ? count : next++;
    };
    std::vector<std::jthread> workers;
    try {
        for (unsigned j = 0; j < jobs; ++j) {
            workers.emplace_back([&] {
                for (std::size_t i = take_next(); i < count; i = take_next()) {
                    work(i, stop.get_token());
                    const std::lock_guard lock(mutex);
                    ready[i] = true;
                    changed.notify_one();
                }
            });
        }
        for (std::size_t i = 0; i < count; ++i) {
            {
                std::unique_lock lock(mutex);
                changed.wait(lock, [&] { return ready[i]; });
            }
            done(i);
        }
    } catch (...) {
        stop.request_stop();
        throw;
    }
}

}  // namespace ncsim::app
