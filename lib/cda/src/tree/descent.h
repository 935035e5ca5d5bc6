// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells on their way down a block, all together. Where boxes are large beside the cells, only boxes
// are compared. A cell in a small box is looked at: it has there the planes that are *active*,
// those that cut the box. A plane that has the box above it ends the way (the cell is not here);
// when no plane is left, the cell covers the box. Where many are left, rows of bounds tell which
// planes and which cells are not needed beside others (normal_table.h).
//
// What becomes of a box is for those to say who go down: insertion.cpp, account.cpp.
#pragma once

#include "tree/block_tree.h"
#include "tree/domination.h"
#include "tree/normal_table.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::cda {

/// Stacks that all levels share: a level adds what is left of the cells of the level above in its
/// box, and takes it away again.
class BlockTree::Descent {
protected:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    /// Boxes are not split below this many half units: cells that meet in a line or a point cannot
    /// be told apart by smaller boxes, only multiplied.
    static constexpr std::int64_t kSmallestBox = 2048;
    /// Splits in a row that part nothing before a list is left as it is.
    static constexpr int kFruitlessSplits = 3;
    /// Of more than a few cells only the boxes are looked at while the box of the node is larger
    /// than this share of their least extent, if halves of it have less than so many times as many
    /// of them, in sum.
    static constexpr std::size_t kFewCells = 8;
    static constexpr double kLargeBox = 0.4;

    // A plane whose normal is one of a family's.
    struct Facet {
        double d2 = 0;                // twice the distance
        std::uint32_t direction = 0;  // in the views
        std::uint32_t plane = 0;      // of the incoming cell; else as stored
    };
    // Any other.
    struct Loose {
        std::uint32_t pool = 0;
    };
    struct LooseEntry {
        HalfPlane half_plane;
        std::uint32_t plane = 0;  // of the incoming cell; else as stored
    };
    // Where they begin in the stacks, and how many.
    struct Range {
        std::uint32_t first = 0, count = 0;
    };
    struct Item {
        const IncomingCell* cell = nullptr;  // null: was in the tree before
        std::uint32_t number = 0;
        std::uint32_t turn = 0;     // who came earlier yields nothing to who came later
        std::uint32_t first = 0;    // of the planes of incoming cells, counted through
        bool is_looked_at = false;  // else nothing but the box of the cell is known
        Range facets, loose;
    };
    // How high the stacks are.
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

    // Empty stacks, and on them the cells.
    void begin(const BlockTree& tree, std::span<const IncomingCell* const> cells,
               const CellTable& table);
    Level level() const { return {items_.size(), facets_.size(), loose_.size(), pool_.size()}; }
    void return_to(const Level& level);
    // Adds those of the items [begin, end) whose boxes meet that of the frame. Which of them has it
    // nearest to its middle, and so may cover all of it; kNone if none was looked at by its box.
    std::size_t take_those_in(const BoxFrame& frame, std::size_t begin, std::size_t end);
    // Adds the cells of a leaf.
    void take_out(std::uint32_t number);
    // Of an item of the level above, what it has in the box, at the end of the stacks; first what
    // is most likely to be above a smaller box.
    Place look(const BoxFrame& frame, Item& item);
    // Of a cell that was not looked at: is it so small beside a box of this extent that the box of
    // the cell tells enough?
    static bool is_small_for(double longest, const Item& item) {
        return !item.is_looked_at && longest > kLargeBox * item.cell->least_extent();
    }
    // Along the axis whose halves have the fewest items from `begin` on, in sum, by the boxes of
    // those that were not looked at; none if that is not much fewer.
    Cut cut_of_boxes(const HalfBox& box, std::size_t begin) const;
    // Along the axis that parts the cells best; the longest of those that do as well.
    Cut best_cut(const HalfBox& box, std::size_t begin);

    // Of items from `begin` on, keeps what no other one of its turn or an earlier one covers in the
    // box. In redundant.cpp.
    void drop_redundant(const BoxFrame& frame, std::size_t begin);

