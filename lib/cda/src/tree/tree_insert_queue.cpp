// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells before insertion: cells wait, block by block, until a query concerns their place or the
// tool has left the block.
#include "ncsim/base/mix.h"
#include "ncsim/base/parallel.h"
#include "ncsim/cda/tree.h"

#include "polytope/within.h"
#include "tree/block.h"
#include "tree/evaluation.h"
#include "tree/normals_pool.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace ncsim::cda {

namespace {

// With fewer cells than this, no thread is started.
constexpr std::size_t kCellsWorthThreads = 16;

// A block in which no cell arrived for this many steps inserts the waiting cells.
constexpr std::uint64_t kWhile = 4096;

// Volumes of single cells below this share of the stock are rounding errors.
constexpr double kAccountRounding = 1e-15;

#ifndef NDEBUG
bool is_unique(std::vector<Plane> planes) {
    std::sort(planes.begin(), planes.end());
    return std::adjacent_find(planes.begin(), planes.end()) == planes.end();
}
#endif

// True if the first planes of the cell have the normals of `cell.normals`.
bool has_its_normals(const Cell& cell) {
    if (!cell.normals || cell.normals->size() > cell.planes.size()) return false;
    const FacetNormals& n = *cell.normals;
    bool is_so = true;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const Plane& p = cell.planes[i];
        is_so &= n.x[i] == p.nx && n.y[i] == p.ny && n.z[i] == p.nz;
    }
    return is_so;
}

// Hashes the body of the cell, the direction of the motion without sign, and the position of both
// seen from above. The hash is equal for a body on the same path at another height, in either
// direction. Two sides along the motion represent the direction; collisions are harmless, because
// callers check lies_within().
std::uint64_t path_hash(const Cell& cell, std::size_t facets) {
    std::uint64_t hash =
        mix(reinterpret_cast<std::uintptr_t>(cell.normals.get()), cell.planes.size());
    for (const double x :
         {cell.bounds.min.x, cell.bounds.min.y, cell.bounds.max.x, cell.bounds.max.y})
        hash = mix(hash, std::bit_cast<std::uint64_t>(x));
    if (facets == cell.planes.size()) return hash;
    for (const Plane* p : {&cell.planes[facets], &cell.planes.back()}) {
        hash = mix(hash, static_cast<std::uint64_t>(p->nx) ^
                             (static_cast<std::uint64_t>(p->ny) << 21) ^
                             (static_cast<std::uint64_t>(p->nz) << 42));
    }
    return hash;
}

bool represents(const Cell& cell, Origin origin) {
    if (!cell.steps) return origin == cell.origin;
    const auto& steps = cell.steps->steps;
    return steps.front().origin <= origin && origin <= steps.back().origin;
}

}  // namespace

void TreeCda::subtract_unmeasured(std::span<const Cell> cells) {
    for (const Cell& cell : cells) {
        if (enqueue(cell)) flush_idle_blocks();
    }
}

void TreeCda::subtract_step(std::span<const Cell> cells, std::span<const Cell> merged_cells,
                            std::span<const Cell> preceding_merged_cells) {
    for (const Cell& cell : preceding_merged_cells)
        enqueue(cell, true);
    for (const Cell& cell : cells)
        enqueue(cell);
    for (const Cell& cell : merged_cells)
        enqueue(cell, true);
    flush_idle_blocks();
}

