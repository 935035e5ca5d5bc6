// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries of time and memory.
#include "ncsim/setup/budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace ncsim::setup {

namespace {

// Returns the memory of this process, on Linux; 0 on further systems.
std::uint64_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    if (!(statm >> all >> resident)) return 0;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// Calls between two queries of the system.
constexpr std::uint32_t kCallsPerQuery = 128;

}  // namespace

Budget::Budget(double memory_gb, double seconds)
    : memory_gb_(memory_gb), seconds_(seconds), start_(std::chrono::steady_clock::now()) {}

std::optional<std::string> Budget::exceeded() {
    const bool is_due = asked_++ % kCallsPerQuery == 0;
    return is_due || stop_.stop_requested() ? query() : std::nullopt;
}

std::optional<std::string> Budget::query() const {
    if (stop_.stop_requested()) return "the caller has stopped the work";
    if (memory_gb_ > 0.0) {
        const double used = 1e-9 * static_cast<double>(resident_bytes());
        if (used > memory_gb_)
            return fmt::format("{:.2f} GB are in use, more than --max-memory {:g}", used,
                               memory_gb_);
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (seconds_ > 0.0 && passed.count() > seconds_)
        return fmt::format("it takes longer than --max-time {:g}", seconds_);
    return std::nullopt;
}

void Budget::check(const std::string& program, std::uint32_t line) {
    if (const auto why = exceeded())
        throw std::runtime_error(fmt::format("{}:{}: {}: given up", program, line, *why));
}

void Budget::check(const std::string& program) const {
    if (const auto why = query())
        throw std::runtime_error(fmt::format("{}: {}: given up", program, *why));
}

}  // namespace ncsim::setup
