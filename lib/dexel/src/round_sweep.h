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

#include <algorithm>
#include <array>
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

/// Of the rays along z of a row, the lowest that any of some tools reaches, at which share of its
/// way, and which it is. Has kWidest more than there are rays.
struct LowestRow {
    std::vector<double> at, s, number;
};
/// Of rays that are looked at together.
inline constexpr std::size_t kWidest = 4;

/// How many rays are looked at together: the results are the same.
enum class Lanes { Two, Four };
/// What this machine has.
Lanes widest_lanes();

class SweptTool {
public:
    SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid);

    /// Rays along `axis` through u[0] … u[count - 1] and `v`, their coordinates along the next two
    /// axes.
    void meet_row(std::size_t axis, const double* u, std::size_t count, double v, Lanes lanes,
                  RowMeeting& row) const;
    /// Along z, of a tool that is_open_above(): makes `lowest` what it reaches if that is lower,
    /// and its number `number`. x has kWidest more than `end`, and so many rays beyond `end` may be
    /// looked at, too.
    void lower_row(const double* x, std::size_t begin, std::size_t end, double y, double number,
                   Lanes lanes, LowestRow& lowest) const;
    /// Is its upper end above that all the way, units?
    bool is_open_above(double top) const;
    /// Where the tool passes over the line along x at this y, units; first > second: nowhere.
    std::pair<double, double> reach_along_x(double y) const;
    /// On the rays along z at this y, it reaches no lower, units.
    double lowest_at(double y) const;
    /// How much higher it stays on rays that are so far from its axis along x, at least.
    double rise_beside(double aside) const {
        return aside > 0.0 ? numbers_.rise * aside * aside : 0.0;
    }
    /// Where its axis is along x, from and to; units.
    double least_x() const {
        return std::min(numbers_.from[0], numbers_.from[0] + numbers_.way[0]);
    }
    double most_x() const { return std::max(numbers_.from[0], numbers_.from[0] + numbers_.way[0]); }
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
        double rise;                       ///< Over the squared distance from it, at least.
    };

private:
    Numbers numbers_;
    Tip tip_;
    Course course_;
};

}  // namespace ncsim::dexel
