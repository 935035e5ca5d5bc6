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
// Planes are looked through for unused ones when there are this many times those last used.
constexpr std::size_t kPlaneGrowth = 3;
constexpr std::size_t kPlanesWorthDropping = 4096;

BoxPlane seen_from(const BoxFrame& frame, const HalfPlane& p, const Plane& exact) {
    BoxPlane result;
    result.n = {p.nx, p.ny, p.nz};
    result.e = p.d2 - p.nx * frame.centre[0] - p.ny * frame.centre[1] - p.nz * frame.centre[2];
    result.exact = &exact;
    return result;
}

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
    return implies(seen_from(frame, cell.half_planes[beside], cell.planes[beside]),
                   seen_from(frame, h, cell.planes[plane]), frame.half) == Domination::Strict;
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
    struct ActivePlane {
        HalfPlane half_plane;
        std::uint32_t stored = 0;    // index in planes_, kNone before it is needed
        std::uint16_t local = 0;     // index in the incoming cell
        std::uint16_t patience = 0;  // levels before it is asked again whether it is implied
    };
    struct Item {
        std::uint32_t number = 0;
        const IncomingCell* cell = nullptr;  // null: was in the tree before
        std::size_t first = 0, count = 0;    // in planes
        bool is_new = true;                  // Not yet compared with others in this box
        Profile profile;
        std::uint32_t* stored = nullptr;  // of an incoming cell: where its planes are in planes_
    };
    const CellOrder* order = nullptr;
    std::uint32_t leaf = 0;
    std::vector<Item> items;
    std::vector<ActivePlane> planes;
    std::uint32_t last_cover = kNone;   // number of the cell that last covered a box
    std::vector<std::uint32_t> stored;  // of all cells, see Item
    // Kept for their memory.
    std::vector<BoxPlane> seen;
    std::vector<std::size_t> seen_begin;
    std::vector<std::size_t> kept;
};

void BlockTree::insert(std::span<const IncomingCell> cells, const CellOrder& order,
                       std::uint32_t leaf) {
    if (nodes_[0].kind == Kind::Empty) return;
    thread_local Work work;
    work.order = &order;
    work.leaf = leaf;
    work.items.clear();
    work.planes.clear();
    work.stored.clear();
    const BoxFrame frame(box_);
    std::size_t count = 0;
    std::vector<const IncomingCell*> here;
    for (const IncomingCell& cell : cells) {
        if (!meets(frame, cell)) continue;
        here.push_back(&cell);
        count += cell.planes.size();
    }
    if (here.empty()) return;
    work.stored.assign(count, kNone);
    std::uint32_t* next = work.stored.data();
    for (const IncomingCell* cell : here) {
        Work::Item item;
        item.number = cell->number;
        item.cell = cell;
        item.first = work.planes.size();
        item.count = cell->cutting.size();
        item.stored = next;
        next += cell->planes.size();
        for (const std::uint16_t plane : cell->cutting)
            work.planes.push_back({cell->half_planes[plane], kNone, plane});
        work.items.push_back(item);
    }
    insert_at(0, box_, 0, work.items.size(), work, 0, kNone);
    if (planes_.size() > kPlaneGrowth * planes_after_drop_ + kPlanesWorthDropping) {
        drop_unused_planes();
    }
}

bool BlockTree::meets_any(std::span<const IncomingCell> cells) const {
    if (nodes_[0].kind == Kind::Empty) return false;
    const BoxFrame frame(box_);
    return std::any_of(cells.begin(), cells.end(),
                       [&](const IncomingCell& cell) { return meets(frame, cell); });
}

