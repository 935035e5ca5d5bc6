// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cell is inserted by going down with the planes that are *active*: those that cut the box of
// the node. A plane that has the box above it ends the way (the cell is not here); when no
// plane is left, the cell covers the box and the node is empty for good. What remains are leaves
// with the few cells whose surface passes through them, and only those are ever evaluated.
#include "ncsim/cda/tree.h"

#include "ncsim/cda/polygon.h"
#include "ncsim/cda/polytope.h"

#include "filtered_polygon.h"
#include "stitch.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ncsim::cda {

namespace {

// Boxes are not split below this many half units: cells that meet in a line or a point cannot be
// told apart by smaller boxes, only multiplied.
constexpr std::int64_t kSmallestBox = 2048;

// How a box lies to a plane. Exact: |n| <= 2^24, coordinates below 2^27 half units, |d| < 2^52.
template <class Bounds>
Side side_of_box(const Bounds& min, const Bounds& max, const Plane& p) {
    const auto reach = [&](const Bounds& positive, const Bounds& negative) {
        return std::int64_t{p.nx} * (p.nx > 0 ? positive : negative)[0] +
               std::int64_t{p.ny} * (p.ny > 0 ? positive : negative)[1] +
               std::int64_t{p.nz} * (p.nz > 0 ? positive : negative)[2];
    };
    if (reach(max, min) <= 2 * p.d) return Side::Below;
    if (reach(min, max) >= 2 * p.d) return Side::Above;
    return Side::On;
}

// The middle of an interval of odd numbers, odd again.
std::int64_t middle(std::int64_t low, std::int64_t high) {
    return ((low + high) >> 1) | 1;
}

double cube(double x) {
    return x * x * x;
}

bool same_direction(const Plane& a, const Plane& b) {
    return std::int64_t{a.nx} * b.nx + std::int64_t{a.ny} * b.ny + std::int64_t{a.nz} * b.nz > 0;
}

// Of planes with the same direction: the sign of the distance of `b` less that of `a`. Exact.
int compare_distances(const Plane& a, const Plane& b) {
    // d/|n| in a component that is not zero: parallel normals are in proportion.
    const auto component = [axis = a.nx != 0   ? 0
                                   : a.ny != 0 ? 1
                                               : 2](const Plane& p) {
        return static_cast<Int128>(std::abs(axis == 0 ? p.nx : axis == 1 ? p.ny : p.nz));
    };
    const Int128 difference = b.d * component(a) - a.d * component(b);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

}  // namespace

// What is left of the facets of a set of cells, box by box. With a window, the surface of what the
// window has in common with the part instead of that of the part.
class TreeCda::Evaluation {
public:
    using Sink = std::function<void(const FilteredPolygon& piece, Origin origin, bool is_wall)>;

    Evaluation(const TreeCda& tree, const std::vector<Plane>* window, Sink sink)
        : tree_(tree), window_(window), sink_(std::move(sink)) {}

    // A box of the tree; boxes that together are the whole may be run in any order, by any thread.
    void run(std::uint32_t node, const HalfBox& box) {
        const std::vector<FilterPlane> stock_planes(tree_.stock_planes_.begin(),
                                                    tree_.stock_planes_.end());
        std::vector<FilterPlane> window_planes;
        if (window_) window_planes = {window_->begin(), window_->end()};
        Planes window;
        if (!active(addresses(window_planes), box, window)) return;
        Planes stock;
        active(addresses(stock_planes), box, stock);
        visit(node, box, stock, window);
    }
    const TreeCounts& counts() const { return counts_; }

private:
    using Planes = std::vector<const FilterPlane*>;

    static Planes addresses(const std::vector<FilterPlane>& planes) {
        Planes result;
        for (const FilterPlane& plane : planes)
            result.push_back(&plane);
        return result;
    }

    // A cell with the planes that cut the box at hand.
    struct Local {
        std::uint32_t cell;
        Planes planes;
    };

