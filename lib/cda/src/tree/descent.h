// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simultaneous descent of cells in a block. While boxes are large compared with cells, only boxes
// are compared. In a small box a cell is classified: its *active* planes are the planes that cut
// the box. If a plane has the box above, the cell is not in the box; if no plane is active, the
// cell covers the box. If many planes are active, rows of bounds show which planes and cells are
// redundant (normal_table.h).
//
// Derived classes decide the result for a box: insertion.cpp, account.cpp.
#pragma once

#include "tree/block_tree.h"
#include "tree/domination.h"
#include "tree/normal_table.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Stacks shared by all levels: a level pushes the parts of the upper level's cells in the level's
/// box, and pops them at the end.
class BlockTree::Descent {
protected:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    /// Boxes are not split below this many half units: smaller boxes cannot separate cells that
    /// meet in a line or a point, only multiply them.
    static constexpr std::int64_t kSmallestBox = 2048;
    /// Successive splits without progress before a list is left unsplit.
    static constexpr int kFruitlessSplits = 3;
    /// With more than kFewCells cells only boxes are compared, if the box of the node is larger
    /// than kLargeBox times the cell's least extent, and halving reduces the cells sufficiently.
    static constexpr std::size_t kFewCells = 8;
    static constexpr double kLargeBox = 0.4;

    // A plane with a normal of a family.
    struct Facet {
        double d2 = 0;                // twice the distance
        std::uint32_t direction = 0;  // in the views
        std::uint32_t plane = 0;      // index in the incoming cell, or in the tree's plane store
    };
    // A plane with any other normal.
    struct LoosePlane {
        std::uint32_t pool = 0;
    };
    struct LooseEntry {
        HalfPlane half_plane;
        std::uint32_t plane = 0;  // index in the incoming cell, or in the tree's plane store
    };
    // First index and number in a stack.
    struct Range {
        std::uint32_t first = 0, count = 0;
    };
    struct Item {
        const IncomingCell* cell = nullptr;  // null: the cell was in the tree before
        std::uint32_t number = 0;
        std::uint32_t turn = 0;   // a cell of an earlier turn keeps its space against later turns
        std::uint32_t first = 0;  // offset of the cell's planes among all incoming planes
        bool is_classified = false;  // false: only the box of the cell is known
        Range facets, loose;
    };
    // Heights of the stacks.
    struct Level {
        std::size_t items = 0, facets = 0, loose = 0, pool = 0;
    };
    struct Cut {
        std::size_t axis = 3;  // 3: none
        bool parts = false;    // less than half of the cells are in both halves
    };
    enum class Place : std::uint8_t { Outside, Covers, Cuts };

    Descent() = default;
    ~Descent() = default;

    // Clears the stacks and pushes the cells.
    void begin(const BlockTree& tree, std::span<const IncomingCell* const> cells,
               const CellTable& table);
    Level level() const { return {items_.size(), facets_.size(), loose_.size(), pool_.size()}; }
    void restore(const Level& level);
    // Pushes the items [begin, end) whose boxes meet the box of the frame. Returns the item whose
    // middle is nearest to the box, which may cover the whole box; kNone if no item has a box.
    std::size_t push_items_in(const BoxFrame& frame, std::size_t begin, std::size_t end);
    // Pushes the cells of a leaf.
    void push_leaf(std::uint32_t number);
    // Finds the planes of an item of the level above that are active in the box, and pushes the
    // planes onto the stacks. The plane most likely to have a smaller box above is first.
    Place classify(const BoxFrame& frame, Item& item);
    // True if the item has not been classified and is so small compared with a box of this extent
    // that the comparison of boxes suffices.
    static bool is_small_for(double longest, const Item& item) {
        return !item.is_classified && longest > kLargeBox * item.cell->least_extent();
    }
    // Chooses the axis whose halves together have the fewest items from `begin` on, by the boxes of
    // items that have not been classified; no axis if the number is not much smaller.
    Cut cut_of_boxes(const HalfBox& box, std::size_t begin) const;
    // Chooses the axis whose cut divides the cells best; the longest axis among equals.
    Cut best_cut(const HalfBox& box, std::size_t begin);

    // Drops items from `begin` on that another item of the same or an earlier turn covers in the
    // box. In redundant.cpp.
    void drop_redundant(const BoxFrame& frame, std::size_t begin);

