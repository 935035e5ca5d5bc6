// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of cells that another cell covers in a box.
#include "tree/descent.h"

#include <algorithm>

namespace ncsim::cda {

namespace {

// Largest number of comparisons per cell; smaller boxes find the remaining redundant cells.
constexpr std::size_t kComparisons = 16;
// A table for more normals than this costs more than smaller boxes.
constexpr std::size_t kManyNormals = 160;

}  // namespace

// Makes a table of the normals of all facets; false if there are too many.
bool BlockTree::Descent::make_table(const BoxFrame& frame, std::span<const Item> items) {
    for (const std::uint32_t direction : directions_)
        column_of_[direction] = kNone;
    directions_.clear();
    scaled_.clear();
    for (const Item& item : items) {
        if (item.facets.count == 0) continue;
        const View& seen = view_in(table_->family(item.number), frame);
        for (const Facet& facet : facets_of(item)) {
            if (column_of_[facet.direction] != kNone) continue;
            column_of_[facet.direction] = 0;
            directions_.push_back(facet.direction);
            const FacetNormals& normals = *seen.normals;
            const std::size_t k = facet.direction - seen.first;
            const double reach = 0.5 * (high_[facet.direction] - low_[facet.direction]);
            scaled_.emplace_back(normals.x[k], normals.y[k], normals.z[k], frame, reach);
        }
    }
    for (std::size_t i = 0; i < directions_.size(); ++i)
        column_of_[directions_[i]] = static_cast<std::uint32_t>(i);
    if (directions_.size() > kManyNormals) return false;
    normals_.assign(scaled_);
    std::vector<ScaledNormal> by_column(normals_.stride());
    for (std::size_t i = 0; i < directions_.size(); ++i) {
        column_of_[directions_[i]] = normals_.column(i);
        by_column[normals_.column(i)] = scaled_[i];
    }
    scaled_.swap(by_column);
    return true;
}

// Computes the reach of the item along all normals and drops planes that other planes of the item
// imply.
void BlockTree::Descent::fill_rows(const BoxFrame& frame, Item& item, Candidate& candidate) {
    const std::size_t stride = normals_.stride();
    float* const own = own_.data() + candidate.item * stride;
    float* const reach = reach_.data() + candidate.item * stride;
    float* const limit = limit_.data() + candidate.item * stride;
    for (const Facet& facet : facets_of(item)) {
        const double low = low_[facet.direction];
        const double high = high_[facet.direction];
        // The conversion is monotone: of two planes with one normal, the farther plane never gets
        // the smaller value.
        own[column_of_[facet.direction]] =
            static_cast<float>((facet.d2 - 0.5 * (low + high)) / (0.5 * (high - low)));
    }
    for (const Facet& facet : facets_of(item)) {
        const std::uint32_t column = column_of_[facet.direction];
        normals_.bound_by(column, own[column], reach);
    }
    candidate.loose.first = static_cast<std::uint32_t>(boxed_planes_.size());
    for (const LoosePlane plane : loose_of(item)) {
        const HalfPlane& h = entry(plane).half_plane;
        const BoxHeight box_height(frame, h);
        BoxedPlane seen{{h.nx, h.ny, h.nz, frame, box_height.reach},
                        static_cast<float>(-box_height.above / box_height.reach),
                        plane};
        normals_.bound_by(seen.normal, seen.e, reach);
        boxed_planes_.push_back(seen);
    }
    candidate.loose.count = item.loose.count;

    // Implication is transitive, so implied planes may be dropped in any order.
    candidate.depth = 1.0F;
    const auto is_needless = [&](const Facet& facet) {
        const std::uint32_t column = column_of_[facet.direction];
        if (reach[column] + row::kMargin < own[column]) return true;
        candidate.depth = std::min(candidate.depth, own[column]);
        limit[column] = own[column];
        return false;
    };
    const std::span<Facet> facets = facets_of(item);
    item.facets.count = static_cast<std::uint32_t>(
        std::remove_if(facets.begin(), facets.end(), is_needless) - facets.begin());
    if (item.loose.count > 0) {
        candidate.planes = seen_planes_.end_group();
        candidate.planes_end = push_planes(item, candidate);
    }
    std::uint32_t kept = 0;
    const std::span<BoxedPlane> seen = std::span(boxed_planes_).subspan(candidate.loose.first);
    for (const BoxedPlane& plane : seen) {
        if (seen_planes_.imply(candidate.planes, candidate.planes_end, plane.normal, plane.e))
            continue;
        candidate.depth = std::min(candidate.depth, plane.e);
        loose_[item.loose.first + kept++] = plane.plane;
    }
    if (kept < item.loose.count) {
        std::size_t to = 0;
        for (const BoxedPlane& plane : seen) {
            if (to < kept && plane.plane.pool == loose_[item.loose.first + to].pool)
                seen[to++] = plane;
        }
        item.loose.count = candidate.loose.count = kept;
        boxed_planes_.resize(candidate.loose.first + kept);
    }
    for (std::size_t i = 0; i < stride; ++i) {
        reach[i] = std::min(reach[i] + row::kMargin, own[i]);
        candidate.reach += std::min(reach[i], 1.0F);
    }
    candidate.planes = seen_planes_.end_group();
    candidate.planes_end = push_planes(item, candidate);
}

// Adds all planes of an item as a group; returns the end of the group.
std::size_t BlockTree::Descent::push_planes(const Item& item, const Candidate& candidate) {
    const float* const own = own_.data() + candidate.item * normals_.stride();
    for (const Facet& facet : facets_of(item)) {
        const std::uint32_t column = column_of_[facet.direction];
        seen_planes_.add(scaled_[column], own[column]);
    }
    for (std::size_t i = 0; i < item.loose.count; ++i) {
        const BoxedPlane& plane = boxed_planes_[candidate.loose.first + i];
        seen_planes_.add(plane.normal, plane.e);
    }
    return seen_planes_.end_group();
}

// Decides if the part of `a` in the box is within `b`.
Domination BlockTree::Descent::covered(const Candidate& a, const Candidate& b,
                                       std::span<const Item> items) const {
    const std::size_t stride = normals_.stride();
    const float* const reach = reach_.data() + a.item * stride;
    const float* const limit = limit_.data() + b.item * stride;
    if (!is_below(reach, limit, stride)) return Domination::None;
    const Item& item = items[a.item];
    const Item& other = items[b.item];
    Domination result = Domination::Strict;
    const float* const own = own_.data() + a.item * stride;
    for (const Facet& facet : facets_of(other)) {
        const std::uint32_t column = column_of_[facet.direction];
        if (own[column] != limit[column]) continue;
        const std::span<const Facet> facets = facets_of(item);
        const auto same = std::ranges::find(facets, facet.direction, &Facet::direction);
        if (same == facets.end() || same->d2 > facet.d2) return Domination::None;
        if (same->d2 == facet.d2) result = Domination::Coplanar;
    }
    for (std::size_t i = 0; i < b.loose.count && result != Domination::None; ++i)
        result = std::min(result, covered(a, item, boxed_planes_[b.loose.first + i], other));
    return result;
}

// Decides if the part of the item in the box is below a loose plane of a second item.
Domination BlockTree::Descent::covered(const Candidate& a, const Item& item, const BoxedPlane& p,
                                       const Item& its_item) const {
    if (seen_planes_.imply(a.planes, a.planes_end, p.normal, p.e)) return Domination::Strict;
    // Equal or nearly equal planes are decided in integers.
    const Plane plane = exact(its_item, pool_[p.plane.pool].plane);
    for (const LoosePlane mine : loose_of(item)) {
        const Plane m = exact(item, pool_[mine.pool].plane);
        if (!m.is_parallel_to(plane) || !same_direction(m, plane)) continue;
        const int order = compare_distances(m, plane);
        if (order >= 0) return order == 0 ? Domination::Coplanar : Domination::Strict;
    }
    return Domination::None;
}

// Drops items from `begin` on that another item covers in the box.
void BlockTree::Descent::drop_redundant(const BoxFrame& frame, std::size_t begin) {
    const std::span<Item> items = std::span(items_).subspan(begin);
    if (!make_table(frame, items)) return;
    const std::size_t size = items.size() * normals_.stride();
    own_.assign(size, row::kUnknown);
    reach_.assign(size, row::kUnknown);
    limit_.assign(size, row::kAnything);
    boxed_planes_.clear();
    seen_planes_.clear();
    candidates_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        candidates_[i] = {};
        candidates_[i].item = i;
        fill_rows(frame, items[i], candidates_[i]);
    }
    // A cell within a second cell has at most the second cell's reach and depth. So with this order
    // a covered cell is compared with the covering cell after the covering cell is kept.
    const auto extent = [](const Candidate& c) { return std::pair{c.reach, c.depth}; };
    std::ranges::sort(candidates_, [&](const Candidate& a, const Candidate& b) {
        return extent(a) != extent(b) ? extent(a) > extent(b)
                                      : comes_before(items[a.item], items[b.item]);
    });
    const auto is_redundant = [&](const Candidate& a, const Candidate& b) {
        const Item& item = items[a.item];
        const Item& other = items[b.item];
        if (other.turn > item.turn) return false;
        const Domination found = covered(a, b, items);
        // If facets lie in one plane, the first cell owns the wall.
        return found == Domination::Strict ||
               (found == Domination::Coplanar && comes_before(other, item));
    };
    kept_.clear();
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const Candidate& a = candidates_[c];
        bool is_needed = true;
        std::size_t comparisons = 0;
        for (std::size_t i = 0; i < kept_.size() && is_needed && comparisons < kComparisons; ++i) {
            const Candidate& b = candidates_[kept_[i]];
            if (items[b.item].turn <= items[a.item].turn) ++comparisons;
            is_needed = !is_redundant(a, b);
            if (!is_needed || extent(a) != extent(b) || !is_redundant(b, a)) continue;
            kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
            --i;
        }
        if (is_needed) kept_.push_back(c);
    }
    for (std::size_t& kept : kept_)
        kept = candidates_[kept].item;
    std::ranges::sort(kept_);
    for (std::size_t i = 0; i < kept_.size(); ++i)
        items[i] = items[kept_[i]];
    items_.resize(begin + kept_.size());
}

}  // namespace ncsim::cda
