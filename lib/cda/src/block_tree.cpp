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
// Planes are looked through for unused ones when there are this many times those last used.
constexpr std::size_t kPlaneGrowth = 3;
constexpr std::size_t kFewPlanes = 4096;

// `cell` is not needed beside `other`.
bool is_redundant(Domination found, std::uint32_t cell, std::uint32_t other,
                  const CellOrder& order) {
    // Of facets in one plane the first one is the wall.
    return found == Domination::Strict || (found == Domination::Coplanar && order(other, cell));
}

bool may_dominate(std::uint64_t mask, std::uint64_t other) {
    return (other & ~mask) == 0;
}

std::uint64_t mask_at(std::span<const std::uint32_t> words) {
    return words[1] | std::uint64_t{words[2]} << 32;
}

}  // namespace

void BlockTree::insert(std::uint32_t cell, std::span<const Plane> planes, const CellOrder& order,
                       std::uint32_t leaf) {
    if (nodes_[0].kind == Kind::Empty) return;
    thread_local Incoming incoming;
    incoming.cell = cell;
    incoming.planes = planes;
    incoming.half_planes.clear();
    for (const Plane& plane : planes)
        incoming.half_planes.emplace_back(plane);
    incoming.stored.assign(planes.size(), kNone);
    incoming.active.clear();
    for (std::size_t i = 0; i < planes.size(); ++i)
        incoming.active.push_back(static_cast<std::uint16_t>(i));
    insert_at(0, box_, 0, incoming, order, leaf);
    if (planes_.size() > kPlaneGrowth * planes_after_drop_ + kFewPlanes) drop_unused_planes();
}

void BlockTree::insert_at(std::uint32_t number, const HalfBox& box, std::size_t active_begin,
                          Incoming& in, const CellOrder& order, std::uint32_t leaf) {
    std::vector<std::uint16_t>& active = in.active;
    const std::size_t active_end = active.size();
    const BoxFrame frame(box);
    for (std::size_t i = active_begin; i < active_end; ++i) {
        switch (side_of(frame, in.half_planes[active[i]])) {
            case Side::Below: break;
            case Side::Above: active.resize(active_end); return;
            case Side::On: active.push_back(active[i]); break;
        }
    }
    if (active.size() == active_end) {
        release(number);
        nodes_[number].kind = Kind::Empty;
        return;
    }
    if (nodes_[number].kind == Kind::Material) {
        add_to_leaf(number, box, active_end, in, order, leaf);
    } else {
        const std::uint32_t first = nodes_[number].first_child;
        const std::size_t axis = nodes_[number].axis;
        for (const bool upper : {false, true}) {
            const std::uint32_t child = first + static_cast<std::uint32_t>(upper);
            if (nodes_[child].kind == Kind::Empty) continue;
            insert_at(child, box.half(axis, upper), active_end, in, order, leaf);
        }
        if (nodes_[first].kind == Kind::Empty && nodes_[first + 1].kind == Kind::Empty) {
            release(number);
            nodes_[number].kind = Kind::Empty;
        }
    }
    active.resize(active_end);
}

void BlockTree::add_to_leaf(std::uint32_t number, const HalfBox& box, std::size_t active_begin,
                            Incoming& in, const CellOrder& order, std::uint32_t leaf) {
    thread_local std::vector<BoxPlane> mine;
    thread_local std::vector<BoxPlane> others;
    const BoxFrame frame(box);
    mine.clear();
    for (std::size_t i = active_begin; i < in.active.size(); ++i)
        mine.emplace_back(in.planes[in.active[i]], frame);
    const std::uint64_t mask = sample_mask(mine, frame.half);

    std::vector<std::uint32_t>& words = nodes_[number].cells;
    const auto load = [&](std::size_t at) {
        others.clear();
        for (std::uint32_t k = 0; k < words[at + 3]; ++k)
            others.emplace_back(planes_[words[at + kHead + k]], frame);
    };
    std::uint32_t count = 0;
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 3]) {
        ++count;
        if (!may_dominate(mask_at(std::span(words).subspan(at)), mask)) continue;
        load(at);
        if (is_redundant(dominated(mine, others, frame.half), in.cell, words[at], order)) return;
    }
    std::size_t kept = 0;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t size = kHead + words[at + 3];
        bool redundant = false;
        if (may_dominate(mask, mask_at(std::span(words).subspan(at)))) {
            load(at);
            redundant =
                is_redundant(dominated(others, mine, frame.half), words[at], in.cell, order);
        }
        if (redundant) {
            --count;
        } else {
            if (kept != at) std::copy_n(&words[at], size, &words[kept]);
            kept += size;
        }
        at += size;
    }
    words.resize(kept);
    words.insert(words.end(),
                 {in.cell, static_cast<std::uint32_t>(mask), static_cast<std::uint32_t>(mask >> 32),
                  static_cast<std::uint32_t>(in.active.size() - active_begin)});
    for (std::size_t i = active_begin; i < in.active.size(); ++i) {
        std::uint32_t& stored = in.stored[in.active[i]];
        if (stored == kNone) {
            stored = static_cast<std::uint32_t>(planes_.size());
            planes_.push_back(in.planes[in.active[i]]);
        }
        words.push_back(stored);
    }
    if (count + 1 > std::max(leaf, nodes_[number].limit)) split(number, box, order, leaf, 0);
}

