// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of removed material, gathered from the ledger: rows whose boxes touch form one region.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/verify/ledger.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::verify {

/// File (index into Verdict::files), first and last line of a stretch of blocks.
struct LineRange {
    std::uint32_t file = 0;
    std::uint32_t first = 0, last = 0;
    bool operator==(const LineRange&) const = default;
};

/// Returns `lines` sorted, with overlapping and consecutive ranges merged.
std::vector<LineRange> merged(std::vector<LineRange> lines);

/// Returns "3-7, 12"; long lists are shortened.
std::string lines_text(const std::vector<LineRange>& lines);

/// Connected region of removed material.
struct Region {
    double volume_mm3 = 0.0;
    Box box;                       ///< Box that encloses the region; mm, W.
    std::vector<LineRange> lines;  ///< Sorted; consecutive lines form one range.
};

/// Returns the regions of all rows that removed material, the largest volume first. Rows belong
/// together if their boxes overlap or touch, directly or through boxes between them.
/// Cost: O(rows²) in the worst case.
std::vector<Region> regions_of(const Ledger& ledger);

}  // namespace ncsim::verify
