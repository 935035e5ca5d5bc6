// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rules about rotary axes: turns-while-clamped, singular-pose, path-deviation.
#include "ncsim/base/triangle_tree.h"
#include "ncsim/toolpath/kinematics.h"

#include "finding_log.h"
#include "rule_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::verify {

void judge_clamps(const Setup& /*setup*/, const Move& move, FindingLog& log) {
    if (!move.is_move || !move.motion->turns_clamped) return;
    Occurrence s{"an axis turns that is clamped"};
    s.box = move.path;
    log.add("turns-while-clamped", move, std::move(s));
}

// Reports a motion in which a joint turns far while the direction of the tool hardly changes.
void judge_singular_pose(const Setup& setup, const Move& move, FindingLog& log) {
    const gcode::Motion& motion = *move.motion;
    if (!move.is_move || !setup.kinematics || motion.coordinates != gcode::Coordinates::Tip ||
        motion.kind != gcode::MoveKind::Feed) {
        return;
    }
    const gcode::Position& from = *gcode::start_of(motion);
    const gcode::Position& to = *gcode::end_of(motion);
    const double turn =
        std::max({std::abs((to.a - from.a).degrees()), std::abs((to.b - from.b).degrees()),
                  std::abs((to.c - from.c).degrees())});
    constexpr double kFar = 5.0, kHardly = 0.5;  // degrees
    if (turn <= kFar) return;
    const toolpath::Poses poses(setup.kinematics.get(), motion);
    const Vec3 before = axis_of(poses.at(from)), after = axis_of(poses.at(to));
    // A turn about the tool's own axis can be intended.
    if (before == after) return;
    const double leans = norm(after - before) * 180.0 / std::numbers::pi;
    if (leans >= kHardly) return;
    Occurrence s{"a joint turns far where the tool hardly leans"};
    s.quantity = Quantity{"by", turn, "degrees"};
    s.box = move.path;
    log.add("singular-pose", move, std::move(s));
}

std::optional<std::string> needs_path_deviation(const Setup& setup) {
    if (!setup.kinematics || setup.machine.path_deviation) return std::nullopt;
    return "the allowed deviation of the tip from its line is not specified (machine.toml, "
           "path_deviation)";
}

// Samples the move every quarter of a degree. Between two samples the deviation grows by at most
// 2.4 µm per metre of distance from the axis.
void judge_path_deviation(const Setup& setup, const Move& move, FindingLog& log) {
    const gcode::Motion& motion = *move.motion;
    const auto* line = std::get_if<gcode::Linear>(&motion.action);
    if (!line || !setup.kinematics || !setup.machine.path_deviation || !move.is_traced ||
        motion.kind != gcode::MoveKind::Feed || motion.coordinates != gcode::Coordinates::Axes) {
        return;
    }
    const auto degrees = [](gcode::Angle a, gcode::Angle b) { return std::abs((b - a).degrees()); };
    const double turn = degrees(line->from.a, line->to.a) + degrees(line->from.b, line->to.b) +
                        degrees(line->from.c, line->to.c);
    if (turn == 0.0) return;
    constexpr double kStep = 0.25, kMost = 100'000;
    const auto steps = static_cast<int>(std::clamp(std::ceil(turn / kStep), 2.0, kMost));
    const toolpath::Poses poses(setup.kinematics.get(), motion);
    const Vec3 from = poses.at(line->from).translation, to = poses.at(line->to).translation;
    double farthest = 0.0;
    for (int i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec3 tip = poses.at(toolpath::interpolate(line->from, line->to, t)).translation;
        farthest = std::max(farthest, distance_to_segment(tip, from, to));
    }
    if (farthest <= *setup.machine.path_deviation) return;
    Occurrence s{fmt::format("the tip leaves the straight line of its move by more than {:.6g} mm",
                             *setup.machine.path_deviation)};
    s.quantity = Quantity{"by", farthest, "mm"};
    s.box = move.path;
    s.rests_on = guesses_of(setup, move);
    std::erase_if(s.rests_on, [](std::string_view reason) {
        return reason == "stock-guess" || reason == "tool-guess";
    });
    log.add("path-deviation", move, std::move(s));
}

}  // namespace ncsim::verify
