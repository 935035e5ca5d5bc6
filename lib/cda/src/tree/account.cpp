// SPDX-License-Identifier: GPL-3.0-or-later
//
// Account of removed volume per origin. A cell removes the volume that no earlier cell removed: the
// first cell that covers a box removes the rest left by the cells before, and later cells remove
// nothing there. Where several cells have a surface in a box, each facet is followed through time:
// the facet is born with the area that no earlier cell has, and each later cell removes part of the
// area, until none is left. The volume under a facet, a third of area times distance, is added to
// the cell with which the facet is born and subtracted from the cell that removes the facet: the
// divergence theorem for each cell. Walls of boxes cancel between adjacent boxes and are not
// counted.
//
// If a cell represents several steps along a straight line, step_shares.h divides the cell's volume
// between the steps.
//
// The cells in a box, and the owner of a facet where planes coincide, are decided exactly. Areas
// are sums in doubles.
#include "polytope/facet_region.h"
#include "tree/descent.h"
#include "tree/step_shares.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ncsim::cda {

class BlockTree::Accounting : Descent {
public:
    void run(const BlockTree& tree, std::span<const IncomingCell* const> cells,
             const AccountInput& input, std::vector<RemovedByTurn>& removed);

private:
    // Consecutive cells of one origin form a turn; the volume of a single cell of a turn is not
    // computed. Turn kInitialTurn holds the cells that are already in the tree.
    static constexpr std::uint32_t kInitialTurn = 0;
    static constexpr std::uint32_t kNoTurn = std::numeric_limits<std::uint32_t>::max();
    // The turn after which nothing is left in a box, and the cell that covers the box.
    struct Cover {
        std::uint32_t turn = kNoTurn, number = 0;
        bool is_none() const { return turn == kNoTurn; }
    };
    // Areas below this share of a facet are rounding errors and are assigned to no cell.
    static constexpr double kRounding = 1e-9;

    // A cell with a surface in the box.
    struct LocalCell {
        std::uint32_t turn = 0, number = 0;
        std::size_t first = 0, count = 0;  // in planes_
    };

    void visit(std::uint32_t node, std::size_t begin, std::size_t end, Cover last);
    void divide(const HalfBox& box, std::size_t begin, std::size_t end, int fruitless,
                std::size_t parent_load, Cover last);
    Cover enqueue(const HalfBox& box, std::size_t begin, std::size_t end, Cover last);
    void split(const HalfBox& box, std::size_t axis, std::size_t begin, int fruitless,
               std::size_t parent_load, Cover last);
    void account_for_leaf(const HalfBox& box, std::size_t begin, Cover last);
    void divide_among_steps();
    void follow_facet(const Plane& plane, double sign, const LocalCell& self, Cover last);
    bool find_cuts(const LocalCell& other, const Plane& plane, bool takes_same,
                   bool takes_opposite) {
        return cuts_of_facet(plane, planes_of(other), takes_same, takes_opposite, cuts_);
    }
    std::span<const Plane> planes_of(const LocalCell& local) const {
        return std::span(planes_).subspan(local.first, local.count);
    }

    const AccountInput* input_ = nullptr;
    std::vector<RemovedByTurn>* removed_ =
        nullptr;  // by turn; turn 0 (kInitialTurn) is not returned
    std::vector<StepShares> shares_;
    std::vector<std::uint32_t> shares_of_turn_;  // index, or kNoTurn
    // The current box.
    std::vector<Plane> stock_, planes_;
    std::vector<LocalCell> locals_;
    std::vector<const Plane*> cuts_;
    FacetRegion facet_;
};

void BlockTree::account(std::span<const IncomingCell* const> cells, const AccountInput& input,
                        std::vector<RemovedByTurn>& removed) const {
    if (nodes_[0].kind == Kind::Empty || cells.empty()) return;
    thread_local Accounting accounting;
    accounting.run(*this, cells, input, removed);
}

void BlockTree::Accounting::run(const BlockTree& tree, std::span<const IncomingCell* const> cells,
                                const AccountInput& input, std::vector<RemovedByTurn>& removed) {
    input_ = &input;
    removed_ = &removed;
    removed.assign(1, {});
    begin(tree, cells, input.cells);
    shares_.clear();
    shares_of_turn_.assign(1, kNoTurn);
    for (Item& item : items_) {
        const Origin origin = input.cells.origin(item.number);
        const bool is_shared = item.cell->steps != nullptr;
        if (removed.back().origin != origin || removed.size() == 1 || is_shared ||
            shares_of_turn_.back() != kNoTurn) {
            removed.push_back({origin, 0.0, {}});
            shares_of_turn_.push_back(is_shared ? static_cast<std::uint32_t>(shares_.size())
                                                : kNoTurn);
            if (is_shared) shares_.emplace_back(*item.cell);
        }
        item.turn = static_cast<std::uint32_t>(removed.size() - 1);
    }
    visit(0, 0, items_.size(), {});
    for (RemovedByTurn& turn : removed) {
        std::ranges::sort(turn.cells);
        turn.cells.erase(std::unique(turn.cells.begin(), turn.cells.end()), turn.cells.end());
    }
    divide_among_steps();
}

