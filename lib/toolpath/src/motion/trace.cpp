// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hulls of a tool between two poses, and bounds of these hulls.
#include "ncsim/toolpath/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ncsim::toolpath {

using cda::LatticePoint;

namespace {

// Number of cached orientations. Programs with a tilted tool alternate between few orientations.
constexpr std::size_t kCachedOrientations = 8;
constexpr double kAll = std::numeric_limits<double>::infinity();

std::int64_t top_of(const std::vector<LatticePoint>& points) {
    return std::ranges::max(points, {}, &LatticePoint::z).z;
}

// Returns the height, in units, above which all edges of the polytope are vertical. The upper end
// if there is no such height.
std::int64_t start_of_cylinder(const std::vector<LatticePoint>& points) {
    const std::int64_t top = top_of(points);
    std::int64_t next = std::numeric_limits<std::int64_t>::min();
    for (const LatticePoint& p : points) {
        if (p.z < top) next = std::max(next, p.z);
    }
    const auto ring_at = [&](std::int64_t z) {
        std::vector<std::pair<std::int64_t, std::int64_t>> ring;
        for (const LatticePoint& p : points) {
            if (p.z == z) ring.emplace_back(p.x, p.y);
        }
        std::sort(ring.begin(), ring.end());
        return ring;
    };
    return ring_at(next) == ring_at(top) ? next : top;
}

// Returns the height of the lower end along the tool axis, with the tip at `tip`. The value
// decreases with depth.
std::int32_t depth(const Vec3& axis, const LatticePoint& tip, double low) {
    constexpr double kMost = std::numeric_limits<std::int32_t>::max();
    const Vec3 at{static_cast<double>(tip.x), static_cast<double>(tip.y),
                  static_cast<double>(tip.z)};
    return static_cast<std::int32_t>(std::clamp(std::floor(dot(axis, at) + low), -kMost, kMost));
}

}  // namespace

SweepSimplification simplification_of(const RotationBounds& turning, double slack_mm) {
    return {turning.top_mm, slack_mm, turning.slab_mm};
}

Cutter::Cutter(const Tool& tool, const cda::Lattice& lattice, const ToolAccuracy& accuracy,
               const ToolPiece* below)
    : lattice_(lattice),
      rounding_(accuracy.side != Side::Inscribed ? cda::Rounding::Outward : cda::Rounding::Inward) {
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
        PieceExtent extent = extent_of(piece);
        const double straight =
            lattice.unit_mm * static_cast<double>(start_of_cylinder(polytope.points_T));
        extent.straight_mm = std::clamp(straight, extent.straight_mm, extent.high_mm);
        extent_.pieces.push_back(extent);
        tops_.push_back(top_of(polytope.points_T));
        pieces_.push_back(std::move(polytope));
    }
}

std::vector<LatticePoint> Cutter::rotate_corners(const Rotation& rows, std::size_t piece,
                                                 const Slab& kept) const {
    std::vector<LatticePoint> points;
    points.reserve(pieces_[piece].points_T.size());
    const auto snap = [](double v) { return static_cast<std::int64_t>(std::round(v)); };
    const PieceExtent& extent = extent_.pieces[piece];
    const double most =
        kept.high_mm < extent.high_mm ? std::ceil(kept.high_mm / lattice_.unit_mm) : kAll;
    // A slab that begins within the cylinder has the corners of the upper end at both ends.
    const bool is_above = kept.low_mm > extent.low_mm;
    const double least = std::ceil(kept.low_mm / lattice_.unit_mm);
    const std::int64_t top = tops_[piece];
    const auto add = [&](Vec3 v) {
        points.push_back({snap(dot(rows[0], v)), snap(dot(rows[1], v)), snap(dot(rows[2], v))});
    };
    for (const LatticePoint& p : pieces_[piece].points_T) {
        const Vec3 v{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
        if (!is_above) {
            add({v.x, v.y, std::min(v.z, most)});
        } else if (p.z == top) {
            const double high = std::min(v.z, most);
            add({v.x, v.y, std::min(least, high)});
            add({v.x, v.y, high});
        }
    }
    return points;
}

Cutter::Oriented& Cutter::oriented(const Rotation& rows) {
    for (Oriented& known : cache_) {
        if (known.rows == rows) return known;
    }
    Oriented made{rows, {}, {}};
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        made.sweeps.push_back(
            cda::TranslationSweep::of(rotate_corners(rows, i, {-kAll, kAll}), lattice_, rounding_));
    }
    if (cache_.size() == kCachedOrientations) cache_.erase(cache_.begin());
    cache_.push_back(std::move(made));
    return cache_.back();
}

