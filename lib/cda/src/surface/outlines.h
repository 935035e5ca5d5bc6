// SPDX-License-Identifier: GPL-3.0-or-later
//
// What evaluation hands to the stitching: the outlines of what is left of facets, piece by
// piece, everything named by planes.
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

/// A point rounded down to 2^-24 of a lattice unit: what equal points have in common, whichever
/// planes made them. Coordinates within 2^26 units.
struct FixedPoint {
    std::array<std::int64_t, 3> at{};
    // Not by a call for so few bytes.
    bool operator==(const FixedPoint& o) const {
        return at[0] == o.at[0] && at[1] == o.at[1] && at[2] == o.at[2];
    }

    static constexpr double kScale = 16777216.0;
    static FixedPoint of(const ExactPoint& p);
    /// In which of the walls across that axis it lies, to 2^-24 of a unit.
    std::optional<std::int64_t> wall(const std::vector<std::int64_t>& walls,
                                     std::size_t axis) const;
    /// In lattice units.
    Vec3 approx() const {
        return {static_cast<double>(at[0]) / kScale, static_cast<double>(at[1]) / kScale,
                static_cast<double>(at[2]) / kScale};
    }
};

/// Planes at right angles to each axis, at odd numbers of half units, ascending.
using Walls = std::array<std::vector<std::int64_t>, 3>;

/// An oriented plane of a table: twice the index, plus one for the opposite orientation.
using PlaneRef = std::uint32_t;

/// Outlines of pieces of faces, with tables of their own. Faces are to the left of their outlines,
/// seen from outside the material. Pieces of one face that lie on each other in opposite
/// directions cancel.
class Outlines {
public:
    struct Point {
        FixedPoint fixed;
        std::array<std::uint32_t, 3> planes{};  // indices, ascending
    };
    struct Piece {
        PlaneRef plane = 0;      // of the face, material below
        std::uint32_t edge = 0;  // index of the other plane in which the piece lies
        Origin origin = kStockOrigin;
        std::uint32_t tail = 0, head = 0;  // points
    };

    std::uint32_t add_plane(const Plane& plane) {
        planes_.push_back(plane);
        return static_cast<std::uint32_t>(planes_.size() - 1);
    }
    /// The meeting point of three planes of the table; they must meet in one. Of the points since
    /// turn_page(), those of the same three planes are the same.
    std::uint32_t point(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// A point that was made elsewhere, once: point() does not know it.
    void add_point(const Point& point) { points_.push_back(point); }
    /// Points that follow have nothing to do with those before: what is looked up stays small. A
    /// point that stands on two pages stands there twice.
    void turn_page();
    void add(const Piece& piece) { pieces_.push_back(piece); }
    /// Drops those of `pieces` (numbers) of which one goes from point to point on a line of a face
    /// and another one back, and the points that nobody names then. Points are the same if they
    /// are made by the same planes, on whichever pages. O(pieces).
    void cancel(std::span<const std::uint32_t> pieces);
    /// After the last point and piece: gives back memory that only adding needs.
    void close();
    /// What there is of it at the walls: pieces with an end in one of them.
    Outlines at(const Walls& walls) const;

    Plane plane(PlaneRef ref) const {
        return ref & 1 ? planes_[ref / 2].opposite() : planes_[ref / 2];
    }
    const std::vector<Plane>& planes() const { return planes_; }
    const std::vector<Point>& points() const { return points_; }
    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    // A hash table of the points of this page: slots of other pages are free.
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
