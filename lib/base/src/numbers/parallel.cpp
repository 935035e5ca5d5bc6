// SPDX-License-Identifier: GPL-3.0-or-later
//
// Threads that take tasks from a shared counter.
#include "ncsim/base/parallel.h"

#include <atomic>
#include <exception>
#include <thread>

namespace ncsim {

struct Background::Shared {
    std::size_t tasks;
    std::function<void(std::size_t)> work;
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    std::vector<std::jthread> others;

    void run_tasks() {
        try {
            for (std::size_t i = next++; i < tasks; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard lock(failure_mutex);
            failure = std::current_exception();
            next = tasks;
        }
    }
};

std::size_t thread_count(std::size_t threads) {
    // The system reads a file for this number.
    static const std::size_t of_hardware = std::max(1U, std::thread::hardware_concurrency());
    return threads > 0 ? threads : of_hardware;
}

Background::Background(std::size_t others, std::size_t tasks, std::function<void(std::size_t)> work)
    : shared_(new Shared{tasks, std::move(work), {}, {}, {}, {}}) {
    for (std::size_t i = 0; i < std::min(others, tasks); ++i)
        shared_->others.emplace_back([shared = shared_.get()] { shared->run_tasks(); });
}

Background::~Background() {
    shared_->next = shared_->tasks;
    shared_->others.clear();  // joins the threads
}

void Background::finish() {
    shared_->run_tasks();
    shared_->others.clear();
    if (shared_->failure) std::rethrow_exception(shared_->failure);
}

void in_parallel(std::size_t threads, std::size_t tasks,
                 const std::function<void(std::size_t)>& work) {
    if (tasks == 0) return;
    const std::size_t all = std::min(thread_count(threads), tasks);
    Background(all - 1, tasks, [&work](std::size_t i) { work(i); }).finish();
}

}  // namespace ncsim
