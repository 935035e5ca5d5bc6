// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells on the way down a block: tests against boxes and choice of cuts.
#include "tree/descent.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace ncsim::cda {

namespace {

// Boxes are cut where the halves together have fewer than this many times the cells of the whole.
constexpr double kPartsBoxes = 1.9;
// Penalty of a short axis in the choice of a cut.
constexpr double kShortAxis = 0.25;
// Boxes with more cells than this are halved along the longest axis.
constexpr std::size_t kManyCells = 64;

}  // namespace

void BlockTree::Descent::begin(const BlockTree& tree, std::span<const IncomingCell* const> cells,
                               const CellTable& table) {
    tree_ = &tree;
    table_ = &table;
    items_.clear();
    facets_.clear();
    loose_.clear();
    pool_.clear();
    views_.clear();
    view_of_family_.assign(table.families(), kNone);
    low_.clear();
    high_.clear();
    column_of_.clear();
    directions_.clear();
    incoming_planes_ = 0;
    for (const IncomingCell* cell : cells) {
        Item item;
        item.number = cell->number;
        item.cell = cell;
        item.first = static_cast<std::uint32_t>(incoming_planes_);
        incoming_planes_ += cell->planes.size();
        items_.push_back(item);
    }
}

void BlockTree::Descent::restore(const Level& level) {
    items_.resize(level.items);
    facets_.resize(level.facets);
    loose_.resize(level.loose);
    pool_.resize(level.pool);
}

std::size_t BlockTree::Descent::load(std::size_t begin) const {
    std::size_t sum = 0;
    for (const Item& item : std::span(items_).subspan(begin))
        sum += item.facets.count + item.loose.count;
    return sum;
}

std::size_t BlockTree::Descent::push_items_in(const BoxFrame& frame, std::size_t begin,
                                              std::size_t end) {
    std::size_t hopeful = kNone;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = begin; i < end; ++i) {
        const IncomingCell* cell = items_[i].cell;
        if (cell) {
            if (!cell->meets(frame)) continue;
            double distance = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                distance = std::max(distance,
                                    std::abs(cell->min[k] + cell->max[k] - 2.0 * frame.centre[k]) /
                                        (cell->max[k] - cell->min[k]));
            }
            if (distance < nearest) {
                nearest = distance;
                hopeful = items_.size();
            }
        }
        items_.push_back(items_[i]);
    }
    return hopeful;
}

// Chooses the axis whose halves together have the fewest items from `begin` on, by the boxes of
// items that have not been classified; no axis if the number is not much smaller.
BlockTree::Descent::Cut BlockTree::Descent::cut_of_boxes(const HalfBox& box,
                                                         std::size_t begin) const {
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i)
        middle[i] = static_cast<double>(box.middle(i));
    std::array<std::size_t, 3> both{};
    std::size_t all = 0;
    for (const Item& item : std::span(items_).subspan(begin)) {
        if (item.is_classified) continue;
        ++all;
        for (std::size_t i = 0; i < 3; ++i) {
            if (item.cell->min[i] <= middle[i] && item.cell->max[i] >= middle[i]) ++both[i];
        }
    }
    const auto longest = static_cast<double>(box.extent(box.longest_axis()));
    Cut best;
    double best_cost = kPartsBoxes;
    for (std::size_t i = 0; i < 3; ++i) {
        if (box.extent(i) < kSmallestBox) continue;
        const double cost = static_cast<double>(all + both[i]) / static_cast<double>(all) +
                            kShortAxis * (1.0 - static_cast<double>(box.extent(i)) / longest);
        if (cost >= best_cost) continue;
        best_cost = cost;
        best = {i, true};
    }
    return best;
}

