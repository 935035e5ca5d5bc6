// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the tools of a program go, and for how long, where no machine is described.
#pragma once

#include "ncsim/gcode/motion.h"
#include "ncsim/toolpath/sampler.h"

#include <cstdint>
#include <map>
#include <optional>

namespace ncsim::verify {

struct Distances {
    double rapid_mm = 0.0;
    double feed_mm = 0.0;
    /// Of the moves at feed, as if every one kept its feed from end to end. Empty if a feed is
    /// not told, or no spindle speed where it counts.
    std::optional<double> feed_seconds = 0.0;
    double dwell_seconds = 0.0;
    std::uint64_t tool_changes = 0;  ///< To this tool.
};

/// Adds those of a motion with a known start, of a dwell or of a tool change.
void add(Distances& distances, const gcode::Motion& motion,
         const toolpath::Kinematics* machine = nullptr);

/// The path of the tip within a hundredth of a millimetre: what lengths are measured on.
toolpath::Samples coarse_samples(const gcode::Motion& motion,
                                 const toolpath::Kinematics* machine = nullptr);
/// The two halves of add(), for who has the samples.
void add_path(Distances& distances, const gcode::Motion& motion, const toolpath::Samples& samples);
void add_rest(Distances& distances, const gcode::Motion& motion);

/// Sum over all tools.
Distances total(const std::map<int, Distances>& distances);

}  // namespace ncsim::verify