// Items [begin, end) of the level above.
void BlockTree::insert_at(std::uint32_t number, const HalfBox& box, std::size_t begin,
                          std::size_t end, Work& work, int fruitless, std::size_t parent_load) {
    const BoxFrame frame(box);
    const std::size_t my_items = work.items.size();
    const std::size_t my_planes = work.planes.size();
    const auto leave = [&] {
        work.items.resize(my_items);
        work.planes.resize(my_planes);
    };
    // What the item has here; false if that is all of the box.
    const auto take = [&](std::size_t i) {
        Work::Item item = work.items[i];
        const std::size_t first = work.planes.size();
        for (std::size_t k = item.first; k < item.first + item.count; ++k) {
            const Work::ActivePlane plane = work.planes[k];
            const Side side = side_of(frame, plane.half_plane);
            if (side == Side::Above) {
                work.planes.resize(first);
                return true;
            }
            if (side == Side::On) work.planes.push_back(plane);
        }
        if (work.planes.size() == first) return false;
        if (item.cell && !item.cell->hints.empty() && work.planes.size() - first > kFewPlanes) {
            // What is implied by a plane that is itself implied is implied by what implies that.
            const auto is_dropped = [&](Work::ActivePlane& plane) {
                if (plane.patience > 0) {
                    --plane.patience;
                    return false;
                }
                plane.patience = kPatience;
                return is_implied(frame, *item.cell, plane.local);
            };
            work.planes.erase(
                std::remove_if(work.planes.begin() + static_cast<std::ptrdiff_t>(first),
                               work.planes.end(), is_dropped),
                work.planes.end());
        }
        item.first = first;
        item.count = work.planes.size() - first;
        item.is_new = true;
        work.items.push_back(item);
        return true;
    };
    // First the cell that has the box nearest to its middle: it may cover all of it.
    std::size_t hopeful = end;
    double nearest = std::numeric_limits<double>::max();
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
    bool is_covered = hopeful < end && !take(hopeful);
    for (std::size_t i = begin; i < end && !is_covered; ++i) {
        if (i != hopeful) is_covered = !take(i);
    }
    if (is_covered) {
        become_empty(number);
    } else if (work.items.size() == my_items) {
        // Nothing of them is here.
    } else if (nodes_[number].kind == Kind::Material) {
        take_out(number, work);
        build(number, box, my_items, work, fruitless, parent_load);
    } else {
        const std::size_t my_end = work.items.size();
        const std::uint32_t first = nodes_[number].first_child;
        const std::size_t axis = nodes_[number].axis;
        for (const bool upper : {false, true}) {
            const std::uint32_t child = first + static_cast<std::uint32_t>(upper);
            if (nodes_[child].kind == Kind::Empty) continue;
            insert_at(child, box.half(axis, upper), my_items, my_end, work, 0, kNone);
        }
        become_empty_if_children_are(number);
    }
    leave();
}

// Adds the cells of a leaf to the items.
void BlockTree::take_out(std::uint32_t number, Work& work) const {
    const std::span<const std::uint32_t> words(nodes_[number].cells);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1]) {
        Work::Item item;
        item.number = words[at];
        item.first = work.planes.size();
        item.count = words[at + 1];
        item.is_new = false;
        for (const std::uint32_t plane : words.subspan(at + kHead, item.count))
            work.planes.push_back({HalfPlane(planes_[plane]), plane, 0});
        work.items.push_back(item);
    }
}

// Makes a leaf of the items from `begin` on, or a tree if they are too many.
void BlockTree::build(std::uint32_t number, const HalfBox& box, std::size_t begin, Work& work,
                      int fruitless, std::size_t parent_load) {
    const BoxFrame frame(box);
    const std::size_t load = drop_redundant(frame, begin, work);

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
    nodes_[number] = {};
    nodes_[number].kind = Kind::Inner;
    nodes_[number].axis = static_cast<std::uint8_t>(cut.axis);
    nodes_[number].first_child = first;
    const std::size_t end = work.items.size();
    for (const bool upper : {false, true}) {
        nodes_[first + static_cast<std::uint32_t>(upper)] = {};
        insert_at(first + static_cast<std::uint32_t>(upper), box.half(cut.axis, upper), begin, end,
                  work, fruitless, cut.parts ? kNone : load);
    }
    become_empty_if_children_are(number);
}

