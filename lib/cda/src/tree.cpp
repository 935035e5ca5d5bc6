// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/cda/tree.h"

#include "ncsim/cda/mesh.h"
#include "ncsim/cda/parallel.h"
#include "ncsim/cda/polytope.h"

#include "block_tree.h"
#include "covering.h"
#include "evaluation.h"
#include "query_point.h"
#include "stitch.h"
#include "tile_bytes.h"
#include "within.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ncsim::cda {

namespace {

// So often along whichever axis is longest; then along the two longer ones of the stock, which make
// columns: most parts are cut from above, and what is deep in the stock is nobody's work.
constexpr int kAnyHalvings = 6;

// Fewer cells than this are not worth waking a thread for.
constexpr std::size_t kCellsWorthThreads = 16;

// Looks that a proof may take that there is nothing left. Nearly all that succeed need less, and it
// is less than taking in what waits.
constexpr std::size_t kMostLooks = 100000;

// Volumes of single cells below this share of the stock are rounding.
constexpr double kAccountRounding = 1e-15;

#ifndef NDEBUG
bool stands_once(std::vector<Plane> planes) {
    std::sort(planes.begin(), planes.end());
    return std::adjacent_find(planes.begin(), planes.end()) == planes.end();
}
#endif

// Are the first planes of the cell those of the normals it claims to have?
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

// The last of several.
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

// Blocks in the order in which tiles take them, where block b is the half b >> (n - 1 - i) & 1 of
// halving i: those above each other follow each other, so that runs of them are columns.
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
    for (const auto& [key, block] : keys)
        order.push_back(block);
    return order;
}

}  // namespace

// A cell that some blocks have not taken in yet.
struct TreeCda::WaitingCell {
    Cell cell;
    IncomingCell incoming;
};

// A part of the tree and its share of the volume.
struct TreeCda::Block {
    std::shared_ptr<BlockTree> tree;
    std::vector<std::shared_ptr<const WaitingCell>> waiting;     // in the order they came
    std::vector<std::shared_ptr<const WaitingCell>> going_down;  // likewise, those before them
    std::uint64_t last_step = 0;                                 // when somebody came
    mutable std::optional<double> volume;  // cubic units; of what is there now, once asked for
    mutable std::shared_ptr<const Outlines> outlines;  // likewise, of a tile
    std::vector<std::pair<Origin, Taking>> taken;      // what is not in the books yet; cubic units

    // To change it: not what others see.
    BlockTree& own() {
        // Whoever let go of it has read it, perhaps in another thread: letting go of it, too, comes
        // after that, which the count alone does not tell.
        std::shared_ptr<BlockTree>(tree).reset();
        if (tree.use_count() > 1) tree = std::make_shared<BlockTree>(*tree);
        volume.reset();
        outlines.reset();
        return *tree;
    }
    // None waits any longer.
    void send_down() {
        going_down.insert(going_down.end(), waiting.begin(), waiting.end());
        waiting.clear();
    }
    // Takes in those that go down; into the books, if there are any.
    void settle(const AccountInput& input, bool keeps_account);
};

// Who asks waits for others that do, and for what goes down the tree meanwhile.
class TreeCda::Asked {
public:
    explicit Asked(const TreeCda& part) : lock_(part.asking_.mutex) { part.finish_settling(); }

private:
    std::lock_guard<std::mutex> lock_;
};

TreeCda::TreeCda(TreeParameters parameters)
    : parameters_(parameters), cells_(std::make_unique<CellTable>()) {}

