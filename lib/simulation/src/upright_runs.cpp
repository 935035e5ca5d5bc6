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

const Linear& line_of(const Motion& motion) {
    return std::get<Linear>(motion.action);
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

UprightRuns::UprightRuns(Sink sink) : sink_(std::move(sink)) {}

bool UprightRuns::goes_on(const Motion& next) const {
    const Linear* line = sloped(next);
    if (run_.empty() || run_.size() >= kMostMoves || !line) return false;
    if (next.tool != run_.back().tool || !(line_of(run_.back()).to == line->from)) return false;
    const Plane plane(place(line_of(run_.front()).from), place(line->to));
    if (!(plane.length > 0.0)) return false;
    double before = 0.0;
    return std::ranges::all_of(run_, [&](const Motion& motion) {
        const Vec3 p = place(line_of(motion).to);
        const double ahead = plane.distance_along(p);
        const bool is_next = ahead > before && ahead < plane.length;
        before = ahead;
        return is_next && norm(plane.offset_from_line(p)) <= kRoundedMm;
    });
}

void UprightRuns::take(const Motion& motion) {
    if (!goes_on(motion)) flush();
    if (!sloped(motion)) return sink_(motion, 0.0);
    run_.push_back(motion);
}

void UprightRuns::flush() {
    if (run_.empty()) return;
    const Plane plane(place(line_of(run_.front()).from), place(line_of(run_.back()).to));
    double moved_mm = 0.0;
    for (std::size_t i = 0; i + 1 < run_.size(); ++i) {
        gcode::Position& end = std::get<Linear>(run_[i].action).to;
        const Vec3 off = plane.offset_from_line(place(end));
        moved_mm = std::max(moved_mm, norm(off));
        end.x = gcode::Length::from_mm(end.x.mm() - off.x);
        end.y = gcode::Length::from_mm(end.y.mm() - off.y);
        std::get<Linear>(run_[i + 1].action).from = end;
    }
    for (const Motion& motion : run_)
        sink_(motion, moved_mm);
    run_.clear();
}

}  // namespace ncsim::simulation
