// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim diff`: do two programs make the same part? The gate for a change of a
// post-processor.
#pragma once

#include "ncsim/verify/region.h"

#include "program_options.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

/// `program` is the old one.
struct DiffOptions : ProgramOptions, SimulationOptions {
    std::string new_program;
    double tolerance_mm3 = 0.0;  ///< Differences up to this volume do not count.
    std::string json;            ///< A file to write; empty: not asked for.
    bool quiet = false;
};

/// What one of the parts has and the other has not.
struct OneSided {
    double volume_mm3 = 0.0;  ///< Exact but for the rounding of sums.
    std::vector<verify::Region> regions;
    std::vector<std::string> files;  ///< That the lines of the regions are in.
};

struct Difference {
    double old_mm3 = 0.0, new_mm3 = 0.0;  ///< Volumes of the parts.
    OneSided only_old;                    ///< Taken away by lines of the new program alone.
    OneSided only_new;                    ///< Taken away by lines of the old program alone.
    /// Both make the same motions with the same tools: nothing had to be simulated.
    bool same_motions = false;
    /// Words for blocks that differ; empty: both programs are cut from the same.
    std::string stocks;
};

CLI::App* add_diff(CLI::App& app, DiffOptions& options);
void complete(const DiffOptions& options);

/// 0: the same part; 1: not, or a program has faults. Throws std::runtime_error if the world fails.
int run(const DiffOptions& options);

}  // namespace ncsim::app