void Cutter::trace(const Pose& X_WA, const Pose& X_WB, cda::Origin origin,
                   std::vector<cda::Cell>& cells, const SweepSimplification& liberties) {
    const LatticePoint from = lattice_.round(X_WA.translation);
    const LatticePoint to = lattice_.round(X_WB.translation);
    const auto rank_of = [&](std::size_t piece) {
        const double low = extent_.pieces[piece].low_mm / lattice_.unit_mm;
        return std::min(depth(axis_of(X_WA), from, low), depth(axis_of(X_WB), to, low));
    };
    if (X_WA.rows == X_WB.rows) {
        const auto& sweeps = oriented(X_WA.rows).sweeps;
        for (std::size_t i = 0; i < sweeps.size(); ++i) {
            if (!sweeps[i]) continue;
            cells.push_back((*sweeps[i])(from, to, origin));
            cells.back().rank = rank_of(i);
        }
        return;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        PieceExtent kept = extent_.pieces[i];
        if (is_above(kept, liberties.top_mm)) continue;
        kept.high_mm = cut_off(kept, liberties.top_mm);
        for (const Slab& slab : slabs_of(kept, liberties.slab_mm)) {
            std::vector<LatticePoint> points = rotate_corners(X_WA.rows, i, slab);
            for (LatticePoint& p : points)
                p = p + from;
            for (const LatticePoint& p : rotate_corners(X_WB.rows, i, slab))
                points.push_back(p + to);
            auto cell = rounding_ == cda::Rounding::Inward
                            ? cda::convex_hull(points, lattice_, origin, rounding_)
                            : cda::convex_hull_within(points, lattice_, origin,
                                                      liberties.slack_mm / lattice_.unit_mm);
            if (!cell) continue;
            cells.push_back(std::move(*cell));
            cells.back().rank = rank_of(i);
        }
    }
}

void Cutter::cover(std::span<const LatticePoint> turn, const Pose& X_WA, cda::Origin origin,
                   std::vector<cda::Cell>& cells) {
    Oriented& oriented = this->oriented(X_WA.rows);
    const auto is_all_straight = [](const PieceExtent& e) { return e.straight_mm <= e.low_mm; };
    if (oriented.straight.empty()) {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const PieceExtent& extent = extent_.pieces[i];
            const bool is_needed = !is_all_straight(extent) && extent.straight_mm < extent.high_mm;
            oriented.straight.push_back(
                is_needed ? cda::TranslationSweep::of(
                                rotate_corners(X_WA.rows, i, {extent.straight_mm, kAll}), lattice_,
                                rounding_)
                          : std::nullopt);
        }
    }
    const LatticePoint& highest = *std::ranges::max_element(turn, {}, &LatticePoint::z);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const PieceExtent& extent = extent_.pieces[i];
        const auto& body = (is_all_straight(extent) ? oriented.sweeps : oriented.straight)[i];
        if (!body) continue;
        auto cell = body->around(turn, origin);
        if (!cell) continue;
        const double low = std::max(extent.low_mm, extent.straight_mm) / lattice_.unit_mm;
        cell->rank = depth(axis_of(X_WA), highest, low) - 1;
        cells.push_back(std::move(*cell));
    }
}

// The cylinder around all corners up to `end`, rotated. Along a unit direction, it reaches its
// radius times the sine, and its ends times the cosine, of the angle to the axis. A unit is added
// for the rounding of rotated corners. In lattice units, like the cells' own bounds.
Cutter::Reach Cutter::reach(const Rotation& rows, double end) const {
    Reach reach;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 row = rows[static_cast<std::size_t>(axis)];
        const double aside = radius_ * std::sqrt(row.x * row.x + row.y * row.y);
        const double ends[] = {low_ * row.z, end * row.z};
        const auto down =
            static_cast<std::int64_t>(std::floor(std::min(ends[0], ends[1]) - aside)) - 1;
        const auto up =
            static_cast<std::int64_t>(std::ceil(std::max(ends[0], ends[1]) + aside)) + 1;
        (axis == 0 ? reach.low.x : axis == 1 ? reach.low.y : reach.low.z) = down;
        (axis == 0 ? reach.high.x : axis == 1 ? reach.high.y : reach.high.z) = up;
    }
    return reach;
}

Box Cutter::bounds(const Pose& X_WA, const Pose& X_WB, const Reach& reach) const {
    Box box;
    for (const Pose* pose : {&X_WA, &X_WB}) {
        const LatticePoint t = lattice_.round(pose->translation);
        box.add(lattice_.to_mm(t + reach.low));
        box.add(lattice_.to_mm(t + reach.high));
    }
    return box;
}

Box Cutter::bounds(const Pose& X_WA, const Pose& X_WB, const SweepSimplification& liberties) const {
    if (X_WA.rows == X_WB.rows) return bounds(X_WA, X_WB, reach(X_WA));
    double kept = low_;
    for (const PieceExtent& piece : extent_.pieces) {
        const double cut = cut_off(piece, liberties.top_mm);
        kept = std::max(kept, cut < piece.high_mm ? std::ceil(cut / lattice_.unit_mm) : high_);
    }
    const double end = std::min(high_, kept);
    Box box = bounds(X_WA, X_WA, reach(X_WA.rows, end));
    box.add(bounds(X_WB, X_WB, reach(X_WB.rows, end)));
    return box;
}

bool Cutter::meets(const Box& place, const Pose& X_WA, const Pose& X_WB) {
    const LatticePoint from = lattice_.round(X_WA.translation);
    const LatticePoint to = lattice_.round(X_WB.translation);
    return std::ranges::any_of(oriented(X_WA.rows).sweeps, [&](const auto& sweep) {
        return sweep && place.overlaps(sweep->bounds(from, to));
    });
}

bool has_known_start(const gcode::Motion& motion) {
    return motion.known_start.all();
}

bool has_known_end(const gcode::Motion& motion) {
    return motion.known_end.all() && !motion.start_assumed;
}

}  // namespace ncsim::toolpath