TreeCda::TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters)
    : parameters_(parameters),
      lattice_(lattice),
      stock_(stock),
      cells_(std::make_unique<CellTable>()) {
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
    settling_.reset();
}
TreeCda::TreeCda(const TreeCda& other) : TreeCda(other, Asked(other)) {}
TreeCda::TreeCda(const TreeCda& other, const Asked&)
    : parameters_(other.parameters_),
      lattice_(other.lattice_),
      stock_(other.stock_),
      centre_(other.centre_),
      stock_box_(other.stock_box_),
      stock_planes_(other.stock_planes_),
      stock_volume_(other.stock_volume_),
      cells_(std::make_unique<CellTable>(*other.cells_)),
      own_(other.own_),
      walls_(other.walls_),
      blocks_(other.blocks_),
      places_(other.places_),
      waiting_(other.waiting_),
      steps_(other.steps_),
      account_(other.account_),
      counts_(other.counts_),
      volumes_asked_(other.volumes_asked_) {}
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
    std::vector<std::size_t> axes;  // each halved in turn
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
        blocks_.push_back({std::make_shared<BlockTree>(box), {}, {}, 0, std::nullopt, nullptr, {}});
        places_.emplace_back();
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        tell_place(i);
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
    settle();  // once for both
    return std::make_unique<TreeCda>(*this);
}

void TreeCda::subtract_unmeasured(std::span<const Cell> cells) {
    for (const Cell& cell : cells) {
        if (take_in(cell)) settle_some();
    }
}

void TreeCda::subtract_step(std::span<const Cell> cells, std::span<const Cell> covering) {
    for (const Cell& cell : cells)
        take_in(cell);
    for (const Cell& cell : covering)
        take_in(cell, true);
    settle_some();
}

// Every so often, those go down that wait where nobody has come for a while: a block that the tool
// has left takes in all at once, while other threads would wait; all do if they are many.
void TreeCda::settle_some() {
    constexpr std::uint64_t kTurn = 512, kWhile = 4096;
    const bool are_many = ++waiting_ >= parameters_.batch;
    if (++steps_ % kTurn != 0 && !are_many) return;
    begin_settling(
        [&](const Block& block) { return are_many || steps_ - block.last_step >= kWhile; });
    if (are_many) waiting_ = 0;
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
    return place.is_empty() ? place : near(place);
}

// Of the latest cells that wait for a block, those that show nowhere beside this one, which is
// before them in rank, need not go down the tree. Where it is told what each origin took, only its
// own.
void TreeCda::forget_within(Block& block, const Cell& covering) const {
    constexpr std::size_t kLatest = 256;
    auto& waiting = block.waiting;
    const std::size_t first = waiting.size() - std::min(waiting.size(), kLatest);
    const auto is_within = [&](const auto& w) {
        if (account_ && w->cell.origin != covering.origin) return false;
        return covering.rank < w->cell.rank && lies_within(w->cell, covering, stock_box_);
    };
    waiting.erase(std::remove_if(waiting.begin() + static_cast<std::ptrdiff_t>(first),
                                 waiting.end(), is_within),
                  waiting.end());
}

// Hands a cell to the blocks that it may meet. False: it does not meet the stock.
bool TreeCda::take_in(const Cell& cell, bool covers) {
    assert(stands_once(cell.planes));
    // What is not below here does not cut the stock.
    constexpr double kBeyond = std::numeric_limits<double>::infinity();
    const std::size_t facets = has_its_normals(cell) ? cell.normals->size() : 0;
    auto taken = std::make_shared<WaitingCell>();
    IncomingCell& here = taken->incoming;
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
    here.number = cells_->size() + static_cast<std::uint32_t>(listed_.size());
    listed_.push_back({cell.origin, cell.rank, facets > 0 ? cell.normals : nullptr});
    ++counts_.cells;
    counts_.planes += here.loose.size();
    for (const double d : here.facets)
        counts_.planes += d < kBeyond ? 1 : 0;
    taken->cell = cell;
    here.planes = taken->cell.planes;
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
        if (covers) forget_within(block, cell);
        block.waiting.push_back(taken);
        block.last_step = steps_;
    }
    return true;
}

