// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries of the part: volume, surface, containment of a point, intersection with a cell. Waiting
// cells are inserted only where the query needs them.
#include "ncsim/base/parallel.h"
#include "ncsim/cda/tree.h"

#include "exact/query_point.h"
#include "surface/stitch.h"
#include "tree/block.h"
#include "tree/covering.h"
#include "tree/evaluation.h"
#include "tree/leaf_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ncsim::cda {

namespace {

// Limit on tests of a proof that no material is left. Nearly all successful proofs need fewer, and
// the limit costs less than the insertion of the waiting cells.
constexpr std::size_t kMostLooks = 100000;

}  // namespace

// Returns a box such that any cell with a point in common with a body of the given bounds overlaps
// the box. The bounds are rounded to millimetres.
Box TreeCda::query_box(const Box& bounds) const {
    const double margin = 2.0 * lattice_.unit_mm;
    const Vec3 more{margin, margin, margin};
    return {bounds.min - more, bounds.max + more};
}

// True if a waiting cell might remove the neighbourhood of a rounded point (mm).
bool TreeCda::has_pending_cell_near(Vec3 point) const {
    constexpr double kNear = 4.0;  // units
    const Vec3 at = (1.0 / lattice_.unit_mm) * point;
    const auto is_near = [&](const auto& pending) {
        return std::ranges::all_of(pending->cell.planes, [&](const Plane& p) {
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
        return std::ranges::any_of(block.pending, is_near);
    });
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
    const ReadLock asked(*this);
    flush_near(cell.bounds);
    const Evaluation result = evaluate_window(cell, false);
    if (parameters_.tile) return result.volume * lattice_.cubic_unit_mm3();
    return result.outlines.pieces().empty()
               ? 0.0
               : std::max(0.0, result.volume * lattice_.cubic_unit_mm3());
}

std::optional<Vec3> TreeCda::contact(const Cell& cell) const {
    const ReadLock asked(*this);
    // Pending cells can only remove material, so "no contact" without them is final.
    const std::optional<Vec3> found = contact_without_pending(cell);
    if (!found || !has_pending_cell_near(*found)) return found;
    if (covers_stock_part_of(cell)) {
        ++counts_.spared;
        return std::nullopt;
    }
    flush_near(cell.bounds);
    return contact_without_pending(cell);
}

// True if the cells, including waiting cells, cover the stock's part of this cell. A negative
// answer may be wrong.
bool TreeCda::covers_stock_part_of(const Cell& cell) const {
    IncomingCell asked;
    asked.enclose(cell.bounds, lattice_.unit_mm);
    HalfBox bounds;
    for (std::size_t i = 0; i < 3; ++i) {
        bounds.min[i] = 2 * static_cast<std::int64_t>(std::floor(asked.min[i] / 2)) - 1;
        bounds.max[i] = 2 * static_cast<std::int64_t>(std::ceil(asked.max[i] / 2)) + 1;
    }
    const Box near = this->query_box(cell.bounds);
    std::vector<const IncomingCell*> pending;
    for (const std::uint32_t number : own_) {
        const Block& block = blocks_[number];
        if (!block.tree->meets(asked)) continue;
        pending.clear();
        for (const auto& cell_in_queue : block.pending) {
            if (cell_in_queue->cell.bounds.overlaps(near))
                pending.push_back(&cell_in_queue->incoming);
        }
        if (!is_covered(*block.tree, {cell.planes, bounds, pending, *cells_, kMostLooks}))
            return false;
    }
    return true;
}

std::optional<Vec3> TreeCda::contact_without_pending(const Cell& cell) const {
    const Evaluation result = evaluate_window(cell, true);
    if (result.outlines.pieces().empty())
        return parameters_.tile ? in_block_within(cell) : std::nullopt;
    const Outlines::Piece& piece = result.outlines.pieces().front();
    const auto at = [&](std::uint32_t p) { return result.outlines.points()[p].fixed.approx(); };
    return lattice_.to_mm(0.5 * (at(piece.tail) + at(piece.head)));
}

// Finds a block of a tile that is within both the part and the cell, where no surface exists. The
// inside of a block is then wholly in both or not at all. A few points decide; the points are
// chosen so that a wall of zero thickness cannot contain all.
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
                   contains_without_pending(query);
        };
        if (std::ranges::all_of(kCorners, is_in_both)) return corner(kCorners[0]);
    }
    return std::nullopt;
}

