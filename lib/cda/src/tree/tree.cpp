// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree as a workpiece: construction, copies, blocks, tiles.
#include "ncsim/cda/tree.h"

#include "ncsim/base/parallel.h"
#include "ncsim/cda/polytope.h"

#include "surface/stitch.h"
#include "tree/block.h"
#include "tree/evaluation.h"
#include "tree/normals_pool.h"
#include "tree/tile_bytes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

// Number of first halvings, along the longest axis. Further halvings are along the two longer axes
// of the stock, which makes columns: most parts are cut from above, and blocks deep in the stock
// have no work.
constexpr int kAnyHalvings = 6;

// Returns the shortest axis; the last among equals.
std::size_t shortest_axis(const HalfBox& box) {
    std::size_t axis = 2;
    for (const std::size_t i : {1U, 0U}) {
        if (box.extent(i) < box.extent(axis)) axis = i;
    }
    return axis;
}

std::size_t longer_axis(const HalfBox& box, std::size_t across) {
    const std::size_t one = (across + 1) % 3, other = (across + 2) % 3;
    return box.extent(other) > box.extent(one) ? other : one;
}

// Returns the blocks in the order in which tiles take blocks. Block b is the half b >> (n - 1 - i)
// & 1 of halving i. Blocks along axis `across` are consecutive, so runs of blocks are columns.
std::vector<std::uint32_t> tile_order(const std::vector<std::size_t>& axes, std::size_t across) {
    const std::size_t n = axes.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
    for (std::uint32_t block = 0; block < 1U << n; ++block) {
        std::uint32_t key = 0;
        for (const bool is_across : {false, true}) {
            for (std::size_t i = 0; i < n; ++i) {
                if ((axes[i] == across) == is_across) key = key << 1 | (block >> (n - 1 - i) & 1U);
            }
        }
        keys.emplace_back(key, block);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, block] : keys)
        order.push_back(block);
    return order;
}

}  // namespace

TreeCda::TreeCda(TreeParameters parameters)
    : parameters_(std::move(parameters)),
      cells_(std::make_unique<CellTable>()),
      normals_(std::make_unique<NormalsPool>()) {}

TreeCda::TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters)
    : parameters_(std::move(parameters)),
      lattice_(lattice),
      stock_(stock),
      cells_(std::make_unique<CellTable>()),
      normals_(std::make_unique<NormalsPool>()) {
    const auto body = ConvexPolytope::of(stock, lattice);
    if (!body) throw std::invalid_argument("the stock has no volume");
    stock_box_ = body->bounds();
    centre_ = stock_box_.centre();
    stock_volume_ = body->volume();
    for (const auto& facet : body->facets())
        stock_planes_.push_back(facet.plane);
    split_into_blocks();
}

TreeCda::~TreeCda() {
    flush_tasks_.reset();
}
TreeCda::TreeCda(const TreeCda& other) : TreeCda(other, ReadLock(other)) {}
TreeCda::TreeCda(const TreeCda& other, const ReadLock&)
    : parameters_(other.parameters_),
      lattice_(other.lattice_),
      stock_(other.stock_),
      centre_(other.centre_),
      stock_box_(other.stock_box_),
      stock_planes_(other.stock_planes_),
      stock_volume_(other.stock_volume_),
      cells_(std::make_unique<CellTable>(*other.cells_)),
      normals_(std::make_unique<NormalsPool>(*other.normals_)),
      own_(other.own_),
      walls_(other.walls_),
      blocks_(other.blocks_),
      places_(other.places_),
      pending_(other.pending_),
      steps_(other.steps_),
      recent_paths_(other.recent_paths_),
      older_paths_(other.older_paths_),
      superseded_(other.superseded_),
      superseded_pending_(other.superseded_pending_),
      account_(other.account_),
      counts_(other.counts_),
      requested_volumes_(other.requested_volumes_) {}
TreeCda& TreeCda::operator=(const TreeCda& other) {
    if (this != &other) *this = TreeCda(other);
    return *this;
}
TreeCda::TreeCda(TreeCda&&) noexcept = default;
TreeCda& TreeCda::operator=(TreeCda&&) noexcept = default;

