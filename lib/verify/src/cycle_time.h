// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a program takes: a model of a control that looks ahead, stated here in full.
//
// - Every move follows its path with a trapezoid of speed: it speeds up and slows down at the
//   acceleration along its direction, the smallest of the axes' limits divided by the direction's
//   component, and never exceeds its feed, or for rapid moves the rate at which the first axis
//   reaches its limit.
// - Rapid moves, dwells and tool changes begin and end at rest.
// - Between two feed moves the control goes through the corner at the speed at which an arc that
//   passes the corner at `junction_deviation` would need the full acceleration (Jeon, "Improving
//   Grbl: Cornering Algorithm", 2011): v² = a d s/(1 - s), where s is the sine of half the angle
//   between the two moves. A straight continuation does not slow down.
// - On an arc of radius r speed stays below √(a r).
// - It looks kLookAhead moves ahead and is always able to stop at the last of them.
//
// Without accelerations a move takes its length divided by its speed. Jerk, servo lag, in-position
// waits, spindle ramps and the control's own processing time are not modelled; rapid moves of
// rotary axes alone take no time.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/verify/machine.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// One move as the control plans it.
struct PlannedMove {
    double length_mm = 0.0;
    double speed = 0.0;         ///< mm/s: the feed, or the rapid rate along the path.
    double acceleration = 0.0;  ///< mm/s² along the path; 0: unlimited.
    cda::Vec3 enters, leaves;   ///< Unit vectors of the path's two ends.
    bool stops = false;         ///< Begins and ends at rest.
    std::size_t key = 0;        ///< The caller's.
};

/// mm/s² along `direction` (a unit vector); 0 where an axis that moves tells none.
double acceleration_along(const MachineDescription& machine, cda::Vec3 direction);
/// mm/s along `direction`; empty where an axis that moves tells no rapid rate.
std::optional<double> rapid_speed_along(const MachineDescription& machine, cda::Vec3 direction);

class MotionPlanner {
public:
    static constexpr std::size_t kLookAhead = 256;

    /// `done(key, seconds)` is called once for each move, in order. Memory is that of the
    /// look-ahead.
    MotionPlanner(double junction_deviation_mm,
                  std::function<void(std::size_t key, double seconds)> done);

    void add(const PlannedMove& move);
    /// The machine comes to rest here: a dwell, a tool change, the end.
    void stop();

private:
    double junction_speed(const PlannedMove& a, const PlannedMove& b) const;
    void plan(std::size_t commit);

    double deviation_;
    std::function<void(std::size_t, double)> done_;
    std::vector<PlannedMove> moves_;
    double entry_speed_ = 0.0;  // of moves_[0], which is decided
};

/// Seconds for `length` mm from speed v0 to v1 (mm/s) below `top`, at `acceleration` (0: at once).
double trapezoid_seconds(double length, double v0, double v1, double top, double acceleration);

}  // namespace ncsim::verify
