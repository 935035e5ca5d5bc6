// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells go down together. Where boxes are large beside the cells, only boxes are compared. A cell
// in a small box is looked at: it has there the planes that are *active*, those that cut the box. A
// plane that has the box above it ends the way (the cell is not here); when no plane is left, the
// cell covers the box, which is empty for good. Where many are left, rows of bounds tell which
// planes and which cells are not needed beside others (normal_table.h).
#include "block_tree.h"
#include "domination.h"
#include "normal_table.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace ncsim::cda {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Boxes are not split below this many half units: cells that meet in a line or a point cannot be
// told apart by smaller boxes, only multiplied.
constexpr std::int64_t kSmallestBox = 2048;
// Splits in a row that part nothing before a list is left as it is.
constexpr int kFruitlessSplits = 3;
// Of more than a few cells only the boxes are looked at while the box of the node is larger than
// this share of their least extent, if halves of it have less than so many times as many of them,
// in sum.
constexpr std::size_t kFewCells = 8;
constexpr double kLargeBox = 0.4;
constexpr double kPartsBoxes = 1.9;
// What an axis loses by being shorter than another when it is chosen.
constexpr double kShortAxis = 0.25;
// Each cell is compared with so many others at most: smaller boxes tell the rest.
constexpr std::size_t kComparisons = 16;
// More cells than this are halved along the longest axis, whatever they are.
constexpr std::size_t kManyCells = 64;
// A table for more normals than this costs more than smaller boxes.
constexpr std::size_t kManyNormals = 160;
// Walls of boxes move inwards where that makes the box an eighth shorter.
constexpr double kWorthShrinking = 0.75;
// Planes are looked through for unused ones when there are this many times those last used.
constexpr std::size_t kPlaneGrowth = 3;
constexpr std::size_t kPlanesWorthDropping = 4096;

std::int64_t odd_above(double x) {
    return static_cast<std::int64_t>(std::ceil(x)) | 1;
}
std::int64_t odd_below(double x) {
    return (static_cast<std::int64_t>(std::floor(x)) - 1) | 1;
}

bool meets(const BoxFrame& frame, const IncomingCell& cell) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (cell.min[i] > frame.centre[i] + frame.half[i]) return false;
        if (cell.max[i] < frame.centre[i] - frame.half[i]) return false;
    }
    return true;
}

double least_extent(const IncomingCell& cell) {
    return std::min(
        {cell.max[0] - cell.min[0], cell.max[1] - cell.min[1], cell.max[2] - cell.min[2]});
}

}  // namespace

