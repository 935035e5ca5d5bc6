// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comparison of two programs: the parts, and the process.
#pragma once

#include "ncsim/verify/region.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::simulation {

/// Material that only one of the two parts has.
struct OneSidedMaterial {
    double volume_mm3 = 0.0;  ///< Exact except for the rounding of sums.
    std::vector<verify::Region> regions;
    std::vector<std::string> files;  ///< Files with the lines of the regions.
};

/// Feeds, speeds, coolant, tools and dwells that only one of the programs has, from the first to
/// the last condition that differs.
struct ProcessDifference {
    /// Consecutive feed moves under one condition, or a dwell.
    struct Run {
        std::string file;
        std::uint32_t line = 0;  ///< Line of the first block.
        std::string condition;   ///< The condition as text.
    };
    std::vector<Run> only_old, only_new;
    bool differs() const { return !only_old.empty() || !only_new.empty(); }
};

/// Result of the comparison.
struct Difference {
    std::string set_up;              ///< "set-up 2, back"; empty outside a job.
    std::string old_name, new_name;  ///< Names of the programs.
    double tolerance_mm3 = 0.0;      ///< Volume up to which differences do not count.
    bool differs = false;
    double old_mm3 = 0.0, new_mm3 = 0.0;  ///< Volumes of the parts.
    OneSidedMaterial only_old;            ///< Removed only by the new program.
    OneSidedMaterial only_new;            ///< Removed only by the old program.
    /// True if both programs make the same motions with the same tools, so no simulation was
    /// needed.
    bool same_motions = false;
    /// Description of stocks that differ; empty: both programs have the same stock.
    std::string stocks;
    ProcessDifference process;
};

}  // namespace ncsim::simulation
