// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cell goes down with the planes that are *active*: those that cut the box of the node. A
// plane that has the box above it ends the way (the cell is not here); when no plane is left, the
// cell covers the box and the node is empty for good.
#include "block_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ncsim::cda {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Boxes are not split below this many half units: cells that meet in a line or a point cannot be
// told apart by smaller boxes, only multiplied.
constexpr std::int64_t kSmallestBox = 2048;
// Splits in a row that part nothing before a list is left as it is.
constexpr int kFruitlessSplits = 3;
// Of more cells than this each is compared with so many others only.
constexpr std::size_t kManyCells = 64;
constexpr std::size_t kComparisons = 16;
// Planes on the way down are not looked at for being implied if they are as few as this.
constexpr std::size_t kFewPlanes = 4;
// Levels before a plane that was not implied is asked for again: boxes shrink by half an axis each.
constexpr std::uint16_t kPatience = 2;
// Walls of boxes move inwards where that makes the box an eighth shorter.
constexpr double kWorthShrinking = 0.75;
// Planes are looked through for unused ones when there are this many times those last used.
constexpr std::size_t kPlaneGrowth = 3;
constexpr std::size_t kPlanesWorthDropping = 4096;

// Is the plane not needed in the box, because one beside it is all that can be seen of the cell
// there? Asked only where its facet seems to be somewhere else.
bool is_implied(const BoxFrame& frame, const IncomingCell& cell, std::size_t plane) {
    const FacetHint& hint = cell.hints[plane];
    bool is_elsewhere = false;
    for (std::size_t i = 0; i < 3; ++i) {
        // Hints are in whole units.
        is_elsewhere = is_elsewhere || 2.0 * hint.min[i] > frame.centre[i] + frame.half[i] ||
                       2.0 * hint.max[i] < frame.centre[i] - frame.half[i];
    }
    if (!is_elsewhere) return false;
    // The neighbour that has most of the plane above it, seen from the middle of the box.
    const HalfPlane& h = cell.half_planes[plane];
    const double above =
        h.nx * frame.centre[0] + h.ny * frame.centre[1] + h.nz * frame.centre[2] - h.d2;
    const double step = above / (h.nx * h.nx + h.ny * h.ny + h.nz * h.nz);
    const double x = frame.centre[0] - step * h.nx;
    const double y = frame.centre[1] - step * h.ny;
    const double z = frame.centre[2] - step * h.nz;
    std::size_t best = hint.count;
    double highest = 0.0;
    for (std::size_t k = 0; k < hint.count; ++k) {
        const HalfPlane& m = cell.half_planes[hint.neighbours[k]];
        const double height = m.nx * x + m.ny * y + m.nz * z - m.d2;
        if (height <= highest) continue;
        highest = height;
        best = k;
    }
    if (best == hint.count) return false;
    const std::size_t beside = hint.neighbours[best];
    return implies(BoxPlane(cell.half_planes[beside], cell.planes[beside], frame),
                   BoxPlane(h, cell.planes[plane], frame)) == Domination::Strict;
}

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

}  // namespace

// Cells on their way down: stacks that all levels share. A level adds what is left of the cells of
// the level above in its box, and takes it away again.
struct BlockTree::Work {
    // All planes met, once each and cell.
    struct PlaneEntry {
        HalfPlane half_plane;
        std::uint32_t stored = kNone;  // index in planes_, kNone before it is needed
    };
    struct ActivePlane {
        std::uint32_t index = 0;     // in pool
        std::uint32_t patience = 0;  // levels before it is asked again whether it is implied
    };
    struct Item {
        const IncomingCell* cell = nullptr;  // null: was in the tree before
        std::uint32_t number = 0;
        std::uint32_t pool = 0;              // where its planes begin there
        std::uint32_t first = 0, count = 0;  // in planes
    };
    // Of the planes from `first` on, those of one item, keeps what cuts the box, first what is most
    // likely above a smaller one; none if the item is not in the box. False: it is all of the box.
    bool keep_active(const BoxFrame& frame, std::size_t first);
    // Once more, at the end; where they begin.
    std::size_t copy_planes(const Item& item) {
        const std::size_t first = planes.size();
        planes.resize(first + item.count);
        std::copy_n(planes.begin() + item.first, item.count,
                    planes.begin() + static_cast<std::ptrdiff_t>(first));
        return first;
    }
    bool shrink(HalfBox& box, const Item& item) const;
    std::span<ActivePlane> planes_of(const Item& item) {
        return std::span(planes).subspan(item.first, item.count);
    }
    std::span<const ActivePlane> planes_of(const Item& item) const {
        return std::span(planes).subspan(item.first, item.count);
    }
    // Planes of the items from `begin` on.
    std::size_t load(std::size_t begin) const {
        std::size_t sum = 0;
        for (const Item& item : std::span(items).subspan(begin))
            sum += item.count;
        return sum;
    }
    const HalfPlane& half_plane(const ActivePlane& plane) const {
        return pool[plane.index].half_plane;
    }