// Cells on their way down: stacks that all levels share. A level adds what is left of the cells of
// the level above in its box, and takes it away again.
class BlockTree::Insertion {
public:
    void run(BlockTree& tree, std::span<const IncomingCell* const> cells, const CellTable& table,
             std::uint32_t leaf);

private:
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
        std::uint32_t stored = 0;   // where stored planes of the incoming cell are noted
        bool is_looked_at = false;  // else nothing but the box of the cell is known
        Range facets, loose;
    };
    // The normals of a family seen from the box at hand.
    struct View {
        const FacetNormals* normals = nullptr;
        std::uint32_t first = 0;  // direction
        std::uint64_t seen = 0;   // for which box
    };
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
    struct Cut {
        std::size_t axis = 3;  // 3: none
        bool parts = false;    // less than half of the cells are in both halves
    };
    enum class Place : std::uint8_t { Outside, Covers, Cuts };

    void insert_at(std::uint32_t number, const HalfBox& within, std::size_t begin, std::size_t end,
                   int fruitless, std::size_t parent_load);
    Cut cut_of_boxes(const HalfBox& box, std::size_t begin) const;
    void take_out(std::uint32_t number);
    void build(std::uint32_t number, HalfBox box, std::size_t begin, int fruitless,
               std::size_t parent_load);
    void split(std::uint32_t number, const HalfBox& box, std::size_t axis, std::size_t begin,
               int fruitless, std::size_t load);
    bool settle(HalfBox& box, std::size_t begin);
    void store(std::uint32_t number, std::size_t begin);

    std::uint32_t view_of(std::uint32_t family);
    const View& see(std::uint32_t family, const BoxFrame& frame);
    Place look(const BoxFrame& frame, Item& item);
    bool look_at_all(const BoxFrame& frame, const Item& item);
    bool look_again(const BoxFrame& frame, const Item& item);
    bool shrink(HalfBox& box, const Item& item);

    void drop_redundant(const BoxFrame& frame, std::size_t begin);
    bool make_table(const BoxFrame& frame, std::span<const Item> items);
    void fill_rows(const BoxFrame& frame, Item& item, Candidate& candidate);
    std::size_t see_planes(const Item& item, const Candidate& candidate);
    Domination covered(const Candidate& a, const Candidate& b, std::span<const Item> items) const;
    Domination covered(const Candidate& a, const Item& item, const SeenLoose& p,
                       const Item& its_item) const;
    void look_into_half(const BoxFrame& box, const BoxFrame& half);
    Cut best_cut(const HalfBox& box, std::size_t begin);

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
    const HalfPlane& half_plane(Loose plane) const { return pool_[plane.pool].half_plane; }
    const Plane& exact(const Item& item, std::uint32_t plane) const {
        return item.cell ? item.cell->planes[plane] : tree_->planes_[plane];
    }
    std::size_t load(std::size_t begin) const {
        std::size_t sum = 0;
        for (const Item& item : std::span(items_).subspan(begin))
            sum += item.facets.count + item.loose.count;
        return sum;
    }
    BlockTree* tree_ = nullptr;
    const CellTable* table_ = nullptr;
    std::uint32_t leaf_ = 0;
    // The stacks.
    std::vector<Item> items_;
    std::vector<Facet> facets_;
    std::vector<Loose> loose_;
    std::vector<LooseEntry> pool_;
    std::vector<std::uint32_t> stored_;  // for each plane of incoming cells: where in the tree

    // Directions of all families met, family by family; for the box of a view: where the box
    // begins and ends along them, in half units times the length of the normal.
    std::vector<View> views_;
    std::vector<std::uint32_t> view_of_family_;
    std::vector<double> low_, high_;
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
    std::vector<double> half_low_, half_high_;  // as low_ and high_, of a half of the box
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

bool BlockTree::meets(const IncomingCell& cell) const {
    return nodes_[0].kind != Kind::Empty && cda::meets(BoxFrame(box()), cell);
}

void BlockTree::Insertion::run(BlockTree& tree, std::span<const IncomingCell* const> cells,
                               const CellTable& table, std::uint32_t leaf) {
    tree_ = &tree;
    table_ = &table;
    leaf_ = leaf;
    items_.clear();
    facets_.clear();
    loose_.clear();
    pool_.clear();
    stored_.clear();
    views_.clear();
    view_of_family_.assign(table.families(), kNone);
    low_.clear();
    high_.clear();
    column_of_.clear();
    directions_.clear();
    for (const IncomingCell* cell : cells) {
        Item item;
        item.number = cell->number;
        item.cell = cell;
        item.stored = static_cast<std::uint32_t>(stored_.size());
        stored_.resize(stored_.size() + cell->planes.size(), kNone);
        items_.push_back(item);
    }
    insert_at(0, tree.box(), 0, items_.size(), 0, kNone);
}

// Items [begin, end) of the level above; what is not within the box has been taken away.
void BlockTree::Insertion::insert_at(std::uint32_t number, const HalfBox& within, std::size_t begin,
                                     std::size_t end, int fruitless, std::size_t parent_load) {
    const HalfBox before = tree_->nodes_[number].box();
    HalfBox box = intersection(before, within);
    if (box.is_empty()) {
        tree_->become_empty(number);
        return;
    }
    ++box_;
    const std::size_t my_items = items_.size();
    const std::size_t my_facets = facets_.size();
    const std::size_t my_loose = loose_.size();
    const std::size_t my_pool = pool_.size();
    const auto leave = [&] {
        items_.resize(my_items);
        facets_.resize(my_facets);
        loose_.resize(my_loose);
        pool_.resize(my_pool);
    };
    BoxFrame frame(box);
    std::size_t hopeful = kNone;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = begin; i < end; ++i) {
        const IncomingCell* cell = items_[i].cell;
        if (cell) {
            if (!cda::meets(frame, *cell)) continue;
            double distance = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                distance = std::max(distance,
                                    std::abs(cell->min[k] + cell->max[k] - 2.0 * frame.centre[k]) /
                                        (cell->max[k] - cell->min[k]));
            }
            if (distance < nearest) {
                nearest = distance;
                hopeful = items_.size();
            }
        }
        items_.push_back(items_[i]);
    }
    // First the cell that has the box nearest to its middle: it may cover all of it.
    if (hopeful != kNone) std::swap(items_[my_items], items_[hopeful]);
    const std::size_t met = items_.size() - my_items;
    const bool is_coarse = met > kFewCells && cut_of_boxes(box, my_items).axis != 3;
    const double longest = static_cast<double>(box.extent(box.longest_axis()));
    bool is_covered = false;
    std::size_t kept = my_items;
    for (std::size_t i = my_items; i < my_items + met && !is_covered; ++i) {
        Item item = items_[i];
        if (!item.is_looked_at && i != my_items && is_coarse &&
            longest > kLargeBox * least_extent(*item.cell)) {
            if (cda::meets(frame, *item.cell)) items_[kept++] = item;
            continue;
        }
        const Place place = look(frame, item);
        if (place == Place::Outside) continue;
        is_covered = place == Place::Covers;
        items_[kept++] = item;
        if (is_covered || !shrink(box, item)) continue;
        is_covered = box.is_empty();
        if (is_covered) break;
        frame = BoxFrame(box);
        ++box_;
    }
    items_.resize(kept);
    if (is_covered) {
        tree_->become_empty(number);
    } else if (kept == my_items && box == before) {
        // Nothing of them is here.
    } else if (tree_->nodes_[number].kind == Kind::Material) {
        take_out(number);
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
    leave();
}

