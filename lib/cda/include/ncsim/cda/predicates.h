// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every geometric decision of the kernel, answered exactly. Points are where three planes
// meet and are kept as integers; nothing here depends on a tolerance.
#pragma once

#include "ncsim/cda/int128.h"
#include "ncsim/cda/plane.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <optional>

namespace ncsim::cda {

/// Below is the inner side of a halfspace: n·x < d.
enum class Side : std::int8_t { Below = -1, On = 0, Above = 1 };

constexpr Side opposite(Side side) {
    return static_cast<Side>(-static_cast<int>(side));
}

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
std::optional<ExactPoint> meet(const Plane& p, const Plane& q, const Plane& r);

/// The same without `approx`, which costs a third of it.
std::optional<ExactPoint> meet_exactly(const Plane& p, const Plane& q, const Plane& r);

/// On which side of `plane` the point lies. For all points p and planes h:
///
///  (1) classify(p, h) == opposite(classify(p, h.opposite()))
///  (2) if p == meet(a, b, c), classify(p, a) == On, and so for b and c
///
/// Filtered: doubles first, integers where they cannot tell. Requires a plane that meets the range
/// of the lattice (|d| < 2^52); planes that do not are told apart by their box, see polytope.h.
Side classify(const ExactPoint& p, const Plane& plane);

/// The same answers from integers alone: the oracle of the filter.
Side classify_exact(const ExactPoint& p, const Plane& plane);

/// classify() of the meeting point of p, q and r, which is known to lie within `most` of `plane`,
/// in units of its normal: n·x − d. The nearer, the cheaper: the determinant is as small, mostly
/// below 2^63, and 64 bits tell it. Requires that p, q and r meet in one point.
Side classify_near(const Plane& p, const Plane& q, const Plane& r, const Plane& plane, double most);

/// Divides out common divisors, so that equal points are equal numbers.
ExactPoint reduced(const ExactPoint& p);
/// Of reduced points.
bool same_point(const ExactPoint& a, const ExactPoint& b);

/// Which of two points on the line of intersection of two planes comes first in direction
/// n_s × n_t: Below if a is before b, On if equal, Above if after. `through_b` is a plane
/// that meets the line in b alone.
Side order_along(const Plane& s, const Plane& t, const ExactPoint& a, const Plane& through_b);

/// Sign of n·v of a direction given by two planes: (n_s × n_t) · n_h.
int turn(const Plane& s, const Plane& t, const Plane& h);

}  // namespace ncsim::cda
