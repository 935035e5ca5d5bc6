// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cells need not be kept in a box: those that another one covers there. In a raster of close
// passes nearly all of them; what is left in a box of the size of the passes is a handful, however
// many pass by.
#pragma once

#include "half_box.h"

#include <cstdint>
#include <span>

namespace ncsim::cda {

/// A plane seen from the centre of a box: n·x <= e for x in half units about the centre.
struct BoxPlane {
    BoxPlane() = default;
    BoxPlane(const Plane& p, const BoxFrame& box)
        : n{static_cast<double>(p.nx), static_cast<double>(p.ny), static_cast<double>(p.nz)},
          e(2.0 * static_cast<double>(p.d) - n[0] * box.centre[0] - n[1] * box.centre[1] -
            n[2] * box.centre[2]),
          exact(&p) {}
    std::array<double, 3> n{};
    double e = 0;
    const Plane* exact = nullptr;
};

enum class Domination : std::uint8_t {
    None,      ///< Or not found.
    Coplanar,  ///< Covered, and both have a facet in one plane there.
    Strict,
};

/// Do all points of a box below `m` lie below `p`? Strict: none of them in p; Coplanar: m and p are
/// one plane. Never claims what is not so. The linear program of a box and a halfspace, a convex
/// function of one multiplier.
Domination implies(const BoxPlane& m, const BoxPlane& p, const std::array<double, 3>& half);

/// Is the part of a cell in a box within another cell? Both are given by the planes that cut the
/// box. Never claims what is not so; may miss what needs two planes at once to be seen. Each plane
/// of the other cell is tried against each of this one: O(planes · planes).
Domination dominated(std::span<const BoxPlane> cell, std::span<const BoxPlane> by,
                     const std::array<double, 3>& half);

/// How far a cell reaches through a box along the axis most of its planes look along, in 16 columns
/// beside each other: what dominates another reaches as far in each. Only to save work.
struct Profile {
    Profile() = default;
    Profile(std::span<const BoxPlane> cell, const std::array<double, 3>& half);
    /// Roughly: may a cell with this profile be covered by one with `other`?
    bool may_be_covered_by(const Profile& other) const;

    std::uint8_t direction = 0;  ///< Twice the axis, plus one for the negative direction.
    std::array<float, 16> reach{};
};

/// Of planes with the same direction: the sign of the distance of `b` less that of `a`. Exact.
int compare_distances(const Plane& a, const Plane& b);

bool same_direction(const Plane& a, const Plane& b);

}  // namespace ncsim::cda