// Passes a cell to the blocks whose boxes the cell may meet. False if the cell does not meet the
// stock.
bool TreeCda::enqueue(const Cell& cell, bool covers) {
    assert(is_unique(cell.planes));
    // Distance of planes that do not cut the stock.
    constexpr double kBeyond = std::numeric_limits<double>::infinity();
    const std::size_t facets = has_its_normals(cell) ? cell.normals->size() : 0;
    auto pending = std::make_shared<PendingCell>();
    IncomingCell& here = pending->incoming;
    here.facets.reserve(facets);
    for (std::size_t i = 0; i < cell.planes.size(); ++i) {
        const Side side = classify_box(stock_box_, cell.planes[i]);
        if (side == Side::Above) return false;
        if (i < facets) {
            here.facets.push_back(side == Side::On ? 2.0 * static_cast<double>(cell.planes[i].d)
                                                   : kBeyond);
        } else if (side == Side::On) {
            here.loose.push_back(static_cast<std::uint16_t>(i));
        }
    }
    here.enclose(cell.bounds, lattice_.unit_mm);
    here.number = cells_->size() + static_cast<std::uint32_t>(unlisted_cells_.size());
    pending->cell = cell;
    if (facets > 0) pending->cell.normals = normals_->intern(cell.normals);
    unlisted_cells_.push_back(
        {cell.origin, cell.rank, facets > 0 ? pending->cell.normals : nullptr});
    ++counts_.cells;
    counts_.planes += here.loose.size();
    for (const double d : here.facets)
        counts_.planes += d < kBeyond ? 1 : 0;
    here.planes = pending->cell.planes;
    here.steps = pending->cell.steps.get();
    const auto is_there = [](const Place& place, const IncomingCell& c) {
        bool is_so = true;
        for (std::size_t i = 0; i < 3; ++i) {
            is_so &= c.min[i] <= place.max[i];
            is_so &= c.max[i] >= place.min[i];
        }
        return is_so;
    };
    for (const std::uint32_t number : own_) {
        if (!is_there(places_[number], here)) continue;
        Block& block = blocks_[number];
        if (covers) drop_pending_within(block, pending->cell);
        block.pending.push_back(pending);
        block.last_step = steps_;
    }
    if (facets > 0 && !account_) drop_superseded(pending);
    return true;
}

// Drops the previous cell on the same path if the cell still waits and lies within `deeper`. A
// contour in many depths makes the same hulls at each depth, only deeper.
void TreeCda::drop_superseded(const std::shared_ptr<const PendingCell>& deeper) {
    const Cell& cell = deeper->cell;
    const std::uint64_t way = path_hash(cell, deeper->incoming.facets.size());
    auto& latest = recent_paths_[way];
    auto before = latest.lock();
    latest = deeper;
    if (!before) {
        const auto found = older_paths_.find(way);
        if (found != older_paths_.end()) before = found->second.lock();
    }
    if (!before || cell.rank >= before->cell.rank || cell.normals != before->cell.normals ||
        !lies_within(before->cell, cell, stock_box_)) {
        return;
    }
    const std::uint32_t number = before->incoming.number;
    if (superseded_.size() <= number) superseded_.resize(number + std::size_t{1});
    superseded_[number] = true;
    ++counts_.superseded;
    constexpr std::size_t kMany = 1024;
    if (++superseded_pending_ >= kMany) erase_superseded();
}

// Frees the memory of superseded cells in the queue.
void TreeCda::erase_superseded() {
    for (Block& block : blocks_) {
        std::erase_if(block.pending, [&](const auto& cell) {
            const std::uint32_t number = cell->incoming.number;
            return number < superseded_.size() && superseded_[number];
        });
    }
    superseded_pending_ = 0;
}

// Drops those of the latest waiting cells of a block that lie within `covering` and are after it in
// rank. With an account, only cells whose origin `covering` represents.
void TreeCda::drop_pending_within(Block& block, const Cell& covering) const {
    constexpr std::size_t kLatest = 256;
    auto& pending = block.pending;
    const std::size_t first = pending.size() - std::min(pending.size(), kLatest);
    const auto is_within = [&](const auto& w) {
        if (account_ && !represents(covering, w->cell.origin)) return false;
        return covering.rank < w->cell.rank && lies_within(w->cell, covering, stock_box_);
    };
    pending.erase(std::remove_if(pending.begin() + static_cast<std::ptrdiff_t>(first),
                                 pending.end(), is_within),
                  pending.end());
}

// At intervals, inserts the waiting cells of blocks in which no cell arrived for a while: a block
// that the tool has left gets all cells at once, in background threads. If too many cells wait, all
// blocks insert.
void TreeCda::flush_idle_blocks() {
    constexpr std::uint64_t kTurn = 512;
    const bool are_many = ++pending_ >= parameters_.batch;
    if (++steps_ % kWhile == 0) older_paths_ = std::exchange(recent_paths_, {});
    if (steps_ % kTurn != 0 && !are_many) return;
    begin_flush([&](const Block& block) { return are_many || steps_ - block.last_step >= kWhile; });
    if (are_many) pending_ = 0;
}

