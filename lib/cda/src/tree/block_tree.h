// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of the tree: a box that is halved where many cells meet. Leaves know the cells whose
// surface passes through them, and of those the planes that do; what another cell of the leaf
// covers is not kept. A node's box shrinks as material goes: what single cells cover from wall to
// wall is cut off for good. A block knows nothing of its neighbours, so blocks are worked on by any
// thread.
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

/// What is known of all cells by number: who made them, and which normals they share.
class CellTable {
public:
    static constexpr std::uint32_t kNoFamily = ~std::uint32_t{0};

    void add(Origin origin, std::int32_t rank, const std::shared_ptr<const FacetNormals>& normals);
    std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
    Origin origin(std::uint32_t cell) const { return cells_[cell].origin; }
    /// Index for normals(), or kNoFamily.
    std::uint32_t family(std::uint32_t cell) const { return cells_[cell].family; }
    const FacetNormals& normals(std::uint32_t family) const { return *families_[family]; }
    std::size_t families() const { return families_.size(); }
    /// The total order of cells: by rank, then by the motion that made them, then by number.
    bool comes_before(std::uint32_t a, std::uint32_t b) const {
        return std::tuple{cells_[a].rank, cells_[a].origin, a} <
               std::tuple{cells_[b].rank, cells_[b].origin, b};
    }
    /// Bytes held.
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

/// A cell on its way into the tree.
struct IncomingCell {
    std::uint32_t number = 0;
    std::span<const Plane> planes;
    const StraightSteps* steps = nullptr;  ///< As the cell has them.
    /// Twice the distance of the planes that are the family's, in their order; beyond everything
    /// where such a plane does not cut the stock.
    std::vector<double> facets;
    std::vector<std::uint16_t> loose;    ///< Indices of the other planes that cut the stock.
    std::array<double, 3> min{}, max{};  ///< Encloses it, in half units.

    /// From its bounds in mm: four half units more for the rounding to millimetres and back.
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
    /// By its box: may it have anything in common with this one?
    bool meets(const BoxFrame& box) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (min[i] > box.centre[i] + box.half[i]) return false;
            if (max[i] < box.centre[i] - box.half[i]) return false;
        }
        return true;
    }
};

/// What all blocks have in common when volumes are asked for.
struct AccountInput {
    std::span<const Plane> stock;
    const CellTable& cells;
    Vec3 centre;         ///< Volumes are summed about it, in lattice units: best near the middle.
    std::uint32_t leaf;  ///< Boxes with more planes are halved.
};

/// What cells of one origin, one after the other, took from a block.
struct Taken {
    Origin origin = kStockOrigin;
    double volume = 0.0;  ///< Cubic units; of a block by itself no volume, only summed up.
    /// Numbers of those that took something, ascending; of cells that took the same, one may stand
    /// for the others.
    std::vector<std::uint32_t> cells;
    /// Where it is one of the steps that the only cell stands for.
    std::optional<std::size_t> step = std::nullopt;
};

class BlockTree {
public:
    explicit BlockTree(const HalfBox& box);

    /// Where material may be.
    HalfBox box() const { return nodes_[0].box(); }
    bool is_empty() const { return nodes_[0].kind == Kind::Empty; }

    /// Takes cells away. Expected O(surface of the cells in the block that is left in the end):
    /// what one of them covers is not looked at for the others. A leaf whose cells are cut by more
    /// than `leaf` planes is split.
    void insert(std::span<const IncomingCell* const> cells, const CellTable& table,
                std::uint32_t leaf);
    /// False: the cell is nowhere near, by its box.
    bool meets(const IncomingCell& cell) const {
        return !is_empty() && cell.meets(BoxFrame(box()));
    }

    /// How much cells would take away, in the order given, if they were inserted now: `taken` for
    /// each origin in turn.
    void account(std::span<const IncomingCell* const> cells, const AccountInput& input,
                 std::vector<Taken>& taken) const;

    /// One cell of a leaf: its number and the planes that cut the leaf (indices for plane()).
    struct Entry {
        std::uint32_t cell;
        std::span<const std::uint32_t> planes;
    };
    /// `index` as in an entry of the cell.
    Plane plane(std::uint32_t cell, std::uint32_t index, const CellTable& table) const;
    std::size_t planes() const { return planes_.size(); }
    /// The entries of a leaf, in one place.
    class LeafCells {
    public:
        std::span<const Entry> entries() const { return entries_; }

    private:
        friend class BlockTree;
        void read(const PackedCells& packed);
        PackedCells::Words words_;
        std::vector<Entry> entries_;
    };

    /// Goes down where `enter` allows it and calls `leaf` for each leaf with material there.
    /// Always in the same order.
    void visit(const std::function<bool(const HalfBox&)>& enter,
               const std::function<void(const HalfBox&, std::span<const Entry>)>& leaf) const;

    /// The cells of the leaf with the point, in units of 2^-15 half units; false if it is empty.
    bool find(const std::array<std::int64_t, 3>& point, LeafCells& cells) const;

    std::size_t nodes() const { return nodes_.size() - 2 * free_children_.size(); }
    /// Bytes held.
    std::size_t memory() const;

private:
    enum class Kind : std::uint32_t { Material, Empty, Inner };
    static constexpr std::uint32_t kMostPlanes = (std::uint32_t{1} << 30) - 1;
    struct Node {
        // Half units of the stock fit.
        std::array<std::int32_t, 3> min{}, max{};
        std::uint32_t first_child = 0;  // Inner: two in a row
        Kind kind : 2 = Kind::Material;
        std::uint32_t limit : 30 = 0;  // Material: planes that may be, where more than `leaf`
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
