// SPDX-License-Identifier: GPL-3.0-or-later
//
// Union of cuts before rays are cut. Consecutive moves overlap, so that of hundreds of moves a ray
// is cut once or twice, and few normals are computed.
#pragma once

#include "rays.h"
#include "round_sweep.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::dexel {

/// A pending interval per ray of some rows, to be removed: in integer units, with the body of each
/// end (the first among equals) and the body's data about the end.
class PendingCuts {
public:
    PendingCuts(std::size_t rows, std::size_t in_row, Lanes lanes);

    /// The pending cut of a ray.
    struct Cut {
        std::int32_t low, high;
        std::uint32_t low_body, high_body;
        double s_low, s_high;
    };

    /// Adds the intervals of a body on `count` rays of a row from `begin` on. If an interval is
    /// disjoint from the pending interval of the ray, calls do_cut(ray, Cut) for the pending
    /// interval first.
    template <class DoCut>
    void add(std::size_t row, std::size_t begin, std::size_t count, RowMeeting& met,
             std::uint32_t body, const DoCut& do_cut);
    /// True if the pending interval of the ray covers [low, high].
    bool covers(std::size_t row, std::size_t ray, double low, double high) const {
        const std::size_t at = row * stride_ + ray;
        return arrays_[0][at] <= low && arrays_[1][at] >= high;
    }
    /// Calls do_cut(ray, Cut) for all pending intervals of a row.
    template <class DoCut>
    void flush(std::size_t row, const DoCut& do_cut);

private:
    struct Range {
        std::size_t begin, end;
    };
    PendingRow of(std::size_t row, std::size_t begin);
    // Returns the pending cut of a ray and clears the cut.
    static Cut take(const PendingRow& pending, std::size_t i);

    std::size_t stride_;
    Lanes lanes_;
    std::array<std::vector<double>, 6> arrays_;  // the arrays of PendingRow
    std::vector<Range> used_;                    // range in use per row
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
