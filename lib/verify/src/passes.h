// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions that an upright tool has passed. Programs clear a pocket level by level along the same
// path and drill in pecks, so the cutter above the flutes, and rapids, mostly follow a path of the
// flutes. A lookup here replaces a query of the part.
#pragma once

#include "ncsim/toolpath/walk.h"

#include <array>
#include <map>

namespace ncsim::verify {

class Passes {
public:
    /// Records a step in which the upper end of the cutter was above the stock.
    /// Cost: O(log n).
    void add(const toolpath::Step& step);
    /// True if a step along the same path, in either direction, was recorded that was nowhere more
    /// than `rise` mm above `step`.
    /// Cost: O(log n).
    bool cover(const toolpath::Step& step, double rise) const;

private:
    using Segment = std::array<double, 4>;  // from x, y to x, y; mm
    using Heights = std::array<double, 2>;  // at the ends, mm
    struct Pass {
        Segment way;
        Heights heights;
    };
    static Pass pass_of(const toolpath::Step& step);

    // About 100 MB; the map is then cleared.
    static constexpr std::size_t kMost = std::size_t{1} << 20;
    std::map<Segment, Heights> lowest_;
};

}  // namespace ncsim::verify