    const CellOrder* order = nullptr;
    std::uint32_t leaf = 0;
    std::vector<Item> items;
    std::vector<ActivePlane> planes;
    std::vector<PlaneEntry> pool;
    // Kept for their memory.
    std::vector<BoxPlane> seen;
    std::vector<std::size_t> seen_begin;
    std::vector<Profile> profiles;
    std::vector<std::size_t> kept;
};

BlockTree::BlockTree(const HalfBox& box) : nodes_(1) {
    nodes_[0].set_box(box);
}

HalfBox BlockTree::Node::box() const {
    return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}

void BlockTree::Node::set_box(const HalfBox& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        min[i] = static_cast<std::int32_t>(box.min[i]);
        max[i] = static_cast<std::int32_t>(box.max[i]);
    }
}

void BlockTree::insert(std::span<const IncomingCell> cells, const CellOrder& order,
                       std::uint32_t leaf) {
    if (nodes_[0].kind == Kind::Empty) return;
    thread_local Work work;
    work.order = &order;
    work.leaf = leaf;
    work.items.clear();
    work.planes.clear();
    work.pool.clear();
    const BoxFrame frame(box());
    for (const IncomingCell& cell : cells) {
        if (!meets(frame, cell)) continue;
        Work::Item item;
        item.number = cell.number;
        item.cell = &cell;
        item.pool = static_cast<std::uint32_t>(work.pool.size());
        item.first = static_cast<std::uint32_t>(work.planes.size());
        item.count = static_cast<std::uint32_t>(cell.cutting.size());
        for (const HalfPlane& plane : cell.half_planes)
            work.pool.push_back({plane});
        for (const std::uint16_t plane : cell.cutting)
            work.planes.push_back({item.pool + plane});
        work.items.push_back(item);
    }
    if (work.items.empty()) return;
    insert_at(0, box(), 0, work.items.size(), work, 0, kNone);
    if (planes_.size() > kPlaneGrowth * planes_after_drop_ + kPlanesWorthDropping) {
        drop_unused_planes();
    }
}

bool BlockTree::meets_any(std::span<const IncomingCell> cells) const {
    if (nodes_[0].kind == Kind::Empty) return false;
    const BoxFrame frame(box());
    return std::any_of(cells.begin(), cells.end(),
                       [&](const IncomingCell& cell) { return meets(frame, cell); });
}

