// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of how many pieces is a part? A program that cuts one free lets it fly.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/cda/triangle_tree.h"
#include "ncsim/cda/vec.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ncsim::verify {

/// One connected piece of material. Pieces that touch in an edge or a corner only are two.
struct Solid {
    std::uint32_t shell = 0;  ///< Its outer surface in the boundary.
    double volume_mm3 = 0.0;  ///< Within that surface; cavities are not taken off.
    cda::Box box;             ///< mm, W
    std::optional<cda::Vec3>
        inner_point;                   ///< Strictly inside; empty if it is too thin to find one.
    std::vector<cda::Origin> origins;  ///< Of its faces, sorted, without the stock's.
};

/// The surface of a part, ready to be asked.
class Solids {
public:
    /// O(n log n) for n faces.
    explicit Solids(const cda::Boundary& boundary);

    /// The largest volume first.
    const std::vector<Solid>& all() const { return solids_; }
    /// Index into all() of the piece that `point` is in; of nested ones the inner one. Expected
    /// O(pieces + log n).
    std::optional<std::size_t> at(cda::Vec3 point) const;

private:
    std::optional<cda::Vec3> point_in(std::size_t solid) const;

    std::unique_ptr<const cda::TriangleMesh> mesh_;      // stays where it is, for surfaces_
    std::vector<std::vector<std::uint32_t>> triangles_;  // of each shell
    std::vector<cda::TriangleTree> surfaces_;            // the same
    std::vector<Solid> solids_;
};

}  // namespace ncsim::verify