void TreeCda::Block::settle(const AccountInput& input, bool keeps_account) {
    std::vector<const IncomingCell*> cells;
    cells.reserve(going_down.size());
    for (const auto& cell : going_down)
        cells.push_back(&cell->incoming);
    if (keeps_account) {
        std::vector<Taken> turns;
        tree->account(cells, input, turns);
        for (const Taken& turn : turns) {
            Taking taking{turn.volume, {}};
            for (const std::uint32_t number : turn.cells) {
                const auto cell = std::ranges::lower_bound(
                    going_down, number, {}, [](const auto& w) { return w->incoming.number; });
                taking.bounds.add((*cell)->cell.bounds);
            }
            taken.emplace_back(turn.origin, taking);
        }
    }
    own().insert(cells, input.cells, input.leaf);
    going_down.clear();
}

void TreeCda::settle() const {
    const Asked asked(*this);
    settle_all();
}

void TreeCda::tell_place(std::size_t number) const {
    const BlockTree& tree = *blocks_[number].tree;
    const HalfBox box = tree.box();
    for (std::size_t i = 0; i < 3; ++i) {
        constexpr double kNowhere = std::numeric_limits<double>::infinity();
        places_[number].min[i] = tree.is_empty() ? kNowhere : static_cast<double>(box.min[i]);
        places_[number].max[i] = tree.is_empty() ? -kNowhere : static_cast<double>(box.max[i]);
    }
}

// What waits goes down where `goes`, by other threads if there are any.
void TreeCda::begin_settling(const std::function<bool(const Block&)>& goes) const {
    std::vector<Block*> changing;
    std::size_t cells = 0;
    for (Block& block : blocks_) {
        if (block.waiting.empty() || !goes(block)) continue;
        cells += block.waiting.size();
        changing.push_back(&block);
    }
    if (changing.empty()) return;
    finish_settling();
    for (Block* block : changing)
        block->send_down();
    changing_ = std::move(changing);
    // The one with most to do first, so that nobody waits for it in the end.
    std::ranges::stable_sort(changing_, std::ranges::greater{},
                             [](const Block* block) { return block->going_down.size(); });
    const std::size_t threads = cells < kCellsWorthThreads ? 1 : thread_count(parameters_.threads);
    // By value: the part may be moved meanwhile; what these point to is not.
    const AccountInput input{stock_planes_, *cells_, centre_, parameters_.leaf};
    settling_ = std::make_unique<Background>(
        threads - 1, changing_.size(),
        [input, changing = changing_.data(), keeps_account = account_.has_value()](std::size_t i) {
            changing[i]->settle(input, keeps_account);
        });
}

// From then on nobody else reads the blocks and the table of cells.
void TreeCda::finish_settling() const {
    if (const auto settling = std::move(settling_)) {
        const auto changed = std::exchange(changing_, {});
        settling->finish();
        for (const Block* block : changed)
            tell_place(static_cast<std::size_t>(block - blocks_.data()));
        close_books();
    }
    for (const Listed& cell : listed_)
        cells_->add(cell.origin, cell.rank, cell.normals);
    listed_.clear();
}

void TreeCda::settle_all() const {
    begin_settling([](const Block&) { return true; });
    finish_settling();
    waiting_ = 0;
}

// In the order of the blocks, whichever thread was first.
void TreeCda::close_books() const {
    for (Block& block : blocks_) {
        for (const auto& [origin, taken] : block.taken) {
            Taking& sum = (*account_)[origin];
            sum.volume += taken.volume;
            sum.bounds.add(taken.bounds);
        }
        block.taken.clear();
    }
}

// Which cells may have something in common with what has these bounds? These are rounded to
// millimetres.
Box TreeCda::near(const Box& bounds) const {
    const double margin = 2.0 * lattice_.unit_mm;
    const Vec3 more{margin, margin, margin};
    return {bounds.min - more, bounds.max + more};
}

// Lets no cell wait that might change what is asked here.
void TreeCda::settle_near(const Box& bounds) const {
    finish_settling();
    const Box near = this->near(bounds);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        Block& block = blocks_[i];
        if (std::ranges::none_of(block.waiting,
                                 [&](const auto& w) { return w->cell.bounds.overlaps(near); }))
            continue;
        block.send_down();
        block.settle({stock_planes_, *cells_, centre_, parameters_.leaf}, account_.has_value());
        tell_place(i);
    }
    close_books();
}

