// SPDX-License-Identifier: GPL-3.0-or-later
//
// Crossings of the surface with edges of the grid.
#include "crossings.h"

#include "ncsim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ncsim::dexel {

namespace {

void mark(const Ray& ray, const GridAxis& z, std::uint64_t* bits) {
    for (const Interval& interval : ray.intervals()) {
        const std::size_t end = z.from(interval.high.at);
        for (std::size_t k = z.from(interval.low.at); k < end; ++k)
            bits[k / 64] |= std::uint64_t{1} << k % 64;
    }
}

}  // namespace

Signs::Signs(const Grid& grid, const Rays& along_z, std::size_t threads)
    : columns_y_(grid.axes[1].corners()),
      words_((grid.axes[2].corners() + 63) / 64),
      bits_(grid.axes[0].corners() * columns_y_ * words_, 0) {
    const Runs runs(grid.axes[0].corners(), 8);
    in_parallel(threads, runs.tasks(), [&](std::size_t task) {
        for (std::size_t x = runs.begin(task); x < runs.end(task); ++x) {
            for (std::size_t y = 0; y < columns_y_; ++y)
                mark(along_z(x, y), grid.axes[2], &bits_[(x * columns_y_ + y) * words_]);
        }
    });
}

Crossing Crossings::at(const Place& from, std::size_t axis) const {
    const std::vector<double>& at = grid_.axes[axis].at;
    const double low = at[from[axis]];
    const double high = at[from[axis] + 1];
    const bool enters = !signs_(from);  // going up
    if (rays_[axis].rows() == 0) return crossing_between(from, axis, enters);
    if (const End* end = end_on(from, axis, enters))
        return {static_cast<double>(end->at), end->normal.unpacked(), end->origin};
    Crossing crossing{0.5 * (low + high), {}, cda::kStockOrigin};
    crossing.normal[static_cast<int>(axis)] = enters ? -1.0 : 1.0;
    return crossing;
}

cda::Origin Crossings::origin_at(const Place& from, std::size_t axis) const {
    const bool enters = !signs_(from);
    if (rays_[axis].rows() == 0) return crossing_between(from, axis, enters).origin;
    const End* end = end_on(from, axis, enters);
    return end ? end->origin : cda::kStockOrigin;
}

// Returns the end of the last interval that begins on the edge, or of the first that ends
// there.
const End* Crossings::end_on(const Place& from, std::size_t axis, bool enters) const {
    const double low = grid_.axes[axis].at[from[axis]];
    const double high = grid_.axes[axis].at[from[axis] + 1];
    const Rays& rays = rays_[axis];
    const auto intervals = rays(from[rays.u_axis()], from[rays.v_axis()]).intervals();
    if (enters) {
        const auto beyond = std::ranges::lower_bound(
            intervals, high, {}, [](const Interval& i) { return double(i.low.at); });
        if (beyond != intervals.begin() && low < std::prev(beyond)->low.at)
            return &std::prev(beyond)->low;
    } else {
        const auto first = std::ranges::upper_bound(
            intervals, low, {}, [](const Interval& i) { return double(i.high.at); });
        if (first != intervals.end() && first->high.at < high) return &first->high;
    }
    return nullptr;
}

// Returns the crossing from the rays along z at both corners of the edge.
Crossing Crossings::crossing_between(const Place& from, std::size_t axis, bool enters) const {
    const auto a = static_cast<int>(axis);
    const std::vector<double>& at = grid_.axes[axis].at;
    const double low = at[from[axis]], high = at[from[axis] + 1];
    Place to = from;
    ++to[axis];
    const Place& inner = enters ? to : from;
    const Place& outer = enters ? from : to;
    const double z = grid_.axes[2].at[from[2]];
    const auto ends = [&](const Place& p) { return rays_[2](p[0], p[1]).intervals(); };
    // If a corner is outside of the stock, only the stock's surface is between the corners.
    if (ends(outer).empty()) {
        if (const auto wall = crossing_of_stock(from, axis, enters)) return *wall;
    }
    // Otherwise the plane at the nearest end determines the crossing, where the plane meets the
    // edge's line on the edge or up to half an edge beyond.
    std::optional<Crossing> nearest;
    double least = 1.5 * (high - low);
    cda::Origin origin = cda::kStockOrigin;
    const auto look = [&](const End& end, const Place& column) {
        const Vec3 n = end.normal.unpacked();
        if (n[a] == 0.0 || (n[a] > 0.0) == enters) return;
        const double away = (end.at - z) * n.z / n[a];
        const double place = at[column[axis]] + away;
        if (std::abs(away) >= least || place < low - 0.5 * (high - low) ||
            place > high + 0.5 * (high - low))
            return;
        least = std::abs(away);
        nearest = Crossing{std::clamp(place, low, high), n, end.origin};
    };
    for (const Interval& interval : ends(inner)) {
        if (z < interval.low.at || interval.high.at < z) continue;
        look(interval.high, inner);
        look(interval.low, inner);
        origin = std::max(interval.low.origin, interval.high.origin);
    }
    const End* below = nullptr;
    const End* above = nullptr;
    for (const Interval& interval : ends(outer)) {
        if (interval.high.at < z) below = &interval.high;
        if (interval.low.at > z && !above) above = &interval.low;
    }
    for (const End* end : {below, above}) {
        if (!end) continue;
        look(*end, outer);
        origin = std::max(origin, end->origin);
    }
    if (nearest) return *nearest;
    Crossing wall{0.5 * (low + high), {}, origin};
    wall.normal[a] = enters ? -1.0 : 1.0;
    return wall;
}

std::optional<Crossing> Crossings::crossing_of_stock(const Place& from, std::size_t axis,
                                                     bool enters) const {
    const auto a = static_cast<int>(axis);
    const double low = grid_.axes[axis].at[from[axis]];
    const double high = grid_.axes[axis].at[from[axis] + 1];
    const Vec3 p = point_of(from);
    std::optional<Crossing> found;
    for (const CuttingCell::Facet& facet : stock_.facets) {
        const Vec3 n{facet.normal[0], facet.normal[1], facet.normal[2]};
        if (n[a] == 0.0 || (n[a] > 0.0) == enters) continue;
        const double place = p[a] + (facet.offset - dot(n, p)) / n[a];
        if (!(low < place && place < high)) continue;
        // The innermost facet.
        if (!found || (enters ? place > found->at : place < found->at))
            found = Crossing{place, normalized(n), cda::kStockOrigin};
    }
    return found;
}

}  // namespace ncsim::dexel
