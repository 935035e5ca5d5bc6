// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/parallel.h"

#include <atomic>
#include <exception>
#include <thread>

namespace ncsim::cda {

void in_parallel(std::size_t threads, std::size_t tasks,
                 const std::function<void(std::size_t)>& work) {
    if (tasks == 0) return;
    const std::size_t wanted = threads > 0 ? threads : std::thread::hardware_concurrency();
    const std::size_t count = std::clamp<std::size_t>(wanted, 1, tasks);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto worker = [&] {
        try {
            for (std::size_t i = next++; i < tasks; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard lock(failure_mutex);
            failure = std::current_exception();
            next = tasks;
        }
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < count; ++i)
        others.emplace_back(worker);
    worker();
    others.clear();  // joins
    if (failure) std::rethrow_exception(failure);
}

}  // namespace ncsim::cda
