// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to cells: the convex hull of points on the lattice, and of a body and its
// translate, which needs no hull code.
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

/// On which side of the true hull the quantised one errs: a normal has kNormalBits, so a
/// facet may turn by 2^-24 (6 nm over 100 mm). Outward: no point of the hull is lost. Inward:
/// nothing beyond the hull is gained. Facets whose normal fits (axis-parallel ones and most others
/// that NC programs make) are exact either way.
enum class Rounding : std::uint8_t { Outward, Inward };

/// Convex hull of `points` by Quickhull (in integers; what that cannot decide, by qhull). Nothing
/// if they lie in a plane: such a body removes no volume. Expected O(n log n).
std::optional<Cell> convex_hull(std::span<const LatticePoint> points, const Lattice& lattice,
                                Origin origin, Rounding rounding = Rounding::Outward);

/// A cell that contains the hull of `points` and is nowhere farther from it than `slack` units,
/// with fewer facets: those in nearly one plane become one. Nothing if the points lie in a plane.
/// The order of the points does not matter.
std::optional<Cell> convex_hull_within(std::span<const LatticePoint> points, const Lattice& lattice,
                                       Origin origin, double slack);

/// The plane of a triangle, its normal quantised, moved out as far as it takes for `points` to lie
/// below or on it. Nothing if the corners lie on a line.
std::optional<Plane> plane_above(const std::array<LatticePoint, 3>& triangle,
                                 std::span<const LatticePoint> points);

/// A convex body that moves without turning: made once per tool piece and orientation, swept many
/// times. Source: support functions, h(n) = h_T(n) + max(0, n·t): each facet keeps its normal, and
/// each edge between a facet that goes with the motion and one that goes against it makes one more.
class TranslationSweep {
public:
    /// The hull of `points`, in the frame of the body. Nothing if they lie in a plane.
    static std::optional<TranslationSweep> of(std::span<const LatticePoint> points,
                                              const Lattice& lattice,
                                              Rounding rounding = Rounding::Outward);

    /// Convex hull of the body at `from` and at `to` (which may be equal). Erring on the side
    /// asked for by at most 2^-kNormalBits times the extent of the hull; where the side normals fit
    /// kNormalBits, exact. O(edges of the body · vertices of the body), no allocation but the
    /// result.
    Cell operator()(LatticePoint from, LatticePoint to, Origin origin) const;
    /// Those of that hull, mm, without making it.
    Box bounds(LatticePoint from, LatticePoint to) const;

    /// What an upright body takes away for certain on a closed way round about a middle that it
    /// always has within it: there is no core, so these are the corners' convex hull, from the
    /// highest place of its lower end to the lowest of its upper one. All of it is in the hulls of
    /// the steps. `turn`: corners of the way, its first one last again, at any height. Nothing if
    /// the way is not convex, or there may be a core, or the body has facets that are neither
    /// upright nor level. Exact. O(corners of the body · corners of the way).
    std::optional<Cell> around(std::span<const LatticePoint> turn, Origin origin) const;

private:
    struct Edge {
        std::uint32_t left, right;  ///< Facets on both sides.
        std::uint32_t tail, head;   ///< Vertices, `left` on the left side seen from outside.
    };
    TranslationSweep() = default;
    void add_sides(Cell& cell, LatticePoint from, LatticePoint to) const;
    std::vector<Plane> facets_;
    std::shared_ptr<const FacetNormals> normals_;  // of facets_
    std::vector<Edge> edges_;
    std::vector<LatticePoint> vertices_;
    LatticePoint low_, high_;  // of these
    Lattice lattice_;
    Rounding rounding_ = Rounding::Outward;
};

}  // namespace ncsim::cda
