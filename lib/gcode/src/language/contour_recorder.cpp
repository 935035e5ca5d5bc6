// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions → moves of a contour.
#include "language/contour_recorder.h"

#include <array>
#include <variant>

namespace ncsim::gcode::language {

void ContourRecorder::add(const Motion& motion) {
    const Position* const from = start_of(motion);
    const Position* const to = end_of(motion);
    if (!from) return;
    const auto in_plane = [&](const Position& p) {
        const std::array<double, 3> all{p.x.mm(), p.y.mm(), p.z.mm()};
        return Vec2{all[axes_.first] / unit_mm_, all[axes_.second] / unit_mm_};
    };
    OutlineMove move{in_plane(*from), in_plane(*to), {}, 0};
    if (const auto* const arc = std::get_if<Arc>(&motion.action)) {
        move.centre = {arc->centre_1.mm() / unit_mm_, arc->centre_2.mm() / unit_mm_};
        move.turns = arc->turns;
    }
    const bool moves = move.turns != 0 || move.from.x != move.to.x || move.from.y != move.to.y;
    if (moves && has_begun_) moves_.push_back(move);
    has_begun_ = true;
    const std::array<bool, 3> known{motion.known_end.x, motion.known_end.y, motion.known_end.z};
    is_known_ = is_known_ && known[axes_.first] && known[axes_.second];
}

}  // namespace ncsim::gcode::language
