// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names for exact things: numbers for points, keys for lines, sets that grow together.
#pragma once

#include "ncsim/cda/predicates.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ncsim::cda {

/// Equal points get equal numbers, whichever planes they were made of; in order of first sight.
class PointNumbers {
public:
    std::uint32_t number(const ExactPoint& point);
    const ExactPoint& operator[](std::uint32_t n) const { return points_[n]; }
    std::size_t size() const { return points_.size(); }

private:
    struct Hash {
        std::size_t operator()(const ExactPoint& p) const noexcept;
    };
    struct Equal {
        bool operator()(const ExactPoint& a, const ExactPoint& b) const { return same_point(a, b); }
    };
    std::unordered_map<ExactPoint, std::uint32_t, Hash, Equal> numbers_;
    std::vector<ExactPoint> points_;
};

/// Plücker coordinates of a line, without common divisors, the first component of the
/// direction that is not zero positive: equal lines are equal keys, whichever planes meet in them.
struct LineKey {
    std::int64_t dx = 0, dy = 0, dz = 0;  ///< Direction, reduced by itself: below 2^50.
    Int128 mx = 0, my = 0, mz = 0;        ///< Moment, with the direction before it was reduced.
    std::int64_t scale = 1;               ///< What the direction was divided by after all six were.
    bool operator==(const LineKey&) const = default;
};

struct LineKeyHash {
    std::size_t operator()(const LineKey& key) const noexcept;
};

/// The line where two planes meet. Requires planes that are not parallel.
LineKey line_through(const Plane& s, const Plane& t);

/// Sign of a[axis] − b[axis], exactly.
int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int axis);

/// Sets that are united, never split (Tarjan). The representative is the smallest member.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size);
    std::uint32_t find(std::uint32_t i);
    void unite(std::uint32_t a, std::uint32_t b);

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace ncsim::cda