    // The planes that cut the box; false if the box is outside of one of them.
    static bool active(const Planes& planes, const HalfBox& box, Planes& cutting) {
        cutting.clear();
        for (const FilterPlane* plane : planes) {
            switch (side_of_box(box.min, box.max, plane->exact)) {
                case Side::Below: break;
                case Side::Above: return false;
                case Side::On: cutting.push_back(plane); break;
            }
        }
        return true;
    }

    void visit(std::uint32_t number, const HalfBox& box, const Planes& stock,
               const Planes& window) {
        const Node& node = tree_.nodes_[number];
        if (node.kind == NodeKind::Empty) return;
        if (node.kind == NodeKind::Inner) {
            Planes inner_stock;
            Planes inner_window;
            for (std::uint32_t child = 0; child < 8; ++child) {
                const HalfBox inner = child_box(box, child);
                if (active(stock, inner, inner_stock) && active(window, inner, inner_window)) {
                    visit(node.first_child + child, inner, inner_stock, inner_window);
                }
            }
            return;
        }
        if (stock.empty() && window.empty() && node.cells.empty()) return;
        // The planes that cut the box, in one place that does not move.
        leaf_planes_.clear();
        std::vector<std::pair<std::uint32_t, std::size_t>> ends;
        for (const std::uint32_t c : node.cells) {
            const std::size_t begin = leaf_planes_.size();
            bool is_here = true;
            for (const Plane& plane : tree_.planes_of(c)) {
                const Side side = side_of_box(box.min, box.max, plane);
                is_here = side != Side::Above;
                if (!is_here) break;
                if (side == Side::On) leaf_planes_.emplace_back(plane);
            }
            if (!is_here) {
                leaf_planes_.resize(begin);
                continue;
            }
            if (leaf_planes_.size() == begin) return;  // covered
            ends.emplace_back(c, leaf_planes_.size());
        }
        std::vector<Local> cells;
        std::size_t at = 0;
        for (const auto& [cell, end] : ends) {
            Local local{cell, {}};
            for (; at < end; ++at)
                local.planes.push_back(&leaf_planes_[at]);
            add(cells, std::move(local));
        }
        refine(box, stock, window, cells);
    }

    // Cells with the same planes here are one; the first of them makes the walls.
    void add(std::vector<Local>& cells, Local local) const {
        for (Local& other : cells) {
            if (!std::equal(other.planes.begin(), other.planes.end(), local.planes.begin(),
                            local.planes.end(), [](const FilterPlane* a, const FilterPlane* b) {
                                return a->exact == b->exact;
                            })) {
                continue;
            }
            if (tree_.comes_before(local.cell, other.cell)) other.cell = local.cell;
            return;
        }
        cells.push_back(std::move(local));
    }

    // Halves the box while many cells meet in it and halves still tell them apart: cells that all
    // meet in a line or a point do so in smaller boxes too, only more often.
    void refine(const HalfBox& box, const Planes& stock, const Planes& window,
                const std::vector<Local>& cells, int fruitless = 0) {
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (box.max[i] - box.min[i] > box.max[axis] - box.min[axis]) axis = i;
        }
        if (cells.size() <= tree_.parameters_.evaluation_leaf || fruitless >= 3 ||
            box.max[axis] - box.min[axis] < kSmallestBox) {
            evaluate(box, stock, window, cells);
            return;
        }
        const std::int64_t cut = middle(box.min[axis], box.max[axis]);
        Planes inner_stock;
        Planes inner_window;
        for (int half = 0; half < 2; ++half) {
            HalfBox inner = box;
            (half == 0 ? inner.max : inner.min)[axis] = cut;
            if (!active(stock, inner, inner_stock) || !active(window, inner, inner_window)) {
                continue;
            }
            std::vector<Local> here;
            bool covered = false;
            for (const Local& local : cells) {
                Local inner_local{local.cell, {}};
                if (!active(local.planes, inner, inner_local.planes)) continue;
                covered = inner_local.planes.empty();
                if (covered) break;
                add(here, std::move(inner_local));
            }
            if (covered) continue;
            refine(inner, inner_stock, inner_window, here,
                   here.size() == cells.size() ? fruitless + 1 : 0);
        }
    }

