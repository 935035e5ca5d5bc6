// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree of Convex Difference Aggregates: the same aggregate as flat.h, P \ (N1 ∪ … ∪ Nn),
// without zero cells and without its quadratic cost. docs/cda.md, "The tree".
#pragma once

#include "ncsim/cda/tile_number.h"
#include "ncsim/cda/workpiece.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ncsim::cda {

class Background;
struct Block;
class NormalsPool;
struct QueryPoint;
struct WaitingCell;
class CellTable;
struct Evaluation;

/// What work was done, counted: the same on every machine.
struct TreeCounts {
    std::uint64_t cells = 0;          ///< Kept: not outside of the stock.
    std::uint64_t planes = 0;         ///< Of those, without the ones all of the stock satisfies.
    std::uint64_t nodes = 0;          ///< Alive now.
    std::uint64_t bytes = 0;          ///< Held by the tree now, about.
    std::uint64_t spared = 0;         ///< Questions of contact that let cells wait on.
    std::uint64_t leaves = 0;         ///< Looked at for the last boundary or volume.
    std::uint64_t facets_tested = 0;  ///< Facets in leaves.
    std::uint64_t facets_alive = 0;   ///< Of those, with something left.
    std::uint64_t pieces = 0;         ///< Of outlines, handed to the stitching.
    std::uint64_t forgotten = 0;      ///< Cells within a deeper one on the same way.
};

/// How the tree works; none of it changes a part.
struct TreeParameters {
    std::uint32_t leaf = 80;      ///< Planes in a leaf before it is split.
    std::uint32_t threads = 0;    ///< 0: as many as the machine has.
    std::uint32_t batch = 32768;  ///< Cells that may wait, or steps.
    /// So often the stock is halved, into blocks that know nothing of each other: more blocks than
    /// threads or tiles, so that none waits for long; not so many that most of their surface is
    /// seams. kMostHalvings at most. Sums of volumes may differ in their last bits.
    int halvings = 6;
    /// Only some of its blocks: volumes are a share then, write_tile() is what it is for, and
    /// nothing else may be asked.
    std::optional<TileNumber> tile = std::nullopt;
};

/// Cells that were taken away may wait until somebody asks about the part where they are: many at a
/// time are cheaper, and what one of them covers is not looked at for the others. Other threads
/// take in what waited while more comes. So asking changes the tree, though not the part; who asks
/// waits for others that do. A part that nobody cuts may be asked, and copied, by many threads.
class TreeCda final : public WorkpieceModel {
public:
    static constexpr std::string_view kName = kTiledModel;

    explicit TreeCda(TreeParameters parameters = {});
    TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters = {});
    ~TreeCda() override;
    /// Copies share what neither of them changes.
    TreeCda(const TreeCda&);
    TreeCda& operator=(const TreeCda&);
    TreeCda(TreeCda&&) noexcept;
    TreeCda& operator=(TreeCda&&) noexcept;

    std::string_view name() const override { return kName; }
    std::unique_ptr<WorkpieceModel> create(const Cell& stock,
                                           const Lattice& lattice) const override;
    /// Expected O(surface of the cell), whatever was cut before, plus the evaluation of what it
    /// overlaps: the price of knowing the volume.
    double subtract(const Cell& cell) override;
    using WorkpieceModel::subtract_unmeasured;
    /// The same without. Many cells at a time are shared between threads.
    void subtract_unmeasured(std::span<const Cell> cells) override;
    void subtract_step(std::span<const Cell> cells, std::span<const Cell> covering = {},
                       std::span<const Cell> before = {}) override;
    std::optional<Box> wanted() const override;
    /// Lets no cell wait any longer.
    void settle() const;
    /// In one pass over many cells at a time: about as dear as taking them away.
    void keep_account() override;
    Account account() const override;
    void render(FacetCanvas& canvas) const override;
    std::unique_ptr<WorkpieceModel> clone() const override;
    /// The evaluation of blocks that changed since it was last asked for.
    double volume() const override;
    Boundary boundary() const override;
    bool contains(Vec3 point) const override;

    /// Stops at the first place. Cells that wait are only taken in where it matters.
    std::optional<Vec3> contact(const Cell& cell) const override;
    double common_volume(const Cell& cell) const override;

    /// Of what `tile` in the parameters says.
    void write_tile(std::ostream& out) const override;

    const Lattice& lattice() const override { return lattice_; }
    /// Of the cutting so far and of the last evaluation.
    TreeCounts counts() const;

