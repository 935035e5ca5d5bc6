// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where rays meet what an upright round tool passes over, a row of them at a time. What a convex
// body passes over is convex, so that each ray has one interval of it.
//
// With s the share of the way that is done, the tool's lower end on a ray is convex in s and its
// upper end concave: the best s of the whole line, clamped to where the ray is in the tool, is the
// best of the way. It has a closed form wherever the tool goes level or straight down, or is flat
// or a ball; of other tools that go down a slope it is found by halving.
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

/// Of the rays of a row: where each enters and leaves what the tool passes over, units, and at
/// which share of the way the tool is there. low > high: they do not meet.
struct RowMeeting {
    void resize(std::size_t count);
    std::vector<double> low, high, s_low, s_high;
};

/// Of rays that are looked at together.
inline constexpr std::size_t kWidest = 4;

/// Of the rays of a row: an interval of each, in whole units, and of both of its ends the share of
/// the way and the body. low > high: none. There is room for kWidest more rays.
struct PendingRow {
    double *low, *high, *s_low, *s_high, *low_body, *high_body;
};

/// Of a block of rays along z, row by row: the lowest that any of some tools reaches, in whole
/// units, at which share of its way, and which it is. Of kWidest rays in a row at a time the
/// highest above a plane through 0 in the middle of the block; of all of them, too, and the last of
/// the numbers.
struct LowestBlock {
    static constexpr std::size_t kGroups = kBlock * kBlock / kWidest;

    double slope_x = 0.0, slope_y = 0.0;  // of the plane
    alignas(32) std::array<double, kBlock * kBlock> plane{};
    alignas(32) std::array<double, kBlock * kBlock> at{}, s{}, number{};
    alignas(32) std::array<double, kGroups> group_highest{};
    double highest = 0.0, last = 0.0;
};
/// Of the rays of a block along an axis: the middle between the first and the last, and how far
/// these are from it; units.
struct BlockExtent {
    double middle, half;
};
/// How low a tool gets on the rays of a block: nowhere lower than `least`, nor than a plane and a
/// parabola over it, which opens across the way, and beyond its ends along it, too.
struct BlockBound {
    static constexpr double kNoReach = 1e30;

    double least;             ///< Units; kNoReach where it does not get there.
    double middle;            ///< The plane in the middle of the block, units.
    double slope_x, slope_y;  ///< Of the plane.
    double opening;           ///< Of the parabola, 1 / units.
    double ahead, behind,
        aside;  ///< From the middle of the block to its ends and its middle, units.
};
/// Of blocks that lie beside each other.
struct BlockBounds {
    void resize(std::size_t count);
    BlockBound operator[](std::size_t i) const {
        return {least[i],   middle[i], slope_x[i], slope_y[i],
                opening[i], ahead[i],  behind[i],  aside[i]};
    }
    std::vector<double> least, middle, slope_x, slope_y, opening, ahead, behind, aside;
};

/// How many rays are looked at together: the results are the same.
enum class Lanes { Two, Four };
/// What this machine has.
Lanes widest_lanes();

/// Makes the intervals of the first `count` rays enclose what is met of them, too, rounded. Those
/// that do not overlap it are handed over first: take(context, ray) makes them none.
void join_row(const PendingRow& pending, std::size_t count, RowMeeting& met, double body,
              Lanes lanes, void (*take)(void*, std::size_t), void* context);

class SweptTool {
public:
    SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid);

    /// Rays along `axis` through u[0] … u[count - 1] and `v`, their coordinates along the next two
    /// axes.
    void meet_row(std::size_t axis, const double* u, std::size_t count, double v, Lanes lanes,
                  RowMeeting& row) const;
    /// Along z, of a tool that is_open_above(): makes `lowest` what it reaches where that is lower,
    /// or as low and its number lower, and its number `number`. Leaves out where the bound tells
    /// that it stays above.
    void lower_block(const double* x, const double* y, std::size_t rows, const BlockBound& bound,
                     double number, Lanes lanes, LowestBlock& lowest) const;
    /// How far it stays above the plane of `lowest` in the block, at least; units.
    double least_above(const BlockBound& bound, const LowestBlock& lowest, double half_x,
                       double half_y) const;
    /// Of the blocks columns[0] … columns[count - 1] in a band. The bounds have room for kWidest
    /// more.
    void bound_blocks(const BlockExtent* columns, std::size_t count, const BlockExtent& band,
                      Lanes lanes, BlockBounds& bounds) const;
    /// Is its upper end above that all the way, units?
    bool is_open_above(double top) const;
    /// Where the tool passes over the line along x at this y, units; first > second: nowhere.
    std::pair<double, double> reach_along_x(double y) const;
    /// On the rays along z at this y, it reaches no lower, units.
    double lowest_at(double y) const;
    /// Out of what the tool passes over where the ray enters (leaves) it, at `at` and `s` as found
    /// by meet_row; not of unit length.
    cda::Vec3 normal(std::size_t axis, double u, double v, bool is_high, double at, double s) const;

    GridBox box;
    cda::Origin origin;

    /// The lower end of the tool.
    enum class Tip { Flat, Ball, Round, Cone };
    enum class Course { Level, Plunge, Slope };
    /// Units. What is the same for all rays.
    struct Numbers {
        double radius, height, flat, tip;  ///< As in RoundSweep.
        double steepness;                  ///< Of a cone: how far it rises a unit outwards.
        std::array<double, 3> from, way;   ///< Of the lowest point on the axis.
        double across, way_across;         ///< Of the way along x and y: squared, and not.
        double by_across;                  ///< 1 / across.
        double by_way_across;              ///< 1 / way_across.
        double along_x, along_y;  ///< Of length 1, as the way across; some, if there is none.
        double opening;  ///< Of a ball: of the parabola that is nowhere above it, 1 / units.
        double lead;  ///< Of a ball: how much less of the way is best for a root of room (along_z).
    };

private:
    Numbers numbers_;
    Tip tip_;
    Course course_;
};

inline double SweptTool::least_above(const BlockBound& bound, const LowestBlock& lowest,
                                     double half_x, double half_y) const {
    const double slope_x = bound.slope_x - lowest.slope_x;
    const double slope_y = bound.slope_y - lowest.slope_y;
    const double c = bound.opening;
    if (c == 0.0) return bound.middle - std::abs(slope_x) * half_x - std::abs(slope_y) * half_y;
    // Along and across the way, each by itself. Where it falls by g a unit, it is lowest g / 2c
    // beyond where the parabola begins to rise, or at an end of the block.
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
