// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every geometric decision of the kernel, answered exactly: what it says of planes, of the points
// where three of them meet, and of the lines where two do. Nothing here depends on a tolerance.
// With each predicate stand its laws, which tests/cda/predicates_test.cpp checks one by one, and
// what is *not* true although it seems so.
//
// Two forms of most: one from doubles, which may not be able to tell, and one from integers, which
// always is. The predicate itself asks the first and, where it must, the second. How often it must:
// docs/cda.md, "How often doubles cannot tell".
//
// Bits, of normals with N = kNormalBits and coordinates with B = kCoordinateBits:
//
//     d of a plane that meets the range            N + B + log2 3
//     n_s × n_t, the direction of a line           2N + 1
//     w, the determinant of three normals          3N + log2 6
//     x, y, z of a point of the range              B more than its w: |x/w| <= 2^B
//     n·x − d·w, what classify_exact() adds up     N + log2 3 more than x, 1 for d·w, a sign
//
// Of points outside of the range the numbers are as large as they please, and nothing here holds.
#pragma once

#include "ncsim/cda/int128.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <optional>

namespace ncsim::cda {

/// Of the largest sum of all.
inline constexpr double kClassifyBits = 4.0 * kNormalBits + kCoordinateBits + 2.6 + 1.6 + 1.0;
static_assert(kClassifyBits < 127.0, "a sign needs more than 128 bits");

/// Below is the inner side of a halfspace: n·x < d.
enum class Side : std::int8_t { Below = -1, On = 0, Above = 1 };

constexpr Side opposite(Side side) {
    return static_cast<Side>(-static_cast<int>(side));
}

// --- Points ---

/// The meeting point of three planes, exactly: (x, y, z) / w in lattice units, w > 0; and its
/// nearest doubles, for filters and for output.
struct ExactPoint {
    Int128 x = 0, y = 0, z = 0, w = 1;
    Vec3 approx;  ///< In lattice units, each coordinate within 2 ulp.

    /// A point of the lattice.
    static ExactPoint at(LatticePoint p);
};

/// The one point on all three planes; nothing if their normals are linearly dependent. Requires
/// the point, and planes that meet the stock, within the range of the lattice.
///
///  (1) the same numbers for p, q, r in any order, and for any of their opposites
///  (2) nothing if and only if turn(p, q, r) is 0
///
/// Not true: that equal points have equal numbers. Other planes through the same point give a
/// multiple of them, and `approx` may differ in its last bits: see reduced().
std::optional<ExactPoint> meet(const Plane& p, const Plane& q, const Plane& r);

/// The same without `approx`, which costs a third of it.
std::optional<ExactPoint> meet_exactly(const Plane& p, const Plane& q, const Plane& r);

/// Divides out common divisors, so that equal points are equal numbers, `approx` included.
///
///  (1) reduced(meet(a, b, c)) and reduced(meet(d, e, f)) are the same if and only if the points
///  are
ExactPoint reduced(const ExactPoint& p);
/// Of reduced points. Not true of others.
bool same_point(const ExactPoint& a, const ExactPoint& b);

/// Sign of a[axis] − b[axis]. For all points:
///
///  (1) compare_coordinate(a, b, i) == −compare_coordinate(b, a, i)
///  (2) a and b are one point if and only if it is 0 for all three axes
///  (3) a < b and b < c: a < c
///
/// Not true: that it is the sign of the difference of `approx`.
int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int axis);
/// From integers alone, by continued fractions, so that no product leaves 128 bits.
int compare_coordinate_exact(const ExactPoint& a, const ExactPoint& b, int axis);

// --- Points and planes ---

/// On which side of `plane` the point lies. For all points p and planes h:
///
///  (1) classify(p, h) == opposite(classify(p, h.opposite()))
///  (2) if p == meet(a, b, c), classify(p, a) == On, and so for b and c
///  (3) it depends on the point alone: classify(p, h) == classify(reduced(p), h)
///  (4) what is On or Below is Below where d is larger by one, and what is On or Above is Above
///      where it is smaller by one
///
/// Not true: that points whose `approx` lies on a plane are On it, or the other way round.
///
/// Requires a plane that meets the range of the lattice (|d| < 2^52); planes that do not are told
/// apart by their box, see polytope.h.
Side classify(const ExactPoint& p, const Plane& plane);

/// From doubles alone: never On, and nothing where they cannot tell.
std::optional<Side> classify_in_doubles(const ExactPoint& p, const Plane& plane);

/// From integers alone: the oracle of the other.
Side classify_exact(const ExactPoint& p, const Plane& plane);

/// classify() of the meeting point of p, q and r, which is known to lie within `most` of `plane`,
/// in units of its normal: n·x − d. The nearer, the cheaper: the determinant is as small, mostly
/// below 2^63, and 64 bits tell it. Requires that p, q and r meet in one point.
///
///  (1) classify_near(p, q, r, h, most) == classify_exact(*meet(p, q, r), h), for each true `most`
///
/// Not true: that it is On, or that anything holds, for a `most` that is too small.
Side classify_near(const Plane& p, const Plane& q, const Plane& r, const Plane& plane, double most);

// --- Directions and lines ---

/// Sign of (n_s × n_t) · n_h. For all planes:
///
///  (1) turn(s, t, h) == turn(t, h, s) == −turn(t, s, h)
///  (2) turn(s, t, h.opposite()) == −turn(s, t, h)
///
/// Not true: that it says where anything lies; distances are not looked at.
int turn(const Plane& s, const Plane& t, const Plane& h);

/// Which of two points on the line of intersection of two planes comes first in direction
/// n_s × n_t: Below if a is before b, On if equal, Above if after. `through_b` is a plane
/// that meets the line in b alone.
///
///  (1) the other way for t and s
///  (2) the same for through_b.opposite(), and for any other plane that meets the line in b alone
///  (3) if a is where g meets the line and b where h does:
///      order_along(s, t, a, h) == opposite(order_along(s, t, b, g))
///
/// Not true: anything of a plane parallel to the line, turn(s, t, through_b) == 0.
Side order_along(const Plane& s, const Plane& t, const ExactPoint& a, const Plane& through_b);

// --- Parallel planes ---

/// Do parallel planes look the same way? Not true of others: there it only says that their normals
/// are less than a right angle apart.
constexpr bool same_direction(const Plane& a, const Plane& b) {
    return std::int64_t{a.nx} * b.nx + std::int64_t{a.ny} * b.ny + std::int64_t{a.nz} * b.nz > 0;
}

/// Of parallel planes that look the same way: the sign of the distance of `b` less that of `a`.
///
///  (1) compare_distances(a, b) == −compare_distances(b, a); 0 if and only if a == b
///  (2) a < b and b < c: a < c
///
/// Not true of planes that look opposite ways, see distance_beyond(); nor that it is the sign of
/// b.d − a.d: normals of parallel planes need not have one length, 2x <= 3 and x <= 1.
int compare_distances(const Plane& a, const Plane& b);

/// Of a plane that is parallel to a facet's, in the same direction (`same`) or not: positive if the
/// facet is below it, 0 if it lies in it, negative above.
///
///  (1) distance_beyond(f, h, same) == −distance_beyond(f, h.opposite(), !same)
int distance_beyond(const Plane& facet, const Plane& plane, bool same);

}  // namespace ncsim::cda
