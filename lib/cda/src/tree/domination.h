// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells that need not be kept in a box because another cell covers them there. In a raster of close
// passes most cells are covered: a box of the size of the passes keeps a handful of cells,
// independent of the number of passes.
#pragma once

#include "exact/half_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ncsim::cda {

/// A plane in coordinates in which the box is -1 <= x_i <= 1: n·x <= e.
struct BoxPlane {
    BoxPlane() = default;
    BoxPlane(const HalfPlane& p, const Plane& same, const BoxFrame& box)
        : e(-BoxHeight(box, p).above), exact(&same) {
        for (std::size_t i = 0; i < 3; ++i) {
            n[i] = p.normal(i) * box.half[i];
            inverse[i] = n[i] == 0.0 ? 0.0 : 1.0 / n[i];
            size += std::abs(n[i]);
        }
    }
    std::array<double, 3> n{}, inverse{};
    double size = 0;  ///< Reach of the box along n.
    double e = 0;
    const Plane* exact = nullptr;
};

/// Result of containment tests within a box, in ascending order of strength.
enum class Domination : std::uint8_t {
    None,      ///< Not covered, or not decided.
    Coplanar,  ///< Covered, and both have a facet in one plane there.
    Strict,
};

/// Decides if all points of a box below `m` are below `p`. Strict: no such point lies in the plane
/// `p`. Coplanar: m and p are the same plane. A positive answer is exact; None may be wrong. Solves
/// the linear program of a box and a halfspace, a convex function of one multiplier.
Domination implies(const BoxPlane& m, const BoxPlane& p);

/// Decides if the part of a cell in a box is within a second cell. Both cells are given by the
/// planes that cut the box. A positive answer is exact; None may be wrong if the proof needs two
/// planes at once. Cost: O(planes · planes), because each plane of the second cell is tested
/// against each plane of the first.
Domination dominated(std::span<const BoxPlane> cell, std::span<const BoxPlane> by);

}  // namespace ncsim::cda