// Might a cell that waits take away a point (mm), which is rounded, and what is right beside it?
bool TreeCda::is_waited_for_near(Vec3 point) const {
    constexpr double kNear = 4.0;  // units
    const Vec3 at = (1.0 / lattice_.unit_mm) * point;
    const auto is_near = [&](const auto& waiting) {
        return std::ranges::all_of(waiting->cell.planes, [&](const Plane& p) {
            const Vec3 normal{static_cast<double>(p.nx), static_cast<double>(p.ny),
                              static_cast<double>(p.nz)};
            return dot(normal, at) - static_cast<double>(p.d) <= kNear * norm(normal);
        });
    };
    return std::ranges::any_of(blocks_, [&](const Block& block) {
        const HalfBox box = block.tree->box();
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = 2.0 * at[static_cast<int>(i)];
            if (x < static_cast<double>(box.min[i]) - 2.0 * kNear ||
                x > static_cast<double>(box.max[i]) + 2.0 * kNear) {
                return false;
            }
        }
        return std::ranges::any_of(block.waiting, is_near);
    });
}

double TreeCda::subtract(const Cell& cell) {
    settle_near(cell.bounds);
    const Evaluation result = evaluate_window(cell, false);
    if (parameters_.tile) {
        WorkpieceModel::subtract_unmeasured(cell);
        return result.volume * lattice_.cubic_unit_mm3();
    }
    // Whether they have anything in common is decided by pieces of surface, exactly; the sum is
    // rounded, and may come out as less than nothing.
    if (result.outlines.pieces().empty()) return 0.0;
    WorkpieceModel::subtract_unmeasured(cell);
    return std::max(0.0, result.volume * lattice_.cubic_unit_mm3());
}

void TreeCda::keep_account() {
    settle();
    if (!account_) account_.emplace();
}

Account TreeCda::account() const {
    const Asked asked(*this);
    settle_all();
    Account result;
    if (!account_) return result;
    const double unit = lattice_.cubic_unit_mm3();
    const double rounding = kAccountRounding * stock_volume_;
    for (const auto& [origin, taken] : *account_) {
        const bool is_nothing = std::abs(taken.volume) < rounding;
        result[origin] = is_nothing ? Taking{} : Taking{taken.volume * unit, taken.bounds};
    }
    return result;
}

Evaluation TreeCda::evaluate_window(const Cell& cell, bool only_first) const {
    Evaluation sum;
    std::vector<Plane> window;
    for (const Plane& plane : cell.planes) {
        const Side side = classify_box(stock_box_, plane);
        if (side == Side::Above) return sum;
        if (side == Side::On) window.push_back(plane);
    }
    const Vec3 middle = 0.5 * (cell.bounds.min + cell.bounds.max);
    const Vec3 centre = (1.0 / lattice_.unit_mm) * middle;
    const EvaluationInput input{stock_planes_, &window, *cells_, centre, only_first};
    IncomingCell near;
    near.enclose(cell.bounds, lattice_.unit_mm);
    for (const std::uint32_t number : own_) {
        const Block& block = blocks_[number];
        if (!block.tree->meets(near)) continue;
        Evaluation here = evaluate(*block.tree, input);
        sum.volume += here.volume;
        if (!here.outlines.pieces().empty()) sum.outlines = std::move(here.outlines);
        if (only_first && !sum.outlines.pieces().empty()) break;
    }
    return sum;
}

double TreeCda::common_volume(const Cell& cell) const {
    const Asked asked(*this);
    settle_near(cell.bounds);
    const Evaluation result = evaluate_window(cell, false);
    if (parameters_.tile) return result.volume * lattice_.cubic_unit_mm3();
    return result.outlines.pieces().empty()
               ? 0.0
               : std::max(0.0, result.volume * lattice_.cubic_unit_mm3());
}

std::optional<Vec3> TreeCda::contact(const Cell& cell) const {
    const Asked asked(*this);
    // What waits can only take away: where there is nothing without it, there is nothing.
    const std::optional<Vec3> found = contact_as_it_is(cell);
    if (!found || !is_waited_for_near(*found)) return found;
    if (takes_all_of(cell)) {
        ++counts_.spared;
        return std::nullopt;
    }
    settle_near(cell.bounds);
    return contact_as_it_is(cell);
}

