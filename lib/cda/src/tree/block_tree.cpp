// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree of a block: nodes, leaves, planes and queries.
#include "tree/block_tree.h"

#include "exact/none.h"

#include <algorithm>
#include <span>
#include <utility>

namespace ncsim::cda {

void CellTable::add(Origin origin, std::int32_t rank,
                    const std::shared_ptr<const FacetNormals>& normals) {
    std::uint32_t family = kNoFamily;
    if (normals) {
        const auto [known, is_new] =
            family_of_.try_emplace(normals.get(), static_cast<std::uint32_t>(families_.size()));
        if (is_new) families_.push_back(normals);
        family = known->second;
    }
    make_room(cells_);
    cells_.push_back({origin, family, rank});
}

std::size_t CellTable::memory() const {
    std::size_t bytes = cells_.capacity() * sizeof(Entry);
    for (const auto& normals : families_)
        bytes += sizeof(FacetNormals) + 3 * sizeof(double) * normals->size();
    return bytes;
}

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

void BlockTree::become_empty(std::uint32_t number) {
    release(number);
    nodes_[number].kind = Kind::Empty;
}

// Updates an inner node after a change of the node's children.
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
    nodes_[number] = Node();
}

void BlockTree::drop_unused_planes() {
    std::vector<std::uint32_t> renumbered(planes_.size(), kNone);
    std::size_t used = 0;
    std::size_t loose = 0;
    const auto number_anew = [&](std::uint32_t& index) {
        if (renumbered[index] == kNone) {
            renumbered[index] = static_cast<std::uint32_t>(used++);
            loose += planes_.facet(index) == kLoose ? 1 : 0;
        }
        index = renumbered[index];
    };
    PackedCells::Words words;
    for (Node& node : nodes_) {
        if (node.cells.is_empty()) continue;
        node.cells.read(words);
        for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1])
            std::ranges::for_each(std::span(words).subspan(at + kHead, words[at + 1]), number_anew);
        node.cells.write(words);
    }
    std::vector<std::uint32_t> old_number(used);
    for (std::uint32_t i = 0; i < renumbered.size(); ++i) {
        if (renumbered[i] != kNone) old_number[renumbered[i]] = i;
    }
    PlaneStore kept;
    kept.reserve(used, loose);
    for (const std::uint32_t old : old_number)
        kept.add_from(planes_, old);
    planes_ = std::move(kept);
    planes_after_drop_ = planes_.size();
}

Plane BlockTree::plane(std::uint32_t cell, std::uint32_t index, const CellTable& table) const {
    const std::uint16_t facet = planes_.facet(index);
    if (facet == kLoose) return planes_.loose(index);
    const FacetNormals& n = table.normals(table.family(cell));
    return {static_cast<std::int32_t>(n.x[facet]), static_cast<std::int32_t>(n.y[facet]),
            static_cast<std::int32_t>(n.z[facet]), planes_.distance(index)};
}

void BlockTree::LeafCells::read(const PackedCells& packed) {
    packed.read(words_);
    entries_.clear();
    const std::span<const std::uint32_t> words(words_);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1])
        entries_.push_back({words[at], words.subspan(at + kHead, words[at + 1])});
}

void BlockTree::visit(
    const std::function<bool(const HalfBox&)>& enter,
    const std::function<void(const HalfBox&, std::span<const Entry>)>& leaf) const {
    LeafCells cells;
    const auto go = [&](const auto& self, std::uint32_t number) -> void {
        const Node& node = nodes_[number];
        const HalfBox box = node.box();
        if (node.kind == Kind::Empty || !enter(box)) return;
        if (node.kind == Kind::Inner) {
            self(self, node.first_child);
            self(self, node.first_child + 1);
            return;
        }
        cells.read(node.cells);
        leaf(box, cells.entries());
    };
    go(go, 0);
}

bool BlockTree::find(const std::array<std::int64_t, 3>& point, LeafCells& cells) const {
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
    cells.read(nodes_[number].cells);
    return true;
}

std::size_t BlockTree::memory() const {
    std::size_t bytes = sizeof(*this) + nodes_.capacity() * sizeof(Node) +
                        free_children_.capacity() * sizeof(std::uint32_t) + planes_.memory();
    for (const Node& node : nodes_)
        bytes += node.cells.memory();
    return bytes;
}

}  // namespace ncsim::cda
