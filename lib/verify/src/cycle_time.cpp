// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plans speeds with look-ahead.
#include "cycle_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::verify {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// Returns the speed that `length` at `acceleration` permits after (or before) `speed`.
double reachable(double speed, double acceleration, double length) {
    return acceleration > 0.0 ? std::sqrt(speed * speed + 2.0 * acceleration * length) : kNoLimit;
}

}  // namespace

double acceleration_along(const MachineDescription& machine, Vec3 direction) {
    double least = kNoLimit;
    for (int axis = 0; axis < 3; ++axis) {
        const double part = std::abs(direction[axis]);
        if (part == 0.0) continue;
        const auto& limit = machine.acceleration[static_cast<std::size_t>(axis)];
        if (!limit) return 0.0;
        least = std::min(least, *limit / part);
    }
    return least == kNoLimit ? 0.0 : least;
}

std::optional<double> rapid_speed_along(const MachineDescription& machine, Vec3 direction) {
    double least = kNoLimit;
    for (int axis = 0; axis < 3; ++axis) {
        const double part = std::abs(direction[axis]);
        if (part == 0.0) continue;
        const auto& rate = machine.rapid[static_cast<std::size_t>(axis)];
        if (!rate) return std::nullopt;
        least = std::min(least, *rate / 60.0 / part);
    }
    if (least == kNoLimit) return std::nullopt;
    return least;
}

double trapezoid_seconds(double length, double v0, double v1, double top, double acceleration) {
    if (length <= 0.0 || top <= 0.0) return 0.0;
    if (acceleration <= 0.0) return length / top;
    const double peak = std::sqrt((2.0 * acceleration * length + v0 * v0 + v1 * v1) / 2.0);
    if (peak <= top) return (2.0 * peak - v0 - v1) / acceleration;
    const double ramps = (2.0 * top * top - v0 * v0 - v1 * v1) / (2.0 * acceleration);
    return (2.0 * top - v0 - v1) / acceleration + (length - ramps) / top;
}

MotionPlanner::MotionPlanner(double junction_deviation_mm,
                             std::function<void(std::size_t, double)> done)
    : deviation_(junction_deviation_mm), done_(std::move(done)) {}

double MotionPlanner::junction_speed(const PlannedMove& a, const PlannedMove& b) const {
    if (a.stops || b.stops) return 0.0;
    const double top = std::min(a.speed, b.speed);
    // If only one move is limited, its limit counts.
    const double acceleration = a.acceleration > 0.0 && b.acceleration > 0.0
                                    ? std::min(a.acceleration, b.acceleration)
                                    : std::max(a.acceleration, b.acceleration);
    if (acceleration <= 0.0) return top;
    const double cosine = -dot(a.leaves, b.enters);
    const double s = std::sqrt(std::clamp((1.0 - cosine) / 2.0, 0.0, 1.0));
    if (s >= 1.0) return top;
    return std::min(top, std::sqrt(acceleration * deviation_ * s / (1.0 - s)));
}

void MotionPlanner::add(const PlannedMove& move) {
    moves_.push_back(move);
    if (moves_.size() >= 2 * kLookAhead) plan(kLookAhead);
}

void MotionPlanner::stop() {
    plan(moves_.size());
}

void MotionPlanner::plan(std::size_t commit) {
    const std::size_t n = moves_.size();
    if (n == 0) return;
    // 1. Speed at each junction, and rest after the last move.
    std::vector<double> speed(n + 1, 0.0);
    speed[0] = entry_speed_;
    for (std::size_t i = 1; i < n; ++i)
        speed[i] = junction_speed(moves_[i - 1], moves_[i]);
    // 2. Backwards: at most the speed from which the machine can decelerate.
    for (std::size_t i = n; i-- > 1;) {
        speed[i] = std::min(speed[i],
                            reachable(speed[i + 1], moves_[i].acceleration, moves_[i].length_mm));
    }
    // 3. Forwards: at most the speed that the machine can reach.
    for (std::size_t i = 0; i < n; ++i) {
        speed[i + 1] = std::min(speed[i + 1],
                                reachable(speed[i], moves_[i].acceleration, moves_[i].length_mm));
    }
    for (std::size_t i = 0; i < commit; ++i) {
        const PlannedMove& m = moves_[i];
        done_(m.key,
              trapezoid_seconds(m.length_mm, speed[i], speed[i + 1], m.speed, m.acceleration));
    }
    entry_speed_ = commit < n ? speed[commit] : 0.0;
    moves_.erase(moves_.begin(), moves_.begin() + static_cast<std::ptrdiff_t>(commit));
}

}  // namespace ncsim::verify
