// SPDX-License-Identifier: GPL-3.0-or-later
//
// Processor time by getrusage() and separate processes by fork().
#include "measure.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace ncsim::bench {

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void apart(const std::string& title, unsigned seconds, const std::function<void()>& measure) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        ::alarm(seconds);
        try {
            measure();
        } catch (const std::exception& e) {
            fmt::print("| {} | {} |\n", title, e.what());
        }
        std::fflush(stdout);
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        fmt::print("| {} | ended by signal {} (14: after {} s) |\n", title, WTERMSIG(status),
                   seconds);
    std::fflush(stdout);
}

}  // namespace ncsim::bench
