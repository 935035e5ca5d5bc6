// SPDX-License-Identifier: GPL-3.0-or-later
#include "cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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
[[gnu::always_inline]] inline std::int32_t whole_units(double place) {
    constexpr double kMost = Gap::kEver;
    const double kept = place < -kMost ? -kMost : place > kMost ? kMost : place;
    return static_cast<std::int32_t>(kept + (kept < 0.0 ? -0.5 : 0.5));
}

struct CutsTask {
    const double *low, *high;
    const Gap* gaps;
    std::size_t count;
    std::int32_t *low_units, *high_units;
    std::uint8_t* is_cut;
};

[[gnu::always_inline]] inline void find_cuts(const CutsTask& t) {
    for (std::size_t i = 0; i < t.count; ++i) {
        const std::int32_t low = whole_units(t.low[i]), high = whole_units(t.high[i]);
        t.low_units[i] = low;
        t.high_units[i] = high;
        const bool is_known = low >= t.gaps[i].low && high <= t.gaps[i].high;
        t.is_cut[i] = static_cast<std::uint8_t>(low < high && !is_known);
    }
}

void find_cuts_by_two(const CutsTask& task) {
    find_cuts(task);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void find_cuts_by_four(const CutsTask& task) {
    find_cuts(task);
}
#endif

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

template <class MakeEnd>
void Cutter::take_away(std::size_t row, std::size_t begin, std::size_t count, const double* low,
                       const double* high, const MakeEnd& end) {
    if (is_cut_.size() < count) {
        is_cut_.resize(count);
        low_units_.resize(count);
        high_units_.resize(count);
    }
    const std::span<Gap> gaps = rays_.gaps(row).subspan(begin, count);
    const CutsTask task{
        low, high, gaps.data(), count, low_units_.data(), high_units_.data(), is_cut_.data()};
#if defined(__x86_64__)
    if (lanes_ == Lanes::Four) {
        find_cuts_by_four(task);
    } else {
        find_cuts_by_two(task);
    }
#else
    find_cuts_by_two(task);
#endif
    const std::span<Ray> rays = rays_.row(row).subspan(begin, count);
    for (std::size_t i = 0; i < count; ++i) {
        if (is_cut_[i] == 0) continue;
        gaps[i] =
            rays[i].cut(low_units_[i], high_units_[i], [&](bool below) { return end(i, below); });
    }
}

void Cutter::cut(const CuttingCell& cell, std::size_t begin, std::size_t end) {
    begin = std::max(begin, cell.box.begin[rays_.v_axis()]);
    end = std::min(end, cell.box.end[rays_.v_axis()]);
    const std::size_t u = rays_.u_axis();
    for (std::size_t row = begin; row < end; ++row) {
        const Range range = find_intervals(cell, row, {cell.box.begin[u], cell.box.end[u]});
        if (range.begin >= range.end) continue;
        take_away(row, range.begin, range.end - range.begin, low_.data(), high_.data(),
                  [&](std::size_t i, bool below) {
                      const double facet = below ? low_facet_[i] : high_facet_[i];
                      return End{below ? low_units_[i] : high_units_[i], cell.origin,
                                 cell.facets[static_cast<std::size_t>(facet)].left};
                  });
    }
}

void Cutter::cut(const SweptTool& tool, std::size_t begin, std::size_t end) {
    const std::size_t d = rays_.axis();
    const std::vector<double>& u = grid_.axes[rays_.u_axis()].at;
    const std::vector<double>& v = grid_.axes[rays_.v_axis()].at;
    const GridBox& box = tool.box;
    begin = std::max(begin, box.begin[rays_.v_axis()]);
    end = std::min(end, box.end[rays_.v_axis()]);
    for (std::size_t row = begin; row < end; ++row) {
        Range range{box.begin[rays_.u_axis()], box.end[rays_.u_axis()]};
        if (d == 2) {
            const auto [low, high] = tool.reach_along_x(v[row]);
            range.begin = std::max(range.begin, grid_.axes[0].from(low));
            range.end = std::min(range.end, grid_.axes[0].from(high));
        }
        // Rays that have nothing where the tool may reach in this row are left out at both ends.
        const double reach = d == 2 ? tool.lowest_at(v[row]) : box.low[d];
        const std::int32_t low_end = whole_units(reach - 1.0);
        const std::int32_t high_end = whole_units(box.high[d] + 1.0);
        const std::span<const Gap> gaps = rays_.gaps(row);
        const auto has_none = [&](std::size_t i) {
            return gaps[i].low <= low_end && gaps[i].high >= high_end;
        };
        while (range.begin < range.end && has_none(range.begin))
            ++range.begin;
        while (range.begin < range.end && has_none(range.end - 1))
            --range.end;
        if (range.begin >= range.end) continue;
        const std::size_t count = range.end - range.begin;
        tool.meet_row(d, &u[range.begin], count, v[row], lanes_, met_);
        take_away(row, range.begin, count, met_.low.data(), met_.high.data(),
                  [&](std::size_t i, bool below) {
                      const double at = below ? met_.low[i] : met_.high[i];
                      const double s = below ? met_.s_low[i] : met_.s_high[i];
                      const cda::Vec3 normal =
                          tool.normal(d, u[range.begin + i], v[row], !below, at, s);
                      return End{below ? low_units_[i] : high_units_[i], tool.origin,
                                 PackedNormal::of(-1.0 * normal)};
                  });
    }
}

// At both ends of a row, rays on which the material ends lower than the tool gets, which comes no
// lower than `reach` in this row; some at a time, as the one that is nearest to its axis.
void Cutter::leave_out_lower(const double* ends, const double* x, const SweptTool& tool,
                             double reach, Range& range) {
    constexpr std::size_t kTogether = 4;
    const auto highest = [ends](std::size_t i) {
        return std::max(std::max(ends[i], ends[i + 1]), std::max(ends[i + 2], ends[i + 3]));
    };
    const double least_x = tool.least_x(), most_x = tool.most_x();
    while (range.begin + kTogether <= range.end &&
           highest(range.begin) <=
               reach + tool.rise_beside(least_x - x[range.begin + kTogether - 1]))
        range.begin += kTogether;
    while (range.begin + kTogether <= range.end &&
           highest(range.end - kTogether) <=
               reach + tool.rise_beside(x[range.end - kTogether] - most_x))
        range.end -= kTogether;
}

void Cutter::cut_open(std::span<const SweptTool* const> tools, std::size_t begin, std::size_t end) {
    const std::vector<double>& x = grid_.axes[0].at;
    const std::vector<double>& y = grid_.axes[1].at;
    // Beyond the last ray there is nothing: nothing reaches lower.
    padded_x_ = x;
    padded_x_.resize(x.size() + kWidest, x.back());
    for (std::vector<double>* each : {&lowest_.at, &lowest_.s, &lowest_.number})
        each->resize(padded_x_.size());
    constexpr double kNone = -1.0;
    for (std::size_t row = begin; row < end; ++row) {
        const std::span<Ray> rays = rays_.row(row);
        Range all{x.size(), 0};
        for (std::size_t k = 0; k < tools.size(); ++k) {
            const SweptTool& tool = *tools[k];
            if (row < tool.box.begin[1] || row >= tool.box.end[1]) continue;
            Range range{tool.box.begin[0], tool.box.end[0]};
            if (range.begin >= range.end) continue;
            if (all.end == 0) {
                for (std::size_t i = 0; i < x.size(); ++i) {
                    const auto intervals = rays[i].intervals();
                    lowest_.at[i] = intervals.empty() ? -kFar : intervals.back().high.at;
                }
                std::ranges::fill(lowest_.number, kNone);
                std::fill(lowest_.at.begin() + static_cast<std::ptrdiff_t>(x.size()),
                          lowest_.at.end(), -kFar);
            }
            all = {std::min(all.begin, range.begin), std::max(all.end, range.end)};
            const double reach = tool.lowest_at(y[row]) - 1.0;
            leave_out_lower(lowest_.at.data(), x.data(), tool, reach, range);
            if (range.begin >= range.end) continue;
            tool.lower_row(padded_x_.data(), range.begin, range.end, y[row], static_cast<double>(k),
                           lanes_, lowest_);
        }
        const std::span<Gap> gaps = rays_.gaps(row);
        const std::size_t last = std::min(all.end + kWidest, x.size());
        for (std::size_t i = all.begin; i < last; ++i) {
            if (lowest_.number[i] == kNone) continue;
            const SweptTool& tool = *tools[static_cast<std::size_t>(lowest_.number[i])];
            const std::int32_t low = whole_units(lowest_.at[i]);
            gaps[i] = rays[i].cut(low, Gap::kEver, [&](bool) {
                const cda::Vec3 normal =
                    tool.normal(2, x[i], y[row], false, lowest_.at[i], lowest_.s[i]);
                return End{low, tool.origin, PackedNormal::of(-1.0 * normal)};
            });
        }
    }
}

void Cutter::fill(const CuttingCell& cell) {
    const std::size_t u = rays_.u_axis();
    for (std::size_t row = 0; row < rays_.rows(); ++row) {
        const Range range = find_intervals(cell, row, {cell.box.begin[u], cell.box.end[u]});
        const std::span<Ray> rays = rays_.row(row);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::size_t k = i - range.begin;
            const std::int32_t low = whole_units(low_[k]), high = whole_units(high_[k]);
            if (low >= high) continue;
            const auto end = [&](std::int32_t at, double facet) {
                const PackedNormal left = cell.facets[static_cast<std::size_t>(facet)].left;
                return End{at, cell.origin, PackedNormal::of(-1.0 * left.unpacked())};
            };
            rays[i].set({end(low, low_facet_[k]), end(high, high_facet_[k])});
        }
    }
}

}  // namespace ncsim::dexel