    // The normals of a family seen from the box at hand.
    struct View {
        const FacetNormals* normals = nullptr;
        std::uint32_t first = 0;  // direction
        std::uint64_t seen = 0;   // for which box
    };
    const View& see(std::uint32_t family, const BoxFrame& frame);
    // Every other box is another one.
    void turn_to_another_box() { ++box_; }
    // Where the box at hand ends along a normal, in half units times its length.
    double end_along(const Facet& facet) const { return high_[facet.direction]; }
    std::uint32_t family_of(const Item& item) const { return table_->family(item.number); }
    // Which of two cells has the wall where both have one.
    bool comes_before(const Item& a, const Item& b) const {
        return a.turn != b.turn ? a.turn < b.turn : table_->comes_before(a.number, b.number);
    }

    std::span<Facet> facets_of(const Item& item) {
        return std::span(facets_).subspan(item.facets.first, item.facets.count);
    }
    std::span<const Facet> facets_of(const Item& item) const {
        return std::span(facets_).subspan(item.facets.first, item.facets.count);
    }
    std::span<Loose> loose_of(const Item& item) {
        return std::span(loose_).subspan(item.loose.first, item.loose.count);
    }
    std::span<const Loose> loose_of(const Item& item) const {
        return std::span(loose_).subspan(item.loose.first, item.loose.count);
    }
    const LooseEntry& entry(Loose plane) const { return pool_[plane.pool]; }
    Plane exact(const Item& item, std::uint32_t plane) const {
        return item.cell ? item.cell->planes[plane] : tree_->plane(item.number, plane, *table_);
    }
    // Planes of the items from `begin` on.
    std::size_t load(std::size_t begin) const;

    const BlockTree* tree_ = nullptr;
    const CellTable* table_ = nullptr;
    std::vector<Item> items_;
    std::size_t incoming_planes_ = 0;  // of all cells together
    PackedCells::Words words_;         // of the leaf at hand

private:
    // A loose plane seen from the box at hand.
    struct SeenLoose {
        ScaledNormal normal;
        float e = 0;
        Loose plane;
    };
    // An item that is compared with others; its rows are those of its number.
    struct Candidate {
        std::size_t item = 0;
        float reach = 0;                         // sum over all normals, at most as far as the box
        float depth = 0;                         // of the middle of the box in it
        std::size_t planes = 0, planes_end = 0;  // in seen_planes_
        Range loose;                             // in seen_
    };

    std::uint32_t view_of(std::uint32_t family);
    bool look_at_all(const BoxFrame& frame, const Item& item);
    bool look_again(const BoxFrame& frame, const Item& item);
    void look_into_half(const BoxFrame& box, const BoxFrame& half);
    bool make_table(const BoxFrame& frame, std::span<const Item> items);
    void fill_rows(const BoxFrame& frame, Item& item, Candidate& candidate);
    std::size_t see_planes(const Item& item, const Candidate& candidate);
    Domination covered(const Candidate& a, const Candidate& b, std::span<const Item> items) const;
    Domination covered(const Candidate& a, const Item& item, const SeenLoose& p,
                       const Item& its_item) const;

    std::vector<Facet> facets_;
    std::vector<Loose> loose_;
    std::vector<LooseEntry> pool_;

    // Directions of all families met, family by family; for the box of a view: where the box
    // begins and ends along them, in half units times the length of the normal.
    std::vector<View> views_;
    std::vector<std::uint32_t> view_of_family_;
    std::vector<double> low_, high_;
    std::vector<double> half_low_, half_high_;  // the same, of a half of the box
    std::uint64_t box_ = 0;

    // Of the box that is looked at for what is redundant.
    std::vector<std::uint32_t> directions_;  // that facets have
    std::vector<std::uint32_t> column_of_;   // for each direction; kNone
    NormalTable normals_;
    std::vector<ScaledNormal> scaled_;        // by column
    std::vector<float> own_, reach_, limit_;  // rows: planes; with bounds; what to compare with
    std::vector<SeenLoose> seen_;
    SeenPlanes seen_planes_;
    std::vector<Candidate> candidates_;
    std::vector<std::size_t> kept_;
};

}  // namespace ncsim::cda