std::vector<BlockTree::Local> BlockTree::cells_of(const Node& node, const HalfBox& box) const {
    const BoxFrame frame(box);
    std::vector<Local> result;
    const std::span<const std::uint32_t> words(node.cells);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 3]) {
        Local local{words[at], mask_at(words.subspan(at)), {}, {}};
        for (const std::uint32_t plane : words.subspan(at + kHead, words[at + 3])) {
            local.planes.push_back(plane);
            local.seen.emplace_back(planes_[plane], frame);
        }
        result.push_back(std::move(local));
    }
    return result;
}

// The axis that parts the cells best; the longest of those that do as well.
std::size_t BlockTree::best_axis(const HalfBox& box, const std::vector<Local>& cells) const {
    std::size_t best = 3;
    double best_cost = std::numeric_limits<double>::max();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (box.extent(axis) < kSmallestBox) continue;
        std::size_t total = 0;
        for (const bool upper : {false, true}) {
            const BoxFrame frame(box.half(axis, upper));
            std::size_t here = 0;
            for (const Local& local : cells) {
                bool outside = false;
                bool cut = false;
                for (const std::uint32_t plane : local.planes) {
                    const Side side = side_of(frame, HalfPlane(planes_[plane]));
                    outside = side == Side::Above;
                    cut = cut || side == Side::On;
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
        const double shape = static_cast<double>(box.extent(axis)) /
                             static_cast<double>(box.extent(box.longest_axis()));
        const double cost =
            static_cast<double>(total) / static_cast<double>(cells.size()) - 0.25 * shape;
        if (cost < best_cost) {
            best_cost = cost;
            best = axis;
        }
    }
    return best;
}

// Hands cells down to a leaf. False: one of them covers it.
bool BlockTree::fill(Node& node, const HalfBox& box, const std::vector<Local>& cells,
                     const CellOrder& order) const {
    const BoxFrame frame(box);
    std::vector<Local> kept;
    for (const Local& local : cells) {
        Local here{local.cell, 0, {}, {}};
        bool outside = false;
        for (const std::uint32_t plane : local.planes) {
            const Side side = side_of(frame, HalfPlane(planes_[plane]));
            outside = side == Side::Above;
            if (outside) break;
            if (side == Side::On) {
                here.planes.push_back(plane);
                here.seen.emplace_back(planes_[plane], frame);
            }
        }
        if (outside) continue;
        if (here.planes.empty()) return false;
        here.mask = sample_mask(here.seen, frame.half);
        const bool redundant = std::any_of(kept.begin(), kept.end(), [&](const Local& other) {
            return may_dominate(other.mask, here.mask) &&
                   is_redundant(dominated(here.seen, other.seen, frame.half), here.cell, other.cell,
                                order);
        });
        if (redundant) continue;
        std::erase_if(kept, [&](const Local& other) {
            return may_dominate(here.mask, other.mask) &&
                   is_redundant(dominated(other.seen, here.seen, frame.half), other.cell, here.cell,
                                order);
        });
        kept.push_back(std::move(here));
    }
    std::size_t size = 0;
    for (const Local& local : kept)
        size += kHead + local.planes.size();
    node.cells.reserve(size);
    for (const Local& local : kept) {
        node.cells.insert(node.cells.end(), {local.cell, static_cast<std::uint32_t>(local.mask),
                                             static_cast<std::uint32_t>(local.mask >> 32),
                                             static_cast<std::uint32_t>(local.planes.size())});
        node.cells.insert(node.cells.end(), local.planes.begin(), local.planes.end());
    }
    node.limit = static_cast<std::uint32_t>(kept.size());
    return true;
}

void BlockTree::split(std::uint32_t number, const HalfBox& box, const CellOrder& order,
                      std::uint32_t leaf, int fruitless) {
    const std::vector<Local> cells = cells_of(nodes_[number], box);
    const auto leave_as_it_is = [&] {
        nodes_[number].limit = static_cast<std::uint32_t>(2 * cells.size());
    };
    const std::size_t axis = best_axis(box, cells);
    if (axis == 3) return leave_as_it_is();
    std::array<Node, 2> halves;
    std::array<bool, 2> overfull{};
    std::array<int, 2> wasted{};
    for (const bool upper : {false, true}) {
        Node& node = halves[upper];
        if (!fill(node, box.half(axis, upper), cells, order)) node.kind = Kind::Empty;
        overfull[upper] = node.kind == Kind::Material && node.limit > leaf;
        wasted[upper] = 10 * node.limit > 9 * cells.size() ? fruitless + 1 : 0;
        node.limit = 0;
    }
    if (overfull[0] && overfull[1] && std::min(wasted[0], wasted[1]) >= kFruitlessSplits) {
        return leave_as_it_is();
    }
    if (halves[0].kind == Kind::Empty && halves[1].kind == Kind::Empty) {
        nodes_[number] = {};
        nodes_[number].kind = Kind::Empty;
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
    nodes_[number].axis = static_cast<std::uint8_t>(axis);
    nodes_[number].first_child = first;
    for (const bool upper : {false, true}) {
        const std::uint32_t child = first + static_cast<std::uint32_t>(upper);
        nodes_[child] = std::move(halves[upper]);
        if (overfull[upper]) split(child, box.half(axis, upper), order, leaf, wasted[upper]);
    }
    if (nodes_[first].kind == Kind::Empty && nodes_[first + 1].kind == Kind::Empty) {
        release(number);
        nodes_[number].kind = Kind::Empty;
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
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 3]) {
            for (std::uint32_t k = 0; k < words[at + 3]; ++k) {
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
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 3])
            entries.push_back({words[at], words.subspan(at + kHead, words[at + 3])});
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
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 3])
        entries.push_back({words[at], words.subspan(at + kHead, words[at + 3])});
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
