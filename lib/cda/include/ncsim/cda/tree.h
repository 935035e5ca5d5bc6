// SPDX-License-Identifier: GPL-3.0-or-later
//
// The octree of Convex Difference Aggregates: the same aggregate as flat.h, P \ (N1 ∪ … ∪ Nn),
// without zero cells and without its quadratic cost. docs/cda.md, "The tree".
#pragma once

#include "ncsim/cda/workpiece.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::cda {

struct ConvexPolygon;
struct Fragment;

/// What work was done, counted: the same on every machine.
struct TreeCounts {
    std::uint64_t cells = 0;             ///< Kept: not outside of the stock.
    std::uint64_t planes = 0;            ///< Of those, without the ones all of the stock satisfies.
    std::uint64_t nodes = 0;             ///< Alive now.
    std::uint64_t leaves_evaluated = 0;  ///< After refinement, for one boundary.
    std::uint64_t facets_tested = 0;     ///< Polygons of facets in leaves.
    std::uint64_t facets_alive = 0;      ///< Of those, with something left.
    std::uint64_t fragments = 0;         ///< Convex pieces handed to the stitching.
};

/// How the tree works; none of it changes a result.
struct TreeParameters {
    std::uint32_t insertion_leaf = 24;  ///< Cells in a leaf before it is split while cutting.
    std::uint32_t evaluation_leaf = 8;  ///< Cells in a leaf before it is refined for evaluation.
    std::uint32_t threads = 0;          ///< That evaluate; 0: as many as the machine has.
};

class TreeCda final : public WorkpieceModel {
public:
    explicit TreeCda(TreeParameters parameters = {});
    TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters = {});

    std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                           const Lattice& lattice) const override;
    /// Expected O(surface of the cell), whatever was cut before, plus the evaluation of what it
    /// overlaps: the price of knowing the volume.
    double subtract(const Cell& cell) override;
    /// The same without.
    void subtract_unmeasured(const Cell& cell) override;
    void render(FacetCanvas& canvas) const override;
    std::unique_ptr<WorkpieceModel> clone() const override;
    double volume() const override;
    Boundary boundary() const override;
    bool contains(Vec3 point) const override;

    /// Volume (mm³) that `cell` has in common with the part; exactly 0 if they touch at most.
    double common_volume(const Cell& cell) const;

    const Lattice& lattice() const { return lattice_; }
    /// Of the cutting so far and of the last boundary().
    const TreeCounts& counts() const { return counts_; }

private:
    // Corners at odd numbers of half units, so that no facet with whole coordinates ever lies on a
    // face of a box.
    struct HalfBox {
        std::array<std::int64_t, 3> min{}, max{};  // in half units
    };
    struct StoredCell {
        std::uint32_t begin = 0, end = 0;  // in planes_
        Origin origin = kStockOrigin;
    };
    enum class NodeKind : std::uint8_t { Material, Empty, Inner };
    struct Node {
        NodeKind kind = NodeKind::Material;
        std::uint32_t first_child = 0;     // Inner: eight in a row
        std::vector<std::uint32_t> cells;  // Material: what may cut it
    };
    class Evaluation;
    struct Task {
        std::uint32_t node;
        HalfBox box;
    };

    static HalfBox child_box(const HalfBox& box, std::uint32_t child);
    std::span<const Plane> planes_of(std::uint32_t cell) const;
    bool comes_before(std::uint32_t a, std::uint32_t b) const;
    std::optional<std::uint32_t> store(const Cell& cell);
    void insert(std::uint32_t node, const HalfBox& box, std::uint32_t cell,
                std::size_t active_begin);
    void split(std::uint32_t node, const HalfBox& box);
    void release(std::uint32_t node);
    std::uint32_t new_children();
    double volume_below(const ConvexPolygon& piece, bool is_wall) const;
    double evaluated_volume(const std::vector<Plane>* window) const;
    std::vector<Fragment> fragments() const;
    std::vector<Task> tasks() const;
    void for_each_task(std::size_t tasks, const std::function<void(std::size_t)>& work) const;

    TreeParameters parameters_;
    Lattice lattice_;
    Cell stock_;
    Vec3 centre_;  // of the stock, in units
    std::vector<Plane> stock_planes_;
    HalfBox root_box_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> free_children_;
    std::vector<StoredCell> cells_;
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> active_;  // stack of insert()
    mutable TreeCounts counts_;
    // Of what is there now, once somebody asked: by volume() or on the way to boundary().
    mutable std::optional<double> volume_;
};

}  // namespace ncsim::cda
