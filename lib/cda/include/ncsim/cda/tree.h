// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree of Convex Difference Aggregates: the same aggregate P \ (N1 ∪ … ∪ Nn) as in flat.h,
// without zero cells and without quadratic cost. See docs/cda.md, "The tree".
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/workpiece.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ncsim {
class Background;
}

namespace ncsim::cda {

struct Block;
class NormalsPool;
struct QueryPoint;
struct PendingCell;
class CellTable;
struct Evaluation;

/// Counts of work; the same on every machine.
struct TreeCounts {
    std::uint64_t cells = 0;  ///< Inserted cells, without cells outside of the stock.
    /// Planes of the inserted cells, without planes that the whole stock satisfies.
    std::uint64_t planes = 0;
    std::uint64_t nodes = 0;          ///< Nodes of all trees at present.
    std::uint64_t bytes = 0;          ///< Memory of the tree at present, approximately.
    std::uint64_t spared = 0;         ///< Contact queries answered without inserting waiting cells.
    std::uint64_t leaves = 0;         ///< Leaves visited for the last boundary().
    std::uint64_t facets_tested = 0;  ///< Facets in leaves.
    std::uint64_t facets_alive = 0;   ///< Facets with a visible remainder.
    std::uint64_t pieces = 0;         ///< Edge pieces of outlines handed to the stitching.
    std::uint64_t superseded =
        0;  ///< Dropped cells that lie within a deeper cell on the same path.
};

/// Parameters of the tree; no parameter changes the part.
struct TreeParameters {
    std::uint32_t leaf = 80;      ///< Planes in a leaf before the leaf is split.
    std::uint32_t threads = 0;    ///< 0: one per hardware thread.
    std::uint32_t batch = 32768;  ///< Largest number of waiting cells or steps.
    /// Number of times that the stock is halved into independent blocks, at most kMostHalvings.
    /// More blocks than threads or tiles balance the load; too many blocks make most of the surface
    /// seams. The value may change the last bits of summed volumes.
    int halvings = 6;
    /// Restricts the tree to the blocks of a tile. Volumes are then shares of the part's, and
    /// write_tile() writes the result.
    std::optional<TileNumber> tile = std::nullopt;
    /// Called by any thread before it inserts cells into a block or evaluates a block; may throw.
    /// After an exception, the workpiece may only be destroyed. Empty: not called.
    std::function<void()> interrupt{};
};

/// Workpiece model with a tree of cells. Subtracted cells may wait until a query concerns their
/// place, because many cells at a time are cheaper, and cells covered by a later cell are skipped.
/// Background threads insert waiting cells while more cells arrive. So a query changes the tree,
/// though not the part; queries of one part exclude each other. Several threads may query and copy
/// a part that no thread cuts.
class TreeCda final : public VerifyingModel {
public:
    static constexpr std::string_view kName = kTiledModel;

    explicit TreeCda(TreeParameters parameters = {});
    TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters = {});
    ~TreeCda() override;
    /// Copies share unmodified blocks.
    TreeCda(const TreeCda&);
    TreeCda& operator=(const TreeCda&);
    TreeCda(TreeCda&&) noexcept;
    TreeCda& operator=(TreeCda&&) noexcept;

    std::string_view name() const override { return kName; }
    std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                           const Lattice& lattice) const override;
    /// Cost: expected O(surface of the cell), independent of previous cuts, plus the evaluation of
    /// the volume within the cell.
    double subtract(const Cell& cell) override;
    using WorkpieceModel::subtract_unmeasured;
    /// The same without the volume. Threads share the insertion of many cells.
    void subtract_unmeasured(std::span<const Cell> cells) override;
    void subtract_step(std::span<const Cell> cells, std::span<const Cell> merged_cells = {},
                       std::span<const Cell> preceding_merged_cells = {}) override;
    std::optional<Box> wanted() const override;
    /// Inserts all waiting cells.
    void settle() const;
    /// Computes the account in one pass over many cells at a time; the cost is about that of the
    /// insertion.
    void track_removal() override;
    RemovalByMotion account() const override;
    std::unique_ptr<WorkpieceModel> clone() const override;
    /// Evaluates the blocks that changed since the last request.
    double volume() const override;
    /// Throws: std::logic_error if the tree is restricted to a tile whose surface is open.
    Boundary boundary() const override;
    /// Evaluates the leaves that changed since the last state of `recorder`.
    /// Requires: `recorder` has recorded only this part.
    void record_surface(SurfaceRecorder& recorder) const override;
    bool contains(Vec3 point) const override;

    /// Stops at the first common point. Waiting cells are inserted only where they affect the
    /// answer.
    std::optional<Vec3> contact(const Cell& cell) const override;
    double common_volume(const Cell& cell) const override;

    /// Writes the tile that TreeParameters::tile selects, for Tiles.
    /// Requires: the tree is restricted to a tile.
    void write_tile(std::ostream& out) const;

    const Lattice& lattice() const override { return lattice_; }
    /// Returns counts of the cutting so far and of the last boundary().
    TreeCounts counts() const;

