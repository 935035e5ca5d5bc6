// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where rays are: at the corners of a grid that begins and ends outside of the stock.
#pragma once

#include "ncsim/cda/lattice.h"
#include "ncsim/cda/vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ncsim::dexel {

/// Of one axis: corners at odd half units, so that no plane of whole coordinates holds one. The
/// first is half a pitch below the stock, the last half a pitch above it, and each stands for a
/// pitch of it.
struct GridAxis {
    GridAxis(double min, double max, double pitch);
    std::size_t corners() const { return at.size(); }
    std::size_t cells() const { return at.size() - 1; }
    /// The first corner at or beyond `place`.
    std::size_t from(double place) const;

    std::vector<double> at;  ///< Units.
    double pitch = 1.0;      ///< Units; a whole number of them is the stock.
};

/// Of all directions together, whether they are there or not: the surface takes about a kilobyte
/// for each.
inline constexpr double kMostRays = 2e6;

struct Grid {
    /// Of a box in units. Throws std::invalid_argument if there were more than kMostRays.
    Grid(cda::Vec3 min, cda::Vec3 max, double pitch);

    std::array<GridAxis, 3> axes;
};

/// What a body may meet: its bounds with some room for rounding.
struct GridBox {
    GridBox(const cda::Box& bounds_mm, const cda::Lattice& lattice, const Grid& grid);

    std::array<double, 3> low, high;        ///< Units.
    std::array<std::size_t, 3> begin, end;  ///< The corners between, along each axis.
};

}  // namespace ncsim::dexel
