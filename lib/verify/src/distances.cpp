// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures paths and times of tools.
#include "ncsim/verify/distances.h"

#include "ncsim/base/vec3.h"
#include "ncsim/toolpath/trace.h"

#include <variant>

namespace ncsim::verify {

namespace {

std::optional<double> sum(std::optional<double> a, std::optional<double> b) {
    return a && b ? std::optional(*a + *b) : std::nullopt;
}

// Returns the time of a move at constant feed; `length` in mm. Rotary moves without a path use
// degrees.
std::optional<double> seconds_of(const gcode::Motion& motion, double length) {
    if (!(motion.feed > 0.0)) return std::nullopt;
    if (motion.feed_mode == gcode::FeedMode::InverseTime) return 60.0 / motion.feed;
    if (length == 0.0) {
        const gcode::Position* from = start_of(motion);
        const gcode::Position* to = end_of(motion);
        length = norm(Vec3{to->a.degrees(), to->b.degrees(), to->c.degrees()} -
                      Vec3{from->a.degrees(), from->b.degrees(), from->c.degrees()});
    }
    if (motion.feed_mode == gcode::FeedMode::PerMinute) return 60.0 * length / motion.feed;
    if (!(motion.spindle_rpm > 0.0)) return std::nullopt;
    return 60.0 * length / (motion.feed * motion.spindle_rpm);
}

}  // namespace

toolpath::Samples coarse_samples(const gcode::Motion& motion, const toolpath::Kinematics* machine) {
    toolpath::SamplingOptions coarse;
    coarse.chord_tolerance_mm = 0.01;
    coarse.rotation_miss_mm = 0.5;
    return toolpath::sample(motion, {}, coarse, {}, machine);
}

void add_path(Distances& distances, const gcode::Motion& motion, const toolpath::Samples& samples) {
    double length = 0.0;
    for (std::size_t i = 1; i < samples.poses.size(); ++i)
        length += norm(samples.poses[i].translation - samples.poses[i - 1].translation);
    if (motion.kind == gcode::MoveKind::Rapid) {
        distances.rapid_mm += length;
        return;
    }
    distances.feed_mm += length;
    distances.feed_seconds = sum(distances.feed_seconds, seconds_of(motion, length));
}

void add_rest(Distances& distances, const gcode::Motion& motion) {
    if (const auto* dwell = std::get_if<gcode::Dwell>(&motion.action))
        distances.dwell_seconds += dwell->seconds;
    if (std::holds_alternative<gcode::ToolChange>(motion.action)) ++distances.tool_changes;
}

void add(Distances& distances, const gcode::Motion& motion, const toolpath::Kinematics* machine) {
    add_rest(distances, motion);
    if (start_of(motion) && toolpath::has_known_start(motion))
        add_path(distances, motion, coarse_samples(motion, machine));
}

Distances total(const std::map<int, Distances>& distances) {
    Distances all;
    for (const auto& [number, d] : distances) {
        all.rapid_mm += d.rapid_mm;
        all.feed_mm += d.feed_mm;
        all.feed_seconds = sum(all.feed_seconds, d.feed_seconds);
        all.dwell_seconds += d.dwell_seconds;
        all.tool_changes += d.tool_changes;
    }
    return all;
}

}  // namespace ncsim::verify
