// SPDX-License-Identifier: GPL-3.0-or-later
#include "cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::dexel {

namespace {

constexpr double kFar = std::numeric_limits<double>::max();

// Where `places` lie below (above) of all before, they and their facet are the new ones.
void lower(double* at, double* facet, const double* u, std::size_t count, double first,
           double slope, double number) {
    for (std::size_t i = 0; i < count; ++i) {
        const double place = first + slope * u[i];
        const bool is_new = place < at[i];
        at[i] = is_new ? place : at[i];
        facet[i] = is_new ? number : facet[i];
    }
}

void raise(double* at, double* facet, const double* u, std::size_t count, double first,
           double slope, double number) {
    for (std::size_t i = 0; i < count; ++i) {
        const double place = first + slope * u[i];
        const bool is_new = place > at[i];
        at[i] = is_new ? place : at[i];
        facet[i] = is_new ? number : facet[i];
    }
}

// Beyond all of the stock it makes no difference where.
std::int32_t whole(double place) {
    constexpr double kMost = 1 << 30;
    return static_cast<std::int32_t>(std::clamp(place, -kMost, kMost) + (place < 0.0 ? -0.5 : 0.5));
}

}  // namespace

CuttingCell::CuttingCell(const cda::Cell& cell, const cda::Lattice& lattice, const Grid& grid)
    : box(cell.bounds, lattice, grid), origin(cell.origin) {
    for (const cda::Plane& plane : cell.planes) {
        const std::array<double, 3> n{static_cast<double>(plane.nx), static_cast<double>(plane.ny),
                                      static_cast<double>(plane.nz)};
        facets.push_back(
            {n, static_cast<double>(plane.d), PackedNormal::of({-n[0], -n[1], -n[2]})});
    }
}

// Into low_, high_ and their facets; which rays of `range` may have any.
Cutter::Range Cutter::find_intervals(const CuttingCell& cell, std::size_t row, Range range) {
    const std::size_t d = rays_.axis();
    const std::vector<double>& u = grid_.axes[rays_.u_axis()].at;
    const double v = grid_.axes[rays_.v_axis()].at[row];
    // What is parallel to the rays has them or not.
    for (const CuttingCell::Facet& facet : cell.facets) {
        if (facet.normal[d] != 0.0) continue;
        const double slope = facet.normal[rays_.u_axis()];
        const double room = facet.offset - facet.normal[rays_.v_axis()] * v;
        while (range.begin < range.end && slope * u[range.begin] > room)
            ++range.begin;
        while (range.begin < range.end && slope * u[range.end - 1] > room)
            --range.end;
    }
    if (range.begin >= range.end) return range;
    const std::size_t count = range.end - range.begin;
    low_.assign(count, -kFar);
    high_.assign(count, kFar);
    low_facet_.assign(count, 0.0);
    high_facet_.assign(count, 0.0);
    for (std::size_t i = 0; i < cell.facets.size(); ++i) {
        const CuttingCell::Facet& facet = cell.facets[i];
        const double n = facet.normal[d];
        if (n == 0.0) continue;
        const double first = (facet.offset - facet.normal[rays_.v_axis()] * v) / n;
        const double slope = -facet.normal[rays_.u_axis()] / n;
        if (n > 0.0) {
            lower(high_.data(), high_facet_.data(), &u[range.begin], count, first, slope,
                  static_cast<double>(i));
        } else {
            raise(low_.data(), low_facet_.data(), &u[range.begin], count, first, slope,
                  static_cast<double>(i));
        }
    }
    return range;
}

template <class Take>
void Cutter::for_each_interval(const CuttingCell& cell, std::size_t row, Take take) {
    const std::size_t u = rays_.u_axis();
    const Range range = find_intervals(cell, row, {cell.box.begin[u], cell.box.end[u]});
    const auto left = [&](double facet) {
        return cell.facets[static_cast<std::size_t>(facet)].left;
    };
    const std::span<Ray> rays = rays_.row(row);
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const std::size_t k = i - range.begin;
        if (low_[k] >= high_[k]) continue;
        take(rays[i], whole(low_[k]), whole(high_[k]), left(low_facet_[k]), left(high_facet_[k]));
    }
}

void Cutter::cut(const CuttingCell& cell, std::size_t begin, std::size_t end) {
    begin = std::max(begin, cell.box.begin[rays_.v_axis()]);
    end = std::min(end, cell.box.end[rays_.v_axis()]);
    for (std::size_t row = begin; row < end; ++row) {
        for_each_interval(cell, row,
                          [&](Ray& ray, std::int32_t low, std::int32_t high, PackedNormal at_low,
                              PackedNormal at_high) {
                              if (low < high)
                                  ray.cut(low, high, [&](bool below) {
                                      return below ? End{low, cell.origin, at_low}
                                                   : End{high, cell.origin, at_high};
                                  });
                          });
    }
}

void Cutter::cut(const SweptTool& tool, std::size_t begin, std::size_t end) {
    const std::size_t d = rays_.axis();
    const GridAxis& u = grid_.axes[rays_.u_axis()];
    const GridAxis& v = grid_.axes[rays_.v_axis()];
    const GridBox& box = tool.box;
    begin = std::max(begin, box.begin[rays_.v_axis()]);
    end = std::min(end, box.end[rays_.v_axis()]);
    const Range range{box.begin[rays_.u_axis()], box.end[rays_.u_axis()]};
    const auto left = [](cda::Vec3 normal) { return PackedNormal::of(-1.0 * normal); };
    for (std::size_t row = begin; row < end; ++row) {
        const std::span<Ray> rays = rays_.row(row);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            if (!rays[i].has_any_between(box.low[d], box.high[d])) continue;
            SweptTool::Interval met;
            if (!tool.meet(d, u.at[i], v.at[row], met)) continue;
            const std::int32_t low = whole(met.low.at), high = whole(met.high.at);
            if (low >= high || !rays[i].has_any_between(low, high)) continue;
            rays[i].cut(low, high, [&](bool below) {
                return below ? End{low, tool.origin, left(met.low.normal)}
                             : End{high, tool.origin, left(met.high.normal)};
            });
        }
    }
}

void Cutter::fill(const CuttingCell& cell) {
    for (std::size_t row = 0; row < rays_.rows(); ++row) {
        for_each_interval(
            cell, row,
            [&](Ray& ray, std::int32_t low, std::int32_t high, PackedNormal at_low,
                PackedNormal at_high) {
                const auto turned = [](PackedNormal n) {
                    return PackedNormal::of(-1.0 * n.unpacked());
                };
                ray.set({{low, cell.origin, turned(at_low)}, {high, cell.origin, turned(at_high)}});
            });
    }
}

}  // namespace ncsim::dexel