private:
    // Mutex held during a query; each part has a separate mutex.
    struct QueryMutex {
        std::mutex mutex;

        QueryMutex() = default;
        QueryMutex(const QueryMutex&) noexcept {}
        QueryMutex& operator=(const QueryMutex&) noexcept { return *this; }
    };
    // Lock of a query: waits for concurrent queries and for running insertions.
    class ReadLock {
    public:
        explicit ReadLock(const TreeCda& part) : lock_(part.query_mutex_.mutex) {
            part.finish_flush();
        }

    private:
        std::lock_guard<std::mutex> lock_;
    };

    TreeCda(const TreeCda& other, const ReadLock&);

    // Box in which a block may have material, half units; readable without access to the block's
    // tree.
    struct Place {
        std::array<double, 3> min, max;
    };
    // A cell's row in the table of cells, before the row is added.
    struct CellRow {
        Origin origin;
        std::int32_t rank;
        std::shared_ptr<const FacetNormals> normals;
    };
    void split_into_blocks();
    bool enqueue(const Cell& cell, bool covers = false);
    void drop_pending_within(Block& block, const Cell& covering) const;
    void erase_superseded();
    void drop_superseded(const std::shared_ptr<const PendingCell>& deeper);
    void flush_idle_blocks();
    void begin_flush(const std::function<bool(const Block&)>& goes) const;
    void finish_flush() const;
    void flush_all() const;
    void mark_listed(std::size_t number) const;
    Box query_box(const Box& bounds) const;
    void flush_near(const Box& bounds) const;
    void merge_removed_volumes() const;
    bool has_pending_cell_near(Vec3 point) const;
    bool covers_stock_part_of(const Cell& cell) const;
    std::optional<Vec3> contact_without_pending(const Cell& cell) const;
    std::optional<Vec3> in_block_within(const Cell& cell) const;
    bool contains_without_pending(const QueryPoint& query) const;
    Evaluation evaluate_window(const Cell& cell, bool only_first) const;

    // Blocks insert waiting cells in the background while more cells arrive. First member,
    // so that a move assignment ends this work before the data is replaced.
    mutable std::unique_ptr<Background> flush_tasks_;
    TreeParameters parameters_;
    Lattice lattice_;
    Cell stock_;
    Vec3 centre_;    // centre of the stock, in units
    Box stock_box_;  // bounds of the stock, in units
    std::vector<Plane> stock_planes_;
    double stock_volume_ = 0.0;  // cubic units
    std::unique_ptr<CellTable> cells_;
    std::unique_ptr<NormalsPool> normals_;  // normals of all cells
    std::vector<std::uint32_t> own_;        // blocks, ascending: all, or the tile's
    // coordinates of planes between blocks, half units, by axis
    std::array<std::vector<std::int64_t>, 3> walls_;
    // State that queries change.
    mutable QueryMutex query_mutex_;
    mutable std::vector<Block*> flushing_blocks_;  // blocks in work by flush_tasks_
    mutable std::vector<CellRow> unlisted_cells_;  // cells that arrived meanwhile
    mutable std::vector<Block> blocks_;
    // places of blocks_, as of the last time when no block was changing
    mutable std::vector<Place> places_;
    mutable std::size_t pending_ = 0;  // cells or steps since no cell waited
    std::uint64_t steps_ = 0;          // all steps (or cells) so far
    // The last cell for each path of a body, seen from above, by a hash of both. recent_paths_
    // holds at least the last kWhile steps, older_paths_ the kWhile steps before.
    using CellsByPath = std::unordered_map<std::uint64_t, std::weak_ptr<const PendingCell>>;
    CellsByPath recent_paths_, older_paths_;
    std::vector<bool> superseded_;        // by cell number: true if the cell need not be inserted
    std::size_t superseded_pending_ = 0;  // upper bound of the superseded cells in the queue
    mutable std::optional<RemovalByMotion> account_;  // cubic units; empty if no account is kept
    mutable TreeCounts counts_;
    mutable std::vector<std::vector<double>>
        requested_volumes_;  // by request and own block, cubic units; only for a tile
};

}  // namespace ncsim::cda
