// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joint positions over time, with keys where the motion deviates from a line.
#include "ncsim/simulation/joint_course.h"

#include "ncsim/toolpath/joint_path.h"
#include "ncsim/verify/distances.h"
#include "ncsim/verify/machining_time.h"

#include "motions.h"
#include "until_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ncsim::simulation {

namespace {

using machine::Values;

constexpr double kDegreesPerSecond = 180.0;
constexpr double kRapidPerSecond = verify::kAssumedRapid / 60.0;

// Largest number of halvings of a leg, which limits its keys.
constexpr int kMostHalvings = 12;

// Writes the keys of a program's motions.
class CourseWriter {
public:
    explicit CourseWriter(const toolpath::Kinematics& machine) : machine_(machine) {}

    void take(const gcode::Motion& motion) {
        const bool is_known = gcode::start_of(motion) && toolpath::has_known_end(motion);
        const double seconds = seconds_of(motion);
        if (!is_known) {
            course_.seconds += seconds;
            return;
        }
        take_tool(motion);
        const LineTime last = course_.lines.empty() ? LineTime{} : course_.lines.back();
        if (last.line != motion.span.line || last.file != motion.file)
            course_.lines.push_back({motion.span.line, motion.file, course_.seconds});
        gcode::Motion from_known = motion;
        if (!toolpath::has_known_start(motion)) {
            const gcode::Position end = *gcode::end_of(motion);
            from_known.action = gcode::Linear{end, end};
        }
        const toolpath::Legs legs = toolpath::legs_of(from_known, {});
        std::vector<double> lengths;
        double all = 0.0;
        for (const gcode::Motion& leg : legs.motions) {
            lengths.push_back(length_of(leg));
            all += lengths.back();
        }
        course_.missed_mm = std::max(course_.missed_mm, legs.missed_mm);
        for (std::size_t i = 0; i < legs.motions.size(); ++i) {
            const double share =
                all > 0.0 ? lengths[i] / all : 1.0 / static_cast<double>(legs.motions.size());
            take_leg(legs.motions[i], share * seconds);
        }
    }

    JointCourse finish() {
        if (!course_.tools.empty()) course_.tools.back().to_seconds = course_.seconds;
        // Adds the time at the end without motion.
        if (!course_.keys.empty() && course_.keys.back().seconds < course_.seconds)
            course_.keys.push_back({course_.seconds, course_.keys.back().values});
        return std::move(course_);
    }

private:
    double length_of(const gcode::Motion& leg) const {
        const auto* line = std::get_if<gcode::Linear>(&leg.action);
        if (!line) return 1.0;
        const toolpath::Poses poses(&machine_, leg);
        return norm(poses.place(line->to) - poses.place(line->from));
    }

    // Returns the time of a motion, as in the report.
    double seconds_of(const gcode::Motion& motion) {
        verify::Distances distances;
        verify::add(distances, motion, &machine_);
        if (distances.feed_seconds) return *verify::time_of(distances).total();
        ++course_.without_feed;
        return distances.feed_mm / kRapidPerSecond;
    }

    void take_tool(const gcode::Motion& motion) {
        const ToolTime now{motion.tool, motion.length.mm(), course_.seconds, course_.seconds};
        if (!course_.tools.empty()) {
            ToolTime& last = course_.tools.back();
            if (last.number == now.number && last.length_mm == now.length_mm) return;
            last.to_seconds = course_.seconds;
        }
        course_.tools.push_back(now);
    }

    // Returns the least time of the rotary joints at their largest speed.
    static double least_seconds(const Values& from, const Values& to) {
        double degrees = 0.0;
        for (std::size_t i = 3; i < 6; ++i)
            degrees = std::max(degrees, std::abs(to[i] - from[i]));
        return degrees / kDegreesPerSecond;
    }

    void add_key(double seconds, const Values& values) {
        auto& keys = course_.keys;
        // Joints at rest have only a first and a last key.
        if (keys.size() >= 2 && keys.back().values == values &&
            keys[keys.size() - 2].values == values) {
            keys.back().seconds = seconds;
            return;
        }
        if (!keys.empty() && keys.back().seconds >= seconds) {
            keys.back().values = values;
            return;
        }
        keys.push_back({seconds, values});
    }

    void take_leg(const gcode::Motion& leg, double specified_seconds) {
        const toolpath::JointPath path(machine_, leg);
        const auto from = path.at(0.0), to = path.at(1.0);
        if (!from || !to) {
            ++course_.left_out;
            course_.seconds += specified_seconds;
            return;
        }
        if (!course_.keys.empty()) {
            const Values before = course_.keys.back().values;
            add_key(course_.seconds, before);
            add_transfer_time(before, *from);
        }
        add_key(course_.seconds, *from);
        const double seconds = std::max(specified_seconds, least_seconds(*from, *to));
        divide(path, {0.0, *from}, {1.0, *to}, seconds, 0);
        course_.seconds += seconds;
    }

    // Adds the time from the end of a motion to the start of the next motion, if the positions
    // differ.
    void add_transfer_time(const Values& from, const Values& to) {
        double square = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            square += (to[i] - from[i]) * (to[i] - from[i]);
        // Rounding of a position.
        constexpr double kSame = 1e-6;
        const double turns = least_seconds(from, to);
        if (square < kSame * kSame && turns < kSame) return;
        course_.seconds += std::max(std::sqrt(square) / kRapidPerSecond, turns);
    }

    struct End {
        double t = 0.0;
        Values values{};
    };

    // Adds keys after the key at `a` up to the key at `b`.
    void divide(const toolpath::JointPath& path, const End& a, const End& b, double seconds,
                int halvings) {
        const auto joint_motion = path.joint_motion(a.t, a.values, b.t, b.values);
        const double missed_mm =
            joint_motion ? joint_motion->bend / 8.0 : std::numeric_limits<double>::infinity();
        const bool is_last = halvings == kMostHalvings || (!joint_motion && halvings == kUnknown);
        if (missed_mm > kCourseTolerance && !is_last) {
            const double middle = 0.5 * (a.t + b.t);
            if (const auto values = path.at(middle)) {
                const End m{middle, *values};
                divide(path, a, m, seconds, halvings + 1);
                divide(path, m, b, seconds, halvings + 1);
                return;
            }
            ++course_.left_out;
        }
        if (joint_motion) course_.missed_mm = std::max(course_.missed_mm, missed_mm);
        add_key(course_.seconds + b.t * seconds, b.values);
    }

    // Number of halvings without a known bound.
    static constexpr int kUnknown = 6;

    const toolpath::Kinematics& machine_;
    JointCourse course_;
};

}  // namespace

JointCourse joint_course(const Plan& plan) {
    CourseWriter writer(*plan.placed);
    const std::uint64_t most = plan.at_line ? motions_until(plan, *plan.at_line)
                                            : std::numeric_limits<std::uint64_t>::max();
    std::uint64_t motions = 0;
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        if (motions++ < most) writer.take(motion);
    });
    return writer.finish();
}

}  // namespace ncsim::simulation