// Pushes the cells of a leaf onto the items.
void BlockTree::Descent::push_leaf(std::uint32_t number) {
    tree_->nodes_[number].cells.read(words_);
    const std::span<const std::uint32_t> words(words_);
    for (std::size_t at = 0; at < words.size(); at += kHead + words[at + 1]) {
        Item item;
        item.number = words[at];
        item.is_classified = true;
        item.facets.first = static_cast<std::uint32_t>(facets_.size());
        item.loose.first = static_cast<std::uint32_t>(loose_.size());
        const std::uint32_t family = table_->family(item.number);
        for (const std::uint32_t plane : words.subspan(at + kHead, words[at + 1])) {
            const std::uint16_t facet = tree_->planes_.facet(plane);
            if (facet == kLoose) {
                loose_.push_back({static_cast<std::uint32_t>(pool_.size())});
                pool_.push_back({HalfPlane(tree_->planes_.loose(plane)), plane});
            } else {
                const double d2 = 2.0 * static_cast<double>(tree_->planes_.distance(plane));
                facets_.push_back({d2, views_[view_of(family)].first + facet, plane});
            }
        }
        item.facets.count = static_cast<std::uint32_t>(facets_.size()) - item.facets.first;
        item.loose.count = static_cast<std::uint32_t>(loose_.size()) - item.loose.first;
        items_.push_back(item);
    }
}

std::uint32_t BlockTree::Descent::view_of(std::uint32_t family) {
    std::uint32_t& view = view_of_family_[family];
    if (view == kNone) {
        view = static_cast<std::uint32_t>(views_.size());
        const FacetNormals& normals = table_->normals(family);
        views_.push_back({&normals, static_cast<std::uint32_t>(low_.size()), 0});
        low_.resize(low_.size() + normals.size());
        high_.resize(low_.size());
        column_of_.resize(low_.size(), kNone);
    }
    return view;
}

// Computes the range of the box along the normals of a family.
const BlockTree::Descent::View& BlockTree::Descent::view_in(std::uint32_t family,
                                                            const BoxFrame& frame) {
    View& view = views_[view_of(family)];
    if (view.seen == box_) return view;
    view.seen = box_;
    const FacetNormals& normals = *view.normals;
    double* const low = &low_[view.first];
    double* const high = &high_[view.first];
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double middle = normals.x[i] * frame.centre[0] + normals.y[i] * frame.centre[1] +
                              normals.z[i] * frame.centre[2];
        const double reach = std::abs(normals.x[i]) * frame.half[0] +
                             std::abs(normals.y[i]) * frame.half[1] +
                             std::abs(normals.z[i]) * frame.half[2];
        low[i] = middle - reach;
        high[i] = middle + reach;
    }
    return view;
}

// Finds the planes of an item of the level above that are active in the box, and pushes the planes
// onto the stacks. The plane most likely to have a smaller box above is tested first.
BlockTree::Descent::Place BlockTree::Descent::classify(const BoxFrame& frame, Item& item) {
    const std::size_t facets = facets_.size();
    const std::size_t loose = loose_.size();
    const bool is_outside =
        item.is_classified ? !narrow_planes(frame, item) : !classify_planes(frame, item);
    if (is_outside) {
        facets_.resize(facets);
        loose_.resize(loose);
        return Place::Outside;
    }
    item.is_classified = true;
    item.facets = {static_cast<std::uint32_t>(facets),
                   static_cast<std::uint32_t>(facets_.size() - facets)};
    item.loose = {static_cast<std::uint32_t>(loose),
                  static_cast<std::uint32_t>(loose_.size() - loose)};
    return item.facets.count + item.loose.count == 0 ? Place::Covers : Place::Cuts;
}

bool BlockTree::Descent::classify_planes(const BoxFrame& frame, const Item& item) {
    const IncomingCell& cell = *item.cell;
    if (!cell.facets.empty()) {
        const View& seen = view_in(table_->family(item.number), frame);
        const double* const d2 = cell.facets.data();
        const double* const low = &low_[seen.first];
        const double* const high = &high_[seen.first];
        const std::size_t count = cell.facets.size();
        int outside = 0;
        for (std::size_t i = 0; i < count; ++i)
            outside |= static_cast<int>(low[i] >= d2[i]);
        if (outside != 0) return false;
        for (std::size_t i = 0; i < count; ++i) {
            if (high[i] <= d2[i]) continue;
            const auto facet = static_cast<std::uint32_t>(i);
            facets_.push_back({d2[i], seen.first + facet, facet});
        }
    }
    for (const std::uint16_t plane : cell.loose) {
        const HalfPlane half_plane(cell.planes[plane]);
        const Side side = side_of(frame, half_plane);
        if (side == Side::Above) return false;
        if (side == Side::Below) continue;
        loose_.push_back({static_cast<std::uint32_t>(pool_.size())});
        pool_.push_back({half_plane, plane});
    }
    return true;
}

