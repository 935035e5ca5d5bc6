// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far it got, on a terminal: a bar, and an estimate once the work is long.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace ncsim::app {

class Progress {
public:
    /// Silent unless `visible`: the caller knows whether stderr is a terminal. `what`: "programs",
    /// counted beside the bar; empty: moves, which nobody wants to count.
    Progress(std::uint64_t total, bool visible, std::string what = {});
    /// Removes the bar.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Draws at most ten times a second.
    void update(std::uint64_t done);
    /// Draws now.
    void draw(std::uint64_t done);
    /// Makes room for something else on the line.
    void hide();

private:
    using Clock = std::chrono::steady_clock;
    std::uint64_t total_;
    bool visible_;
    std::string what_;
    bool drawn_ = false;
    Clock::time_point start_;
    Clock::time_point last_;
};

/// "[=====>    ]  52 %  ETA 0:41"; without the estimate where `seconds` is below 2. `seconds` have
/// passed. Apart from Progress so that it can be tested.
std::string progress_bar(std::uint64_t done, std::uint64_t total, double seconds);

}  // namespace ncsim::app