void TreeCda::split_into_blocks() {
    HalfBox root;
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        root.min[i] = 2 * static_cast<std::int64_t>(std::floor(stock_box_.min[axis])) - 1;
        root.max[i] = 2 * static_cast<std::int64_t>(std::ceil(stock_box_.max[axis])) + 1;
    }
    std::vector<HalfBox> boxes{root};
    std::vector<std::size_t> axes;  // axis of each halving
    const std::size_t across = shortest_axis(root);
    for (int i = 0; i < parameters_.halvings; ++i) {
        const std::size_t axis =
            i < kAnyHalvings ? boxes[0].longest_axis() : longer_axis(boxes[0], across);
        if (boxes[0].extent(axis) < 8) break;
        axes.push_back(axis);
        std::vector<HalfBox> halves;
        for (const HalfBox& box : boxes) {
            halves.push_back(box.half(axis, false));
            halves.push_back(box.half(axis, true));
        }
        boxes = std::move(halves);
    }
    for (const HalfBox& box : boxes) {
        blocks_.push_back(
            {std::make_shared<BlockTree>(box), {}, {}, 0, 0, std::nullopt, nullptr, {}});
        places_.emplace_back();
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        mark_listed(i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const HalfBox& box : boxes) {
            if (box.min[axis] != root.min[axis]) walls_[axis].push_back(box.min[axis]);
        }
        std::vector<std::int64_t>& walls = walls_[axis];
        std::sort(walls.begin(), walls.end());
        walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
    }
    const TileNumber number = parameters_.tile.value_or(TileNumber{});
    const std::vector<std::uint32_t> order = tile_order(axes, across);
    const auto at = [&](std::size_t i) {
        return order.begin() + static_cast<std::ptrdiff_t>(order.size() * i / number.of);
    };
    own_.assign(at(number.tile), at(number.tile + std::size_t{1}));
    std::sort(own_.begin(), own_.end());
}

std::unique_ptr<WorkpieceModel> TreeCda::create(const Cell& stock, const Lattice& lattice) const {
    return std::make_unique<TreeCda>(stock, lattice, parameters_);
}

std::unique_ptr<WorkpieceModel> TreeCda::clone() const {
    settle();  // settles once for both copies
    return std::make_unique<TreeCda>(*this);
}

std::optional<Box> TreeCda::wanted() const {
    if (!parameters_.tile) return std::nullopt;
    Box place;
    for (const std::uint32_t number : own_) {
        const HalfBox box = blocks_[number].tree->box();
        for (const auto& corner : {box.min, box.max}) {
            place.add(lattice_.to_mm(Vec3{0.5 * static_cast<double>(corner[0]),
                                          0.5 * static_cast<double>(corner[1]),
                                          0.5 * static_cast<double>(corner[2])}));
        }
    }
    return place.is_empty() ? place : query_box(place);
}

void TreeCda::mark_listed(std::size_t number) const {
    const BlockTree& tree = *blocks_[number].tree;
    const HalfBox box = tree.box();
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr double kNowhere = std::numeric_limits<double>::infinity();
        places_[number].min[i] = tree.is_empty() ? kNowhere : static_cast<double>(box.min[i]);
        places_[number].max[i] = tree.is_empty() ? -kNowhere : static_cast<double>(box.max[i]);
    }
}

// Format: tile, number of tiles, blocks of the part, blocks of the tile, volume requests; the
// tile's blocks, and the blocks' volumes per request; outlines block by block; edges at the walls.
void TreeCda::write_tile(std::ostream& out) const {
    assert(parameters_.tile);
    const ReadLock asked(*this);
    flush_all();
    for (const std::size_t n :
         {std::size_t{parameters_.tile->tile}, std::size_t{parameters_.tile->of}, blocks_.size(),
          own_.size(), requested_volumes_.size()})
        put_u32(out, static_cast<std::uint32_t>(n));
    for (const std::uint32_t number : own_)
        put_u32(out, number);
    for (const std::vector<double>& volumes : requested_volumes_) {
        for (const double volume : volumes)
            put_double(out, volume);
    }
    const EvaluationInput input{stock_planes_, nullptr, *cells_, centre_, false};
    Stitcher stitcher(lattice_, parameters_.threads);
    for (const std::uint32_t number : own_) {
        Block& block = blocks_[number];
        if (!block.outlines) {
            block.outlines =
                std::make_shared<const Outlines>(evaluate(*block.tree, input).outlines);
        }
        put_outlines(out, *block.outlines);
        stitcher.add_part(block.outlines->at(walls_));
        block.outlines.reset();
    }
    put_outlines(out, stitcher.finish_border(walls_));
}

TreeCounts TreeCda::counts() const {
    const ReadLock asked(*this);
    flush_all();
    TreeCounts counts = counts_;
    counts.nodes = 0;
    counts.bytes = cells_->memory();
    for (const Block& block : blocks_) {
        counts.nodes += block.tree->nodes();
        counts.bytes += block.tree->memory();
    }
    return counts;
}

}  // namespace ncsim::cda
