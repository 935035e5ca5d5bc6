// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of cells from a block: the part of the block that a cell covers becomes empty
// permanently; otherwise the leaves keep the cells that may have surface.
#include "tree/descent.h"

#include <algorithm>
#include <cmath>

namespace ncsim::cda {

namespace {

// A wall of a box moves inwards only if the box becomes at least an eighth shorter.
constexpr double kWorthShrinking = 0.75;
// Unused planes are dropped when the number of planes exceeds this multiple of the number after the
// last drop.
constexpr std::size_t kPlaneGrowth = 3;
constexpr std::size_t kPlanesWorthDropping = 4096;

std::int64_t odd_above(double x) {
    return static_cast<std::int64_t>(std::ceil(x)) | 1;
}
std::int64_t odd_below(double x) {
    return (static_cast<std::int64_t>(std::floor(x)) - 1) | 1;
}

}  // namespace

class BlockTree::Insertion : Descent {
public:
    void run(BlockTree& tree, std::span<const IncomingCell* const> cells, const CellTable& table,
             std::uint32_t leaf);

private:
    void insert_at(std::uint32_t number, const HalfBox& within, std::size_t begin, std::size_t end,
                   int fruitless, std::size_t parent_load);
    void build(std::uint32_t number, HalfBox box, std::size_t begin, int fruitless,
               std::size_t parent_load);
    void split(std::uint32_t number, const HalfBox& box, std::size_t axis, std::size_t begin,
               int fruitless, std::size_t load);
    bool trim(HalfBox& box, std::size_t begin);
    bool shrink(HalfBox& box, const Item& item);
    void store(std::uint32_t number, std::size_t begin);