// Starts the insertion of waiting cells into blocks for which `goes` is true, in background threads
// if there are any.
void TreeCda::begin_flush(const std::function<bool(const Block&)>& goes) const {
    std::vector<Block*> changing;
    std::size_t cells = 0;
    for (Block& block : blocks_) {
        if (block.pending.empty() || !goes(block)) continue;
        cells += block.pending.size();
        changing.push_back(&block);
    }
    if (changing.empty()) return;
    finish_flush();
    for (Block* block : changing)
        block->start_insertion(superseded_);
    flushing_blocks_ = std::move(changing);
    // Starts with the block that has most cells, which balances the load at the end.
    std::ranges::stable_sort(flushing_blocks_, std::ranges::greater{},
                             [](const Block* block) { return block->inserting.size(); });
    const std::size_t threads = cells < kCellsWorthThreads ? 1 : thread_count(parameters_.threads);
    // Captured by value, because the part may be moved meanwhile; the referenced data stays.
    const AccountInput input{stock_planes_, *cells_, centre_, parameters_.leaf};
    flush_tasks_ = std::make_unique<Background>(
        threads - 1, flushing_blocks_.size(),
        [input, changing = flushing_blocks_.data(), keeps_account = account_.has_value(),
         interrupt = parameters_.interrupt](std::size_t i) {
            if (interrupt) interrupt();
            changing[i]->settle(input, keeps_account);
        });
}

// Ends the insertion. After that, no other thread reads the blocks and the table of cells.
void TreeCda::finish_flush() const {
    if (const auto settling = std::move(flush_tasks_)) {
        const auto changed = std::exchange(flushing_blocks_, {});
        settling->finish();
        for (const Block* block : changed)
            mark_listed(static_cast<std::size_t>(block - blocks_.data()));
        merge_removed_volumes();
    }
    for (const CellRow& cell : unlisted_cells_)
        cells_->add(cell.origin, cell.rank, cell.normals);
    unlisted_cells_.clear();
}

void TreeCda::flush_all() const {
    begin_flush([](const Block&) { return true; });
    finish_flush();
    pending_ = 0;
}

void TreeCda::settle() const {
    const ReadLock asked(*this);
    flush_all();
}

// Inserts the waiting cells that might change the answer of a query within `bounds`.
void TreeCda::flush_near(const Box& bounds) const {
    finish_flush();
    const Box near = this->query_box(bounds);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        Block& block = blocks_[i];
        if (std::ranges::none_of(block.pending,
                                 [&](const auto& w) { return w->cell.bounds.overlaps(near); }))
            continue;
        block.start_insertion(superseded_);
        block.settle({stock_planes_, *cells_, centre_, parameters_.leaf}, account_.has_value());
        mark_listed(i);
    }
    merge_removed_volumes();
}

// Adds the amounts in the order of the blocks, independent of the order of threads.
void TreeCda::merge_removed_volumes() const {
    for (Block& block : blocks_) {
        for (const auto& [origin, removed] : block.removed_volumes) {
            RemovedVolume& sum = (*account_)[origin];
            sum.volume += removed.volume;
            sum.bounds.add(removed.bounds);
        }
        block.removed_volumes.clear();
    }
}

double TreeCda::subtract(const Cell& cell) {
    flush_near(cell.bounds);
    const Evaluation result = evaluate_window(cell, false);
    if (parameters_.tile) {
        WorkpieceModel::subtract_unmeasured(cell);
        return result.volume * lattice_.cubic_unit_mm3();
    }
    // Pieces of surface decide exactly whether the cell removes volume; the sum is rounded and may
    // be negative.
    if (result.outlines.pieces().empty()) return 0.0;
    WorkpieceModel::subtract_unmeasured(cell);
    return std::max(0.0, result.volume * lattice_.cubic_unit_mm3());
}

void TreeCda::track_removal() {
    settle();
    if (!account_) account_.emplace();
}

RemovalByMotion TreeCda::account() const {
    const ReadLock asked(*this);
    flush_all();
    RemovalByMotion result;
    if (!account_) return result;
    const double unit = lattice_.cubic_unit_mm3();
    const double rounding = kAccountRounding * stock_volume_;
    for (const auto& [origin, removed] : *account_) {
        const bool is_nothing = std::abs(removed.volume) < rounding;
        result[origin] =
            is_nothing ? RemovedVolume{} : RemovedVolume{removed.volume * unit, removed.bounds};
    }
    return result;
}

}  // namespace ncsim::cda
