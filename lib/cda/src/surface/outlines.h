// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines of the visible remainders of facets, the result of evaluation and the input of
// stitching. All objects are identified by planes.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"

#include "exact/interner.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// A point rounded down to 2^-24 of a lattice unit. Equal points have equal values, for any
/// defining planes. Coordinates are within 2^26 units.
struct FixedPoint {
    std::array<std::int64_t, 3> at{};
    // Written out, because a library call for so few bytes is slow.
    bool operator==(const FixedPoint& o) const {
        return at[0] == o.at[0] && at[1] == o.at[1] && at[2] == o.at[2];
    }

    static constexpr double kScale = 16777216.0;
    static FixedPoint of(const ExactPoint& p);
    /// Returns the wall perpendicular to `axis` in which the point lies, to 2^-24 of a unit; empty
    /// if none.
    std::optional<std::int64_t> wall(const std::vector<std::int64_t>& walls,
                                     std::size_t axis) const;
    /// Returns the position in lattice units.
    Vec3 approx() const {
        return {static_cast<double>(at[0]) / kScale, static_cast<double>(at[1]) / kScale,
                static_cast<double>(at[2]) / kScale};
    }
};

/// Coordinates of planes perpendicular to each axis: odd numbers of half units, ascending.
using Walls = std::array<std::vector<std::int64_t>, 3>;

/// A reference to an oriented plane of a table: twice the index, plus one for the opposite
/// orientation.
using PlaneRef = std::uint32_t;

/// Outlines of pieces of faces, with separate tables of planes and points. Faces are to the left of
/// their outlines, seen from outside the material. Pieces of one face that coincide in opposite
/// directions cancel.
class Outlines {
public:
    struct Point {
        FixedPoint fixed;
        std::array<std::uint32_t, 3> planes{};  // indices, ascending
    };
    struct Piece {
        PlaneRef plane = 0;      // plane of the face, material below
        std::uint32_t edge = 0;  // index of the second plane through the piece
        Origin origin = kStockOrigin;
        std::uint32_t tail = 0, head = 0;  // points
    };

    std::uint32_t add_plane(const Plane& plane) {
        planes_.push_back(plane);
        return static_cast<std::uint32_t>(planes_.size() - 1);
    }
    /// Returns the meeting point of three planes of the table. Points of the same three planes
    /// since start_page() are the same point. Requires: the planes meet in one point.
    std::uint32_t point(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Adds a point computed elsewhere, without duplicates; point() does not find this point.
    void add_point(const Point& point) { points_.push_back(point); }
    /// Starts a new page, so that the lookup table stays small. Points before and after are not
    /// compared; a point on two pages is stored twice.
    void start_page();
    void add(const Piece& piece) { pieces_.push_back(piece); }
    /// Drops pairs of `pieces` (numbers) that connect the same points on a line of one face in
    /// opposite directions, and points that become unused. Points are the same if their planes are
    /// the same, on any page.
    /// Cost: O(pieces).
    void cancel(std::span<const std::uint32_t> pieces);
    /// Frees memory that only insertion needs. Call after the last point and piece.
    void close();
    /// Returns the pieces with an end in a wall.
    Outlines at(const Walls& walls) const;

    Plane plane(PlaneRef ref) const {
        return ref & 1 ? planes_[ref / 2].opposite() : planes_[ref / 2];
    }
    const std::vector<Plane>& planes() const { return planes_; }
    const std::vector<Point>& points() const { return points_; }
    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    // A hash table of the points of this page; slots of previous pages count as free.
    struct Slot {
        std::uint32_t page = 0;
        std::uint32_t point = 0;
    };
    static std::uint64_t hash(const std::array<std::uint32_t, 3>& planes) {
        return mix(planes[0] | std::uint64_t{planes[1]} << 32, planes[2]);
    }
    void grow();

    std::vector<Plane> planes_;
    std::vector<Slot> slots_;
    std::uint32_t page_ = 1;
    std::size_t page_begin_ = 0;
    std::vector<Point> points_;
    std::vector<Piece> pieces_;
};

}  // namespace ncsim::cda
