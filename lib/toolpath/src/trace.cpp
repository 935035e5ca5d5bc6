// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/trace.h"

#include <algorithm>
#include <cmath>

namespace ncsim::toolpath {

using cda::LatticePoint;
using cda::Vec3;

namespace {

// Orientations kept: programs with a tilted tool alternate between a few.
constexpr std::size_t kCachedOrientations = 8;

}  // namespace

Cutter::Cutter(const Tool& tool, const cda::Lattice& lattice, const ToolAccuracy& accuracy)
    : lattice_(lattice),
      rounding_(accuracy.side == Side::Circumscribed ? cda::Rounding::Outward
                                                     : cda::Rounding::Inward),
      extent_(extent_of(tool)) {
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        PiecePolytope polytope = approximate(piece, lattice, accuracy);
        if (polytope.points_T.empty()) continue;
        error_mm_ = std::max(error_mm_, polytope.error_mm);
        sides_ = std::max(sides_, polytope.sides);
        for (const LatticePoint& p : polytope.points_T) {
            radius_mm_ = std::max(radius_mm_, norm(lattice.to_mm(p)));
        }
        pieces_.push_back(std::move(polytope));
    }
}

std::vector<LatticePoint> Cutter::turned(const Rotation& rows, std::size_t piece) const {
    std::vector<LatticePoint> points;
    points.reserve(pieces_[piece].points_T.size());
    const auto snap = [](double v) { return static_cast<std::int64_t>(std::round(v)); };
    for (const LatticePoint& p : pieces_[piece].points_T) {
        const Vec3 v{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        points.push_back({snap(dot(rows[0], v)), snap(dot(rows[1], v)), snap(dot(rows[2], v))});
    }
    return points;
}

const Cutter::Oriented& Cutter::oriented(const Rotation& rows) {
    for (const Oriented& known : cache_) {
        if (known.rows == rows) return known;
    }
    Oriented made{rows, {}};
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        made.sweeps.push_back(cda::TranslationSweep::of(turned(rows, i), lattice_, rounding_));
    }
    if (cache_.size() == kCachedOrientations) cache_.erase(cache_.begin());
    cache_.push_back(std::move(made));
    return cache_.back();
}

void Cutter::trace(const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
                   std::vector<cda::Cell>& cells) {
    const LatticePoint from = lattice_.round(X_WA.translation);
    const LatticePoint to = lattice_.round(X_WB.translation);
    if (X_WA.rows == X_WB.rows) {
        for (const auto& sweep : oriented(X_WA.rows).sweeps) {
            if (sweep) cells.push_back((*sweep)(from, to, origin));
        }
        return;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        std::vector<LatticePoint> points = turned(X_WA.rows, i);
        for (LatticePoint& p : points)
            p = p + from;
        for (const LatticePoint& p : turned(X_WB.rows, i))
            points.push_back(p + to);
        if (auto cell = cda::convex_hull(points, lattice_, origin, rounding_)) {
            cells.push_back(std::move(*cell));
        }
    }
}

cda::Box Cutter::bounds(const std::vector<Pose>& X_WT) const {
    // In lattice units, as the cells' own bounds are, so that no rounding can put a cell outside.
    // Not the sphere about the tip where the tool stands upright: its lower half would reach
    // into stock far below.
    const auto units = [this](double mm) {
        return static_cast<std::int64_t>(std::ceil(mm / lattice_.unit_mm)) + 1;
    };
    const std::int64_t r = units(radius_mm_);
    const LatticePoint low_sphere{-r, -r, -r};
    LatticePoint low{0, 0, 0};
    LatticePoint high{0, 0, 0};
    for (const PiecePolytope& piece : pieces_) {
        for (const LatticePoint& p : piece.points_T) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    }
    cda::Box box;
    for (const Pose& pose : X_WT) {
        const LatticePoint t = lattice_.round(pose.translation);
        const bool upright = pose.rows == Pose{}.rows;
        box.add(lattice_.to_mm(t + (upright ? low : low_sphere)));
        box.add(lattice_.to_mm(t + (upright ? high : -low_sphere)));
    }
    return box;
}

bool has_known_start(const gcode::Motion& motion) {
    return motion.known_start.x && motion.known_start.y && motion.known_start.z;
}

}  // namespace ncsim::toolpath
