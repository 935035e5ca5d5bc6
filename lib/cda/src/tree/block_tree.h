// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of the tree: a box that is halved where many cells meet. Leaves hold the cells whose
// surface passes through the leaf, with the planes that cut the leaf; cells covered by another cell
// of the leaf are not kept. A node's box shrinks as material is removed: a slab that a single cell
// covers from wall to wall is cut off permanently. Blocks are independent, so any thread may
// process a block.
#pragma once

#include "ncsim/cda/cell.h"

#include "exact/half_box.h"
#include "tree/plane_store.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace ncsim::cda {

/// Table of all cells by number: origin, rank and family. Cells with the same FacetNormals object
/// form a family.
class CellTable {
public:
    static constexpr std::uint32_t kNoFamily = ~std::uint32_t{0};

    void add(Origin origin, std::int32_t rank, const std::shared_ptr<const FacetNormals>& normals);
    std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
    Origin origin(std::uint32_t cell) const { return cells_[cell].origin; }
    /// Returns an index for normals(), or kNoFamily.
    std::uint32_t family(std::uint32_t cell) const { return cells_[cell].family; }
    const FacetNormals& normals(std::uint32_t family) const { return *families_[family]; }
    std::size_t families() const { return families_.size(); }
    /// True if `a` is before `b` in the total order of cells: by rank, then origin, then number.
    bool comes_before(std::uint32_t a, std::uint32_t b) const {
        return std::tuple{cells_[a].rank, cells_[a].origin, a} <
               std::tuple{cells_[b].rank, cells_[b].origin, b};
    }
    /// Returns the memory in bytes.
    std::size_t memory() const;

private:
    struct Entry {
        Origin origin;
        std::uint32_t family;
        std::int32_t rank;
    };
    std::vector<Entry> cells_;
    std::vector<std::shared_ptr<const FacetNormals>> families_;
    std::unordered_map<const FacetNormals*, std::uint32_t> family_of_;
};

/// A cell to be inserted into the tree.
struct IncomingCell {
    std::uint32_t number = 0;
    std::span<const Plane> planes;
    const StraightSteps* steps = nullptr;  ///< Same as Cell::steps.
    /// Twice the distances of the planes with shared normals, in the order of the normals; infinity
    /// if the plane does not cut the stock.
    std::vector<double> facets;
    std::vector<std::uint16_t> loose;    ///< Indices of the remaining planes that cut the stock.
    std::array<double, 3> min{}, max{};  ///< Box around the cell, in half units.

    /// Sets the box from bounds in mm, extended by four half units for the rounding to millimetres
    /// and back.
    void enclose(const Box& bounds, double unit_mm) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int axis = static_cast<int>(i);
            min[i] = 2.0 * bounds.min[axis] / unit_mm - 4.0;
            max[i] = 2.0 * bounds.max[axis] / unit_mm + 4.0;
        }
    }
    double least_extent() const {
        return std::min({max[0] - min[0], max[1] - min[1], max[2] - min[2]});
    }
    /// False if the cell's box and `box` have no common point.
    bool meets(const BoxFrame& box) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (min[i] > box.centre[i] + box.half[i]) return false;
            if (max[i] < box.centre[i] - box.half[i]) return false;
        }
        return true;
    }
};

/// Input of accounts, the same for all blocks.
struct AccountInput {
    std::span<const Plane> stock;
    const CellTable& cells;
    /// Reference point of volumes in lattice units; rounding is smallest near the middle.
    Vec3 centre;
    std::uint32_t leaf;  ///< Boxes with more planes are halved.
};

/// Volume that consecutive cells of one origin removed from a block.
struct RemovedByTurn {
    Origin origin = kStockOrigin;
    double volume = 0.0;  ///< Cubic units; a volume only as a sum over all blocks.
    /// Numbers of the cells that removed volume, ascending; of cells that removed the same volume,
    /// one may represent all.
    std::vector<std::uint32_t> cells;
    /// Index of the step, if this is one of the steps that the only cell represents.
    std::optional<std::size_t> step = std::nullopt;
};

/// The tree of a block.
class BlockTree {
public:
    explicit BlockTree(const HalfBox& box);

    /// Returns the box that encloses the material.
    HalfBox box() const { return nodes_[0].box(); }
    bool is_empty() const { return nodes_[0].kind == Kind::Empty; }

    /// Removes cells. A leaf whose cells have more than `leaf` planes in the leaf is split.
    /// Cost: expected O(surface of the cells that remains in the block): parts of cells that
    /// another cell covers are skipped.
    void insert(std::span<const IncomingCell* const> cells, const CellTable& table,
                std::uint32_t leaf);
    /// False if the cell's box is outside of the block's box.
    bool meets(const IncomingCell& cell) const {
        return !is_empty() && cell.meets(BoxFrame(box()));
    }

    /// Computes the volumes that `cells` would remove if inserted in the given order: `taken` per
    /// origin in turn.
    void account(std::span<const IncomingCell* const> cells, const AccountInput& input,
                 std::vector<RemovedByTurn>& removed) const;

    /// A cell of a leaf: the number and the planes that cut the leaf (indices for plane()).
    struct Entry {
        std::uint32_t cell;
        std::span<const std::uint32_t> planes;
    };
    /// Returns a plane; `index` is from an entry of the cell.
    Plane plane(std::uint32_t cell, std::uint32_t index, const CellTable& table) const;
    std::size_t planes() const { return planes_.size(); }
    /// The entries of a leaf in contiguous memory.
    class LeafCells {
    public:
        std::span<const Entry> entries() const { return entries_; }

    private:
        friend class BlockTree;
        void read(const PackedCells& packed);
        PackedCells::Words words_;
        std::vector<Entry> entries_;
    };

    /// Visits the nodes that `enter` accepts and calls `leaf` for each leaf with material. The
    /// order is always the same.
    void visit(const std::function<bool(const HalfBox&)>& enter,
               const std::function<void(const HalfBox&, std::span<const Entry>)>& leaf) const;

    /// Finds the cells of the leaf with the point, in units of 2^-15 half units; false if the leaf
    /// is empty.
    bool find(const std::array<std::int64_t, 3>& point, LeafCells& cells) const;

    std::size_t nodes() const { return nodes_.size() - 2 * free_children_.size(); }
    /// Returns the memory in bytes.
    std::size_t memory() const;

private:
    enum class Kind : std::uint32_t { Material, Empty, Inner };
    static constexpr std::uint32_t kMostPlanes = (std::uint32_t{1} << 30) - 1;
    struct Node {
        // Half units of the stock fit 32 bits.
        std::array<std::int32_t, 3> min{}, max{};
        std::uint32_t first_child = 0;  // Inner: two consecutive nodes
        Kind kind : 2 = Kind::Material;
        std::uint32_t limit : 30 = 0;  // Material: planes allowed, if more than `leaf`
        PackedCells cells;             // Material

        HalfBox box() const;
        void set_box(const HalfBox& box);
    };
    static constexpr std::size_t kHead = PackedCells::kHead;
    static constexpr std::uint16_t kLoose = PlaneStore::kLoose;
    class Accounting;
    class Descent;
    class Insertion;

    void become_empty(std::uint32_t number);
    void enclose_children(std::uint32_t number);
    void release(std::uint32_t number);
    void drop_unused_planes();

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> free_children_;
    PlaneStore planes_;
    std::size_t planes_after_drop_ = 0;
};

}  // namespace ncsim::cda
