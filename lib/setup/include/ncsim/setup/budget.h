// SPDX-License-Identifier: GPL-3.0-or-later
//
// What working on a program may cost: time and memory.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace ncsim::setup {

class Budget {
public:
    Budget() = default;
    /// 10^9 bytes and seconds from now on; 0: as much as there is.
    Budget(double memory_gb, double seconds);

    /// Gives up when it is asked to.
    void stop_with(std::stop_token stop) { stop_ = std::move(stop); }

    /// Which of them is used up, in words; nothing: neither. Looks at the system only once in a
    /// while, which it counts, so it may be asked for every motion.
    std::optional<std::string> exceeded();
    /// Throws std::runtime_error, "PROGRAM:LINE: why: given up", if one is.
    void check(const std::string& program, std::uint32_t line);

private:
    double memory_gb_ = 0.0;
    double seconds_ = 0.0;
    std::chrono::steady_clock::time_point start_;
    std::stop_token stop_;
    std::uint32_t asked_ = 0;
};

}  // namespace ncsim::setup
