// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface in a leaf as convex polygons, in doubles. Faster than evaluate(), and without the
// topology that stitching needs; for pictures.
#pragma once

#include "ncsim/cda/surface_recorder.h"

#include "polytope/facet_region.h"
#include "tree/block_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Computes polygons leaf by leaf; keeps its memory between leaves.
class LeafSurface {
public:
    using Entry = BlockTree::Entry;

    /// Requires: `stock` and `table` outlive the object.
    LeafSurface(std::span<const Plane> stock, const CellTable& table)
        : all_stock_(stock), table_(table) {}

    /// Reads a leaf and returns a hash of its box and cells.
    SurfaceRecorder::Hash read(const BlockTree& tree, const HalfBox& box,
                               std::span<const Entry> entries);
    /// Adds the polygons of the leaf read last. `unit_mm`: lattice unit.
    void add_polygons(const RecordGrid& grid, double unit_mm, SurfaceRecorder::Polygons& polygons);

private:
    // A cell with a surface in the leaf.
    struct LocalCell {
        std::uint32_t number = 0;
        std::size_t first = 0, count = 0;  // in planes_
    };

    std::span<const Plane> planes_of(const LocalCell& cell) const {
        return std::span(planes_).subspan(cell.first, cell.count);
    }
    bool remove(const Plane& plane, std::size_t other, std::size_t self);

    std::span<const Plane> all_stock_;
    const CellTable& table_;
    HalfBox box_;
    std::vector<Plane> stock_, planes_;
    std::vector<LocalCell> cells_;
    std::vector<const Plane*> cuts_;
    std::vector<Vec3> corners_;
    FacetRegion facet_;
};

}  // namespace ncsim::cda