// Divides the volume of cells that represent several steps between the steps. Drops turn
// kInitialTurn.
void BlockTree::Accounting::divide_among_steps() {
    std::vector<RemovedByTurn> all;
    for (std::size_t turn = 1; turn < removed_->size(); ++turn) {
        RemovedByTurn& whole = (*removed_)[turn];
        const std::uint32_t number = shares_of_turn_[turn];
        if (number == kNoTurn) {
            all.push_back(std::move(whole));
            continue;
        }
        const StepShares& shares = shares_[number];
        const std::vector<double> volumes = shares.of(whole.volume);
        for (std::size_t step = 0; step < volumes.size(); ++step)
            all.push_back({shares.origin(step), volumes[step], whole.cells, step});
    }
    removed_->swap(all);
}

// Visits a node with items [begin, end) of the level above, in chronological order.
void BlockTree::Accounting::visit(std::uint32_t node, std::size_t begin, std::size_t end,
                                  Cover last) {
    const HalfBox box = tree_->nodes_[node].box();
    const Level above = level();
    last = enqueue(box, begin, end, last);
    if (items_.size() == above.items && last.is_none()) {
        // No cell removes anything here.
    } else if (tree_->nodes_[node].kind == Kind::Material) {
        push_leaf(node);
        divide(box, above.items, items_.size(), 0, kNone, last);
    } else {
        const std::size_t here = items_.size();
        const std::uint32_t first = tree_->nodes_[node].first_child;
        for (const std::uint32_t child : {first, first + 1}) {
            if (tree_->nodes_[child].kind != Kind::Empty) visit(child, above.items, here, last);
        }
    }
    restore(above);
}

// Pushes the parts of items [begin, end) in the box, except items whose turn is not before the turn
// of the first item that covers the box. Returns this turn.
BlockTree::Accounting::Cover BlockTree::Accounting::enqueue(const HalfBox& box, std::size_t begin,
                                                            std::size_t end, Cover last) {
    start_box();
    const BoxFrame frame(box);
    const std::size_t mine = items_.size();
    const std::size_t hopeful = push_items_in(frame, begin, end);
    const std::size_t met = items_.size();
    const bool is_coarse = met - mine > kFewCells && cut_of_boxes(box, mine).axis != 3;
    const auto longest = static_cast<double>(box.extent(box.longest_axis()));
    if (hopeful != kNone) {
        Item item = items_[hopeful];
        if (classify(frame, item) == Place::Covers) last = {item.turn, item.number};
    }
    std::size_t kept = mine;
    for (std::size_t i = mine; i < met; ++i) {
        Item item = items_[i];
        if (item.turn >= last.turn) continue;
        if (!is_coarse || !is_small_for(longest, item)) {
            const Place place = classify(frame, item);
            if (place == Place::Outside) continue;
            if (place == Place::Covers) {
                last = {item.turn, item.number};
                continue;
            }
        }
        items_[kept++] = item;
    }
    items_.resize(kept);
    // The covering item of a turn makes the remaining items of the turn redundant.
    const auto begin_of_mine = items_.begin() + static_cast<std::ptrdiff_t>(mine);
    items_.erase(std::remove_if(begin_of_mine, items_.end(),
                                [last](const Item& item) { return item.turn >= last.turn; }),
                 items_.end());
    return last;
}

// Divides a box in a leaf of the tree; items [begin, end) are all items in the box.
void BlockTree::Accounting::divide(const HalfBox& box, std::size_t begin, std::size_t end,
                                   int fruitless, std::size_t parent_load, Cover last) {
    const Level above = level();
    const std::size_t mine = above.items;
    last = enqueue(box, begin, end, last);
    const std::span<const Item> items = std::span(items_).subspan(mine);
    const auto changes = [](const Item& item) { return item.turn != kInitialTurn; };
    if (last.is_none() && std::ranges::none_of(items, changes)) {
        // No cell removes anything here.
    } else if (std::ranges::any_of(items, [](const Item& item) { return !item.is_classified; })) {
        const Cut cut = cut_of_boxes(box, mine);
        split(box, cut.axis == 3 ? box.longest_axis() : cut.axis, mine, 0, kNone, last);
    } else {
        // In most boxes the cells of the tree already cover the new cells; then no further test is
        // needed.
        drop_redundant(BoxFrame(box), mine);
        const std::size_t planes = load(mine);
        const bool was_in_vain = 10 * planes > 9 * parent_load;
        fruitless = was_in_vain ? fruitless + 1 : 0;
        Cut cut;
        if (planes > input_->leaf && fruitless < kFruitlessSplits) cut = best_cut(box, mine);
        if (last.is_none() && std::ranges::none_of(std::span(items_).subspan(mine), changes)) {
            // No cell removes anything here.
        } else if (cut.axis == 3) {
            account_for_leaf(box, mine, last);
        } else {
            split(box, cut.axis, mine, fruitless, cut.parts ? kNone : planes, last);
        }
    }
    restore(above);
}