// Do cells, those that wait included, take all that the stock has of this one? May miss it.
bool TreeCda::takes_all_of(const Cell& cell) const {
    IncomingCell asked;
    asked.enclose(cell.bounds, lattice_.unit_mm);
    HalfBox bounds;
    for (std::size_t i = 0; i < 3; ++i) {
        bounds.min[i] = 2 * static_cast<std::int64_t>(std::floor(asked.min[i] / 2)) - 1;
        bounds.max[i] = 2 * static_cast<std::int64_t>(std::ceil(asked.max[i] / 2)) + 1;
    }
    const Box near = this->near(cell.bounds);
    std::vector<const IncomingCell*> waiting;
    for (const std::uint32_t number : own_) {
        const Block& block = blocks_[number];
        if (!block.tree->meets(asked)) continue;
        waiting.clear();
        for (const auto& taken : block.waiting) {
            if (taken->cell.bounds.overlaps(near)) waiting.push_back(&taken->incoming);
        }
        if (!is_covered(*block.tree, {cell.planes, bounds, waiting, *cells_, kMostLooks}))
            return false;
    }
    return true;
}

std::optional<Vec3> TreeCda::contact_as_it_is(const Cell& cell) const {
    const Evaluation result = evaluate_window(cell, true);
    if (result.outlines.pieces().empty())
        return parameters_.tile ? in_block_within(cell) : std::nullopt;
    const Outlines::Piece& piece = result.outlines.pieces().front();
    const auto at = [&](std::uint32_t p) { return result.outlines.points()[p].fixed.approx(); };
    return lattice_.to_mm(0.5 * (at(piece.tail) + at(piece.head)));
}

// Of a tile: where a block is within both, of which no surface can tell there. All of its inside
// is, or nothing: a few points tell, which no wall without thickness has all.
std::optional<Vec3> TreeCda::in_block_within(const Cell& cell) const {
    constexpr std::array<Vec3, 4> kCorners{
        {{0.31, 0.43, 0.37}, {0.67, 0.59, 0.41}, {0.47, 0.71, 0.53}, {0.61, 0.33, 0.69}}};
    IncomingCell near;
    near.enclose(cell.bounds, lattice_.unit_mm);
    for (const std::uint32_t number : own_) {
        if (!blocks_[number].tree->meets(near)) continue;
        const HalfBox box = blocks_[number].tree->box();
        const auto corner = [&](const Vec3& share) {
            Vec3 at;
            for (int i = 0; i < 3; ++i) {
                const auto axis = static_cast<std::size_t>(i);
                at[i] = 0.5 * (static_cast<double>(box.min[axis]) +
                               share[i] * static_cast<double>(box.extent(axis)));
            }
            return lattice_.to_mm(at);
        };
        const auto is_in_both = [&](const Vec3& share) {
            const QueryPoint query(corner(share), lattice_);
            return std::ranges::all_of(
                       cell.planes,
                       [&](const Plane& h) { return query.side_of(h) != Side::Above; }) &&
                   contains_as_it_is(query);
        };
        if (std::ranges::all_of(kCorners, is_in_both)) return corner(kCorners[0]);
    }
    return std::nullopt;
}

double TreeCda::volume() const {
    const Asked asked(*this);
    settle_all();
    const EvaluationInput input{stock_planes_, nullptr, *cells_, centre_, false};
    in_parallel(parameters_.threads, own_.size(), [&](std::size_t i) {
        const Block& block = blocks_[own_[i]];
        if (block.volume) return;
        Evaluation result = evaluate(*block.tree, input);
        block.volume = result.volume;
        if (parameters_.tile)
            block.outlines = std::make_shared<const Outlines>(std::move(result.outlines));
    });
    double sum = 0.0;
    for (const std::uint32_t number : own_)
        sum += *blocks_[number].volume;
    if (parameters_.tile) {
        std::vector<double>& volumes = volumes_asked_.emplace_back();
        for (const std::uint32_t number : own_)
            volumes.push_back(*blocks_[number].volume);
    }
    return sum * lattice_.cubic_unit_mm3();
}