    void evaluate(const HalfBox& box, const Planes& stock, const Planes& window,
                  const std::vector<Local>& cells) {
        ++counts_.leaves_evaluated;
        std::array<FilterPlane, 6> walls;
        for (std::size_t i = 0; i < 3; ++i) {
            // 2x <= max: odd distances, hence canonical.
            std::array<std::int32_t, 3> n{};
            n[i] = 2;
            walls[2 * i + 1] = FilterPlane({n[0], n[1], n[2], box.max[i]});
            walls[2 * i] = FilterPlane({-n[0], -n[1], -n[2], -box.min[i]});
        }
        const auto takes_same = [](const Local&, bool same) { return same; };
        for (const FilterPlane* s : stock) {
            if (facet_.assign_section(*s, box.min, box.max, walls) && clip_to(stock) &&
                clip_strictly_to(window)) {
                finish(kStockOrigin, false, cells, nullptr, takes_same);
            }
        }
        for (const Local& local : cells) {
            for (const FilterPlane* s : local.planes) {
                if (!facet_.assign_section(*s, box.min, box.max, walls) || !clip_to(local.planes) ||
                    !clip_strictly_to(stock) || !clip_strictly_to(window)) {
                    continue;
                }
                // Opposite walls both go; of equal ones the first stays.
                finish(tree_.cells_[local.cell].origin, true, cells, &local,
                       [&](const Local& other, bool same) {
                           return !same || tree_.comes_before(other.cell, local.cell);
                       });
            }
        }
        for (const FilterPlane* s : window) {
            if (facet_.assign_section(*s, box.min, box.max, walls) && clip_to(window) &&
                clip_to(stock)) {
                finish(kStockOrigin, false, cells, nullptr, takes_same);
            }
        }
    }

    // Keeps of facet_ what lies below the planes; a plane in which it lies itself does not count,
    // but between it and an opposite one there is nothing.
    bool clip_to(const Planes& planes) {
        for (const FilterPlane* plane : planes) {
            if (facet_.plane().is_parallel_to(plane->exact)) {
                const bool same = same_direction(facet_.plane(), plane->exact);
                const int beyond = distance_beyond(facet_.plane(), plane->exact, same);
                if (beyond < 0 || (beyond == 0 && !same)) return false;
            } else if (!facet_.clip(*plane)) {
                return false;
            }
        }
        return true;
    }

    // The same, but nothing if it lies in one of the planes.
    bool clip_strictly_to(const Planes& planes) {
        return std::none_of(planes.begin(), planes.end(),
                            [&](const FilterPlane* p) { return p->exact == facet_.plane(); }) &&
               clip_to(planes);
    }

    // Of a plane parallel to that of a facet: positive if the facet is below it, 0 if it lies in
    // it.
    static int distance_beyond(const Plane& facet, const Plane& plane, bool same) {
        return compare_distances(facet, same ? plane : plane.opposite()) * (same ? 1 : -1);
    }

    // The facet rule: takes from facet_ what other cells have of it. `takes_coplanar(cell, same)`
    // tells whether a cell with a facet in the same plane, in the same or the opposite orientation,
    // does.
    template <class TakesCoplanar>
    void finish(Origin origin, bool is_wall, const std::vector<Local>& cells, const Local* self,
                TakesCoplanar takes_coplanar) {
        ++counts_.facets_tested;
        std::size_t takers = 0;
        // Most facets are covered by one cell, and often by the one that covered the facet before.
        if (killer_ < cells.size() && &cells[killer_] != self) {
            if (crossing_.empty()) crossing_.emplace_back();
            if (taken_by(cells[killer_], takes_coplanar, crossing_[0]) == Overlap::Covered) return;
        }
        for (const Local& other : cells) {
            if (&other == self) continue;
            if (takers == crossing_.size()) crossing_.emplace_back();
            switch (taken_by(other, takes_coplanar, crossing_[takers])) {
                case Overlap::None: break;
                case Overlap::Covered:
                    killer_ = static_cast<std::size_t>(&other - cells.data());
                    return;
                case Overlap::Undecided: ++takers; break;
            }
        }
        std::size_t pieces = 1;
        if (pieces_.empty()) pieces_.emplace_back();
        pieces_[0] = facet_;
        for (std::size_t t = 0; t < takers; ++t) {
            std::size_t rest = 0;
            for (std::size_t i = 0; i < pieces; ++i)
                pieces_[i].subtract(crossing_[t], rest_, rest);
            pieces_.swap(rest_);
            pieces = rest;
            if (pieces == 0) return;
        }
        ++counts_.facets_alive;
        counts_.fragments += pieces;
        for (std::size_t i = 0; i < pieces; ++i)
            sink_(pieces_[i], origin, is_wall);
    }