void BlockTree::Accounting::split(const HalfBox& box, std::size_t axis, std::size_t begin,
                                  int fruitless, std::size_t parent_load, Cover last) {
    const std::size_t end = items_.size();
    for (const bool upper : {false, true})
        divide(box.half(axis, upper), begin, end, fruitless, parent_load, last);
}

// Follows all facets in a leaf.
void BlockTree::Accounting::account_for_leaf(const HalfBox& box, std::size_t begin, Cover last) {
    const BoxFrame frame(box);
    stock_.clear();
    for (const Plane& plane : input_->stock) {
        const Side side = side_of(frame, HalfPlane(plane));
        if (side == Side::Above) return;
        if (side == Side::On) stock_.push_back(plane);
    }
    locals_.clear();
    planes_.clear();
    for (const Item& item : std::span(items_).subspan(begin)) {
        LocalCell local{item.turn, item.number, planes_.size(), 0};
        for (const Facet& facet : facets_of(item))
            planes_.push_back(exact(item, facet.plane));
        for (const LoosePlane plane : loose_of(item))
            planes_.push_back(exact(item, entry(plane).plane));
        local.count = planes_.size() - local.first;
        locals_.push_back(local);
    }
    std::ranges::sort(locals_, {}, [](const LocalCell& l) { return std::pair{l.turn, l.number}; });
    for (const Plane& plane : stock_) {
        if (facet_.assign(plane, box)) follow_facet(plane, 1.0, {kInitialTurn, 0, 0, 0}, last);
    }
    for (const LocalCell& local : locals_) {
        for (const Plane& plane : planes_of(local)) {
            if (facet_.assign(plane, box)) follow_facet(plane, -1.0, local, last);
        }
    }
}

// Follows facet_ through time, starting with the part that `self`, if a cell, has first. `sign`: 1
// if the facet's normal points out of the part.
void BlockTree::Accounting::follow_facet(const Plane& plane, double sign, const LocalCell& self,
                                         Cover last) {
    const bool is_wall = self.count > 0;
    const double rounding = kRounding * facet_.area();
    const auto begin_of_later = static_cast<std::size_t>(
        std::ranges::upper_bound(locals_, self.turn, {}, &LocalCell::turn) - locals_.begin());
    // A facet that existed before is processed only if some cell removes part of the facet.
    if (self.turn == kInitialTurn && last.is_none()) {
        std::size_t takers = 0;
        std::size_t taker = 0;
        for (std::size_t i = begin_of_later; i < locals_.size() && takers < 2; ++i) {
            if (!find_cuts(locals_[i], plane, !is_wall, is_wall) || !facet_.meets(cuts_)) continue;
            ++takers;
            taker = i;
        }
        if (takers == 0) return;
        if (takers == 1) {
            find_cuts(locals_[taker], plane, !is_wall, is_wall);
            for (const Plane* cut : cuts_) {
                if (!facet_.clip(*cut)) return;
            }
        }
    }
    if (is_wall && (std::ranges::find(stock_, plane) != stock_.end() ||
                    !facet_.clip_to(plane, planes_of(self)))) {
        return;
    }
    if (!facet_.clip_to(plane, stock_)) return;
    const double height = sign * distance_about(plane, input_->centre) / 3.0;
    // The latest cells first: a later cell usually contains the region that the tool has passed.
    for (std::size_t i = begin_of_later; i-- > 0;) {
        const LocalCell& other = locals_[i];
        if (is_wall && other.number == self.number) continue;
        const bool comes_before =
            std::pair{other.turn, other.number} < std::pair{self.turn, self.number};
        if (!find_cuts(other, plane, !is_wall || comes_before, is_wall)) continue;
        facet_.remove(cuts_);
        if (facet_.is_empty()) return;
    }
    const auto give = [&](std::uint32_t turn, std::uint32_t number, double area,
                          double sign_of_it) {
        RemovedByTurn& removed = (*removed_)[turn];
        removed.volume += sign_of_it * height * area;
        if (area > rounding && (removed.cells.empty() || removed.cells.back() != number))
            removed.cells.push_back(number);
    };
    const auto shares_of = [&](std::uint32_t turn) {
        const std::uint32_t shares = shares_of_turn_[turn];
        return shares == kNoTurn ? nullptr : &shares_[shares];
    };
    if (self.turn != kInitialTurn) {
        const double area = facet_.area();
        give(self.turn, self.number, area, -1.0);
        if (StepShares* shares = shares_of(self.turn)) shares->add_wall(plane, area);
    }
    for (std::size_t i = begin_of_later; i < locals_.size(); ++i) {
        const LocalCell& other = locals_[i];
        if (!find_cuts(other, plane, !is_wall, is_wall)) continue;
        give(other.turn, other.number, facet_.remove(cuts_), 1.0);
        if (StepShares* shares = shares_of(other.turn))
            shares->add_removed(plane, sign, facet_, facet_.removed());
        if (facet_.is_empty()) return;
    }
    if (last.is_none()) return;
    give(last.turn, last.number, facet_.area(), 1.0);
    if (StepShares* shares = shares_of(last.turn))
        shares->add_removed(plane, sign, facet_, facet_.polygons());
}

}  // namespace ncsim::cda