// Moves a wall of the box to where the cell with these planes begins to cover all that is beyond;
// but not for a little.
bool BlockTree::Work::shrink(HalfBox& box, const Item& item) const {
    const BoxFrame frame(box);
    const std::span<const ActivePlane> its_planes = planes_of(item);
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_upper = half_plane(its_planes[0]).normal(i) < 0;
        const double not_worth_it = kWorthShrinking * frame.half[i];
        // How far out from the middle the cell's surface reaches.
        double outermost = -frame.half[i];
        for (const ActivePlane& plane : its_planes) {
            const HalfPlane& h = half_plane(plane);
            const double n = h.normal(i);
            if (is_upper ? n >= 0 : n <= 0) {
                outermost = frame.half[i];
            } else {
                const Sight sight(frame, h);
                outermost =
                    std::max(outermost, (sight.reach + sight.above) / std::abs(n) - frame.half[i]);
            }
            if (outermost > not_worth_it) break;
        }
        if (outermost > not_worth_it) continue;
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

bool BlockTree::Work::keep_active(const BoxFrame& frame, std::size_t first) {
    std::size_t end_of_kept = first;
    std::size_t highest = first;
    double most = -1.0;
    for (std::size_t k = first; k < planes.size(); ++k) {
        const ActivePlane plane = planes[k];
        const Sight sight(frame, half_plane(plane));
        const Side side = sight.side();
        if (side == Side::Above) {
            planes.resize(first);
            return true;
        }
        if (side == Side::Below) continue;
        if (sight.above > most * sight.reach) {
            most = sight.above / sight.reach;
            highest = end_of_kept;
        }
        planes[end_of_kept++] = plane;
    }
    planes.resize(end_of_kept);
    if (end_of_kept == first) return false;
    std::swap(planes[first], planes[highest]);
    return true;
}

// Items [begin, end) of the level above; what is not within the box has been taken away.
void BlockTree::insert_at(std::uint32_t number, const HalfBox& within, std::size_t begin,
                          std::size_t end, Work& work, int fruitless, std::size_t parent_load) {
    const HalfBox before = nodes_[number].box();
    HalfBox box = intersection(before, within);
    const std::size_t my_items = work.items.size();
    const std::size_t my_planes = work.planes.size();
    const std::size_t my_pool = work.pool.size();
    const auto leave = [&] {
        work.items.resize(my_items);
        work.planes.resize(my_planes);
        work.pool.resize(my_pool);
    };
    // What the item has here; false if that is all of the box.
    const auto take = [&](std::size_t i) {
        if (box.is_empty()) return false;
        const BoxFrame frame(box);
        Work::Item item = work.items[i];
        if (item.cell && !meets(frame, *item.cell)) return true;
        const std::size_t first = work.copy_planes(item);
        if (!work.keep_active(frame, first)) return false;
        if (work.planes.size() == first) return true;
        if (item.cell && !item.cell->hints.empty() && work.planes.size() - first > kFewPlanes) {
            // What is implied by a plane that is itself implied is implied by what implies that.
            const auto is_dropped = [&](Work::ActivePlane& plane) {
                if (plane.patience > 0) {
                    --plane.patience;
                    return false;
                }
                plane.patience = kPatience;
                return is_implied(frame, *item.cell, plane.index - item.pool);
            };
            work.planes.erase(
                std::remove_if(work.planes.begin() + static_cast<std::ptrdiff_t>(first),
                               work.planes.end(), is_dropped),
                work.planes.end());
        }
        item.first = static_cast<std::uint32_t>(first);
        item.count = static_cast<std::uint32_t>(work.planes.size() - first);
        work.items.push_back(item);
        work.shrink(box, item);
        return true;
    };
    // First the cell that has the box nearest to its middle: it may cover all of it.
    std::size_t hopeful = end;
    double nearest = std::numeric_limits<double>::max();
    const BoxFrame frame(box);
    for (std::size_t i = begin; i < end; ++i) {
        const IncomingCell* cell = work.items[i].cell;
        if (!cell) continue;
        double distance = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            distance =
                std::max(distance, std::abs(cell->min[k] + cell->max[k] - 2.0 * frame.centre[k]) /
                                       (cell->max[k] - cell->min[k]));
        }
        if (distance >= nearest) continue;
        nearest = distance;
        hopeful = i;
    }
    bool is_covered = box.is_empty() || (hopeful < end && !take(hopeful));
    for (std::size_t i = begin; i < end && !is_covered; ++i) {
        if (i != hopeful) is_covered = !take(i);
    }
    const bool has_shrunk = box != before;
    if (is_covered || box.is_empty()) {
        become_empty(number);
    } else if (work.items.size() == my_items && !has_shrunk) {
        // Nothing of them is here.
    } else if (nodes_[number].kind == Kind::Material) {
        take_out(number, work);
        build(number, box, my_items, work, fruitless, parent_load);
    } else {
        const std::size_t my_end = work.items.size();
        const std::uint32_t first = nodes_[number].first_child;
        for (const std::uint32_t child : {first, first + 1}) {
            if (nodes_[child].kind == Kind::Empty) continue;
            insert_at(child, box, my_items, my_end, work, 0, kNone);
        }
        enclose_children(number);
    }
    leave();
}