    // What single planes tell of what `other` takes from facet_; `crossing` are those that do not.
    template <class TakesCoplanar>
    Overlap taken_by(const Local& other, TakesCoplanar takes_coplanar, Planes& crossing) {
        bool coplanar_same = false;
        bool coplanar_opposite = false;
        cuts_.clear();
        for (const FilterPlane* plane : other.planes) {
            if (!plane->exact.is_parallel_to(facet_.plane())) {
                cuts_.push_back(plane);
                continue;
            }
            const bool same = same_direction(facet_.plane(), plane->exact);
            const int beyond = distance_beyond(facet_.plane(), plane->exact, same);
            if (beyond < 0 || (beyond == 0 && !takes_coplanar(other, same))) return Overlap::None;
            if (beyond == 0) (same ? coplanar_same : coplanar_opposite) = true;
        }
        if (coplanar_same && coplanar_opposite) return Overlap::None;  // a flat cell
        return facet_.overlap(cuts_, crossing);
    }

    const TreeCda& tree_;
    const std::vector<Plane>* window_;
    Sink sink_;
    TreeCounts counts_;
    // Kept between facets, so that nothing is allocated for each.
    std::vector<FilterPlane> leaf_planes_;
    FilteredPolygon facet_;
    Planes cuts_;
    std::size_t killer_ = 0;  // index into the cells of the leaf at hand
    std::vector<Planes> crossing_;
    std::vector<FilteredPolygon> pieces_;
    std::vector<FilteredPolygon> rest_;
};

TreeCda::TreeCda(TreeParameters parameters) : parameters_(parameters) {}

TreeCda::TreeCda(const Cell& stock, const Lattice& lattice, TreeParameters parameters)
    : parameters_(parameters), lattice_(lattice), stock_(stock) {
    const auto body = ConvexPolytope::of(stock, lattice);
    if (!body) throw std::invalid_argument("the stock has no volume");
    centre_ = body->bounds().centre();
    for (const auto& facet : body->facets())
        stock_planes_.push_back(facet.plane);
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        root_box_.min[i] = 2 * static_cast<std::int64_t>(body->bounds().min[axis]) - 1;
        root_box_.max[i] = 2 * static_cast<std::int64_t>(body->bounds().max[axis]) + 1;
    }
    nodes_.emplace_back();
}

std::unique_ptr<WorkpieceModel> TreeCda::create(const Cell& stock, const Lattice& lattice) const {
    return std::make_unique<TreeCda>(stock, lattice, parameters_);
}

std::unique_ptr<WorkpieceModel> TreeCda::clone() const {
    return std::make_unique<TreeCda>(*this);
}

std::span<const Plane> TreeCda::planes_of(std::uint32_t cell) const {
    return std::span(planes_).subspan(cells_[cell].begin, cells_[cell].end - cells_[cell].begin);
}

bool TreeCda::comes_before(std::uint32_t a, std::uint32_t b) const {
    return std::pair{cells_[a].origin, a} < std::pair{cells_[b].origin, b};
}

TreeCda::HalfBox TreeCda::child_box(const HalfBox& box, std::uint32_t child) {
    HalfBox inner = box;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t cut = middle(box.min[i], box.max[i]);
        ((child >> i) & 1 ? inner.min : inner.max)[i] = cut;
    }
    return inner;
}

std::uint32_t TreeCda::new_children() {
    if (!free_children_.empty()) {
        const std::uint32_t first = free_children_.back();
        free_children_.pop_back();
        for (std::uint32_t i = 0; i < 8; ++i)
            nodes_[first + i] = {};
        return first;
    }
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
    return first;
}

