// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of feed moves and the estimate of a tool.
#include "ncsim/setup/tool_clues.h"

#include "ncsim/base/angles.h"
#include "ncsim/toolpath/kinematics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <variant>
#include <vector>

namespace ncsim::setup {

namespace {

struct Size {
    double mm;
    const char* text;
};
constexpr Size kMetric[] = {{0.2, "0.2"}, {0.5, "0.5"}, {1.0, "1"}, {2.0, "2"},
                            {3.0, "3"},   {4.0, "4"},   {5.0, "5"}, {6.0, "6"}};
constexpr Size kInches[] = {{0.396875, "1/64in"}, {0.79375, "1/32in"}, {1.5875, "1/16in"},
                            {3.175, "1/8in"},     {4.7625, "3/16in"},  {6.35, "1/4in"}};

}  // namespace

void ToolClues::take(const gcode::Motion& motion, const toolpath::Poses& poses) {
    const gcode::Position* from = start_of(motion);
    const gcode::Position* to = end_of(motion);
    if (!from || !to) return;
    const Vec3 a = poses.place(*from);
    const Vec3 b = poses.place(*to);
    const Vec3 way = b - a;
    const double aside = hypotenuse(way.x, way.y);
    ++moves_;
    if (aside == 0.0) {
        ++falling_;
        if (holes_.size() < kMostLines)
            holes_.emplace(std::llround(1e3 * b.x), std::llround(1e3 * b.y));
    }
    tips_.add(b);
    if (aside > 0.0) tips_.add(a);
    length_mm_ += norm(way);
    if (const auto* arc = std::get_if<gcode::Arc>(&motion.action)) {
        if (arc->tilted) return;
        const bool is_flat = arc->plane == gcode::Plane::XY && way.z == 0.0;
        const double radius = hypotenuse(a.x - arc->centre_1.mm(), a.y - arc->centre_2.mm());
        constexpr double kCorner = 0.05;  // mm; tighter arcs are rounded corners of the path
        if (is_flat && radius > kCorner) smallest_arc_mm_ = std::min(smallest_arc_mm_, radius);
        return;
    }
    if (aside > 0.0 && way.z != 0.0) ++slanting_;
    const auto add_line = [this](std::size_t axis, double where) {
        if (lines_[axis].size() < kMostLines) lines_[axis].insert(std::llround(1e3 * where));
    };
    if (way.x != 0.0 && way.y == 0.0) add_line(0, a.y);
    if (way.y != 0.0 && way.x == 0.0) add_line(1, a.x);
}

// Returns the width of the area of the moves, mm; 0 without motion in the plane.
double ToolClues::width_mm() const {
    if (tips_.is_empty()) return 0.0;
    const Vec3 size = tips_.size();
    const double narrow = std::min(size.x, size.y);
    return narrow > 0.0 ? narrow : std::max(size.x, size.y);
}

// Returns the median distance of adjacent lines, mm; infinite for few lines.
double ToolClues::step_mm() const {
    constexpr std::size_t kFew = 6;
    double step = std::numeric_limits<double>::infinity();
    for (const auto& lines : lines_) {
        if (lines.size() < kFew) continue;
        std::vector<std::int64_t> steps;
        for (auto line = std::next(lines.begin()); line != lines.end(); ++line)
            steps.push_back(*line - *std::prev(line));
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::ranges::nth_element(steps, middle);
        step = std::min(step, 1e-3 * static_cast<double>(*middle));
    }
    return step;
}

// Returns the least distance of two of the first kMostLines holes, mm; infinite for a single hole.
// Cost: O(n^2) for a column of holes, less if the holes are spread along X.
double ToolClues::hole_spacing_mm() const {
    double least = std::numeric_limits<double>::infinity();
    for (auto a = holes_.begin(); a != holes_.end(); ++a) {
        for (auto b = std::next(a); b != holes_.end(); ++b) {
            const double x = 1e-3 * static_cast<double>(b->first - a->first);
            if (x >= least) break;
            const double y = 1e-3 * static_cast<double>(b->second - a->second);
            least = std::min(least, hypotenuse(x, y));
        }
    }
    return least;
}

std::string ToolClues::guess(bool inches) const {
    constexpr double kSlanting = 0.3;   // share of moves from which a surface is assumed
    constexpr double kShallow = 2.0;    // mm
    constexpr double kShortMove = 2.0;  // mm
    const auto share = [this](std::size_t of) {
        return moves_ == 0 ? 0.0 : static_cast<double>(of) / static_cast<double>(moves_);
    };
    const double depth = tips_.is_empty() ? 0.0 : tips_.size().z;
    const bool is_drill = moves_ > 0 && falling_ == moves_;
    const bool is_surface = share(slanting_) > kSlanting && depth > kShallow;
    const bool engraves = !is_drill && !is_surface && depth < kShallow && moves_ >= 100 &&
                          length_mm_ < kShortMove * static_cast<double>(moves_);
    const char* kind = is_drill ? "drill" : is_surface ? "ball" : engraves ? "v" : "flat";
    // Lines are assumed 0.1 tool diameters apart on a surface, 0.4 in a pocket. For an engraver
    // only the tip counts.
    double diameter = std::numeric_limits<double>::infinity();
    if (!engraves) {
        diameter = std::min(2.0 * smallest_arc_mm_, step_mm() * (is_surface ? 10.0 : 2.5));
        if (is_drill) diameter = std::min(diameter, hole_spacing_mm());
        if (width_mm() > 0.0) diameter = std::min(diameter, width_mm() / 4.0);
    }
    const std::span<const Size> sizes =
        inches ? std::span<const Size>(kInches) : std::span<const Size>(kMetric);
    const Size* size = &sizes.front();
    for (const Size& s : sizes) {
        if (s.mm <= 1.001 * diameter) size = &s;
    }
    return std::string(kind).append(":D").append(size->text).append(engraves ? ":A60" : "");
}

}  // namespace ncsim::setup
