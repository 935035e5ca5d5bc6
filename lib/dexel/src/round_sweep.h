// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersection of rays with the sweep of an upright round tool, a row of rays at a time. A convex
// tool sweeps a convex volume, so each ray has one interval.
//
// Let s be the share of the way. On a ray, the tool's lower end is convex in s and the upper end
// concave. So the best s of the whole line, clamped to the range in which the ray is in the tool,
// is the best s of the way. The best s has a closed form if the tool moves level or straight down,
// or is flat or a ball; for other tools on a slope, bisection finds the best s.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/sweep.h"

#include "grid.h"
#include "rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ncsim::dexel {

/// Intervals of the rays of a row in the sweep, units, with the share of the way at both ends. low
/// > high if the ray does not meet the sweep.
struct RowMeeting {
    void resize(std::size_t count);
    std::vector<double> low, high, s_low, s_high;
};

/// Largest number of rays in a vector.
inline constexpr std::size_t kWidest = 4;

/// Pending intervals of the rays of a row, in integer units, with the share of the way and the body
/// of both ends. low > high: no interval. Arrays have space for kWidest more rays.
struct PendingRow {
    double *low, *high, *s_low, *s_high, *low_body, *high_body;
};

/// Heights of a block of rays along z, row by row: the lowest height of all tools, in integer
/// units, with the share of the way and the tool's number. Also the highest value above a plane
/// through 0 at the middle of the block, for each group of kWidest rays and for the block, and the
/// largest number.
struct LowestBlock {
    static constexpr std::size_t kGroups = kBlock * kBlock / kWidest;

    double slope_x = 0.0, slope_y = 0.0;  // slopes of the plane
    alignas(32) std::array<double, kBlock * kBlock> plane{};
    alignas(32) std::array<double, kBlock * kBlock> at{}, s{}, number{};
    alignas(32) std::array<double, kGroups> group_highest{};
    double highest = 0.0, last = 0.0;
};
/// Extent of a block of rays along an axis, units: the middle between the first and the last ray,
/// and the half distance.
struct BlockExtent {
    double middle, half;
};
/// Lower bound of a tool's height on the rays of a block: at least `least`, and at least a plane
/// plus a parabola, which opens across the way and, beyond the ends of the way, along the way.
struct BlockBound {
    static constexpr double kNoLimit = 1e30;

    double least;             ///< Units; kNoLimit if the tool does not reach the block.
    double middle;            ///< Height of the plane at the middle of the block, units.
    double slope_x, slope_y;  ///< Slopes of the plane.
    double opening;           ///< Coefficient of the parabola, 1 / units.
    double ahead, behind,
        aside;  ///< Distances from the block's middle to the ends and the middle line of the way.
};
/// Bounds of consecutive blocks.
struct BlockBounds {
    void resize(std::size_t count);
    BlockBound operator[](std::size_t i) const {
        return {least[i],   middle[i], slope_x[i], slope_y[i],
                opening[i], ahead[i],  behind[i],  aside[i]};
    }
    std::vector<double> least, middle, slope_x, slope_y, opening, ahead, behind, aside;
};

/// Number of rays per vector; the results are identical.
enum class Lanes { Two, Four };
/// Returns the widest vectors that this machine supports.
Lanes widest_lanes();

/// Extends the pending intervals of the first `count` rays by the rounded intervals in `met`. If
/// the two are disjoint, take(context, ray) is called first and must clear the pending interval.
void join_row(const PendingRow& pending, std::size_t count, RowMeeting& met, double body,
              Lanes lanes, void (*take)(void*, std::size_t), void* context);