// Along the axis whose halves have the fewest items from `begin` on, in sum, by the boxes of those
// that were not looked at; none if that is not much fewer.
BlockTree::Insertion::Cut BlockTree::Insertion::cut_of_boxes(const HalfBox& box,
                                                             std::size_t begin) const {
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i)
        middle[i] = static_cast<double>(box.middle(i));
    std::array<std::size_t, 3> both{};
    std::size_t all = 0;
    for (const Item& item : std::span(items_).subspan(begin)) {
        if (item.is_looked_at) continue;
        ++all;
        for (std::size_t i = 0; i < 3; ++i) {
            if (item.cell->min[i] <= middle[i] && item.cell->max[i] >= middle[i]) ++both[i];
        }
    }
    const auto longest = static_cast<double>(box.extent(box.longest_axis()));
    Cut best;
    double best_cost = kPartsBoxes;
    for (std::size_t i = 0; i < 3; ++i) {
        if (box.extent(i) < kSmallestBox) continue;
        const double cost = static_cast<double>(all + both[i]) / static_cast<double>(all) +
                            kShortAxis * (1.0 - static_cast<double>(box.extent(i)) / longest);
        if (cost >= best_cost) continue;
        best_cost = cost;
        best = {i, true};
    }
    return best;
}

// Adds the cells of a leaf to the items.
void BlockTree::Insertion::take_out(std::uint32_t number) {
    const std::span<const std::uint32_t> words(tree_->nodes_[number].cells);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1]) {
        Item item;
        item.number = words[at];
        item.is_looked_at = true;
        item.facets.first = static_cast<std::uint32_t>(facets_.size());
        item.loose.first = static_cast<std::uint32_t>(loose_.size());
        const std::uint32_t family = table_->family(item.number);
        for (const std::uint32_t plane : words.subspan(at + kHead, words[at + 1])) {
            const HalfPlane half_plane(tree_->planes_[plane]);
            const std::uint16_t facet = tree_->facets_[plane];
            if (facet == kLoose) {
                loose_.push_back({static_cast<std::uint32_t>(pool_.size())});
                pool_.push_back({half_plane, plane});
            } else {
                facets_.push_back({half_plane.d2, views_[view_of(family)].first + facet, plane});
            }
        }
        item.facets.count = static_cast<std::uint32_t>(facets_.size()) - item.facets.first;
        item.loose.count = static_cast<std::uint32_t>(loose_.size()) - item.loose.first;
        items_.push_back(item);
    }
}

std::uint32_t BlockTree::Insertion::view_of(std::uint32_t family) {
    std::uint32_t& view = view_of_family_[family];
    if (view == kNone) {
        view = static_cast<std::uint32_t>(views_.size());
        const FacetNormals& normals = table_->normals(family);
        views_.push_back({&normals, static_cast<std::uint32_t>(low_.size()), 0});
        low_.resize(low_.size() + normals.size());
        high_.resize(low_.size());
        column_of_.resize(low_.size(), kNone);
    }
    return view;
}

