// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes of the tree: corners are odd numbers of half units, so that no facet with integer
// coordinates lies on a face of a box.
#pragma once

#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ncsim::cda {

/// A box in half lattice units.
struct HalfBox {
    std::array<std::int64_t, 3> min{}, max{};

    std::int64_t extent(std::size_t axis) const { return max[axis] - min[axis]; }
    std::size_t longest_axis() const {
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (extent(i) > extent(axis)) axis = i;
        }
        return axis;
    }
    /// Returns the coordinate of the cut between the halves: the middle, rounded to an odd number.
    std::int64_t middle(std::size_t axis) const { return ((min[axis] + max[axis]) >> 1) | 1; }
    HalfBox half(std::size_t axis, bool upper) const {
        HalfBox result = *this;
        (upper ? result.min : result.max)[axis] = middle(axis);
        return result;
    }
    bool is_empty() const { return min[0] >= max[0] || min[1] >= max[1] || min[2] >= max[2]; }
    bool operator==(const HalfBox&) const = default;
};

/// Returns the intersection; empty if there is no common volume.
inline HalfBox intersection(const HalfBox& a, const HalfBox& b) {
    HalfBox result;
    for (std::size_t i = 0; i < 3; ++i) {
        result.min[i] = std::max(a.min[i], b.min[i]);
        result.max[i] = std::min(a.max[i], b.max[i]);
    }
    return result;
}

inline HalfBox enclosing(const HalfBox& a, const HalfBox& b) {
    HalfBox result;
    for (std::size_t i = 0; i < 3; ++i) {
        result.min[i] = std::min(a.min[i], b.min[i]);
        result.max[i] = std::max(a.max[i], b.max[i]);
    }
    return result;
}

/// Centre and half extents of a box, in half units: integers.
struct BoxFrame {
    explicit BoxFrame(const HalfBox& box) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t middle = (box.min[i] + box.max[i]) / 2;
            const std::int64_t extent = (box.max[i] - box.min[i]) / 2;
            centre[i] = static_cast<double>(middle);
            half[i] = static_cast<double>(extent);
        }
    }
    std::array<double, 3> centre{}, half{};
};

/// The halfspace n·x <= d2 for x in half units: a plane of the lattice in doubles, exactly.
struct HalfPlane {
    HalfPlane() = default;
    explicit HalfPlane(const Plane& p)
        : nx(p.nx), ny(p.ny), nz(p.nz), d2(2.0 * static_cast<double>(p.d)) {}
    double normal(std::size_t axis) const { return axis == 0 ? nx : axis == 1 ? ny : nz; }
    double nx = 0, ny = 0, nz = 0, d2 = 0;
};

/// Height of a box's middle above a plane, and reach of the box to both sides of its middle; in
/// half units times the length of the normal.
struct BoxHeight {
    BoxHeight(const BoxFrame& box, const HalfPlane& p)
        : above(p.nx * box.centre[0] + p.ny * box.centre[1] + p.nz * box.centre[2] - p.d2),
          reach(std::abs(p.nx) * box.half[0] + std::abs(p.ny) * box.half[1] +
                std::abs(p.nz) * box.half[2]) {}
    /// Exact: normals below 2^24 and coordinates below 2^26 half units give products below 2^50,
    /// with sums that are integers below 2^53. Only a difference whose size alone decides may be
    /// rounded.
    Side side() const {
        return above + reach <= 0 ? Side::Below : above >= reach ? Side::Above : Side::On;
    }
    double above, reach;
};

/// Returns how a box lies to a plane.
inline Side side_of(const BoxFrame& box, const HalfPlane& p) {
    return BoxHeight(box, p).side();
}

}  // namespace ncsim::cda