// Adds the cells of a leaf to the items.
void BlockTree::take_out(std::uint32_t number, Work& work) const {
    const std::span<const std::uint32_t> words(nodes_[number].cells);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1]) {
        Work::Item item;
        item.number = words[at];
        item.pool = static_cast<std::uint32_t>(work.pool.size());
        item.first = static_cast<std::uint32_t>(work.planes.size());
        item.count = words[at + 1];
        for (const std::uint32_t plane : words.subspan(at + kHead, item.count)) {
            work.planes.push_back({static_cast<std::uint32_t>(work.pool.size())});
            work.pool.push_back({HalfPlane(planes_[plane]), plane});
        }
        work.items.push_back(item);
    }
}

// Cuts off from the box what one of the items from `begin` on covers, and from the items what is
// not in it. False: nothing is left of it.
bool BlockTree::settle(HalfBox& box, std::size_t begin, Work& work) {
    for (bool has_shrunk = true; has_shrunk;) {
        const BoxFrame frame(box);
        std::size_t kept = begin;
        for (std::size_t i = begin; i < work.items.size(); ++i) {
            Work::Item item = work.items[i];
            const std::size_t first = work.copy_planes(item);
            if (!work.keep_active(frame, first)) return false;
            const auto count = static_cast<std::uint32_t>(work.planes.size() - first);
            if (count == 0) continue;
            std::copy(work.planes.begin() + static_cast<std::ptrdiff_t>(first), work.planes.end(),
                      work.planes.begin() + static_cast<std::ptrdiff_t>(item.first));
            work.planes.resize(first);
            item.count = count;
            work.items[kept++] = item;
        }
        work.items.resize(kept);
        has_shrunk = false;
        for (std::size_t i = begin; i < kept && !box.is_empty(); ++i)
            has_shrunk |= work.shrink(box, work.items[i]);
        if (box.is_empty()) return false;
    }
    return true;
}

// Makes a leaf of the items from `begin` on, or a tree if they are too many.
void BlockTree::build(std::uint32_t number, HalfBox box, std::size_t begin, Work& work,
                      int fruitless, std::size_t parent_load) {
    if (!settle(box, begin, work)) {
        become_empty(number);
        return;
    }
    nodes_[number].set_box(box);
    const BoxFrame frame(box);
    std::size_t load = work.load(begin);
    if (load > work.leaf) {
        drop_redundant(frame, begin, work);
        load = work.load(begin);
    }

    const std::size_t limit = std::max(work.leaf, nodes_[number].limit);
    // A split that left nearly all of it in both halves.
    const bool was_in_vain = 10 * load > 9 * parent_load;
    fruitless = was_in_vain ? fruitless + 1 : 0;
    Cut cut;
    if (load > limit && fruitless < kFruitlessSplits) cut = best_cut(box, begin, work);
    if (cut.axis == 3) {
        store(number, begin, work);
        if (load > limit) nodes_[number].limit = static_cast<std::uint32_t>(2 * load);
        return;
    }
    std::uint32_t first = 0;
    if (free_children_.empty()) {
        first = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
    } else {
        first = free_children_.back();
        free_children_.pop_back();
    }
    nodes_[number].kind = Kind::Inner;
    nodes_[number].first_child = first;
    nodes_[number].limit = 0;
    nodes_[number].cells = {};
    const std::size_t end = work.items.size();
    for (const bool upper : {false, true}) {
        const std::uint32_t child = first + static_cast<std::uint32_t>(upper);
        nodes_[child] = {};
        nodes_[child].set_box(box.half(cut.axis, upper));
        insert_at(child, box, begin, end, work, fruitless, cut.parts ? kNone : load);
    }
    enclose_children(number);
}

