// SPDX-License-Identifier: GPL-3.0-or-later
//
// Do two programs make the same part, and in the same way?
#pragma once

#include "ncsim/verify/region.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace ncsim::report {

/// What one of the parts has and the other has not.
struct OneSided {
    double volume_mm3 = 0.0;  ///< Exact but for the rounding of sums.
    std::vector<verify::Region> regions;
    std::vector<std::string> files;  ///< That the lines of the regions are in.
};

/// Feeds, speeds, coolant, tools and dwells that only one of the programs has: what lies between
/// the first and the last condition that differ.
struct ProcessDifference {
    /// Feed moves in a row under one condition, or a dwell.
    struct Run {
        std::string file;
        std::uint32_t line = 0;  ///< Of the first block.
        std::string condition;   ///< In words.
    };
    std::vector<Run> only_old, only_new;
    bool differs() const { return !only_old.empty() || !only_new.empty(); }
};

struct Difference {
    std::string old_name, new_name;  ///< Of the programs.
    double tolerance_mm3 = 0.0;      ///< Differences up to this volume do not count.
    bool differs = false;
    double old_mm3 = 0.0, new_mm3 = 0.0;  ///< Volumes of the parts.
    OneSided only_old;                    ///< Taken away by lines of the new program alone.
    OneSided only_new;                    ///< Taken away by lines of the old program alone.
    /// Both make the same motions with the same tools: nothing had to be simulated.
    bool same_motions = false;
    /// Words for blocks that differ; empty: both programs are cut from the same.
    std::string stocks;
    ProcessDifference process;
};

/// Text for people.
std::string text_of(const Difference& difference);
/// JSON. Lengths in mm, volumes in mm³.
void write_difference(std::ostream& out, const Difference& difference);

}  // namespace ncsim::report
