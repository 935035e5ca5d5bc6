// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress bar on a terminal, with an estimate for long work.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace ncsim::app {

class Progress {
public:
    /// Creates a bar; silent unless `visible`: the caller knows whether stderr is a terminal.
    /// `what`: unit shown with the count, for example "programs"; empty: no count.
    Progress(std::uint64_t total, bool visible, std::string what = {});
    /// Removes the bar.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Draws at most ten times a second.
    void update(std::uint64_t done);
    /// Draws immediately.
    void draw(std::uint64_t done);
    /// Clears the line for different output.
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

/// Formats "[=====>    ]  52 %  ETA 0:41" after `seconds`; without the estimate before 2 seconds.
/// Separate from Progress for tests.
std::string progress_bar(std::uint64_t done, std::uint64_t total, double seconds);

}  // namespace ncsim::app