void TreeCda::release(std::uint32_t number) {
    Node& node = nodes_[number];
    if (node.kind == NodeKind::Inner) {
        const std::uint32_t first = node.first_child;
        for (std::uint32_t i = 0; i < 8; ++i)
            release(first + i);
        free_children_.push_back(first);
    }
    nodes_[number] = {};
}

// Keeps what cuts the stock of a cell. Nothing if the cell lies outside.
std::optional<std::uint32_t> TreeCda::store(const Cell& cell) {
    const auto begin = static_cast<std::uint32_t>(planes_.size());
    const Box stock_box{{0.5 * static_cast<double>(root_box_.min[0] + 1),
                         0.5 * static_cast<double>(root_box_.min[1] + 1),
                         0.5 * static_cast<double>(root_box_.min[2] + 1)},
                        {0.5 * static_cast<double>(root_box_.max[0] - 1),
                         0.5 * static_cast<double>(root_box_.max[1] - 1),
                         0.5 * static_cast<double>(root_box_.max[2] - 1)}};
    for (const Plane& plane : cell.planes) {
        switch (classify_box(stock_box, plane)) {
            case Side::Below: break;
            case Side::On: planes_.push_back(plane); break;
            case Side::Above: planes_.resize(begin); return std::nullopt;
        }
    }
    cells_.push_back({begin, static_cast<std::uint32_t>(planes_.size()), cell.origin});
    ++counts_.cells;
    counts_.planes += planes_.size() - begin;
    return static_cast<std::uint32_t>(cells_.size() - 1);
}

void TreeCda::insert(std::uint32_t number, const HalfBox& box, std::uint32_t cell,
                     std::size_t active_begin) {
    // The active planes of a node stand at the end of one stack that all levels share.
    const std::size_t parent_end = active_.size();
    for (std::size_t i = active_begin; i < parent_end; ++i) {
        switch (side_of_box(box.min, box.max, planes_[active_[i]])) {
            case Side::Below: break;
            case Side::Above: active_.resize(parent_end); return;
            case Side::On: active_.push_back(active_[i]); break;
        }
    }
    if (active_.size() == parent_end) {
        release(number);
        nodes_[number].kind = NodeKind::Empty;
        return;
    }
    if (nodes_[number].kind == NodeKind::Material) {
        nodes_[number].cells.push_back(cell);
        if (nodes_[number].cells.size() > parameters_.insertion_leaf) split(number, box);
    } else {
        const std::uint32_t first = nodes_[number].first_child;
        bool all_empty = true;
        for (std::uint32_t child = 0; child < 8; ++child) {
            if (nodes_[first + child].kind != NodeKind::Empty) {
                insert(first + child, child_box(box, child), cell, parent_end);
            }
            all_empty = all_empty && nodes_[first + child].kind == NodeKind::Empty;
        }
        if (all_empty) {
            release(number);
            nodes_[number].kind = NodeKind::Empty;
        }
    }
    active_.resize(parent_end);
}

// Hands the cells of a leaf down to eight children; drops repeats first, since the same cell
// cut a thousand times cannot be told apart by any box.
void TreeCda::split(std::uint32_t number, const HalfBox& box) {
    std::vector<std::vector<Plane>> seen;
    std::vector<std::uint32_t> distinct;
    for (const std::uint32_t cell : nodes_[number].cells) {
        std::vector<Plane> cutting;
        for (const Plane& plane : planes_of(cell)) {
            if (side_of_box(box.min, box.max, plane) == Side::On) cutting.push_back(plane);
        }
        const auto same = std::find(seen.begin(), seen.end(), cutting);
        if (same == seen.end()) {
            seen.push_back(std::move(cutting));
            distinct.push_back(cell);
        } else {
            std::uint32_t& other = distinct[static_cast<std::size_t>(same - seen.begin())];
            if (comes_before(cell, other)) other = cell;
        }
    }
    const bool is_small = box.max[0] - box.min[0] < kSmallestBox ||
                          box.max[1] - box.min[1] < kSmallestBox ||
                          box.max[2] - box.min[2] < kSmallestBox;
    if (is_small || 2 * distinct.size() <= parameters_.insertion_leaf) {
        nodes_[number].cells = std::move(distinct);
        return;
    }
    const std::uint32_t first = new_children();
    nodes_[number].kind = NodeKind::Inner;
    nodes_[number].first_child = first;
    nodes_[number].cells = {};
    const std::size_t begin = active_.size();
    for (const std::uint32_t cell : distinct) {
        for (std::uint32_t i = cells_[cell].begin; i < cells_[cell].end; ++i)
            active_.push_back(i);
        for (std::uint32_t child = 0; child < 8; ++child) {
            if (nodes_[first + child].kind == NodeKind::Empty) continue;
            insert(first + child, child_box(box, child), cell, begin);
        }
        active_.resize(begin);
    }
}

