// SPDX-License-Identifier: GPL-3.0-or-later
//
// A single block, with boxes cut out of it.
#pragma once

#include "support/random_shapes.h"
#include "tree/block_tree.h"

#include <memory>
#include <vector>

namespace ncsim::cda {

/// The whole stock in a single block: a cube of `size` units, from the origin.
class TestBlock {
public:
    explicit TestBlock(std::int64_t size)
        : size_(size), tree_({{-1, -1, -1}, {2 * size + 1, 2 * size + 1, 2 * size + 1}}) {
        stock_ = box_cell({0, 0, 0}, {size, size, size}, test::kLattice).planes;
    }

    /// Cuts `cells` away, in a single batch.
    void cut(const std::vector<Cell>& cells, std::uint32_t leaf = 80) {
        std::vector<IncomingCell> incoming;
        incoming.reserve(cells.size());
        std::vector<const IncomingCell*> pointers;
        for (const Cell& cell : cells) {
            const IncomingCell& here = incoming.emplace_back(receive(cell));
            if (tree_.meets(here)) pointers.push_back(&here);
        }
        tree_.insert(pointers, table_, leaf);
    }

    /// Adds `cell` to the table. The block itself need not insert the cell.
    IncomingCell receive(const Cell& cell) {
        kept_.push_back(std::make_unique<Cell>(cell));
        IncomingCell here;
        here.number = table_.size();
        here.planes = kept_.back()->planes;
        for (std::size_t i = 0; i < cell.planes.size(); ++i)
            here.loose.push_back(static_cast<std::uint16_t>(i));
        here.enclose(cell.bounds, test::kLattice.unit_mm);
        table_.add(cell.origin, cell.rank, nullptr);
        return here;
    }

    /// True if there is material in the unit cube at `p`.
    bool has(LatticePoint p) const {
        // The middle of the cube, in units of 2^-15 half units.
        const auto middle = [](std::int64_t v) { return (2 * v + 1) << 15; };
        BlockTree::LeafCells cells;
        if (!tree_.find({middle(p.x), middle(p.y), middle(p.z)}, cells)) return false;
        for (const BlockTree::Entry& entry : cells.entries()) {
            bool is_in = true;
            for (const std::uint32_t index : entry.planes) {
                const Plane h = tree_.plane(entry.cell, index, table_);
                is_in &=
                    h.nx * (2 * p.x + 1) + h.ny * (2 * p.y + 1) + h.nz * (2 * p.z + 1) < 2 * h.d;
            }
            if (is_in) return false;
        }
        return true;
    }

    std::int64_t size() const { return size_; }
    const BlockTree& tree() const { return tree_; }
    const CellTable& table() const { return table_; }
    const std::vector<Plane>& stock() const { return stock_; }

private:
    std::int64_t size_;
    BlockTree tree_;
    CellTable table_;
    std::vector<Plane> stock_;
    std::vector<std::unique_ptr<Cell>> kept_;
};

/// Box of whole units from `min` to `max`.
struct UnitBox {
    LatticePoint min, max;

    bool has(LatticePoint p) const {
        return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y && p.z >= min.z &&
               p.z < max.z;
    }
    Cell cell(Origin origin) const { return box_cell(min, max, test::kLattice, origin); }
};

inline UnitBox random_unit_box(test::Random& random, std::int64_t size) {
    UnitBox box;
    const auto ends = [&](std::int64_t& low, std::int64_t& high) {
        low = random.between(-1, size - 1);
        high = random.between(low + 1, size + 1);
    };
    ends(box.min.x, box.max.x);
    ends(box.min.y, box.max.y);
    ends(box.min.z, box.max.z);
    return box;
}

}  // namespace ncsim::cda