double TreeCda::volume() const {
    const ReadLock asked(*this);
    flush_all();
    const EvaluationInput input{stock_planes_, nullptr, *cells_, centre_, false};
    in_parallel(parameters_.threads, own_.size(), [&](std::size_t i) {
        const Block& block = blocks_[own_[i]];
        if (block.volume) return;
        if (parameters_.interrupt) parameters_.interrupt();
        Evaluation result = evaluate(*block.tree, input);
        block.volume = result.volume;
        if (parameters_.tile)
            block.outlines = std::make_shared<const Outlines>(std::move(result.outlines));
    });
    double sum = 0.0;
    for (const std::uint32_t number : own_)
        sum += *blocks_[number].volume;
    if (parameters_.tile) {
        std::vector<double>& volumes = requested_volumes_.emplace_back();
        for (const std::uint32_t number : own_)
            volumes.push_back(*blocks_[number].volume);
    }
    return sum * lattice_.cubic_unit_mm3();
}

Boundary TreeCda::boundary() const {
    const ReadLock asked(*this);
    flush_all();
    const EvaluationInput input{stock_planes_, nullptr, *cells_, centre_, false};
    counts_.leaves = counts_.facets_tested = counts_.facets_alive = counts_.pieces = 0;
    Stitcher stitcher(lattice_, parameters_.threads);
    make_in_parallel(
        parameters_.threads, own_.size(),
        [&](std::size_t i) {
            if (parameters_.interrupt) parameters_.interrupt();
            return evaluate(*blocks_[own_[i]].tree, input);
        },
        [&](std::size_t i, const Evaluation& result) {
            blocks_[own_[i]].volume = result.volume;
            counts_.leaves += result.leaves;
            counts_.facets_tested += result.facets_tested;
            counts_.facets_alive += result.facets_alive;
            counts_.pieces += result.outlines.pieces().size();
            stitcher.add_part(result.outlines);
        });
    return stitcher.finish();
}

void TreeCda::record_surface(SurfaceRecorder& recorder) const {
    const ReadLock asked(*this);
    flush_all();
    std::vector<std::size_t> changed;
    for (const std::uint32_t i : own_) {
        std::uint64_t& mark = recorder.mark(i);
        if (mark == blocks_[i].changes) continue;
        mark = blocks_[i].changes;
        changed.push_back(i);
    }
    recorder.begin_state();
    make_in_parallel(
        parameters_.threads, changed.size(),
        [&](std::size_t i) {
            if (parameters_.interrupt) parameters_.interrupt();
            std::vector<SurfaceRecorder::Cell> cells;
            LeafSurface surface(stock_planes_, *cells_);
            const BlockTree& tree = *blocks_[changed[i]].tree;
            const auto add = [&](const HalfBox& box, std::span<const BlockTree::Entry> entries) {
                const BoxFrame frame(box);
                const auto excludes = [&](const Plane& plane) {
                    return side_of(frame, HalfPlane(plane)) == Side::Above;
                };
                if (std::ranges::any_of(stock_planes_, excludes)) return;
                SurfaceRecorder::Cell& cell = cells.emplace_back();
                cell.hash = surface.read(tree, box, entries);
                if (!recorder.has_cell(changed[i], cell.hash))
                    surface.add_polygons(recorder.grid(), lattice_.unit_mm, cell.polygons);
            };
            tree.visit([](const HalfBox&) { return true; }, add);
            return cells;
        },
        [&](std::size_t i, const std::vector<SurfaceRecorder::Cell>& cells) {
            recorder.replace_region(changed[i], cells);
        });
}

bool TreeCda::contains(Vec3 point) const {
    const ReadLock asked(*this);
    flush_all();
    return contains_without_pending(QueryPoint(point, lattice_));
}

bool TreeCda::contains_without_pending(const QueryPoint& query) const {
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
