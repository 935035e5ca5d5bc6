// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of stitching: equal planes, points, lines and owners get equal numbers across all parts of
// the outlines; pieces of outlines become intervals on lines. Parts are added one by one, so that
// few parts are in memory at a time.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"

#include "exact/chunks.h"
#include "exact/groups.h"
#include "exact/interner.h"
#include "exact/numbering.h"
#include "surface/outlines.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::cda {

/// Direction of a line, 50 bits.
struct Direction {
    std::int64_t x = 0, y = 0, z = 0;
    Direction operator-() const { return {-x, -y, -z}; }
};

/// Limits on numbers; the named objects would exceed the memory first.
inline constexpr std::uint32_t kMostOwners = (std::uint32_t{1} << 31) - 1;
inline constexpr std::uint32_t kMostLines = (std::uint32_t{1} << 30) - 1;

/// Origin of outside pieces, which only determine where edges are divided.
inline constexpr Origin kOutside{0xffffffffU};

/// A piece of an outline on a line, tail before head along the line. Points and owners are given by
/// number.
struct Interval {
    std::uint32_t tail, head;
    std::uint32_t owner : 31;
    std::uint32_t forward : 1;
};

/// Numbers for planes, points, lines and owners of outlines.
class Naming {
public:
    Naming() : points_({}, SamePoint{&planes_.keys()}), lines_({}, SameLine{&planes_.keys()}) {}
    Naming(const Naming&) = delete;
    Naming& operator=(const Naming&) = delete;

    /// Adds a part. Numbers depend on the order of parts. Cost: expected O(pieces).
    void add_part(const Outlines& part);
    /// Adds a part of the outside: all pieces get the origin kOutside.
    void add_outside(const Outlines& part);
    /// Ends the input. Returns all pieces by line. The numbers of owners depend only on the
    /// geometry.
    /// Throws: std::length_error if there are too many owners or lines.
    Groups<Interval> finish(std::size_t threads);

    // Valid after finish().

    std::size_t points() const { return points_.size(); }
    /// Returns the position in lattice units.
    Vec3 point(std::uint32_t p) const { return points_.keys()[p].fixed.approx(); }
    ExactPoint exact(std::uint32_t p) const { return exact(points_.keys()[p], planes_.keys()); }
    const FixedPoint& fixed(std::uint32_t p) const { return points_.keys()[p].fixed; }
    /// Returns three planes that meet at the point.
    std::array<Plane, 3> planes_at(std::uint32_t p) const;
    /// Compares coordinates exactly: negative, 0 or positive. Two distinct points may have equal
    /// rounded coordinates; the order must not depend on the order of input.
    int compare(std::uint32_t a, std::uint32_t b) const;

    std::size_t lines() const { return directions_.size(); }
    const Direction& direction(std::uint32_t line) const { return directions_[line]; }
    /// True if `a` is before `b` on the line. Requires: both points are on the line.
    bool comes_before(std::uint32_t line, std::uint32_t a, std::uint32_t b) const;

    /// Frees the directions of lines; direction() and comes_before() are invalid afterwards.
    void forget_directions() { directions_ = {}; }

    /// An owner is an oriented plane with an origin.
    const std::vector<std::pair<Plane, Origin>>& owners() const { return owners_; }
    bool is_outside(std::size_t owner) const {
        return has_outside_ && owners_[owner].second == kOutside;
    }

private:
    // Planes are numbered without orientation: the first non-zero component is positive. The lowest
    // bit of a reference is the orientation.
    struct HashPlane {
        std::uint64_t operator()(const Plane& p) const { return PlaneHash{}(p); }
    };
    Plane plane_of(PlaneRef ref) const;
    void add_part(const Outlines& part, bool is_outside);

    // Points are compared by rounded coordinates first, then exactly.
    struct PointKey {
        FixedPoint fixed;
        std::array<std::uint32_t, 3> planes{};
    };
    struct HashPoint {
        std::uint64_t operator()(const PointKey& key) const {
            std::uint64_t h = 0;
            for (const std::int64_t v : key.fixed.at)
                h = mix(h, static_cast<std::uint64_t>(v));
            return h;
        }
    };
    static ExactPoint exact(const PointKey& key, const Chunks<Plane>& planes) {
        return *meet(planes[key.planes[0]], planes[key.planes[1]], planes[key.planes[2]]);
    }
    struct SamePoint {
        const Chunks<Plane>* planes;
        bool operator()(const PointKey& a, const PointKey& b) const;
    };

    // Lines are compared by rounded quotients of their Plücker coordinates first, then exactly.
    struct LineKey {
        std::array<std::uint32_t, 2> planes{};
        std::uint64_t hash = 0;
    };
    struct HashLine {
        std::uint64_t operator()(const LineKey& key) const { return key.hash; }
    };
    struct SameLine {
        const Chunks<Plane>* planes;
        bool operator()(const LineKey& a, const LineKey& b) const {
            return a.hash == b.hash &&
                   are_same(Pluecker((*planes)[a.planes[0]], (*planes)[a.planes[1]]),
                            Pluecker((*planes)[b.planes[0]], (*planes)[b.planes[1]]));
        }
    };
    struct PairHash {
        std::uint64_t operator()(const std::array<std::uint32_t, 2>& key) const {
            return mix(0, key[0] | std::uint64_t{key[1]} << 32);
        }
    };
    struct Owner {
        PlaneRef plane = 0;
        Origin origin = kStockOrigin;
        bool operator==(const Owner&) const = default;
    };
    struct HashOwner {
        std::uint64_t operator()(const Owner& o) const {
            return mix(0, o.plane | std::uint64_t{static_cast<std::uint32_t>(o.origin)} << 32);
        }
    };
    // A piece with numbers: numbers of the part at first, global numbers later.
    struct NumberedPiece {
        std::uint32_t line, tail, head;
        std::uint32_t owner : 31;
        std::uint32_t forward : 1;
    };

    Interner<Plane, HashPlane> planes_;
    Interner<PointKey, HashPoint, SamePoint> points_;
    Interner<LineKey, HashLine, SameLine> lines_;
    Chunks<Direction> directions_;  // by line
    Interner<Owner, HashOwner> owner_numbers_;
    std::vector<std::vector<NumberedPiece>> named_;  // by part
    std::vector<std::pair<Plane, Origin>> owners_;
    bool has_outside_ = false;

    // Buffers for one part, reused for the next part.
    std::vector<Plane> plane_keys_;
    std::vector<PlaneRef> plane_refs_;
    std::vector<PointKey> point_keys_;
    std::vector<std::uint32_t> point_numbers_;
    std::vector<LineKey> line_keys_;
    std::vector<Direction> line_directions_;
    std::vector<std::uint32_t> line_numbers_;
    std::vector<Owner> owner_keys_;
    std::vector<std::uint32_t> part_owners_;
};

}  // namespace ncsim::cda
