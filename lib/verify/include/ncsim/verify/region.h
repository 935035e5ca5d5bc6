// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where material went, gathered from the ledger: rows whose places touch are one region.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/verify/ledger.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::verify {

/// File (index into Verdict::files), first and last line of a stretch of blocks.
struct LineRange {
    std::uint32_t file = 0;
    std::uint32_t first = 0, last = 0;
    bool operator==(const LineRange&) const = default;
};

/// Sorted; ranges that overlap or follow one another are one.
std::vector<LineRange> merged(std::vector<LineRange> lines);

struct Region {
    double volume_mm3 = 0.0;
    cda::Box box;                  ///< In W, mm; encloses it.
    std::vector<LineRange> lines;  ///< Sorted; lines that follow one another are one range.
};

/// The regions of all rows that removed something, the largest volume first. Rows belong together
/// if their boxes overlap or touch, directly or through others. O(rows²) at worst.
std::vector<Region> regions_of(const Ledger& ledger);

}  // namespace ncsim::verify
