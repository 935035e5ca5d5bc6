// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners of the grid in the material, and crossings of the surface with edges of the grid.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

#include "cutter.h"
#include "rays.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ncsim::dexel {

/// Indices of a grid corner, or of the cell that begins there.
using Place = std::array<std::size_t, 3>;

/// A bit for each corner of the grid, columns along z in sequence.
class Signs {
public:
    Signs(const Grid& grid, const Rays& along_z, std::size_t threads);

    std::size_t words() const { return words_; }
    const std::uint64_t* column(std::size_t x, std::size_t y) const {
        return &bits_[(x * columns_y_ + y) * words_];
    }
    bool operator()(const Place& p) const {
        return (column(p[0], p[1])[p[2] / 64] >> p[2] % 64 & 1) != 0;
    }

private:
    std::size_t columns_y_, words_;
    std::vector<std::uint64_t> bits_;
};

/// The point where the surface crosses an edge of the grid.
struct Crossing {
    double at = 0.0;  ///< Along the edge, units.
    Vec3 normal;
    cda::Origin origin = cda::kStockOrigin;
    bool operator==(const Crossing&) const = default;
};

/// Finds crossings from the ends of rays.
class Crossings {
public:
    /// Requires: `grid`, `rays` and `stock` outlive this object.
    Crossings(const Grid& grid, const std::array<Rays, 3>& rays, const CuttingCell& stock,
              std::size_t threads)
        : signs_(grid, rays[2], threads), grid_(grid), rays_(rays), stock_(stock) {}

    const Signs& signs() const { return signs_; }
    Vec3 point_of(const Place& corner) const {
        return {grid_.axes[0].at[corner[0]], grid_.axes[1].at[corner[1]],
                grid_.axes[2].at[corner[2]]};
    }
    /// Returns the crossing on the edge from this corner along the axis. If no ray end is on the
    /// edge, because all rays are rounded, returns the middle.
    /// Requires: exactly one end of the edge is in the material.
    Crossing at(const Place& from, std::size_t axis) const;
    /// Returns at().origin at lower cost.
    cda::Origin origin_at(const Place& from, std::size_t axis) const;

private:
    const End* end_on(const Place& from, std::size_t axis, bool enters) const;
    Crossing crossing_between(const Place& from, std::size_t axis, bool enters) const;
    std::optional<Crossing> crossing_of_stock(const Place& from, std::size_t axis,
                                              bool enters) const;

    Signs signs_;
    const Grid& grid_;
    const std::array<Rays, 3>& rays_;
    const CuttingCell& stock_;
};

}  // namespace ncsim::dexel
