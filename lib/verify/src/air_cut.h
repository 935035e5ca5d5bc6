// SPDX-License-Identifier: GPL-3.0-or-later
//
// Feed moves without removal of material: a single finding for the program, with the share of the
// feed path and the lines.
#pragma once

#include "finding_log.h"
#include "rule_table.h"

#include <cstdint>
#include <vector>

namespace ncsim::verify {

class AirCuts {
public:
    void take(const Move& move);
    void conclude(const Setup& setup, FindingLog& log) const;

    double feed_mm() const { return feed_mm_; }
    double air_mm() const { return air_mm_; }

private:
    struct Lines {
        std::uint32_t first = 0, last = 0;
    };
    double feed_mm_ = 0.0, air_mm_ = 0.0;
    std::uint64_t blocks_ = 0, air_blocks_ = 0;
    bool was_air_ = false;
    std::vector<Lines> ranges_;  // in the program itself, the first few
    std::uint64_t ranges_more_ = 0;
    Finding first_;
};

}  // namespace ncsim::verify