/// The sweep of a round tool in lattice units, prepared for intersection with rays.
class SweptTool {
public:
    SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid);

    /// Computes the intervals of the rays along `axis` through u[0] … u[count - 1] and `v`, the
    /// coordinates along the next two axes.
    void intersect_row(std::size_t axis, const double* u, std::size_t count, double v, Lanes lanes,
                       RowMeeting& row) const;
    /// Lowers `lowest` along z where the tool is lower, or equally low with a lower number, and
    /// stores `number`. Groups that the bound excludes are skipped. Requires: is_open_above().
    void lower_block(const double* x, const double* y, std::size_t rows, const BlockBound& bound,
                     double number, Lanes lanes, LowestBlock& lowest) const;
    /// Returns a lower bound of the tool's height above the plane of `lowest` in the block, units.
    double lowest_above(const BlockBound& bound, const LowestBlock& lowest, double half_x,
                        double half_y) const;
    /// Computes bounds for the blocks columns[0] … columns[count - 1] of a band. The vectors of
    /// `bounds` have space for kWidest more entries.
    void bound_blocks(const BlockExtent* columns, std::size_t count, const BlockExtent& band,
                      Lanes lanes, BlockBounds& bounds) const;
    /// True if the tool's upper end is above `top` on the whole way, units.
    bool is_open_above(double top) const;
    /// Returns the range of the sweep on the line along x at this y, units; first > second if
    /// empty.
    std::pair<double, double> reach_along_x(double y) const;
    /// Returns a lower bound of the sweep on rays along z at this y, units.
    double lowest_at(double y) const;
    /// Returns the normal of the sweep at the end where the ray leaves (`is_high`) or enters, with
    /// `at` and `s` from intersect_row(); points outwards, not of unit length.
    Vec3 normal(std::size_t axis, double u, double v, bool is_high, double at, double s) const;

    GridBox box;
    cda::Origin origin;

    /// Shape of the lower end of the tool.
    enum class Tip { Flat, Ball, Round, Cone };
    enum class Course { Level, Plunge, Slope };
    /// Values in units that are the same for all rays.
    struct Numbers {
        double radius, height, flat, tip;  ///< Same meaning as in RoundSweep.
        double steepness;                  ///< Rise of a cone per unit outwards.
        std::array<double, 3> from, way;   ///< Tip, and motion of the tip.
        double across, way_across;  ///< Horizontal length of the way: squared, and not squared.
        double inverse_across;      ///< 1 / across.
        double inverse_way_across;  ///< 1 / way_across.
        double along_x, along_y;  ///< Horizontal unit direction of the way; arbitrary if vertical.
        double opening;           ///< Coefficient of a parabola below a ball, 1 / units.
        double lead;              ///< Shift of a ball's best s per root of `room` (along_z).
    };

private:
    Numbers numbers_;
    Tip tip_;
    Course course_;
};

inline double SweptTool::lowest_above(const BlockBound& bound, const LowestBlock& lowest,
                                      double half_x, double half_y) const {
    const double slope_x = bound.slope_x - lowest.slope_x;
    const double slope_y = bound.slope_y - lowest.slope_y;
    const double c = bound.opening;
    if (c == 0.0) return bound.middle - std::abs(slope_x) * half_x - std::abs(slope_y) * half_y;
    // Minimises along and across the way separately. If the height falls by g per unit, the minimum
    // is g / 2c beyond the beginning of the parabola, or at an end of the block.
    const auto least = [c](double g, double begin, double half) {
        const double place = std::clamp(begin + g / (2.0 * c), -half, half);
        const double risen = std::max(place - begin, 0.0);
        return c * risen * risen - g * place;
    };
    const double x = numbers_.along_x, y = numbers_.along_y;
    const double along = slope_x * x + slope_y * y, across = slope_x * y - slope_y * x;
    const double size_x = std::abs(x), size_y = std::abs(y);
    return bound.middle +
           least(std::abs(along), along < 0.0 ? bound.ahead : bound.behind,
                 size_x * half_x + size_y * half_y) +
           least(std::abs(across), across < 0.0 ? bound.aside : -bound.aside,
                 size_y * half_x + size_x * half_y);
}

}  // namespace ncsim::dexel
