// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits of the time and memory spent on a program.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace ncsim::setup {

/// Time and memory that may be used, and a request to stop.
class Budget {
public:
    Budget() = default;
    /// Limits memory to `memory_gb` (10^9 bytes) and time to `seconds` from construction on; 0
    /// means no limit.
    Budget(double memory_gb, double seconds);

    /// Counts a stop request on `stop` as an exceeded limit.
    void stop_with(std::stop_token stop) { stop_ = std::move(stop); }

    /// Returns which limit is exceeded, in words; empty if none is. May be called for every motion:
    /// the system is queried only at every 128th call.
    std::optional<std::string> exceeded();
    /// Throws: std::runtime_error, "PROGRAM:LINE: reason: given up", if a limit is exceeded.
    void check(const std::string& program, std::uint32_t line);
    /// Throws: the same without the line. Queries the system at every call; several threads may
    /// call.
    void check(const std::string& program) const;

private:
    std::optional<std::string> query() const;

    double memory_gb_ = 0.0;
    double seconds_ = 0.0;
    std::chrono::steady_clock::time_point start_;
    std::stop_token stop_;
    std::uint32_t asked_ = 0;
};

}  // namespace ncsim::setup