Boundary TreeCda::boundary() const {
    if (parameters_.tile) throw CannotAnswer(name(), "the surface of a tile");
    const Asked asked(*this);
    settle_all();
    const EvaluationInput input{stock_planes_, nullptr, *cells_, centre_, false};
    counts_.leaves = counts_.facets_tested = counts_.facets_alive = counts_.pieces = 0;
    Stitcher stitcher(lattice_, parameters_.threads);
    make_in_parallel(
        parameters_.threads, blocks_.size(),
        [&](std::size_t i) { return evaluate(*blocks_[i].tree, input); },
        [&](std::size_t i, const Evaluation& result) {
            blocks_[i].volume = result.volume;
            counts_.leaves += result.leaves;
            counts_.facets_tested += result.facets_tested;
            counts_.facets_alive += result.facets_alive;
            counts_.pieces += result.outlines.pieces().size();
            stitcher.take(result.outlines);
        });
    return stitcher.finish();
}

// Tile, of how many; blocks of the part, how many of them are its own, how often volumes were asked
// for; which blocks, and what their volumes were each time; outlines block by block; edges at the
// walls.
void TreeCda::write_tile(std::ostream& out) const {
    if (!parameters_.tile) throw CannotAnswer(name(), "a tile where there are none");
    const Asked asked(*this);
    settle_all();
    for (const std::size_t n :
         {std::size_t{parameters_.tile->tile}, std::size_t{parameters_.tile->of}, blocks_.size(),
          own_.size(), volumes_asked_.size()})
        put_u32(out, static_cast<std::uint32_t>(n));
    for (const std::uint32_t number : own_)
        put_u32(out, number);
    for (const std::vector<double>& volumes : volumes_asked_) {
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
        stitcher.take(block.outlines->at(walls_));
        block.outlines.reset();
    }
    put_outlines(out, stitcher.finish_border(walls_));
}

TreeCounts TreeCda::counts() const {
    const Asked asked(*this);
    settle_all();
    TreeCounts counts = counts_;
    counts.nodes = 0;
    counts.bytes = cells_->memory();
    for (const Block& block : blocks_) {
        counts.nodes += block.tree->nodes();
        counts.bytes += block.tree->memory();
    }
    return counts;
}

void TreeCda::render(FacetCanvas& canvas) const {
    // Nothing is left to mask: faces of the boundary are what is seen.
    const Boundary surface = boundary();
    const TriangleMesh mesh = triangulate(surface);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const BoundaryFace& face = surface.faces[mesh.face[i]];
        std::vector<Vec3> outline;
        for (const std::uint32_t corner : mesh.triangles[i])
            outline.push_back(mesh.vertices[corner]);
        canvas.draw({face.normal, face.origin, outline, {}});
    }
}

bool TreeCda::contains(Vec3 point) const {
    const Asked asked(*this);
    settle_all();
    return contains_as_it_is(QueryPoint(point, lattice_));
}

bool TreeCda::contains_as_it_is(const QueryPoint& query) const {
    if (std::any_of(stock_planes_.begin(), stock_planes_.end(),
                    [&](const Plane& h) { return query.side_of(h) == Side::Above; })) {
        return false;
    }
    BlockTree::LeafCells cells;
    const auto own = std::ranges::find_if(
        own_, [&](std::uint32_t i) { return blocks_[i].tree->find(query.at, cells); });
    if (own == own_.end()) return false;
    const Block& block = blocks_[*own];
    return std::ranges::none_of(cells.entries(), [&](const BlockTree::Entry& cell) {
        return std::ranges::all_of(cell.planes, [&](std::uint32_t h) {
            return query.side_of(block.tree->plane(cell.cell, h, *cells_)) == Side::Below;
        });
    });
}

}  // namespace ncsim::cda