// Where the box begins and ends along the normals of a family.
const BlockTree::Insertion::View& BlockTree::Insertion::see(std::uint32_t family,
                                                            const BoxFrame& frame) {
    View& view = views_[view_of(family)];
    if (view.seen == box_) return view;
    view.seen = box_;
    const FacetNormals& normals = *view.normals;
    double* const low = &low_[view.first];
    double* const high = &high_[view.first];
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double middle = normals.x[i] * frame.centre[0] + normals.y[i] * frame.centre[1] +
                              normals.z[i] * frame.centre[2];
        const double reach = std::abs(normals.x[i]) * frame.half[0] +
                             std::abs(normals.y[i]) * frame.half[1] +
                             std::abs(normals.z[i]) * frame.half[2];
        low[i] = middle - reach;
        high[i] = middle + reach;
    }
    return view;
}

// Of an item of the level above, what it has in the box, at the end of the stacks; first what is
// most likely to be above a smaller box.
BlockTree::Insertion::Place BlockTree::Insertion::look(const BoxFrame& frame, Item& item) {
    const std::size_t facets = facets_.size();
    const std::size_t loose = loose_.size();
    const bool is_outside =
        item.is_looked_at ? !look_again(frame, item) : !look_at_all(frame, item);
    if (is_outside) {
        facets_.resize(facets);
        loose_.resize(loose);
        return Place::Outside;
    }
    item.is_looked_at = true;
    item.facets = {static_cast<std::uint32_t>(facets),
                   static_cast<std::uint32_t>(facets_.size() - facets)};
    item.loose = {static_cast<std::uint32_t>(loose),
                  static_cast<std::uint32_t>(loose_.size() - loose)};
    return item.facets.count + item.loose.count == 0 ? Place::Covers : Place::Cuts;
}

bool BlockTree::Insertion::look_at_all(const BoxFrame& frame, const Item& item) {
    const IncomingCell& cell = *item.cell;
    if (!cell.facets.empty()) {
        const View& seen = see(table_->family(item.number), frame);
        const double* const d2 = cell.facets.data();
        const double* const low = &low_[seen.first];
        const double* const high = &high_[seen.first];
        const std::size_t count = cell.facets.size();
        int outside = 0;
        for (std::size_t i = 0; i < count; ++i)
            outside |= static_cast<int>(low[i] >= d2[i]);
        if (outside != 0) return false;
        for (std::size_t i = 0; i < count; ++i) {
            if (high[i] <= d2[i]) continue;
            const auto facet = static_cast<std::uint32_t>(i);
            facets_.push_back({d2[i], seen.first + facet, facet});
        }
    }
    for (const std::uint16_t plane : cell.loose) {
        const HalfPlane half_plane(cell.planes[plane]);
        const Side side = side_of(frame, half_plane);
        if (side == Side::Above) return false;
        if (side == Side::Below) continue;
        loose_.push_back({static_cast<std::uint32_t>(pool_.size())});
        pool_.push_back({half_plane, plane});
    }
    return true;
}

bool BlockTree::Insertion::look_again(const BoxFrame& frame, const Item& item) {
    if (item.facets.count > 0) see(table_->family(item.number), frame);
    const std::uint32_t first = item.facets.first;
    for (std::uint32_t i = first; i < first + item.facets.count; ++i) {
        const Facet facet = facets_[i];
        if (low_[facet.direction] >= facet.d2) {
            // Most likely it is the one again, next door.
            std::swap(facets_[i], facets_[first]);
            return false;
        }
        if (high_[facet.direction] > facet.d2) facets_.push_back(facet);
    }
    for (std::uint32_t i = 0; i < item.loose.count; ++i) {
        const Loose plane = loose_[item.loose.first + i];
        const Side side = side_of(frame, half_plane(plane));
        if (side == Side::Above) return false;
        if (side == Side::On) loose_.push_back(plane);
    }
    return true;
}