bool BlockTree::Descent::narrow_planes(const BoxFrame& frame, const Item& item) {
    if (item.facets.count > 0) view_in(table_->family(item.number), frame);
    const std::uint32_t first = item.facets.first;
    for (std::uint32_t i = first; i < first + item.facets.count; ++i) {
        const Facet facet = facets_[i];
        if (low_[facet.direction] >= facet.d2) {
            // The same plane probably excludes the adjacent box as well.
            std::swap(facets_[i], facets_[first]);
            return false;
        }
        if (high_[facet.direction] > facet.d2) facets_.push_back(facet);
    }
    for (std::uint32_t i = 0; i < item.loose.count; ++i) {
        const LoosePlane plane = loose_[item.loose.first + i];
        const Side side = side_of(frame, entry(plane).half_plane);
        if (side == Side::Above) return false;
        if (side == Side::On) loose_.push_back(plane);
    }
    return true;
}

// Computes the range of a half of the box along the normals of the table.
void BlockTree::Descent::narrow_bounds(const BoxFrame& box, const BoxFrame& half) {
    for (const std::uint32_t direction : directions_) {
        const ScaledNormal& normal = scaled_[column_of_[direction]];
        const double reach = 0.5 * (high_[direction] - low_[direction]);
        double middle = 0.5 * (high_[direction] + low_[direction]);
        double rest = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            // Component of the normal along the axis, in half extents of the whole box.
            const double n = reach * static_cast<double>(normal.n[i]);
            middle += n * (half.centre[i] - box.centre[i]) / box.half[i];
            rest += std::abs(n) * half.half[i] / box.half[i];
        }
        half_low_[direction] = middle - rest;
        half_high_[direction] = middle + rest;
    }
}

// Chooses the axis whose cut divides the cells best; the longest axis among equals.
BlockTree::Descent::Cut BlockTree::Descent::best_cut(const HalfBox& box, std::size_t begin) {
    const std::span<const Item> items = std::span(items_).subspan(begin);
    const std::size_t longest = box.longest_axis();
    if (box.extent(longest) < kSmallestBox) return {};
    if (items.size() > kManyCells) return {longest, true};
    half_low_.resize(low_.size());
    half_high_.resize(low_.size());
    const BoxFrame whole(box);
    Cut best;
    double best_cost = std::numeric_limits<double>::max();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (box.extent(axis) < kSmallestBox) continue;
        std::size_t total = 0;
        for (const bool upper : {false, true}) {
            const HalfBox half = box.half(axis, upper);
            const BoxFrame frame(half);
            narrow_bounds(whole, frame);
            std::size_t here = 0;
            for (const Item& item : items) {
                bool outside = false;
                bool cut = false;
                for (const Facet& facet : facets_of(item)) {
                    const std::uint32_t d = facet.direction;
                    cut = cut || half_high_[d] > facet.d2;
                    outside = half_low_[d] >= facet.d2;
                    if (outside) break;
                }
                for (std::size_t k = 0; k < item.loose.count && !outside; ++k) {
                    const Side side = side_of(frame, entry(loose_of(item)[k]).half_plane);
                    cut = cut || side == Side::On;
                    outside = side == Side::Above;
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
        const double shape =
            static_cast<double>(box.extent(axis)) / static_cast<double>(box.extent(longest));
        const double cost =
            static_cast<double>(total) / static_cast<double>(items.size()) - kShortAxis * shape;
        if (cost < best_cost) {
            best_cost = cost;
            // `parts`: at most half of the cells are in both halves, or a cell covers a half.
            best = {axis, 2 * total <= 3 * items.size()};
        }
    }
    return best;
}

}  // namespace ncsim::cda
