// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a progress bar.
#include "system/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ncsim::app {

std::string progress_bar(std::uint64_t done, std::uint64_t total, double seconds) {
    constexpr int kWidth = 40;
    const double share =
        total == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
    const int filled = static_cast<int>(share * kWidth);
    std::string bar(static_cast<std::size_t>(filled), '=');
    if (filled < kWidth) bar += '>';
    std::string text = fmt::format("[{:<{}}] {:3d} %", bar, kWidth, static_cast<int>(share * 100));
    if (seconds >= 2.0 && share > 0.0) {
        const auto left = std::llround(seconds / share * (1 - share));
        text += fmt::format("  ETA {}:{:02d}", left / 60, left % 60);
    }
    return text;
}

Progress::Progress(std::uint64_t total, bool visible, std::string what)
    : total_(total),
      visible_(visible),
      what_(std::move(what)),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    hide();
}

void Progress::hide() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

void Progress::update(std::uint64_t done) {
    if (!visible_) return;
    if (Clock::now() - last_ < std::chrono::milliseconds(100)) return;
    draw(done);
}

void Progress::draw(std::uint64_t done) {
    if (!visible_) return;
    last_ = Clock::now();
    drawn_ = true;
    const double seconds = std::chrono::duration<double>(last_ - start_).count();
    std::string text = progress_bar(done, total_, seconds);
    if (!what_.empty()) text += fmt::format("  {} of {} {}", done, total_, what_);
    fmt::print(stderr, "\r{}\x1b[K", text);
    std::fflush(stderr);
}

}  // namespace ncsim::app