// Of items from `begin` on, keeps what no other one covers in the box.
void BlockTree::drop_redundant(const BoxFrame& frame, std::size_t begin, Work& work) const {
    const std::span<Work::Item> items = std::span(work.items).subspan(begin);
    work.seen.clear();
    work.seen_begin.clear();
    work.profiles.clear();
    for (const Work::Item& item : items) {
        const std::size_t first = work.seen.size();
        work.seen_begin.push_back(first);
        for (const Work::ActivePlane& plane : work.planes_of(item)) {
            const Work::PlaneEntry& entry = work.pool[plane.index];
            work.seen.emplace_back(
                entry.half_plane,
                item.cell ? item.cell->planes[plane.index - item.pool] : planes_[entry.stored],
                frame);
        }
        work.profiles.emplace_back(std::span(work.seen).subspan(first));
    }
    work.seen_begin.push_back(work.seen.size());
    const auto seen = [&](std::size_t i) {
        return std::span(work.seen).subspan(work.seen_begin[i],
                                            work.seen_begin[i + 1] - work.seen_begin[i]);
    };
    // `a` is not needed beside `b`.
    const auto is_redundant = [&](std::size_t a, std::size_t b) {
        if (!work.profiles[a].may_be_covered_by(work.profiles[b])) return false;
        const Domination found = dominated(seen(a), seen(b));
        // Of facets in one plane the first one is the wall.
        return found == Domination::Strict ||
               (found == Domination::Coplanar && (*work.order)(items[b].number, items[a].number));
    };
    // Of many cells each is compared with a few that were kept: smaller boxes tell the rest.
    const std::size_t most = items.size() > kManyCells ? kComparisons : items.size();
    std::vector<std::size_t>& kept = work.kept;
    kept.clear();
    for (std::size_t a = 0; a < items.size(); ++a) {
        bool is_needed = true;
        const std::size_t from = kept.size() > most ? kept.size() - most : 0;
        std::size_t to = from;
        for (std::size_t i = from; i < kept.size(); ++i) {
            const std::size_t b = kept[i];
            if (is_needed && is_redundant(a, b)) is_needed = false;
            if (is_needed && is_redundant(b, a)) continue;
            kept[to++] = b;
        }
        kept.resize(to);
        if (is_needed) kept.push_back(a);
    }
    std::sort(kept.begin(), kept.end());
    for (std::size_t i = 0; i < kept.size(); ++i)
        items[i] = items[kept[i]];
    work.items.resize(begin + kept.size());
}

