// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a ray meets what an upright round tool passes over: in closed form, with the normal there.
// What a convex body passes over is convex, so that there is one interval; for a cylinder with a
// half ball below, it is the union of those of the cylinder and of the ball, which overlap.
//
// With s the share of the way that is done, the ball's lower end on a ray along d is the least of
// c_d(s) - √(R² - q(s)²), c its centre and q how far that is from the ray. This is convex in s, so
// that the best s of the whole line, clamped to [0, 1], is the best of the way. Likewise for the
// circle in which a plane across the axis meets the cylinder.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/sweep.h"

#include "grid.h"

#include <array>
#include <cstddef>

namespace ncsim::dexel {

/// A place on a ray and how the swept surface lies there.
struct Meeting {
    double at = 0.0;
    cda::Vec3 normal;  ///< Out of the tool; not of unit length.
};

class SweptTool {
public:
    SweptTool(const cda::RoundSweep& sweep, const cda::Lattice& lattice, const Grid& grid);

    struct Interval {
        Meeting low, high;
    };
    /// On the ray along `axis` through `u` and `v`, its coordinates along the next two axes. False:
    /// they do not meet.
    bool meet(std::size_t axis, double u, double v, Interval& result) const;

    GridBox box;
    cda::Origin origin;

private:
    using Triple = std::array<double, 3>;
    bool meet_ball(std::size_t axis, double u, double v, Interval& result) const;
    bool meet_along_z(double x, double y, Interval& result) const;
    bool meet_across_z(std::size_t axis, double other, double z, Interval& result) const;
    cda::Vec3 rim_normal(double x, double y, double s, bool is_lower) const;

    double radius_, height_;
    bool is_ball_;
    Triple from_, way_;  // of the lowest point on the axis, units
};

}  // namespace ncsim::dexel
