// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bodies take of rays, put together before the rays are cut: neighbouring moves overlap, so
// that of hundreds a ray is cut once or twice, and asked for two normals.
#pragma once

#include "rays.h"
#include "round_sweep.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::dexel {

/// Of the rays of some rows an interval each, from which all is to be taken away: whole units, the
/// body that each of its ends is from (the first of several), and what that body knows of the end.
class PendingCuts {
public:
    PendingCuts(std::size_t rows, std::size_t in_row, Lanes lanes);

    /// Of one ray.
    struct Cut {
        std::int32_t low, high;
        std::uint32_t low_body, high_body;
        double s_low, s_high;
    };

    /// Adds what a body meets of `count` rays of a row from `begin` on. Where that is apart from
    /// what is pending of a ray, do_cut(ray, Cut) is called of the latter first.
    template <class DoCut>
    void add(std::size_t row, std::size_t begin, std::size_t count, RowMeeting& met,
             std::uint32_t body, const DoCut& do_cut);
    /// Is everything between these places pending of the ray?
    bool covers(std::size_t row, std::size_t ray, double low, double high) const {
        const std::size_t at = row * stride_ + ray;
        return arrays_[0][at] <= low && arrays_[1][at] >= high;
    }
    /// Calls do_cut(ray, Cut) of all that is pending in a row.
    template <class DoCut>
    void flush(std::size_t row, const DoCut& do_cut);

private:
    struct Range {
        std::size_t begin, end;
    };
    PendingRow of(std::size_t row, std::size_t begin);
    // Of one ray, and forgets it.
    static Cut take(const PendingRow& pending, std::size_t i);

    std::size_t stride_;
    Lanes lanes_;
    std::array<std::vector<double>, 6> arrays_;  // as in PendingRow
    std::vector<Range> used_;                    // of each row
};

template <class DoCut>
void PendingCuts::add(std::size_t row, std::size_t begin, std::size_t count, RowMeeting& met,
                      std::uint32_t body, const DoCut& do_cut) {
    const PendingRow pending = of(row, begin);
    auto take_one = [&](std::size_t i) { do_cut(begin + i, take(pending, i)); };
    using TakeOne = decltype(take_one);
    join_row(
        pending, count, met, static_cast<double>(body), lanes_,
        [](void* context, std::size_t i) { (*static_cast<TakeOne*>(context))(i); }, &take_one);
    Range& used = used_[row];
    used = {std::min(used.begin, begin), std::max(used.end, begin + count)};
}

template <class DoCut>
void PendingCuts::flush(std::size_t row, const DoCut& do_cut) {
    Range& used = used_[row];
    const PendingRow pending = of(row, 0);
    for (std::size_t i = used.begin; i < used.end; ++i) {
        if (pending.low[i] < pending.high[i]) do_cut(i, take(pending, i));
    }
    used = {stride_, 0};
}

}  // namespace ncsim::dexel