void TreeCda::subtract_unmeasured(const Cell& cell) {
    const auto stored = store(cell);
    if (!stored || nodes_[0].kind == NodeKind::Empty) return;
    volume_.reset();
    active_.clear();
    for (std::uint32_t i = cells_[*stored].begin; i < cells_[*stored].end; ++i)
        active_.push_back(i);
    insert(0, root_box_, *stored, 0);
}

double TreeCda::subtract(const Cell& cell) {
    const double removed = common_volume(cell);
    subtract_unmeasured(cell);
    return removed;
}

double TreeCda::common_volume(const Cell& cell) const {
    std::vector<Plane> window;
    for (const Plane& plane : cell.planes) {
        // Planes beyond the range of the lattice do not cut the stock; see store().
        if (std::abs(plane.d) < (std::int64_t{1} << 52)) {
            window.push_back(plane);
        } else if (plane.d < 0) {
            return 0.0;
        }
    }
    return evaluated_volume(&window);
}

double TreeCda::volume() const {
    if (!volume_) volume_ = evaluated_volume(nullptr);
    return *volume_;
}

// A third of the sum of distance times area over the surface; walls face the other way.
double TreeCda::volume_below(const ConvexPolygon& piece, bool is_wall) const {
    const double part = distance_about(piece.plane, centre_) * area(piece) / 3.0;
    return (is_wall ? -part : part) * cube(lattice_.unit_mm);
}

// Boxes of the tree down to three levels: enough to keep threads busy. The same for any number of
// them, so that sums are added up in the same order.
std::vector<TreeCda::Task> TreeCda::tasks() const {
    constexpr int kLevels = 3;
    std::vector<Task> all;
    const auto collect = [&](const auto& self, std::uint32_t node, const HalfBox& box,
                             int level) -> void {
        if (nodes_[node].kind == NodeKind::Empty) return;
        if (nodes_[node].kind == NodeKind::Material || level == kLevels) {
            all.push_back({node, box});
            return;
        }
        for (std::uint32_t child = 0; child < 8; ++child) {
            self(self, nodes_[node].first_child + child, child_box(box, child), level + 1);
        }
    };
    collect(collect, 0, root_box_, 0);
    return all;
}