private:
    // Held by whoever asks; each part has its own.
    struct Asking {
        std::mutex mutex;

        Asking() = default;
        Asking(const Asking&) noexcept {}
        Asking& operator=(const Asking&) noexcept { return *this; }
    };
    // Who asks waits for others that do, and for what goes down the tree meanwhile.
    class Asked {
    public:
        explicit Asked(const TreeCda& part) : lock_(part.asking_.mutex) { part.finish_settling(); }

    private:
        std::lock_guard<std::mutex> lock_;
    };

    TreeCda(const TreeCda& other, const Asked&);

    // Where a block may have material, half units; known without a look at its tree.
    struct Place {
        std::array<double, 3> min, max;
    };
    // A cell's line in the table of cells, before it has one.
    struct Listed {
        Origin origin;
        std::int32_t rank;
        std::shared_ptr<const FacetNormals> normals;
    };
    void split_into_blocks();
    bool take_in(const Cell& cell, bool covers = false);
    void forget_within(Block& block, const Cell& covering) const;
    void drop_forgotten();
    void forget_same_way(const std::shared_ptr<const WaitingCell>& deeper);
    void settle_some();
    void begin_settling(const std::function<bool(const Block&)>& goes) const;
    void finish_settling() const;
    void settle_all() const;
    void tell_place(std::size_t number) const;
    Box near(const Box& bounds) const;
    void settle_near(const Box& bounds) const;
    void close_books() const;
    bool is_waited_for_near(Vec3 point) const;
    bool takes_all_of(const Cell& cell) const;
    std::optional<Vec3> contact_as_it_is(const Cell& cell) const;
    std::optional<Vec3> in_block_within(const Cell& cell) const;
    bool contains_as_it_is(const QueryPoint& query) const;
    Evaluation evaluate_window(const Cell& cell, bool only_first) const;

    // Blocks take in what waited, while more cells come; the first of all, so that this ends before
    // what it works on is assigned.
    mutable std::unique_ptr<Background> settling_;
    TreeParameters parameters_;
    Lattice lattice_;
    Cell stock_;
    Vec3 centre_;    // of the stock, in units
    Box stock_box_;  // in units
    std::vector<Plane> stock_planes_;
    double stock_volume_ = 0.0;  // cubic units
    std::unique_ptr<CellTable> cells_;
    std::unique_ptr<NormalsPool> normals_;            // of cells that came
    std::vector<std::uint32_t> own_;                  // blocks, ascending: all, or the tile's
    std::array<std::vector<std::int64_t>, 3> walls_;  // where blocks meet, half units, by axis
    // What asking changes.
    mutable Asking asking_;
    mutable std::vector<Block*> changing_;  // by settling_
    mutable std::vector<Listed> listed_;    // cells that came meanwhile
    mutable std::vector<Block> blocks_;
    mutable std::vector<Place> places_;  // of these, when none was changing
    mutable std::size_t waiting_ = 0;    // cells since the last time that none waited
    std::uint64_t steps_ = 0;            // or cells, ever
    // The last cell for each way of a body, seen from above, by a hash of both: of the last
    // kWhile steps or more, and of kWhile steps before these.
    using CellsByWay = std::unordered_map<std::uint64_t, std::weak_ptr<const WaitingCell>>;
    CellsByWay recent_ways_, older_ways_;
    std::vector<bool> forgotten_;             // cells by number that need not go down any more
    std::size_t forgotten_waiting_ = 0;       // at most so many of these wait
    mutable std::optional<Account> account_;  // cubic units; where it is kept
    mutable TreeCounts counts_;
    mutable std::vector<std::vector<double>>
        volumes_asked_;  // of own blocks, cubic units; of a tile
};

}  // namespace ncsim::cda
