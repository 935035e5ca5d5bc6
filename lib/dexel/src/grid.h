// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the rays: corners of a grid that begins and ends outside of the stock.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/lattice.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ncsim::dexel {

/// Corners along an axis, at odd numbers of half units, so that no plane with integer coordinates
/// contains a corner. The first corner is half a pitch below the stock, the last half a pitch
/// above, and each corner represents a pitch of length.
struct GridAxis {
    GridAxis(double min, double max, double pitch);
    std::size_t corners() const { return at.size(); }
    std::size_t cells() const { return at.size() - 1; }
    /// Returns the index of the first corner at or beyond `place`.
    std::size_t from(double place) const;

    std::vector<double> at;  ///< Units.
    double pitch = 1.0;      ///< Units; the stock's extent is an integer multiple.
};

/// Limit on the rays of all three directions, even if a direction is not used: the surface takes
/// about a kilobyte per ray.
inline constexpr double kMostRays = 2e6;

/// The grid of rays: corners along three axes.
struct Grid {
    /// Builds the grid of a box in units. Throws: std::invalid_argument if the grid exceeds
    /// kMostRays.
    Grid(Vec3 min, Vec3 max, double pitch);

    std::array<GridAxis, 3> axes;
};

/// Bounds of a body with a margin for rounding, and the corners within.
struct GridBox {
    GridBox(const Box& bounds_mm, const cda::Lattice& lattice, const Grid& grid);

    std::array<double, 3> low, high;        ///< Units.
    std::array<std::size_t, 3> begin, end;  ///< Range of corners within, along each axis.
};

}  // namespace ncsim::dexel