void TreeCda::for_each_task(std::size_t tasks, const std::function<void(std::size_t)>& work) const {
    const std::size_t wanted =
        parameters_.threads > 0 ? parameters_.threads : std::thread::hardware_concurrency();
    const std::size_t count = std::clamp<std::size_t>(wanted, 1, tasks);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto worker = [&] {
        try {
            for (std::size_t i = next++; i < tasks; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard lock(failure_mutex);
            failure = std::current_exception();
            next = tasks;
        }
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < count; ++i)
        others.emplace_back(worker);
    worker();
    others.clear();  // joins
    if (failure) std::rethrow_exception(failure);
}

double TreeCda::evaluated_volume(const std::vector<Plane>* window) const {
    const std::vector<Task> boxes = tasks();
    std::vector<double> sums(boxes.size(), 0.0);
    const auto work = [&](std::size_t i) {
        Evaluation evaluation(*this, window,
                              [&](const FilteredPolygon& piece, Origin, bool is_wall) {
                                  sums[i] += volume_below(piece.exact(), is_wall);
                              });
        evaluation.run(boxes[i].node, boxes[i].box);
    };
    // A window is small: starting threads would take longer than looking through it.
    if (window) {
        for (std::size_t i = 0; i < boxes.size(); ++i)
            work(i);
    } else {
        for_each_task(boxes.size(), work);
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

std::vector<Fragment> TreeCda::fragments() const {
    struct Result {
        std::vector<Fragment> fragments;
        double volume = 0.0;
        TreeCounts counts;
    };
    const std::vector<Task> boxes = tasks();
    std::vector<Result> results(boxes.size());
    for_each_task(boxes.size(), [&](std::size_t i) {
        Result& result = results[i];
        Evaluation evaluation(
            *this, nullptr, [&](const FilteredPolygon& filtered, Origin origin, bool is_wall) {
                const ConvexPolygon piece = filtered.exact();
                result.volume += volume_below(piece, is_wall);
                const ConvexPolygon outer = is_wall ? turned_over(piece) : piece;
                Fragment fragment{outer.plane, origin, {{}}};
                for (std::size_t k = 0; k < outer.corners.size(); ++k) {
                    fragment.loops[0].push_back({outer.corners[k], outer.edges[k]});
                }
                result.fragments.push_back(std::move(fragment));
            });
        evaluation.run(boxes[i].node, boxes[i].box);
        result.counts = evaluation.counts();
    });

    std::vector<Fragment> all;
    double volume = 0.0;
    counts_.nodes = nodes_.size() - 8 * free_children_.size();
    counts_.leaves_evaluated = counts_.facets_tested = counts_.facets_alive = counts_.fragments = 0;
    for (Result& result : results) {
        std::move(result.fragments.begin(), result.fragments.end(), std::back_inserter(all));
        volume += result.volume;
        counts_.leaves_evaluated += result.counts.leaves_evaluated;
        counts_.facets_tested += result.counts.facets_tested;
        counts_.facets_alive += result.counts.facets_alive;
        counts_.fragments += result.counts.fragments;
    }
    volume_ = volume;
    return all;
}

Boundary TreeCda::boundary() const {
    return stitch(fragments(), lattice_);
}

void TreeCda::render(FacetCanvas& canvas) const {
    // Pieces of facets are what is left of them: nothing to mask.
    for (const Fragment& fragment : fragments()) {
        std::vector<Vec3> outline;
        for (const auto& corner : fragment.loops[0]) {
            outline.push_back(lattice_.to_mm(corner.point.approx));
        }
        canvas.draw({unit_normal(fragment.plane), fragment.origin, outline, {}});
    }
}

bool TreeCda::contains(Vec3 point) const {
    constexpr double kScale = 65536.0;
    constexpr double kReach = 1e12;
    const auto fixed = [&](double mm) {
        return static_cast<std::int64_t>(
            std::round(std::clamp(mm / lattice_.unit_mm, -kReach, kReach) * kScale));
    };
    const std::array<std::int64_t, 3> p{fixed(point.x), fixed(point.y), fixed(point.z)};
    const auto height = [&](const Plane& h) {
        return static_cast<Int128>(h.nx) * p[0] + static_cast<Int128>(h.ny) * p[1] +
               static_cast<Int128>(h.nz) * p[2] - static_cast<Int128>(h.d) * 65536;
    };
    if (std::any_of(stock_planes_.begin(), stock_planes_.end(),
                    [&](const Plane& h) { return height(h) > 0; })) {
        return false;
    }
    std::uint32_t number = 0;
    HalfBox box = root_box_;
    while (nodes_[number].kind == NodeKind::Inner) {
        std::uint32_t child = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            // Half units are 2^15 of the fixed point.
            if (p[i] > middle(box.min[i], box.max[i]) * 32768) child |= 1U << i;
        }
        box = child_box(box, child);
        number = nodes_[number].first_child + child;
    }
    if (nodes_[number].kind == NodeKind::Empty) return false;
    return std::none_of(nodes_[number].cells.begin(), nodes_[number].cells.end(),
                        [&](std::uint32_t cell) {
                            const auto planes = planes_of(cell);
                            return std::all_of(planes.begin(), planes.end(),
                                               [&](const Plane& h) { return height(h) < 0; });
                        });
}

}  // namespace ncsim::cda
