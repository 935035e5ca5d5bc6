// SPDX-License-Identifier: GPL-3.0-or-later
//
// Follows a tool in a hole.
#include "hole_course.h"

#include "rule_table.h"

#include <algorithm>
#include <utility>

namespace ncsim::verify {

void HoleCourse::take(Move& move) {
    const gcode::Motion& motion = *move.motion;
    const auto* from = gcode::start_of(motion);
    const auto* to = gcode::end_of(motion);
    if (!from || !to) return;  // a dwell or a tool change
    const auto last_cut = std::exchange(cut_, std::nullopt);
    const bool is_axial = from->x == to->x && from->y == to->y && !is_turned(motion);
    const bool is_here = motion.tool == tool_ && to->x.mm() == x_ && to->y.mm() == y_;
    if (!is_here) top_.reset();
    tool_ = motion.tool;
    x_ = to->x.mm();
    y_ = to->y.mm();
    if (!is_axial) return;
    if (to->z > from->z) {
        if (is_here) move.leaves_cut = last_cut;
        return;
    }
    if (motion.kind != gcode::MoveKind::Feed || !move.meets_material) return;
    if (!top_) top_ = std::min(from->z.mm(), move.contact.max.z);
    move.hole_depth_mm = *top_ - to->z.mm();
    cut_ = motion.spindle;
}

}  // namespace ncsim::verify
