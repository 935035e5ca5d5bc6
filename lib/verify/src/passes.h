// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where an upright tool has passed. Programs clear a pocket level by level along the same way, and
// drill in pecks, so what is above their flutes, and what moves at rapid, mostly goes where the
// flutes were before: that is looked up here, and the part need not be asked.
#pragma once

#include "ncsim/toolpath/walk.h"

#include <array>
#include <map>

namespace ncsim::verify {

class Passes {
public:
    /// The step was made with all of a tool that stands out of the stock. O(log n).
    void add(const toolpath::Step& step);
    /// Has a step along the same way, there or back, been made that was nowhere more than `rise` mm
    /// above this one? O(log n).
    bool cover(const toolpath::Step& step, double rise) const;

private:
    using Way = std::array<double, 4>;      // from x, y to x, y; mm
    using Heights = std::array<double, 2>;  // at its ends, mm
    struct Pass {
        Way way;
        Heights heights;
    };
    static Pass pass_of(const toolpath::Step& step);

    // About 100 MB; then it begins anew.
    static constexpr std::size_t kMost = std::size_t{1} << 20;
    std::map<Way, Heights> lowest_;
};

}  // namespace ncsim::verify
