// SPDX-License-Identifier: GPL-3.0-or-later
//
// Storage of pending cuts.
#include "pending_cuts.h"

#include "whole_units.h"

#include <algorithm>
#include <cstdint>

namespace ncsim::dexel {

namespace {

constexpr double kNowhere = 1e30;

}  // namespace

PendingCuts::PendingCuts(std::size_t rows, std::size_t in_row, Lanes lanes)
    : stride_(in_row + kWidest), lanes_(lanes), used_(rows, Range{in_row, 0}) {
    for (std::vector<double>& each : arrays_)
        each.resize(rows * stride_);
    std::ranges::fill(arrays_[0], kNowhere);
    std::ranges::fill(arrays_[1], -kNowhere);
}

PendingRow PendingCuts::of(std::size_t row, std::size_t begin) {
    const std::size_t at = row * stride_ + begin;
    return {&arrays_[0][at], &arrays_[1][at], &arrays_[2][at],
            &arrays_[3][at], &arrays_[4][at], &arrays_[5][at]};
}

PendingCuts::Cut PendingCuts::take(const PendingRow& pending, std::size_t i) {
    const Cut cut{whole_units(pending.low[i]),
                  whole_units(pending.high[i]),
                  static_cast<std::uint32_t>(pending.low_body[i]),
                  static_cast<std::uint32_t>(pending.high_body[i]),
                  pending.s_low[i],
                  pending.s_high[i]};
    pending.low[i] = kNowhere;
    pending.high[i] = -kNowhere;
    return cut;
}

}  // namespace ncsim::dexel
