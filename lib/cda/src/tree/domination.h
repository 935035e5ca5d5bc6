// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cells need not be kept in a box: those that another one covers there. In a raster of close
// passes nearly all of them; what is left in a box of the size of the passes is a handful, however
// many pass by.
#pragma once

#include "exact/half_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ncsim::cda {

/// A plane seen from the centre of a box whose half extents are taken for one: n·x <= e, and the
/// box is -1 <= x_i <= 1.
struct BoxPlane {
    BoxPlane() = default;
    BoxPlane(const HalfPlane& p, const Plane& same, const BoxFrame& box)
        : e(-Sight(box, p).above), exact(&same) {
        for (std::size_t i = 0; i < 3; ++i) {
            n[i] = p.normal(i) * box.half[i];
            inverse[i] = n[i] == 0.0 ? 0.0 : 1.0 / n[i];
            size += std::abs(n[i]);
        }
    }
    std::array<double, 3> n{}, inverse{};
    double size = 0;  ///< How far the box reaches along n.
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
Domination implies(const BoxPlane& m, const BoxPlane& p);

/// Is the part of a cell in a box within another cell? Both are given by the planes that cut the
/// box. Never claims what is not so; may miss what needs two planes at once to be seen. Each plane
/// of the other cell is tried against each of this one: O(planes · planes).
Domination dominated(std::span<const BoxPlane> cell, std::span<const BoxPlane> by);

/// How far a cell reaches through a box along the axis most of its planes look along, in 16 columns
/// beside each other: what dominates another reaches as far in each. Only to save work.
struct Profile {
    Profile() = default;
    explicit Profile(std::span<const BoxPlane> cell);
    /// Roughly: may a cell with this profile be covered by one with `other`?
    bool may_be_covered_by(const Profile& other) const;

    std::uint8_t direction = 0;  ///< Twice the axis, plus one for the negative direction.
    std::array<float, 16> reach{};
};

}  // namespace ncsim::cda
