// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells from points: the convex hull of lattice points, and the sweep of a body along a
// translation, which needs no hull algorithm.
#pragma once

#include "ncsim/cda/cell.h"
#include "ncsim/cda/lattice.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Side of the true hull on which the quantised hull errs. A normal has kNormalBits, so a facet may
/// turn by 2^-24 (6 nm over 100 mm). Outward: the result contains the hull. Inward: the hull
/// contains the result. Facets whose normals fit kNormalBits (axis-parallel facets and most facets
/// that NC programs make) are exact in both cases.
enum class Rounding : std::uint8_t { Outward, Inward };

/// Returns the convex hull of `points` by Quickhull in integers, or by qhull if the integer
/// algorithm cannot decide; empty if the points lie in a plane, because a flat body removes no
/// volume.
/// Cost: expected O(n log n).
std::optional<Cell> convex_hull(std::span<const LatticePoint> points, const Lattice& lattice,
                                Origin origin, Rounding rounding = Rounding::Outward);

/// Returns a cell with fewer facets that contains the hull of `points` and is nowhere farther from
/// the hull than `slack` units: facets in nearly one plane are merged. Empty if the points lie in a
/// plane. The order of the points does not matter.
std::optional<Cell> convex_hull_within(std::span<const LatticePoint> points, const Lattice& lattice,
                                       Origin origin, double slack);

/// Returns the plane of a triangle with quantised normal, moved out until all `points` lie below or
/// on the plane; empty if the corners lie on a line.
std::optional<Plane> plane_above(const std::array<LatticePoint, 3>& triangle,
                                 std::span<const LatticePoint> points);

/// A convex body that moves without rotation. Built once per tool piece and orientation, swept many
/// times. Source: support functions, h(n) = h_T(n) + max(0, n·t). Each facet keeps the normal; each
/// edge between a facet that faces forward and a facet that faces backward adds a facet.
class TranslationSweep {
public:
    /// Returns the sweep of the hull of `points`, in the frame of the body; empty if the points lie
    /// in a plane.
    static std::optional<TranslationSweep> of(std::span<const LatticePoint> points,
                                              const Lattice& lattice,
                                              Rounding rounding = Rounding::Outward);

    /// Returns the convex hull of the body at `from` and at `to` (which may be equal). The error is
    /// on the side given by `rounding`, at most 2^-kNormalBits times the extent of the hull; exact
    /// where the side normals fit kNormalBits.
    /// Cost: O(edges of the body · vertices of the body); allocates only the result.
    Cell operator()(LatticePoint from, LatticePoint to, Origin origin) const;
    /// Returns the bounds (mm) of the hull that operator() returns, without the hull.
    Box bounds(LatticePoint from, LatticePoint to) const;

    /// Returns a cell that an upright body certainly removes on a closed path around a centre that
    /// the body always covers, so no core remains. The cell is the convex hull of the path's
    /// corners, from the highest position of the body's lower end to the lowest position of the
    /// upper end. The hulls of the steps contain the cell. `turn`: corners of the path at any
    /// height, the first corner repeated at the end. Exact.
    /// Returns: empty if the path is not convex, if a core may remain, or if the body has facets
    /// that are neither upright nor level.
    /// Cost: O(corners of the body · corners of the path).
    std::optional<Cell> around(std::span<const LatticePoint> turn, Origin origin) const;

private:
    struct Edge {
        std::uint32_t left, right;  ///< Facets on both sides.
        std::uint32_t tail, head;   ///< Vertices; `left` is on the left side seen from outside.
    };
    TranslationSweep() = default;
    void add_sides(Cell& cell, LatticePoint from, LatticePoint to) const;
    std::vector<Plane> facets_;
    std::shared_ptr<const FacetNormals> normals_;  // normals of facets_
    std::vector<Edge> edges_;
    std::vector<LatticePoint> vertices_;
    LatticePoint low_, high_;  // bounds of vertices_
    Lattice lattice_;
    Rounding rounding_ = Rounding::Outward;
};

}  // namespace ncsim::cda