// Moves a wall of the box to where the item begins to cover all that is beyond; but not for a
// little.
bool BlockTree::Insertion::shrink(HalfBox& box, const Item& item) {
    const BoxFrame frame(box);
    for (std::size_t i = 0; i < 3; ++i) {
        const double not_worth_it = kWorthShrinking * frame.half[i];
        bool is_upper = false;
        bool is_first = true;
        // How far out from the middle the cell's surface reaches.
        double outermost = -frame.half[i];
        // `end`: where the box ends along the normal.
        const auto takes = [&](double n, double end, double d2) {
            if (is_first) is_upper = n < 0;
            is_first = false;
            if (is_upper ? n >= 0 : n <= 0) return false;
            outermost = std::max(outermost, (end - d2) / std::abs(n) - frame.half[i]);
            return outermost <= not_worth_it;
        };
        bool is_worth_it = true;
        const View* seen =
            item.facets.count > 0 ? &see(table_->family(item.number), frame) : nullptr;
        for (const Facet& facet : facets_of(item)) {
            const FacetNormals& normals = *seen->normals;
            const std::size_t k = facet.direction - seen->first;
            const double n = i == 0 ? normals.x[k] : i == 1 ? normals.y[k] : normals.z[k];
            is_worth_it = takes(n, high_[facet.direction], facet.d2);
            if (!is_worth_it) break;
        }
        for (std::size_t k = 0; k < item.loose.count && is_worth_it; ++k) {
            const HalfPlane& h = half_plane(loose_of(item)[k]);
            const Sight sight(frame, h);
            is_worth_it = takes(h.normal(i), sight.above + sight.reach + h.d2, h.d2);
        }
        if (!is_worth_it) continue;
        // Two half units more, for rounding and so that the wall is well within the cell.
        std::int64_t& wall = (is_upper ? box.max : box.min)[i];
        const std::int64_t moved = is_upper ? odd_above(frame.centre[i] + outermost) + 2
                                            : odd_below(frame.centre[i] - outermost) - 2;
        if (is_upper ? moved >= wall : moved <= wall) continue;
        wall = moved;
        return true;
    }
    return false;
}

// Cuts off from the box what one of the items from `begin` on covers, and from the items what is
// not in it. False: nothing is left of it.
bool BlockTree::Insertion::settle(HalfBox& box, std::size_t begin) {
    for (bool has_shrunk = true; has_shrunk;) {
        ++box_;
        const BoxFrame frame(box);
        const bool is_small = box.extent(box.longest_axis()) < kSmallestBox;
        std::size_t kept = begin;
        for (std::size_t i = begin; i < items_.size(); ++i) {
            Item item = items_[i];
            if (item.is_looked_at || is_small) {
                const Place place = look(frame, item);
                if (place == Place::Covers) return false;
                if (place == Place::Outside) continue;
            } else if (!cda::meets(frame, *item.cell)) {
                continue;
            }
            items_[kept++] = item;
        }
        items_.resize(kept);
        has_shrunk = false;
        for (std::size_t i = begin; i < kept && !box.is_empty(); ++i) {
            if (!items_[i].is_looked_at || !shrink(box, items_[i])) continue;
            has_shrunk = true;
            ++box_;
        }
        if (box.is_empty()) return false;
    }
    return true;
}

