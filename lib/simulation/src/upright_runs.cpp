// SPDX-License-Identifier: GPL-3.0-or-later
//
// Correction of rounded ends in runs of sloping moves.
#include "upright_runs.h"

#include "ncsim/toolpath/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace ncsim::simulation {

namespace {

using gcode::Linear;
using gcode::Motion;

// Returns the position seen from above.
Vec3 place(const gcode::Position& p) {
    const Vec3 at = toolpath::linear_axes(p);
    return {at.x, at.y, 0.0};
}

double height(const gcode::Position& p) {
    return toolpath::linear_axes(p).z;
}

const Linear* sloped(const Motion& motion) {
    if (motion.kind != gcode::MoveKind::Feed || !gcode::start_of(motion)) return nullptr;
    const Linear* line = toolpath::straight_upright(motion);
    if (!line || height(line->from) == height(line->to)) return nullptr;
    return norm(place(line->to) - place(line->from)) > 0.0 ? line : nullptr;
}

// The vertical plane through two positions.
struct Plane {
    Plane(Vec3 start, Vec3 end)
        : from(start), along(normalized(end - start)), length(norm(end - start)) {}

    Vec3 from, along;
    double length;

    double distance_along(Vec3 p) const { return dot(p - from, along); }
    Vec3 offset_from_line(Vec3 p) const { return p - from - distance_along(p) * along; }
};

}  // namespace

bool UprightRuns::goes_on(const Linear& next, int tool) const {
    if (run_.empty() || run_.size() >= kMostMoves || tool != tool_) return false;
    if (!(run_.back().line.to == next.from)) return false;
    const Plane plane(place(run_.front().line.from), place(next.to));
    if (!(plane.length > 0.0)) return false;
    double before = 0.0;
    return std::ranges::all_of(run_, [&](const Move& move) {
        const Vec3 p = place(move.line.to);
        const double ahead = plane.distance_along(p);
        const bool is_next = ahead > before && ahead < plane.length;
        before = ahead;
        return is_next && norm(plane.offset_from_line(p)) <= kRoundedMm;
    });
}

void UprightRuns::take(const Motion& motion, std::optional<std::size_t> cut) {
    const Linear* line = sloped(motion);
    if (!line || !goes_on(*line, motion.tool)) flush();
    if (!line) return;
    run_.push_back({*line, cut});
    tool_ = motion.tool;
}

void UprightRuns::flush() {
    std::vector<Move> run = std::exchange(run_, {});
    if (run.size() < 2) return;
    const Plane plane(place(run.front().line.from), place(run.back().line.to));
    double moved_mm = 0.0;
    for (std::size_t i = 0; i + 1 < run.size(); ++i) {
        gcode::Position& end = run[i].line.to;
        const Vec3 off = plane.offset_from_line(place(end));
        moved_mm = std::max(moved_mm, norm(off));
        end.x = gcode::Length::from_mm(end.x.mm() - off.x);
        end.y = gcode::Length::from_mm(end.y.mm() - off.y);
        run[i + 1].line.from = end;
    }
    for (const Move& move : run) {
        if (move.cut) sink_(*move.cut, move.line, moved_mm);
    }
}

}  // namespace ncsim::simulation
