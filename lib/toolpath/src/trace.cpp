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

Cutter::Cutter(const Tool& tool, const cda::Lattice& lattice, const ToolAccuracy& accuracy,
               const ToolPiece* below)
    : lattice_(lattice),
      rounding_(accuracy.side != Side::Inscribed ? cda::Rounding::Outward : cda::Rounding::Inward),
      extent_(extent_of(tool)) {
    for (const ToolPiece& piece : tool.pieces) {
        if (!piece.cutting) continue;
        PiecePolytope polytope = below ? approximate_above(*below, piece, lattice, accuracy)
                                       : approximate(piece, lattice, accuracy);
        if (polytope.points_T.empty()) continue;
        error_mm_ = std::max(error_mm_, polytope.error_mm);
        sides_ = std::max(sides_, polytope.sides);
        for (const LatticePoint& p : polytope.points_T) {
            const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
            radius_ = std::max(radius_, std::sqrt(x * x + y * y));
            low_ = std::min(low_, static_cast<double>(p.z));
            high_ = std::max(high_, static_cast<double>(p.z));
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

cda::Box Cutter::bounds(const Pose& X_WA, const Pose& X_WB) const {
    // The cylinder around all corners, turned: along a unit direction it reaches its radius times
    // the sine, and its ends times the cosine, of the angle to the axis. A unit more for the
    // rounding of the turned corners; in lattice units, as the cells' own bounds are.
    cda::Box box;
    for (const Pose* pose : {&X_WA, &X_WB}) {
        const LatticePoint t = lattice_.round(pose->translation);
        LatticePoint low, high;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 row = pose->rows[static_cast<std::size_t>(axis)];
            const double aside = radius_ * std::sqrt(row.x * row.x + row.y * row.y);
            const double ends[] = {low_ * row.z, high_ * row.z};
            const auto down =
                static_cast<std::int64_t>(std::floor(std::min(ends[0], ends[1]) - aside)) - 1;
            const auto up =
                static_cast<std::int64_t>(std::ceil(std::max(ends[0], ends[1]) + aside)) + 1;
            (axis == 0 ? low.x : axis == 1 ? low.y : low.z) = down;
            (axis == 0 ? high.x : axis == 1 ? high.y : high.z) = up;
        }
        box.add(lattice_.to_mm(t + low));
        box.add(lattice_.to_mm(t + high));
    }
    return box;
}

bool has_known_start(const gcode::Motion& motion) {
    return motion.known_start.x && motion.known_start.y && motion.known_start.z;
}

bool has_known_end(const gcode::Motion& motion) {
    return motion.known_end.x && motion.known_end.y && motion.known_end.z && !motion.start_assumed;
}

}  // namespace ncsim::toolpath
