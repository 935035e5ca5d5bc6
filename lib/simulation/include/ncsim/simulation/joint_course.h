// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the joints of a machine stand at any time of a program: what moves its links in files that
// can move.
#pragma once

#include "ncsim/machine/chain.h"
#include "ncsim/simulation/plan.h"

#include <cstdint>
#include <vector>

namespace ncsim::simulation {

/// Joints at one time, machine coordinates: those of the spindle nose, mm and degrees.
struct JointKey {
    double seconds = 0.0;
    machine::Values values{};
};

/// A tool from when it is called, or another length of it counts, to the next one.
struct ToolTime {
    int number = 0;
    double length_mm = 0.0;  ///< From the spindle nose to its tip, as G43 has it.
    double from_seconds = 0.0, to_seconds = 0.0;
    bool operator==(const ToolTime&) const = default;
};

/// A line of the program that moves, and when it begins.
struct LineTime {
    std::uint32_t line = 0;
    std::uint32_t file = 0;  ///< Index into Interpretation::files; 0 is the program itself.
    double seconds = 0.0;
};

struct JointCourse {
    /// In the order of their times; joints go evenly from each to the next. None: nothing moves, or
    /// nobody knows from where.
    std::vector<JointKey> keys;
    std::vector<ToolTime> tools;
    std::vector<LineTime> lines;
    double seconds = 0.0;  ///< How long it takes in all.
    /// Between two keys no linear joint is farther than this from where it goes in truth. Not
    /// known of machines whose linear axes have a rotary one between them, under tip control: there
    /// each motion has 64 keys.
    double missed_mm = 0.0;
    /// Motions that the joints cannot follow, which are left out.
    std::uint64_t left_out = 0;
    /// Motions of which no feed is told, which go as fast as rapid ones.
    std::uint64_t without_feed = 0;
};

/// Most that JointCourse::missed_mm is, mm, but for motions of more than some thousand keys.
inline constexpr double kCourseTolerance = 0.01;

/// Moves at feed keep it from end to end, rapid ones go at report::kAssumedRapid, and joints turn
/// no faster than 180 degrees in a second; tool changes and dwells take what report::time_of()
/// says. A machine that accelerates is slower. Only what the program does up to plan.at_line.
/// Requires a program that is ready, and a machine that is told (plan.placed).
JointCourse joint_course(const Plan& plan);

}  // namespace ncsim::simulation