// Makes a leaf of the items from `begin` on, or a tree if they are too many.
void BlockTree::Insertion::build(std::uint32_t number, HalfBox box, std::size_t begin,
                                 int fruitless, std::size_t parent_load) {
    if (!settle(box, begin)) {
        tree_->become_empty(number);
        return;
    }
    const std::span<const Item> items = std::span(items_).subspan(begin);
    if (std::ranges::any_of(items, [](const Item& item) { return !item.is_looked_at; })) {
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
    // A split that left nearly all of it in both halves.
    const bool was_in_vain = 10 * planes > 9 * parent_load;
    fruitless = was_in_vain ? fruitless + 1 : 0;
    Cut cut;
    if (planes > limit && fruitless < kFruitlessSplits) cut = best_cut(box, begin);
    if (cut.axis == 3) {
        store(number, begin);
        if (planes > limit) tree_->nodes_[number].limit = static_cast<std::uint32_t>(2 * planes);
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
        nodes.resize(nodes.size() + 2);
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
        nodes[child] = {};
        nodes[child].set_box(box.half(axis, upper));
        insert_at(child, box, begin, end, fruitless, parent_load);
    }
    tree_->enclose_children(number);
}

// The normals of all facets, as columns; false if there are too many.
bool BlockTree::Insertion::make_table(const BoxFrame& frame, std::span<const Item> items) {
    for (const std::uint32_t direction : directions_)
        column_of_[direction] = kNone;
    directions_.clear();
    scaled_.clear();
    for (const Item& item : items) {
        if (item.facets.count == 0) continue;
        const View& seen = see(table_->family(item.number), frame);
        for (const Facet& facet : facets_of(item)) {
            if (column_of_[facet.direction] != kNone) continue;
            column_of_[facet.direction] = 0;
            directions_.push_back(facet.direction);
            const FacetNormals& normals = *seen.normals;
            const std::size_t k = facet.direction - seen.first;
            const double reach = 0.5 * (high_[facet.direction] - low_[facet.direction]);
            scaled_.emplace_back(normals.x[k], normals.y[k], normals.z[k], frame, reach);
        }
    }
    for (std::size_t i = 0; i < directions_.size(); ++i)
        column_of_[directions_[i]] = static_cast<std::uint32_t>(i);
    if (directions_.size() > kManyNormals) return false;
    normals_.assign(scaled_);
    std::vector<ScaledNormal> by_column(scaled_.size());
    for (std::size_t i = 0; i < directions_.size(); ++i) {
        column_of_[directions_[i]] = normals_.column(i);
        by_column[normals_.column(i)] = scaled_[i];
    }
    scaled_.swap(by_column);
    return true;
}

// How far the item reaches along all normals, and which of its planes are needed beside others of
// its own.
void BlockTree::Insertion::fill_rows(const BoxFrame& frame, Item& item, Candidate& candidate) {
    const std::size_t stride = normals_.stride();
    float* const own = own_.data() + candidate.item * stride;
    float* const reach = reach_.data() + candidate.item * stride;
    float* const limit = limit_.data() + candidate.item * stride;
    for (const Facet& facet : facets_of(item)) {
        const double low = low_[facet.direction];
        const double high = high_[facet.direction];
        // Of planes with one normal the farther one never comes out as the nearer one.
        own[column_of_[facet.direction]] =
            static_cast<float>((facet.d2 - 0.5 * (low + high)) / (0.5 * (high - low)));
    }
    for (const Facet& facet : facets_of(item)) {
        const std::uint32_t column = column_of_[facet.direction];
        normals_.bound_by(column, own[column], reach);
    }
    candidate.loose.first = static_cast<std::uint32_t>(seen_.size());
    for (const Loose plane : loose_of(item)) {
        const HalfPlane& h = half_plane(plane);
        const Sight sight(frame, h);
        SeenLoose seen{{h.nx, h.ny, h.nz, frame, sight.reach},
                       static_cast<float>(-sight.above / sight.reach),
                       plane};
        normals_.bound_by(seen.normal, seen.e, reach);
        seen_.push_back(seen);
    }
    candidate.loose.count = item.loose.count;

    // What is implied by a plane that is itself implied is implied by what implies that.
    candidate.depth = 1.0F;
    const auto is_needless = [&](const Facet& facet) {
        const std::uint32_t column = column_of_[facet.direction];
        if (reach[column] + row::kMargin < own[column]) return true;
        candidate.depth = std::min(candidate.depth, own[column]);
        limit[column] = own[column];
        return false;
    };
    const std::span<Facet> facets = facets_of(item);
    item.facets.count = static_cast<std::uint32_t>(
        std::remove_if(facets.begin(), facets.end(), is_needless) - facets.begin());
    if (item.loose.count > 0) {
        candidate.planes = seen_planes_.end_group();
        candidate.planes_end = see_planes(item, candidate);
    }
    std::uint32_t kept = 0;
    const std::span<SeenLoose> seen = std::span(seen_).subspan(candidate.loose.first);
    for (const SeenLoose& plane : seen) {
        if (seen_planes_.imply(candidate.planes, candidate.planes_end, plane.normal, plane.e))
            continue;
        candidate.depth = std::min(candidate.depth, plane.e);
        loose_[item.loose.first + kept++] = plane.plane;
    }
    if (kept < item.loose.count) {
        std::size_t to = 0;
        for (const SeenLoose& plane : seen) {
            if (to < kept && plane.plane.pool == loose_[item.loose.first + to].pool)
                seen[to++] = plane;
        }
        item.loose.count = candidate.loose.count = kept;
        seen_.resize(candidate.loose.first + kept);
    }
    for (std::size_t i = 0; i < stride; ++i) {
        reach[i] = std::min(reach[i] + row::kMargin, own[i]);
        candidate.reach += std::min(reach[i], 1.0F);
    }
    candidate.planes = seen_planes_.end_group();
    candidate.planes_end = see_planes(item, candidate);
}

// All planes of an item as a group; where it ends.
std::size_t BlockTree::Insertion::see_planes(const Item& item, const Candidate& candidate) {
    const float* const own = own_.data() + candidate.item * normals_.stride();
    for (const Facet& facet : facets_of(item)) {
        const std::uint32_t column = column_of_[facet.direction];
        seen_planes_.add(scaled_[column], own[column]);
    }
    for (std::size_t i = 0; i < item.loose.count; ++i) {
        const SeenLoose& plane = seen_[candidate.loose.first + i];
        seen_planes_.add(plane.normal, plane.e);
    }
    return seen_planes_.end_group();
}

// Is the part of `a` in the box within `b`?
Domination BlockTree::Insertion::covered(const Candidate& a, const Candidate& b,
                                         std::span<const Item> items) const {
    const std::size_t stride = normals_.stride();
    const float* const reach = reach_.data() + a.item * stride;
    const float* const limit = limit_.data() + b.item * stride;
    if (!is_below(reach, limit, stride)) return Domination::None;
    const Item& item = items[a.item];
    const Item& other = items[b.item];
    Domination result = Domination::Strict;
    const float* const own = own_.data() + a.item * stride;
    for (const Facet& facet : facets_of(other)) {
        const std::uint32_t column = column_of_[facet.direction];
        if (own[column] != limit[column]) continue;
        const std::span<const Facet> facets = facets_of(item);
        const auto same = std::ranges::find(facets, facet.direction, &Facet::direction);
        if (same == facets.end() || same->d2 > facet.d2) return Domination::None;
        if (same->d2 == facet.d2) result = Domination::Coplanar;
    }
    for (std::size_t i = 0; i < b.loose.count && result != Domination::None; ++i)
        result = std::min(result, covered(a, item, seen_[b.loose.first + i], other));
    return result;
}

// Is what the item has in the box below a loose plane of another?
Domination BlockTree::Insertion::covered(const Candidate& a, const Item& item, const SeenLoose& p,
                                         const Item& its_item) const {
    if (seen_planes_.imply(a.planes, a.planes_end, p.normal, p.e)) return Domination::Strict;
    // Equal planes, or nearly so, are left to integers.
    const Plane& plane = exact(its_item, pool_[p.plane.pool].plane);
    for (const Loose mine : loose_of(item)) {
        const Plane& m = exact(item, pool_[mine.pool].plane);
        if (!m.is_parallel_to(plane) || !same_direction(m, plane)) continue;
        const int order = compare_distances(m, plane);
        if (order >= 0) return order == 0 ? Domination::Coplanar : Domination::Strict;
    }
    return Domination::None;
}

// Of items from `begin` on, keeps what no other one covers in the box.
void BlockTree::Insertion::drop_redundant(const BoxFrame& frame, std::size_t begin) {
    const std::span<Item> items = std::span(items_).subspan(begin);
    if (!make_table(frame, items)) return;
    const std::size_t size = items.size() * normals_.stride();
    own_.assign(size, row::kUnknown);
    reach_.assign(size, row::kUnknown);
    limit_.assign(size, row::kAnything);
    seen_.clear();
    seen_planes_.clear();
    candidates_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        candidates_[i] = {};
        candidates_[i].item = i;
        fill_rows(frame, items[i], candidates_[i]);
    }
    // What lies within another reaches no farther, and is no deeper: asked later, it is covered by
    // what came before, not the other way round.
    const auto extent = [](const Candidate& c) { return std::pair{c.reach, c.depth}; };
    std::ranges::sort(candidates_, [&](const Candidate& a, const Candidate& b) {
        return extent(a) != extent(b)
                   ? extent(a) > extent(b)
                   : table_->comes_before(items[a.item].number, items[b.item].number);
    });
    const auto is_redundant = [&](const Candidate& a, const Candidate& b) {
        const Domination found = covered(a, b, items);
        // Of facets in one plane the first one is the wall.
        return found == Domination::Strict ||
               (found == Domination::Coplanar &&
                table_->comes_before(items[b.item].number, items[a.item].number));
    };
    kept_.clear();
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const Candidate& a = candidates_[c];
        bool is_needed = true;
        for (std::size_t i = 0; i < std::min(kept_.size(), kComparisons) && is_needed; ++i) {
            const Candidate& b = candidates_[kept_[i]];
            is_needed = !is_redundant(a, b);
            if (!is_needed || extent(a) != extent(b) || !is_redundant(b, a)) continue;
            kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
            --i;
        }
        if (is_needed) kept_.push_back(c);
    }
    for (std::size_t& kept : kept_)
        kept = candidates_[kept].item;
    std::ranges::sort(kept_);
    for (std::size_t i = 0; i < kept_.size(); ++i)
        items[i] = items[kept_[i]];
    items_.resize(begin + kept_.size());
}

