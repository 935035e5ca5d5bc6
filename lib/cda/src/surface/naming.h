// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first step of stitching: equal planes, points, lines and owners get equal numbers, whichever
// parts of the outlines they come from; pieces of outlines become intervals on lines. Parts are
// taken one by one, so that no more of them are kept than are under way.
#pragma once

#include "ncsim/cda/origin.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/predicates.h"
#include "ncsim/cda/vec.h"

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

/// Of a line: of 50 bits.
struct Direction {
    std::int64_t x = 0, y = 0, z = 0;
    Direction operator-() const { return {-x, -y, -z}; }
};

/// More than fit into memory beside what they name.
inline constexpr std::uint32_t kMostOwners = (std::uint32_t{1} << 31) - 1;
inline constexpr std::uint32_t kMostLines = (std::uint32_t{1} << 30) - 1;

/// Of pieces that others see: they only tell where edges are cut.
inline constexpr Origin kOutside{0xffffffffU};

/// A piece of an outline on its line, tail before head along the line. Points and owners by number.
struct Interval {
    std::uint32_t tail, head;
    std::uint32_t owner : 31;
    std::uint32_t forward : 1;
};

class Naming {
public:
    Naming() : points_({}, SamePoint{&planes_.keys()}), lines_({}, SameLine{&planes_.keys()}) {}
    Naming(const Naming&) = delete;
    Naming& operator=(const Naming&) = delete;

    /// Numbers depend on the order of the parts. Expected O(pieces).
    void take(const Outlines& part);
    /// The same of what others see: all its pieces are kOutside.
    void take_outside(const Outlines& part);
    /// After the last part: all pieces by line. Owners are numbered in an order that depends on the
    /// geometry only. Throws std::length_error if there are too many of them, or of lines.
    Groups<Interval> finish(std::size_t threads);

    // All that follows is for after finish().

    std::size_t points() const { return points_.size(); }
    /// In lattice units.
    Vec3 point(std::uint32_t p) const { return points_.keys()[p].fixed.approx(); }
    ExactPoint exact(std::uint32_t p) const { return exact(points_.keys()[p], planes_.keys()); }
    const FixedPoint& fixed(std::uint32_t p) const { return points_.keys()[p].fixed; }
    /// Three that meet there.
    std::array<Plane, 3> planes_at(std::uint32_t p) const;
    /// By coordinates, exactly: two points may be nearer to each other than what they are rounded
    /// to, and whoever was first must not decide. Negative, 0 or positive.
    int compare(std::uint32_t a, std::uint32_t b) const;

    std::size_t lines() const { return directions_.size(); }
    const Direction& direction(std::uint32_t line) const { return directions_[line]; }
    /// Of points on a line.
    bool comes_before(std::uint32_t line, std::uint32_t a, std::uint32_t b) const;

    /// Lines have no directions any more.
    void forget_directions() { directions_ = {}; }

    /// An oriented plane together with an origin.
    const std::vector<std::pair<Plane, Origin>>& owners() const { return owners_; }
    bool is_outside(std::size_t owner) const {
        return has_outside_ && owners_[owner].second == kOutside;
    }

private:
    // Planes are numbered without their orientation: the first component that is not zero is
    // positive. A reference has the orientation in its lowest bit.
    struct HashPlane {
        std::uint64_t operator()(const Plane& p) const { return PlaneHash{}(p); }
    };
    Plane plane_of(PlaneRef ref) const;
    void take(const Outlines& part, bool is_outside);

    // Points are told apart by what they are rounded to, and where that is the same, exactly.
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

    // Lines likewise: by quotients of their Plücker coordinates, rounded, then exactly.
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
    // A piece by numbers: those of its part at first.
    struct Named {
        std::uint32_t line, tail, head;
        std::uint32_t owner : 31;
        std::uint32_t forward : 1;
    };

    Interner<Plane, HashPlane> planes_;
    Interner<PointKey, HashPoint, SamePoint> points_;
    Interner<LineKey, HashLine, SameLine> lines_;
    Chunks<Direction> directions_;  // of lines
    Interner<Owner, HashOwner> owner_numbers_;
    std::vector<std::vector<Named>> named_;  // of each part
    std::vector<std::pair<Plane, Origin>> owners_;
    bool has_outside_ = false;

    // Of one part, kept for their memory.
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
