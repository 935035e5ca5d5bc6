// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connected pieces of a part. A piece that a program cuts free can fly off.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/base/triangle_tree.h"
#include "ncsim/base/vec3.h"
#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// Connected piece of material. Pieces that touch only along an edge or at a vertex are separate.
struct Solid {
    std::uint32_t shell = 0;           ///< Outer surface in the boundary.
    double volume_mm3 = 0.0;           ///< Volume within the outer surface, including cavities.
    Box box;                           ///< mm, W.
    std::optional<Vec3> inner_point;   ///< Strictly inside; empty if the piece is too thin.
    std::vector<cda::Origin> origins;  ///< Origins of the faces, sorted, without the stock's.
};

/// Surface of a part with search structures for its pieces.
class Solids {
public:
    /// Finds the pieces of `boundary`.
    /// Cost: O(n log n) for n faces.
    explicit Solids(const cda::Boundary& boundary);

    /// Returns the pieces, the largest volume first.
    const std::vector<Solid>& all() const { return solids_; }
    /// Returns the index into all() of the piece that contains `point`; the innermost of nested
    /// pieces.
    /// Cost: expected O(pieces + log n).
    std::optional<std::size_t> at(Vec3 point) const;

private:
    std::optional<Vec3> point_in(std::size_t solid) const;

    // on the heap, so that pointers of surfaces_ stay valid
    std::unique_ptr<const TriangleMesh> mesh_;
    std::vector<std::vector<std::uint32_t>> triangles_;  // by shell
    std::vector<TriangleTree> surfaces_;                 // by shell
    std::vector<Solid> solids_;
};

}  // namespace ncsim::verify