// Where a half of the box begins and ends along the normals of the table.
void BlockTree::Insertion::look_into_half(const BoxFrame& box, const BoxFrame& half) {
    for (const std::uint32_t direction : directions_) {
        const ScaledNormal& normal = scaled_[column_of_[direction]];
        const double reach = 0.5 * (high_[direction] - low_[direction]);
        double middle = 0.5 * (high_[direction] + low_[direction]);
        double rest = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            // Along the axis, in half extents of the whole box, times the length of the normal.
            const double n = reach * static_cast<double>(normal.n[i]);
            middle += n * (half.centre[i] - box.centre[i]) / box.half[i];
            rest += std::abs(n) * half.half[i] / box.half[i];
        }
        half_low_[direction] = middle - rest;
        half_high_[direction] = middle + rest;
    }
}

// Along the axis that parts the cells best; the longest of those that do as well.
BlockTree::Insertion::Cut BlockTree::Insertion::best_cut(const HalfBox& box, std::size_t begin) {
    const std::span<const Item> items = std::span(items_).subspan(begin);
    const std::size_t longest = box.longest_axis();
    if (box.extent(longest) < kSmallestBox) return {};
    if (items.size() > kManyCells) return {longest, true};
    half_low_.resize(low_.size());
    half_high_.resize(low_.size());
    const BoxFrame whole(box);
    Cut best;
    double best_cost = std::numeric_limits<double>::max();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (box.extent(axis) < kSmallestBox) continue;
        std::size_t total = 0;
        for (const bool upper : {false, true}) {
            const HalfBox half = box.half(axis, upper);
            const BoxFrame frame(half);
            look_into_half(whole, frame);
            std::size_t here = 0;
            for (const Item& item : items) {
                bool outside = false;
                bool cut = false;
                for (const Facet& facet : facets_of(item)) {
                    const std::uint32_t d = facet.direction;
                    cut = cut || half_high_[d] > facet.d2;
                    outside = half_low_[d] >= facet.d2;
                    if (outside) break;
                }
                for (std::size_t k = 0; k < item.loose.count && !outside; ++k) {
                    const Side side = side_of(frame, half_plane(loose_of(item)[k]));
                    cut = cut || side == Side::On;
                    outside = side == Side::Above;
                }
                if (outside) continue;
                if (!cut) {
                    here = 0;
                    break;
                }
                ++here;
            }
            total += here;
        }
        const double shape =
            static_cast<double>(box.extent(axis)) / static_cast<double>(box.extent(longest));
        const double cost =
            static_cast<double>(total) / static_cast<double>(items.size()) - kShortAxis * shape;
        if (cost < best_cost) {
            best_cost = cost;
            // Less than half of the cells in both halves: one was cut off rather.
            best = {axis, 2 * total <= 3 * items.size()};
        }
    }
    return best;
}

void BlockTree::Insertion::store(std::uint32_t number, std::size_t begin) {
    const std::span<const Item> items = std::span(items_).subspan(begin);
    std::vector<std::uint32_t>& words = tree_->nodes_[number].cells;
    words.clear();
    std::size_t size = 0;
    for (const Item& item : items)
        size += kHead + item.facets.count + item.loose.count;
    words.reserve(size);
    for (const Item& item : items) {
        words.push_back(item.number);
        words.push_back(item.facets.count + item.loose.count);
        const auto write = [&](std::uint32_t plane, std::uint16_t facet) {
            if (!item.cell) {
                words.push_back(plane);
                return;
            }
            std::uint32_t& stored = stored_[item.stored + plane];
            if (stored == kNone) {
                stored = static_cast<std::uint32_t>(tree_->planes_.size());
                tree_->planes_.push_back(item.cell->planes[plane]);
                tree_->facets_.push_back(facet);
            }
            words.push_back(stored);
        };
        for (const Facet& facet : facets_of(item))
            write(facet.plane, static_cast<std::uint16_t>(facet.plane));
        for (const Loose plane : loose_of(item))
            write(pool_[plane.pool].plane, kLoose);
    }
}

}  // namespace ncsim::cda