// Of items from `begin` on, keeps what no other one covers in the box. How many planes those have.
std::size_t BlockTree::drop_redundant(const BoxFrame& frame, std::size_t begin, Work& work) const {
    const std::span<Work::Item> items = std::span(work.items).subspan(begin);
    work.seen.clear();
    work.seen_begin.clear();
    for (Work::Item& item : items) {
        const std::size_t first = work.seen.size();
        work.seen_begin.push_back(first);
        for (std::size_t k = item.first; k < item.first + item.count; ++k) {
            const Work::ActivePlane& plane = work.planes[k];
            work.seen.push_back(
                seen_from(frame, plane.half_plane,
                          item.cell ? item.cell->planes[plane.local] : planes_[plane.stored]));
        }
        item.profile = Profile(std::span(work.seen).subspan(first), frame.half);
    }
    work.seen_begin.push_back(work.seen.size());
    const auto seen = [&](std::size_t i) {
        return std::span(work.seen).subspan(work.seen_begin[i],
                                            work.seen_begin[i + 1] - work.seen_begin[i]);
    };
    // `a` is not needed beside `b`.
    const auto is_redundant = [&](std::size_t a, std::size_t b) {
        if (!items[a].profile.may_be_covered_by(items[b].profile)) return false;
        const Domination found = dominated(seen(a), seen(b), frame.half);
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
            const bool ask = is_needed && (items[a].is_new || items[b].is_new);
            if (ask && is_redundant(a, b)) {
                is_needed = false;
            }
            if (ask && is_redundant(b, a)) continue;
            kept[to++] = b;
        }
        kept.resize(to);
        if (is_needed) kept.push_back(a);
    }
    std::sort(kept.begin(), kept.end());
    std::size_t load = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        items[i] = items[kept[i]];
        load += items[i].count;
    }
    work.items.resize(begin + kept.size());
    return load;
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
                for (std::size_t k = item.first; k < item.first + item.count && !outside; ++k) {
                    const Side side = side_of(frame, work.planes[k].half_plane);
                    outside = side == Side::Above;
                    cut = cut || side == Side::On;
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
        for (std::size_t k = item.first; k < item.first + item.count; ++k) {
            const Work::ActivePlane& plane = work.planes[k];
            if (!item.cell) {
                words.push_back(plane.stored);
                continue;
            }
            std::uint32_t& stored = item.stored[plane.local];
            if (stored == kNone) {
                stored = static_cast<std::uint32_t>(planes_.size());
                planes_.push_back(item.cell->planes[plane.local]);
            }
            words.push_back(stored);
        }
    }
}

void BlockTree::become_empty(std::uint32_t number) {
    release(number);
    nodes_[number].kind = Kind::Empty;
}

void BlockTree::become_empty_if_children_are(std::uint32_t number) {
    const std::uint32_t first = nodes_[number].first_child;
    if (nodes_[first].kind == Kind::Empty && nodes_[first + 1].kind == Kind::Empty) {
        become_empty(number);
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
    const auto go = [&](const auto& self, std::uint32_t number, const HalfBox& box) -> void {
        const Node& node = nodes_[number];
        if (node.kind == Kind::Empty || !enter(box)) return;
        if (node.kind == Kind::Inner) {
            self(self, node.first_child, box.half(node.axis, false));
            self(self, node.first_child + 1, box.half(node.axis, true));
            return;
        }
        entries.clear();
        const std::span<const std::uint32_t> words(node.cells);
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1])
            entries.push_back({words[at], words.subspan(at + kHead, words[at + 1])});
        leaf(box, entries);
    };
    go(go, 0, box_);
}

bool BlockTree::find(const std::array<std::int64_t, 3>& point, std::vector<Entry>& entries) const {
    constexpr std::int64_t kHalfUnit = std::int64_t{1} << 15;
    std::uint32_t number = 0;
    HalfBox box = box_;
    while (nodes_[number].kind == Kind::Inner) {
        const std::size_t axis = nodes_[number].axis;
        const bool upper = point[axis] > box.middle(axis) * kHalfUnit;
        box = box.half(axis, upper);
        number = nodes_[number].first_child + static_cast<std::uint32_t>(upper);
    }
    if (nodes_[number].kind == Kind::Empty) return false;
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
