// SPDX-License-Identifier: GPL-3.0-or-later
//
// Duration of a program, by a model of a control that looks ahead. The model:
//
// - Every move follows its path with a trapezoid of speed. The move accelerates and decelerates at
//   the acceleration along its direction, the smallest quotient of an axis limit and the
//   direction's component. The speed never exceeds the feed, or for rapids the rate at which the
//   first axis reaches its limit.
// - Rapid moves, dwells and tool changes begin and end at rest.
// - Between two feed moves the control passes the corner at the speed at which an arc that passes
//   the corner at `junction_deviation` would need the full acceleration: v² = a d s/(1 - s), where
//   s is the sine of half the angle between the two moves. A straight continuation does not slow
//   down. Source: Jeon, "Improving Grbl: Cornering Algorithm", 2011.
// - On an arc of radius r the speed is at most √(a r).
// - The control looks kLookAhead moves ahead and can always stop at the last of them.
//
// Without accelerations the duration of a move is its length divided by its speed. Jerk, servo lag,
// in-position waits, spindle ramps and processing time of the control are not modelled. Rapid moves
// of rotary axes alone take no time.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/verify/machine_description.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// Move as the control plans it.
struct PlannedMove {
    double length_mm = 0.0;
    double speed = 0.0;         ///< mm/s: the feed, or the rapid rate along the path.
    double acceleration = 0.0;  ///< mm/s² along the path; 0: unlimited.
    Vec3 enters, leaves;        ///< Unit vectors at the two ends of the path.
    bool stops = false;         ///< Begins and ends at rest.
    std::size_t key = 0;        ///< Key of the caller.
};

/// Returns the acceleration (mm/s²) along `direction` (a unit vector); 0 if the limit of a moving
/// axis is unspecified.
double acceleration_along(const MachineDescription& machine, Vec3 direction);
/// Returns the rapid rate (mm/s) along `direction`; empty if the rate of a moving axis is
/// unspecified.
std::optional<double> rapid_speed_along(const MachineDescription& machine, Vec3 direction);

class MotionPlanner {
public:
    static constexpr std::size_t kLookAhead = 256;

    /// Creates a planner that calls `done(key, seconds)` once for each move, in order. Memory is
    /// bounded by the look-ahead.
    MotionPlanner(double junction_deviation_mm,
                  std::function<void(std::size_t key, double seconds)> done);

    void add(const PlannedMove& move);
    /// Plans a stop: a dwell, a tool change, the end.
    void stop();

private:
    double junction_speed(const PlannedMove& a, const PlannedMove& b) const;
    void plan(std::size_t commit);

    double deviation_;
    std::function<void(std::size_t, double)> done_;
    std::vector<PlannedMove> moves_;
    double entry_speed_ = 0.0;  // of moves_[0]; fixed
};

/// Returns the seconds for `length` mm from speed v0 to v1 (mm/s) at most at `top`, with
/// `acceleration` (0: unlimited).
double trapezoid_seconds(double length, double v0, double v1, double top, double acceleration);

}  // namespace ncsim::verify
