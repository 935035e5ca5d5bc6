// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface of a part in several states of the cutting, for animations. A piece of the surface is
// stored once, with the states between which the piece exists.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Corner of a recorded polygon, in steps of the recorder's grid.
using GridPoint = std::array<std::uint16_t, 3>;

/// Regular grid on which recorded corners lie: 65536 steps along the longest side of a box.
struct RecordGrid {
    Vec3 origin;      ///< Position of {0, 0, 0}, mm.
    double step = 1;  ///< mm

    /// Returns the grid that covers `box` (mm).
    static RecordGrid around(const Box& box);
    /// Returns the nearest grid point; points outside of the grid are moved to its border.
    GridPoint nearest(Vec3 point) const;
    /// Returns the position in mm.
    Vec3 position(const GridPoint& point) const;
};

/// A convex polygon of the surface, and the states in which the polygon is part of the surface.
struct SurfacePiece {
    Vec3 normal;  ///< Unit vector out of the material.
    Origin origin = kStockOrigin;
    std::uint32_t first_corner = 0;  ///< Index into SurfaceRecorder::corners().
    std::uint32_t corners = 0;       ///< Number of corners, counter-clockwise from outside.
    std::uint32_t first_state = 0;   ///< First state with the piece.
    std::uint32_t end_state = 0;     ///< First later state without the piece.
};

/// Records the surface in states 0, 1, 2 …
class SurfaceRecorder {
public:
    /// State number of pieces that exist in the last state.
    static constexpr std::uint32_t kNever = ~std::uint32_t{0};

    /// Creates a recorder without states; corners are rounded to `grid`.
    explicit SurfaceRecorder(const RecordGrid& grid) : grid_(grid) {}

    const RecordGrid& grid() const { return grid_; }
    /// Returns the number of recorded states.
    std::uint32_t states() const { return states_; }
    /// Returns all pieces; first_state is ascending.
    std::span<const SurfacePiece> pieces() const { return pieces_; }
    std::span<const GridPoint> corners() const { return corners_; }
    /// Keeps the states `kept` (ascending) only and renumbers the states. Pieces that exist in none
    /// of these states are erased, except pieces that exist at present.
    void keep_states(std::span<const std::uint32_t> kept);

    // Interface for models.

    /// Hash of the content of a cell of a model. Equal hashes: the cell has the same surface.
    using Hash = std::array<std::uint64_t, 2>;
    /// Polygons of a cell of a model.
    class Polygons {
    public:
        /// Adds a polygon with corners in mm. A polygon without area on the grid is left out.
        void add(const RecordGrid& grid, Vec3 normal, Origin origin, std::span<const Vec3> corners);

    private:
        friend class SurfaceRecorder;
        std::vector<SurfacePiece> pieces_;
        std::vector<GridPoint> corners_;
        std::vector<GridPoint> rounded_;  // of one polygon
    };
    /// A cell of a model; `polygons` is unused if the previous state has a cell with the same hash.
    struct Cell {
        Hash hash{};
        Polygons polygons;
    };
    /// Starts the next state.
    void begin_state() { ++states_; }
    /// True if `region` in the previous state has a cell with this hash.
    bool has_cell(std::size_t region, const Hash& hash) const;
    /// Replaces the cells of a region. Regions that are not replaced stay as in the previous state.
    void replace_region(std::size_t region, std::span<const Cell> cells);
    /// Number that a model may store for each region.
    std::uint64_t& mark(std::size_t region) { return region_at(region).mark; }

private:
    struct Region {
        std::map<Hash, std::vector<std::uint32_t>> cells;  // numbers of pieces
        std::uint64_t mark = kNoMark;
    };
    static constexpr std::uint64_t kNoMark = ~std::uint64_t{0};
    Region& region_at(std::size_t region);

    RecordGrid grid_;
    std::uint32_t states_ = 0;
    std::vector<SurfacePiece> pieces_;
    std::vector<GridPoint> corners_;
    std::vector<Region> regions_;
};

/// Extends a hash by a number.
SurfaceRecorder::Hash extended(const SurfaceRecorder::Hash& hash, std::uint64_t number);

}  // namespace ncsim::cda
