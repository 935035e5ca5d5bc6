// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joining of short moves.
#include "join_moves.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

namespace ncsim::simulation {

namespace {

constexpr std::size_t kMostPlaces = 256;

Vec3 place(const gcode::Position& p) {
    return {p.x.mm(), p.y.mm(), p.z.mm()};
}

bool moves_xyz_only(const gcode::Linear& line) {
    gcode::Position from = line.from;
    from.x = line.to.x, from.y = line.to.y, from.z = line.to.z;
    return from == line.to;
}

/// Returns the straight feed move if all its values are known; otherwise null.
const gcode::Linear* plain_line(const gcode::Motion& motion) {
    const auto* line = std::get_if<gcode::Linear>(&motion.action);
    if (!line || motion.kind != gcode::MoveKind::Feed || motion.machine_coordinates) return nullptr;
    const gcode::KnownAxes all;
    return motion.known_start == all && motion.known_end == all && moves_xyz_only(*line) ? line
                                                                                         : nullptr;
}

bool is_same_kind(const gcode::Motion& a, const gcode::Motion& b) {
    return a.tool == b.tool && a.file == b.file && a.coordinates == b.coordinates &&
           a.length == b.length && a.feed == b.feed && a.feed_mode == b.feed_mode &&
           a.feed_mode != gcode::FeedMode::InverseTime && a.spindle == b.spindle &&
           a.spindle_rpm == b.spindle_rpm && a.start_assumed == b.start_assumed &&
           a.offset_unknown == b.offset_unknown && a.spindle_in_doubt == b.spindle_in_doubt &&
           a.spindle_oriented == b.spindle_oriented;
}

}  // namespace

MoveJoiner::MoveJoiner(double tolerance_mm, Sink sink,
                       std::span<const toolpath::OperationName> names)
    : tolerance_mm_(tolerance_mm), sink_(std::move(sink)), names_(names) {}

// True if a name of an operation may be read between the held move and `next`.
bool MoveJoiner::has_name_before(const gcode::Motion& next) const {
    if (names_.empty() || next.file != 0) return false;
    if (next.span.line < last_line_) return true;
    const auto after =
        std::ranges::upper_bound(names_, last_line_, {}, &toolpath::OperationName::line);
    return after != names_.end() && after->line <= next.span.line;
}

bool MoveJoiner::can_join(const gcode::Motion& next) const {
    const gcode::Linear* line = plain_line(next);
    if (!held_ || !line || !is_same_kind(*held_, next) || has_name_before(next) ||
        intermediate_ends_.size() >= kMostPlaces)
        return false;
    const auto& row = std::get<gcode::Linear>(held_->action);
    if (!(row.to == line->from)) return false;
    const Vec3 from = place(row.from);
    const Vec3 way = place(line->to) - from;
    const double length_2 = dot(way, way);
    if (length_2 == 0.0) return false;
    double before = 0.0;
    const auto lies_on_way = [&](const Vec3& p) {
        const double t = dot(p - from, way) / length_2;
        const Vec3 off = p - from - t * way;
        const bool is_next = t >= before && t <= 1.0;
        before = t;
        return is_next && dot(off, off) <= tolerance_mm_ * tolerance_mm_;
    };
    return std::ranges::all_of(intermediate_ends_, lies_on_way) && lies_on_way(place(row.to));
}

void MoveJoiner::take(const gcode::Motion& motion) {
    if (tolerance_mm_ <= 0.0) return sink_(motion, 1);
    if (can_join(motion)) {
        auto& row = std::get<gcode::Linear>(held_->action);
        intermediate_ends_.push_back(place(row.to));
        has_joined_ = true;
        last_line_ = motion.span.line;
        row.to = std::get<gcode::Linear>(motion.action).to;
        return;
    }
    flush();
    if (!plain_line(motion)) return sink_(motion, 1);
    held_ = motion;
    last_line_ = motion.span.line;
}

void MoveJoiner::flush() {
    if (!held_) return;
    sink_(*held_, intermediate_ends_.size() + 1);
    held_.reset();
    intermediate_ends_.clear();
}

}  // namespace ncsim::simulation
