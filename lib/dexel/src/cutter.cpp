// SPDX-License-Identifier: GPL-3.0-or-later
//
// Row by row intersection of cells and swept tools with rays.
#include "cutter.h"

#include "whole_units.h"

#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>

namespace ncsim::dexel {

namespace {

constexpr double kFar = std::numeric_limits<double>::max();

// Replaces each value by the linear function's where the function is lower (higher), together with
// the facet number.
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

Cutter::Range Cutter::intersect(const CuttingCell& cell, std::size_t row) {
    Range range{cell.box.begin[rays_.u_axis()], cell.box.end[rays_.u_axis()]};
    const std::size_t d = rays_.axis();
    const std::vector<double>& u = grid_.axes[rays_.u_axis()].at;
    const double v = grid_.axes[rays_.v_axis()].at[row];
    // Facets parallel to the rays contain a ray or not.
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
    meeting_.resize(count);
    std::fill_n(meeting_.low.begin(), count, -kFar);
    std::fill_n(meeting_.high.begin(), count, kFar);
    std::fill_n(meeting_.s_low.begin(), count, 0.0);
    std::fill_n(meeting_.s_high.begin(), count, 0.0);
    for (std::size_t i = 0; i < cell.facets.size(); ++i) {
        const CuttingCell::Facet& facet = cell.facets[i];
        const double n = facet.normal[d];
        if (n == 0.0) continue;
        const double first = (facet.offset - facet.normal[rays_.v_axis()] * v) / n;
        const double slope = -facet.normal[rays_.u_axis()] / n;
        if (n > 0.0) {
            lower(meeting_.high.data(), meeting_.s_high.data(), &u[range.begin], count, first,
                  slope, static_cast<double>(i));
        } else {
            raise(meeting_.low.data(), meeting_.s_low.data(), &u[range.begin], count, first, slope,
                  static_cast<double>(i));
        }
    }
    return range;
}

Cutter::Range Cutter::intersect(const SweptTool& tool, std::size_t row, const PendingCuts& pending,
                                std::size_t pending_row) {
    const std::size_t d = rays_.axis();
    const double v = grid_.axes[rays_.v_axis()].at[row];
    const GridBox& box = tool.box;
    Range range{box.begin[rays_.u_axis()], box.end[rays_.u_axis()]};
    if (d == 2) {
        const auto [low, high] = tool.reach_along_x(v);
        range.begin = std::max(range.begin, grid_.axes[0].from(low));
        range.end = std::min(range.end, grid_.axes[0].from(high));
    }
    // Skips rays at both ends that have no material where the tool may reach in this row.
    const double reach = d == 2 ? tool.lowest_at(v) : box.low[d];
    const std::int32_t low_end = whole_units(reach - 1.0);
    const std::int32_t high_end = whole_units(box.high[d] + 1.0);
    const std::span<const Gap> gaps = rays_.gaps(row);
    const auto has_none = [&](std::size_t i) {
        return (gaps[i].low <= low_end && gaps[i].high >= high_end) ||
               pending.covers(pending_row, i, low_end, high_end);
    };
    while (range.begin < range.end && has_none(range.begin))
        ++range.begin;
    while (range.begin < range.end && has_none(range.end - 1))
        --range.end;
    if (range.begin >= range.end) return range;
    tool.intersect_row(d, &grid_.axes[rays_.u_axis()].at[range.begin], range.end - range.begin, v,
                       lanes_, meeting_);
    return range;
}

void Cutter::subtract(std::size_t row, std::size_t ray, const PendingCuts::Cut& cut,
                      std::span<const Body* const> bodies) {
    Gap& gap = rays_.gaps(row)[ray];
    if (cut.low >= gap.low && cut.high <= gap.high) return;
    gap = rays_.row(row)[ray].cut(cut.low, cut.high, [&](bool below) {
        const std::int32_t at = below ? cut.low : cut.high;
        const double s = below ? cut.s_low : cut.s_high;
        const Body& body = *bodies[below ? cut.low_body : cut.high_body];
        if (const auto* cell = std::get_if<CuttingCell>(&body))
            return End{at, cell->origin, cell->facets[static_cast<std::size_t>(s)].left};
        const auto& tool = std::get<SweptTool>(body);
        const Vec3 normal = tool.normal(rays_.axis(), grid_.axes[rays_.u_axis()].at[ray],
                                        grid_.axes[rays_.v_axis()].at[row], !below, at, s);
        return End{at, tool.origin, PackedNormal::of(-1.0 * normal)};
    });
}

void Cutter::cut(std::span<const Body* const> bodies, std::size_t begin, std::size_t end) {
    // Few rows, so that their pending cuts stay in the cache.
    constexpr std::size_t kRowsTogether = 8;
    const std::size_t v = rays_.v_axis();
    PendingCuts pending(kRowsTogether, grid_.axes[rays_.u_axis()].corners(), lanes_);
    for (std::size_t first = begin; first < end; first += kRowsTogether) {
        const std::size_t last = std::min(first + kRowsTogether, end);
        const auto cut_in = [&](std::size_t row) {
            return [&, row](std::size_t ray, const PendingCuts::Cut& cut) {
                subtract(row, ray, cut, bodies);
            };
        };
        const auto meet_of = [&](const auto& body, std::size_t row) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(body)>, SweptTool>) {
                return intersect(body, row, pending, row - first);
            } else {
                return intersect(body, row);
            }
        };
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            std::visit(
                [&](const auto& body) {
                    const std::size_t to = std::min(last, body.box.end[v]);
                    for (std::size_t row = std::max(first, body.box.begin[v]); row < to; ++row) {
                        const Range range = meet_of(body, row);
                        if (range.begin >= range.end) continue;
                        pending.add(row - first, range.begin, range.end - range.begin, meeting_,
                                    static_cast<std::uint32_t>(k), cut_in(row));
                    }
                },
                *bodies[k]);
        }
        for (std::size_t row = first; row < last; ++row)
            pending.flush(row - first, cut_in(row));
    }
}

void Cutter::fill(const CuttingCell& cell) {
    std::vector<PackedNormal> outward;
    for (const CuttingCell::Facet& facet : cell.facets)
        outward.push_back(PackedNormal::of(-1.0 * facet.left.unpacked()));
    for (std::size_t row = 0; row < rays_.rows(); ++row) {
        const Range range = intersect(cell, row);
        const std::span<Ray> rays = rays_.row(row);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::size_t k = i - range.begin;
            const std::int32_t low = whole_units(meeting_.low[k]),
                               high = whole_units(meeting_.high[k]);
            if (low >= high) continue;
            const auto end = [&](std::int32_t at, double facet) {
                return End{at, cell.origin, outward[static_cast<std::size_t>(facet)]};
            };
            rays[i].set({end(low, meeting_.s_low[k]), end(high, meeting_.s_high[k])});
        }
    }
}

}  // namespace ncsim::dexel
