// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joint positions of a machine over the time of a program, for files with moving links.
#pragma once

#include "ncsim/machine/chain.h"
#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <vector>

namespace ncsim::simulation {

/// Joint positions at a time, in machine coordinates of the spindle nose, mm and degrees.
struct JointKey {
    double seconds = 0.0;
    machine::Values values{};
};

/// Time from the call of a tool, or from a change of its length, to the next call or change.
struct ToolTime {
    int number = 0;
    double length_mm = 0.0;  ///< Length from the spindle nose to the tip, as set by G43.
    double from_seconds = 0.0, to_seconds = 0.0;
    bool operator==(const ToolTime&) const = default;
};

/// A line of the program that moves, and the start of its motion.
struct LineTime {
    std::uint32_t line = 0;
    std::uint32_t file = 0;  ///< Index into Interpretation::files; 0 is the program.
    double seconds = 0.0;
};

/// Motion of the joints during a program.
struct JointCourse {
    /// Sorted by time; joints move linearly from key to key. Empty if no motion is known.
    std::vector<JointKey> keys;
    std::vector<ToolTime> tools;
    std::vector<LineTime> lines;
    double seconds = 0.0;  ///< Total time.
    /// Largest deviation of a linear joint from its true position between two keys. Unknown for
    /// machines with a rotary axis between linear axes, under tip control; there, each straight
    /// move or arc has 64 keys.
    double missed_mm = 0.0;
    /// Number of motions that the joints cannot follow, which are left out.
    std::uint64_t left_out = 0;
    /// Number of motions without a known feed, which move at rapid speed.
    std::uint64_t without_feed = 0;
};

/// Limit of JointCourse::missed_mm, mm; exceeded only by motions of more than some thousand keys.
inline constexpr double kCourseTolerance = 0.01;

/// Returns the motion of the joints. Feed moves have a constant feed, rapid moves the speed
/// verify::kAssumedRapid, and joints rotate at most at 180 degrees/s; tool changes and dwells take
/// the times of verify::time_of(). A machine with limited acceleration is slower. Motions after
/// plan.at_line are left out.
/// Requires: the program is ready, and the machine is specified (plan.placed).
JointCourse joint_course(const Plan& plan);

}  // namespace ncsim::simulation