    // The normals of a family with the range of the current box.
    struct View {
        const FacetNormals* normals = nullptr;
        std::uint32_t first = 0;  // first direction
        std::uint64_t seen = 0;   // the box for which the ranges are valid
    };
    const View& view_in(std::uint32_t family, const BoxFrame& frame);
    // Starts a new box: invalidates all views.
    void start_box() { ++box_; }
    // Returns the upper end of the box along a normal, in half units times the normal's length.
    double end_along(const Facet& facet) const { return high_[facet.direction]; }
    std::uint32_t family_of(const Item& item) const { return table_->family(item.number); }
    // True if `a` owns the wall where both cells have a facet in one plane.
    bool comes_before(const Item& a, const Item& b) const {
        return a.turn != b.turn ? a.turn < b.turn : table_->comes_before(a.number, b.number);
    }

    std::span<Facet> facets_of(const Item& item) {
        return std::span(facets_).subspan(item.facets.first, item.facets.count);
    }
    std::span<const Facet> facets_of(const Item& item) const {
        return std::span(facets_).subspan(item.facets.first, item.facets.count);
    }
    std::span<LoosePlane> loose_of(const Item& item) {
        return std::span(loose_).subspan(item.loose.first, item.loose.count);
    }
    std::span<const LoosePlane> loose_of(const Item& item) const {
        return std::span(loose_).subspan(item.loose.first, item.loose.count);
    }
    const LooseEntry& entry(LoosePlane plane) const { return pool_[plane.pool]; }
    Plane exact(const Item& item, std::uint32_t plane) const {
        return item.cell ? item.cell->planes[plane] : tree_->plane(item.number, plane, *table_);
    }
    // Returns the number of active planes of the items from `begin` on.
    std::size_t load(std::size_t begin) const;

    const BlockTree* tree_ = nullptr;
    const CellTable* table_ = nullptr;
    std::vector<Item> items_;
    std::size_t incoming_planes_ = 0;  // planes of all incoming cells
    PackedCells::Words words_;         // the current leaf

private:
    // A loose plane in coordinates of the current box.
    struct BoxedPlane {
        ScaledNormal normal;
        float e = 0;
        LoosePlane plane;
    };
    // An item that is compared with the rest. Row numbers are item numbers.
    struct Candidate {
        std::size_t item = 0;
        float reach = 0;                         // sum over all normals, each limited to the box
        float depth = 0;                         // depth of the box's middle in the cell
        std::size_t planes = 0, planes_end = 0;  // in seen_planes_
        Range loose;                             // in boxed_planes_
    };

    std::uint32_t view_of(std::uint32_t family);
    bool classify_planes(const BoxFrame& frame, const Item& item);
    bool narrow_planes(const BoxFrame& frame, const Item& item);
    void narrow_bounds(const BoxFrame& box, const BoxFrame& half);
    bool make_table(const BoxFrame& frame, std::span<const Item> items);
    void fill_rows(const BoxFrame& frame, Item& item, Candidate& candidate);
    std::size_t push_planes(const Item& item, const Candidate& candidate);
    Domination covered(const Candidate& a, const Candidate& b, std::span<const Item> items) const;
    Domination covered(const Candidate& a, const Item& item, const BoxedPlane& p,
                       const Item& its_item) const;

    std::vector<Facet> facets_;
    std::vector<LoosePlane> loose_;
    std::vector<LooseEntry> pool_;

    // Directions of all families met, family by family, and the range of a view's box along each
    // direction, in half units times the length of the normal.
    std::vector<View> views_;
    std::vector<std::uint32_t> view_of_family_;
    std::vector<double> low_, high_;
    std::vector<double> half_low_, half_high_;  // the same for a half of the box
    std::uint64_t box_ = 0;

    // Data of drop_redundant() for the current box.
    std::vector<std::uint32_t> directions_;  // directions of facets
    std::vector<std::uint32_t> column_of_;   // per direction; kNone if there is no column
    NormalTable normals_;
    std::vector<ScaledNormal> scaled_;  // by column
    // rows: own planes; planes with bounds; thresholds for comparison
    std::vector<float> own_, reach_, limit_;
    std::vector<BoxedPlane> boxed_planes_;
    SeenPlanes seen_planes_;
    std::vector<Candidate> candidates_;
    std::vector<std::size_t> kept_;
};

}  // namespace ncsim::cda