// Along the axis that parts the cells best; the longest of those that do as well.
BlockTree::Cut BlockTree::best_cut(const HalfBox& box, std::size_t begin, const Work& work) {
    const std::span<const Work::Item> items = std::span(work.items).subspan(begin);
    const std::size_t longest = box.longest_axis();
    if (box.extent(longest) < kSmallestBox) return {};
    if (items.size() > kManyCells) return {longest, true};
    Cut best;
    double best_cost = std::numeric_limits<double>::max();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (box.extent(axis) < kSmallestBox) continue;
        std::size_t total = 0;
        for (const bool upper : {false, true}) {
            const BoxFrame frame(box.half(axis, upper));
            std::size_t here = 0;
            for (const Work::Item& item : items) {
                bool outside = false;
                bool cut = false;
                for (const Work::ActivePlane& plane : work.planes_of(item)) {
                    const Side side = side_of(frame, work.half_plane(plane));
                    cut = cut || side == Side::On;
                    outside = side == Side::Above;
                    if (outside) break;
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
            static_cast<double>(total) / static_cast<double>(items.size()) - 0.25 * shape;
        if (cost < best_cost) {
            best_cost = cost;
            // Less than half of the cells in both halves: one was cut off rather.
            best = {axis, 2 * total <= 3 * items.size()};
        }
    }
    return best;
}

void BlockTree::store(std::uint32_t number, std::size_t begin, Work& work) {
    const std::span<Work::Item> items = std::span(work.items).subspan(begin);
    std::vector<std::uint32_t>& words = nodes_[number].cells;
    words.clear();
    std::size_t size = 0;
    for (const Work::Item& item : items)
        size += kHead + item.count;
    words.reserve(size);
    for (const Work::Item& item : items) {
        words.push_back(item.number);
        words.push_back(static_cast<std::uint32_t>(item.count));
        for (const Work::ActivePlane& plane : work.planes_of(item)) {
            std::uint32_t& stored = work.pool[plane.index].stored;
            if (stored == kNone) {
                stored = static_cast<std::uint32_t>(planes_.size());
                planes_.push_back(item.cell->planes[plane.index - item.pool]);
            }
            words.push_back(stored);
        }
    }
}

void BlockTree::become_empty(std::uint32_t number) {
    release(number);
    nodes_[number].kind = Kind::Empty;
}

// Of an inner node, once its children have changed.
void BlockTree::enclose_children(std::uint32_t number) {
    const Node& a = nodes_[nodes_[number].first_child];
    const Node& b = nodes_[nodes_[number].first_child + 1];
    if (a.kind == Kind::Empty && b.kind == Kind::Empty) {
        become_empty(number);
    } else if (a.kind == Kind::Empty || b.kind == Kind::Empty) {
        nodes_[number].set_box((a.kind == Kind::Empty ? b : a).box());
    } else {
        nodes_[number].set_box(enclosing(a.box(), b.box()));
    }
}

void BlockTree::release(std::uint32_t number) {
    Node& node = nodes_[number];
    if (node.kind == Kind::Inner) {
        const std::uint32_t first = node.first_child;
        release(first);
        release(first + 1);
        free_children_.push_back(first);
    }
    nodes_[number] = {};
}

void BlockTree::drop_unused_planes() {
    std::vector<std::uint32_t> renumbered(planes_.size(), kNone);
    std::vector<Plane> used;
    for (Node& node : nodes_) {
        std::vector<std::uint32_t>& words = node.cells;
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1]) {
            for (std::uint32_t k = 0; k < words[at + 1]; ++k) {
                std::uint32_t& index = words[at + kHead + k];
                if (renumbered[index] == kNone) {
                    renumbered[index] = static_cast<std::uint32_t>(used.size());
                    used.push_back(planes_[index]);
                }
                index = renumbered[index];
            }
        }
    }
    planes_ = std::move(used);
    planes_after_drop_ = planes_.size();
}

void BlockTree::visit(
    const std::function<bool(const HalfBox&)>& enter,
    const std::function<void(const HalfBox&, std::span<const Entry>)>& leaf) const {
    std::vector<Entry> entries;
    const auto go = [&](const auto& self, std::uint32_t number) -> void {
        const Node& node = nodes_[number];
        const HalfBox box = node.box();
        if (node.kind == Kind::Empty || !enter(box)) return;
        if (node.kind == Kind::Inner) {
            self(self, node.first_child);
            self(self, node.first_child + 1);
            return;
        }
        entries.clear();
        const std::span<const std::uint32_t> words(node.cells);
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1])
            entries.push_back({words[at], words.subspan(at + kHead, words[at + 1])});
        leaf(box, entries);
    };
    go(go, 0);
}

bool BlockTree::find(const std::array<std::int64_t, 3>& point, std::vector<Entry>& entries) const {
    constexpr std::int64_t kHalfUnit = std::int64_t{1} << 15;
    const auto is_in = [&](const Node& node) {
        bool result = node.kind != Kind::Empty;
        for (std::size_t i = 0; i < 3; ++i) {
            result = result && point[i] >= node.min[i] * kHalfUnit &&
                     point[i] <= node.max[i] * kHalfUnit;
        }
        return result;
    };
    std::uint32_t number = 0;
    if (!is_in(nodes_[number])) return false;
    while (nodes_[number].kind == Kind::Inner) {
        number = nodes_[number].first_child;
        if (is_in(nodes_[number])) continue;
        if (!is_in(nodes_[++number])) return false;
    }
    entries.clear();
    const std::span<const std::uint32_t> words(nodes_[number].cells);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1])
        entries.push_back({words[at], words.subspan(at + kHead, words[at + 1])});
    return true;
}

std::size_t BlockTree::memory() const {
    std::size_t bytes = sizeof(*this) + nodes_.capacity() * sizeof(Node) +
                        free_children_.capacity() * sizeof(std::uint32_t) +
                        planes_.capacity() * sizeof(Plane);
    for (const Node& node : nodes_)
        bytes += node.cells.capacity() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace ncsim::cda