    BlockTree* tree_ = nullptr;
    std::uint32_t leaf_ = 0;
    std::vector<std::uint32_t> stored_;  // per plane of incoming cells: index in the tree
};

void BlockTree::insert(std::span<const IncomingCell* const> cells, const CellTable& table,
                       std::uint32_t leaf) {
    if (nodes_[0].kind == Kind::Empty || cells.empty()) return;
    thread_local Insertion insertion;
    insertion.run(*this, cells, table, leaf);
    if (planes_.size() > kPlaneGrowth * planes_after_drop_ + kPlanesWorthDropping) {
        drop_unused_planes();
    }
}

void BlockTree::Insertion::run(BlockTree& tree, std::span<const IncomingCell* const> cells,
                               const CellTable& table, std::uint32_t leaf) {
    tree_ = &tree;
    leaf_ = leaf;
    begin(tree, cells, table);
    stored_.assign(incoming_planes_, kNone);
    insert_at(0, tree.box(), 0, items_.size(), 0, kNone);
}

// Inserts items [begin, end) of the level above. Material outside of `within` has been removed.
void BlockTree::Insertion::insert_at(std::uint32_t number, const HalfBox& within, std::size_t begin,
                                     std::size_t end, int fruitless, std::size_t parent_load) {
    const HalfBox before = tree_->nodes_[number].box();
    HalfBox box = intersection(before, within);
    if (box.is_empty()) {
        tree_->become_empty(number);
        return;
    }
    start_box();
    const Level above = level();
    const std::size_t my_items = above.items;
    BoxFrame frame(box);
    const std::size_t hopeful = push_items_in(frame, begin, end);
    // The cell whose middle is nearest to the box is first, because this cell may cover the whole
    // box.
    if (hopeful != kNone) std::swap(items_[my_items], items_[hopeful]);
    const std::size_t met = items_.size() - my_items;
    const bool is_coarse = met > kFewCells && cut_of_boxes(box, my_items).axis != 3;
    const auto longest = static_cast<double>(box.extent(box.longest_axis()));
    bool is_covered = false;
    std::size_t kept = my_items;
    for (std::size_t i = my_items; i < my_items + met && !is_covered; ++i) {
        Item item = items_[i];
        if (i != my_items && is_coarse && is_small_for(longest, item)) {
            if (item.cell->meets(frame)) items_[kept++] = item;
            continue;
        }
        const Place place = classify(frame, item);
        if (place == Place::Outside) continue;
        is_covered = place == Place::Covers;
        items_[kept++] = item;
        if (is_covered || !shrink(box, item)) continue;
        is_covered = box.is_empty();
        if (is_covered) break;
        frame = BoxFrame(box);
        start_box();
    }
    items_.resize(kept);
    if (is_covered) {
        tree_->become_empty(number);
    } else if (kept == my_items && box == before) {
        // No item is in the box.
    } else if (tree_->nodes_[number].kind == Kind::Material) {
        push_leaf(number);
        build(number, box, my_items, fruitless, parent_load);
    } else {
        const std::size_t my_end = items_.size();
        const std::uint32_t first = tree_->nodes_[number].first_child;
        for (const std::uint32_t child : {first, first + 1}) {
            if (tree_->nodes_[child].kind == Kind::Empty) continue;
            insert_at(child, box, my_items, my_end, 0, kNone);
        }
        tree_->enclose_children(number);
    }
    restore(above);
}

// Moves a wall of the box inwards to the place beyond which the item covers the box, unless the
// distance is small.
bool BlockTree::Insertion::shrink(HalfBox& box, const Item& item) {
    const BoxFrame frame(box);
    for (std::size_t i = 0; i < 3; ++i) {
        const double not_worth_it = kWorthShrinking * frame.half[i];
        bool is_upper = false;
        bool is_first = true;
        // Largest distance of the cell's surface from the middle.
        double outermost = -frame.half[i];
        // `end`: upper end of the box along the normal.
        const auto takes = [&](double n, double end, double d2) {
            if (is_first) is_upper = n < 0;
            is_first = false;
            if (is_upper ? n >= 0 : n <= 0) return false;
            outermost = std::max(outermost, (end - d2) / std::abs(n) - frame.half[i]);
            return outermost <= not_worth_it;
        };
        bool is_worth_it = true;
        const View* seen = item.facets.count > 0 ? &view_in(family_of(item), frame) : nullptr;
        for (const Facet& facet : facets_of(item)) {
            const FacetNormals& normals = *seen->normals;
            const std::size_t k = facet.direction - seen->first;
            const double n = i == 0 ? normals.x[k] : i == 1 ? normals.y[k] : normals.z[k];
            is_worth_it = takes(n, end_along(facet), facet.d2);
            if (!is_worth_it) break;
        }
        for (std::size_t k = 0; k < item.loose.count && is_worth_it; ++k) {
            const HalfPlane& h = entry(loose_of(item)[k]).half_plane;
            const BoxHeight box_height(frame, h);
            is_worth_it = takes(h.normal(i), box_height.above + box_height.reach + h.d2, h.d2);
        }
        if (!is_worth_it) continue;
        // Leaves two half units more, for rounding and so that the wall is well within the cell.
        std::int64_t& wall = (is_upper ? box.max : box.min)[i];
        const std::int64_t moved = is_upper ? odd_above(frame.centre[i] + outermost) + 2
                                            : odd_below(frame.centre[i] - outermost) - 2;
        if (is_upper ? moved >= wall : moved <= wall) continue;
        wall = moved;
        return true;
    }
    return false;
}

// Cuts off the parts of the box that an item from `begin` on covers, and drops items outside of the
// box. False if no part of the box is left.
bool BlockTree::Insertion::trim(HalfBox& box, std::size_t begin) {
    for (bool has_shrunk = true; has_shrunk;) {
        start_box();
        const BoxFrame frame(box);
        const bool is_small = box.extent(box.longest_axis()) < kSmallestBox;
        std::size_t kept = begin;
        for (std::size_t i = begin; i < items_.size(); ++i) {
            Item item = items_[i];
            if (item.is_classified || is_small) {
                const Place place = classify(frame, item);
                if (place == Place::Covers) return false;
                if (place == Place::Outside) continue;
            } else if (!item.cell->meets(frame)) {
                continue;
            }
            items_[kept++] = item;
        }
        items_.resize(kept);
        has_shrunk = false;
        for (std::size_t i = begin; i < kept && !box.is_empty(); ++i) {
            if (!items_[i].is_classified || !shrink(box, items_[i])) continue;
            has_shrunk = true;
            start_box();
        }
        if (box.is_empty()) return false;
    }
    return true;
}

// Makes a leaf of the items from `begin` on, or a subtree if the items are too many.
void BlockTree::Insertion::build(std::uint32_t number, HalfBox box, std::size_t begin,
                                 int fruitless, std::size_t parent_load) {
    if (!trim(box, begin)) {
        tree_->become_empty(number);
        return;
    }
    const std::span<const Item> items = std::span(items_).subspan(begin);
    if (std::ranges::any_of(items, [](const Item& item) { return !item.is_classified; })) {
        const Cut cut = cut_of_boxes(box, begin);
        const std::size_t axis = cut.axis == 3 ? box.longest_axis() : cut.axis;
        return split(number, box, axis, begin, 0, kNone);
    }
    tree_->nodes_[number].set_box(box);
    const BoxFrame frame(box);
    std::size_t planes = load(begin);
    if (planes > leaf_) {
        drop_redundant(frame, begin);
        planes = load(begin);
    }
    const std::size_t limit = std::max<std::size_t>(leaf_, tree_->nodes_[number].limit);
    // True if the split left nearly all planes in both halves.
    const bool was_in_vain = 10 * planes > 9 * parent_load;
    fruitless = was_in_vain ? fruitless + 1 : 0;
    Cut cut;
    if (planes > limit && fruitless < kFruitlessSplits) cut = best_cut(box, begin);
    if (cut.axis == 3) {
        store(number, begin);
        if (planes > limit)
            tree_->nodes_[number].limit =
                std::min<std::size_t>(2 * planes, kMostPlanes) & kMostPlanes;
        return;
    }
    split(number, box, cut.axis, begin, fruitless, cut.parts ? kNone : planes);
}

void BlockTree::Insertion::split(std::uint32_t number, const HalfBox& box, std::size_t axis,
                                 std::size_t begin, int fruitless, std::size_t parent_load) {
    std::vector<Node>& nodes = tree_->nodes_;
    std::vector<std::uint32_t>& free = tree_->free_children_;
    std::uint32_t first = 0;
    if (free.empty()) {
        first = static_cast<std::uint32_t>(nodes.size());
        make_room(nodes);
        nodes.emplace_back();
        make_room(nodes);
        nodes.emplace_back();
    } else {
        first = free.back();
        free.pop_back();
    }
    nodes[number].set_box(box);
    nodes[number].kind = Kind::Inner;
    nodes[number].first_child = first;
    nodes[number].limit = 0;
    nodes[number].cells = {};
    const std::size_t end = items_.size();
    for (const bool upper : {false, true}) {
        const std::uint32_t child = first + static_cast<std::uint32_t>(upper);
        nodes[child] = Node();
        nodes[child].set_box(box.half(axis, upper));
        insert_at(child, box, begin, end, fruitless, parent_load);
    }
    tree_->enclose_children(number);
}

void BlockTree::Insertion::store(std::uint32_t number, std::size_t begin) {
    const std::span<const Item> items = std::span(items_).subspan(begin);
    words_.clear();
    for (const Item& item : items) {
        words_.push_back(item.number);
        words_.push_back(item.facets.count + item.loose.count);
        const auto write = [&](std::uint32_t plane, std::uint16_t facet) {
            if (!item.cell) {
                words_.push_back(plane);
                return;
            }
            std::uint32_t& stored = stored_[item.first + plane];
            if (stored == kNone) stored = tree_->planes_.add(item.cell->planes[plane], facet);
            words_.push_back(stored);
        };
        for (const Facet& facet : facets_of(item))
            write(facet.plane, static_cast<std::uint16_t>(facet.plane));
        for (const LoosePlane plane : loose_of(item))
            write(entry(plane).plane, kLoose);
    }
    tree_->nodes_[number].cells.write(words_);
}

}  // namespace ncsim::cda
