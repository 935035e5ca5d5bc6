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
    if (motion.tool != tool_) has_threaded_ = false;
    move.has_threaded = has_threaded_;
    const bool is_helical =
        (from->x != to->x || from->y != to->y || move.radius_mm > 0.0) && from->z != to->z;
    has_threaded_ |= motion.kind == gcode::MoveKind::Feed && is_helical && move.meets_material;
    const bool is_axial =
        from->x == to->x && from->y == to->y && move.radius_mm == 0.0 && !is_turned(motion);
    const bool is_here = motion.tool == tool_ && to->x.mm() == x_ && to->y.mm() == y_;
    if (!is_here) {
        top_.reset();
        has_cut_ = false;
    }
    tool_ = motion.tool;
    x_ = to->x.mm();
    y_ = to->y.mm();
    if (!is_axial) return;
    move.has_cut_below = has_cut_ && to->z > from->z;
    has_cut_ |= motion.kind == gcode::MoveKind::Feed && move.meets_material;
    if (to->z > from->z) {
        if (is_here) move.leaves_cut = last_cut;
        return;
    }
    if (motion.kind != gcode::MoveKind::Feed || !move.meets_material) return;
    if (!top_) {
        top_ = std::min(from->z.mm(), move.contact.max.z);
        // Measured upwards to the next step, so material that ends there counts as measured.
        if (move.mouth_z && *move.mouth_z < *top_) top_ = *move.mouth_z;
    }
    move.hole_depth_mm = *top_ - to->z.mm();
    cut_ = motion.spindle;
}

}  // namespace ncsim::verify
