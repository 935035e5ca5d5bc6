// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact geometric decisions of the kernel: about planes, points where three planes meet, and lines
// where two planes meet. No decision depends on a tolerance. Each predicate lists laws, which
// tests/cda/predicates_test.cpp checks one by one, and statements that are *not* true although they
// seem to be.
//
// Most predicates have two forms: a filter in doubles, which may be undecided, and an integer form,
// which always decides. The predicate calls the filter first and the integer form if the filter is
// undecided. docs/cda.md states how often the filter is undecided.
//
// Bits, for normals with N = kNormalBits and coordinates with B = kCoordinateBits:
//
//     d of a plane that meets the range            N + B + log2 3
//     n_s × n_t, the direction of a line           2N + 1
//     w, the determinant of three normals          3N + log2 6
//     x, y, z of a point of the range              B more than its w: |x/w| <= 2^B
//     n·x − d·w, what classify_exact() adds up     N + log2 3 more than x, 1 for d·w, a sign
//
// For points outside the range the numbers are unbounded, and no law holds.
#pragma once

#include "ncsim/base/int128.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/plane.h"

#include <cstdint>
#include <optional>

namespace ncsim::cda {

/// Bits of the largest sum.
inline constexpr double kClassifyBits = 4.0 * kNormalBits + kCoordinateBits + 2.6 + 1.6 + 1.0;
static_assert(kClassifyBits < 127.0, "a sign needs more than 128 bits");

/// Below is the inner side of a halfspace: n·x < d.
enum class Side : std::int8_t { Below = -1, On = 0, Above = 1 };

constexpr Side opposite(Side side) {
    return static_cast<Side>(-static_cast<int>(side));
}

// --- Points ---

/// The exact meeting point (x, y, z) / w of three planes in lattice units, w > 0, with the nearest
/// doubles for filters and output.
struct ExactPoint {
    Int128 x = 0, y = 0, z = 0, w = 1;
    Vec3 approx;  ///< In lattice units, each coordinate within 2 ulp.

    /// Returns a point of the lattice.
    static ExactPoint at(LatticePoint p);
};

/// Returns the unique point on all three planes; empty if the normals are linearly dependent.
/// Requires: the point, and planes that meet the stock, are within the range of the lattice.
///
///  (1) the same numbers for p, q, r in any order, and for any opposites
///  (2) empty if and only if turn(p, q, r) is 0
///
/// Not true: that equal points have equal numbers. Other planes through the same point give a
/// multiple of the numbers, and `approx` may differ in the last bits: see reduced().
std::optional<ExactPoint> meet(const Plane& p, const Plane& q, const Plane& r);

/// The same without `approx`, which costs a third of meet().
std::optional<ExactPoint> meet_exactly(const Plane& p, const Plane& q, const Plane& r);

/// Divides out common divisors, so that equal points have equal numbers, `approx` included.
///
///  (1) reduced(meet(a, b, c)) equals reduced(meet(d, e, f)) if and only if the points are equal
ExactPoint reduced(const ExactPoint& p);
/// True if two reduced points are equal. Not true of points that are not reduced.
bool same_point(const ExactPoint& a, const ExactPoint& b);

/// Returns the sign of a[axis] − b[axis]. For all points:
///
///  (1) compare_coordinate(a, b, i) == −compare_coordinate(b, a, i)
///  (2) a == b if and only if the result is 0 for all three axes
///  (3) a < b and b < c: a < c
///
/// Not true: that the result is the sign of the difference of `approx`.
int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int axis);
/// Decides from integers alone, by continued fractions, so that no product exceeds 128 bits.
int compare_coordinate_exact(const ExactPoint& a, const ExactPoint& b, int axis);

// --- Points and planes ---

/// Returns the side of `plane` on which the point lies. For all points p and planes h:
///
///  (1) classify(p, h) == opposite(classify(p, h.opposite()))
///  (2) if p == meet(a, b, c), classify(p, a) == On; the same for b and c
///  (3) the result depends on the point alone: classify(p, h) == classify(reduced(p), h)
///  (4) a point On or Below h is Below the plane with d + 1; a point On or Above h is Above the
///      plane with d − 1
///
/// Not true: that points whose `approx` lies on a plane are On the plane, or the converse.
///
/// Requires: a plane that meets the range of the lattice (|d| < 2^52). For other planes classify
/// the box, see polytope.h.
Side classify(const ExactPoint& p, const Plane& plane);

/// Decides from doubles alone: never On; empty if undecided.
std::optional<Side> classify_in_doubles(const ExactPoint& p, const Plane& plane);

/// Decides from integers alone: the oracle of classify().
Side classify_exact(const ExactPoint& p, const Plane& plane);

/// Returns classify() of the meeting point of p, q and r, which is known to lie within `most` of
/// `plane`, in units of the plane's normal: |n·x − d| <= `most`. A small `most` makes the
/// determinant small, mostly below 2^63, so that 64 bits decide.
/// Requires: p, q and r meet in one point.
///
///  (1) classify_near(p, q, r, h, most) == classify_exact(*meet(p, q, r), h), for each true `most`
///
/// Not true: that the result is On, or any law, for a `most` that is too small.
Side classify_near(const Plane& p, const Plane& q, const Plane& r, const Plane& plane, double most);

// --- Directions and lines ---

/// Returns the sign of (n_s × n_t) · n_h. For all planes:
///
///  (1) turn(s, t, h) == turn(t, h, s) == −turn(t, s, h)
///  (2) turn(s, t, h.opposite()) == −turn(s, t, h)
///
/// Not true: that the sign depends on positions; distances are not used.
int turn(const Plane& s, const Plane& t, const Plane& h);

/// Compares two points on the line of intersection of two planes in direction n_s × n_t: Below if a
/// is before b, On if equal, Above if after. `through_b` is a plane that meets the line in b alone.
///
///  (1) the opposite result for t and s swapped
///  (2) the same result for through_b.opposite(), and for any plane that meets the line in b alone
///  (3) if a is where g meets the line and b where h does:
///      order_along(s, t, a, h) == opposite(order_along(s, t, b, g))
///
/// Not true: any law for a plane parallel to the line, turn(s, t, through_b) == 0.
Side order_along(const Plane& s, const Plane& t, const ExactPoint& a, const Plane& through_b);

// --- Parallel planes ---

/// True if two parallel planes have the same orientation. Not true of planes that are not parallel:
/// there the result only states that the angle between the normals is below 90°.
constexpr bool same_direction(const Plane& a, const Plane& b) {
    return std::int64_t{a.nx} * b.nx + std::int64_t{a.ny} * b.ny + std::int64_t{a.nz} * b.nz > 0;
}

/// Returns, for parallel planes with the same orientation, the sign of the distance of `b` minus
/// the distance of `a`.
///
///  (1) compare_distances(a, b) == −compare_distances(b, a); 0 if and only if a == b
///  (2) a < b and b < c: a < c
///
/// Not true of planes with opposite orientation, see distance_beyond(); nor that the result is the
/// sign of b.d − a.d: normals of parallel planes may differ in length, as in 2x <= 3 and x <= 1.
int compare_distances(const Plane& a, const Plane& b);

/// Compares a facet with a parallel plane, whose orientation is the facet's (`same`) or opposite:
/// positive if the facet is below the plane, 0 if in the plane, negative if above.
///
///  (1) distance_beyond(f, h, same) == −distance_beyond(f, h.opposite(), !same)
int distance_beyond(const Plane& facet, const Plane& plane, bool same);

}  // namespace ncsim::cda
