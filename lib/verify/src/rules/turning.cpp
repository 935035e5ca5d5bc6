// SPDX-License-Identifier: GPL-3.0-or-later
//
// How rotary axes turn: clamps that hold them, directions near those of joints.
#include "ncsim/toolpath/machine.h"

#include "finding_log.h"
#include "rule_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ncsim::verify {

void judge_clamps(const Setup& /*setup*/, const Move& move, FindingLog& log) {
    if (!move.is_move || !move.motion->turns_clamped) return;
    Sighting s{"an axis turns that is clamped"};
    s.box = move.path;
    log.add("turns-while-clamped", move, std::move(s));
}

// A joint turns far, and the tool hardly leans elsewhere.
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
    const cda::Vec3 before = axis_of(poses.at(from)), after = axis_of(poses.at(to));
    // About its own axis a tool may turn on purpose.
    if (before == after) return;
    const double leans = norm(after - before) * 180.0 / std::numbers::pi;
    if (leans >= kHardly) return;
    Sighting s{"a joint turns far where the tool hardly leans"};
    s.quantity = Quantity{"by", turn, "degrees"};
    s.box = move.path;
    log.add("singular-pose", move, std::move(s));
}

}  // namespace ncsim::verify
