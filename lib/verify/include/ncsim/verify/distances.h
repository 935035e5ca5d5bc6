// SPDX-License-Identifier: GPL-3.0-or-later
//
// Path lengths and times of the tools of a program, without a machine description.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/sampler.h"

#include <cstdint>
#include <map>
#include <optional>

namespace ncsim::verify {

/// Path lengths (mm) and times (s) of a tool.
struct Distances {
    double rapid_mm = 0.0;
    double feed_mm = 0.0;
    /// Time of the feed moves if every move keeps its feed from end to end. Empty if a feed is not
    /// specified, or a spindle speed on which the feed depends.
    std::optional<double> feed_seconds = 0.0;
    double dwell_seconds = 0.0;
    std::uint64_t tool_changes = 0;  ///< Number of changes to this tool.
};

/// Adds the path and the time of `motion`: a motion with a known start, a dwell or a tool change.
void add(Distances& distances, const gcode::Motion& motion,
         const toolpath::Kinematics* machine = nullptr);

/// Returns samples of the path of the tip with a chord tolerance of 0.01 mm, for length
/// measurement.
toolpath::Samples coarse_samples(const gcode::Motion& motion,
                                 const toolpath::Kinematics* machine = nullptr);
/// Add the two halves of add() separately, for callers that have the samples.
void add_path(Distances& distances, const gcode::Motion& motion, const toolpath::Samples& samples);
void add_rest(Distances& distances, const gcode::Motion& motion);

/// Returns the sum over all tools.
Distances total(const std::map<int, Distances>& distances);

}  // namespace ncsim::verify
