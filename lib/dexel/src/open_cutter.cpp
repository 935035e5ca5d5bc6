// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts of rays along z by tools that are open above, block by block.
#include "open_cutter.h"

#include "whole_units.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ncsim::dexel {

namespace {

constexpr double kFar = std::numeric_limits<double>::max();
constexpr double kNone = -1.0;  // Below all tool numbers, so that the stock is first among equals.

BlockExtent extent_of(const std::vector<double>& at, std::size_t block) {
    const double first = at[block * kBlock];
    const double last = at[std::min((block + 1) * kBlock, at.size()) - 1];
    return {0.5 * (first + last), 0.5 * (last - first)};
}

}  // namespace

OpenCutter::OpenCutter(const Grid& grid, Rays& rays, Lanes lanes)
    : grid_(grid), rays_(rays), lanes_(lanes), x_(grid.axes[0].at), y_(grid.axes[1].at) {
    for (std::size_t block = 0; block * kBlock < x_.size(); ++block)
        columns_.push_back(extent_of(grid.axes[0].at, block));
    x_.resize(columns_.size() * kBlock, x_.back());
    y_.resize((y_.size() + kBlock - 1) / kBlock * kBlock, y_.back());
    visits_.resize(columns_.size());
}

void OpenCutter::cut(std::span<const SweptTool* const> tools, std::size_t begin, std::size_t end) {
    // Collects, for each band, the tools that may reach the band, in order.
    std::vector<std::size_t> first(end - begin + 1, 0);
    const auto bands = [&](const SweptTool& tool) {
        const std::size_t from = std::max(tool.box.begin[1] / kBlock, begin);
        const std::size_t to = std::min((tool.box.end[1] + kBlock - 1) / kBlock, end);
        return std::pair{from, std::max(from, to)};
    };
    for (const SweptTool* tool : tools) {
        const auto [from, to] = bands(*tool);
        for (std::size_t band = from; band < to; ++band)
            ++first[band - begin + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<std::uint32_t> numbers(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (std::size_t k = 0; k < tools.size(); ++k) {
        const auto [from, to] = bands(*tools[k]);
        for (std::size_t band = from; band < to; ++band)
            numbers[next[band - begin]++] = static_cast<std::uint32_t>(k);
    }
    for (std::size_t band = begin; band < end; ++band) {
        const std::span of_band(
            numbers.begin() + static_cast<std::ptrdiff_t>(first[band - begin]),
            numbers.begin() + static_cast<std::ptrdiff_t>(first[band - begin + 1]));
        find_visits(tools, of_band, band);
        for (std::size_t column = 0; column < visits_.size(); ++column) {
            if (!visits_[column].empty()) cut_block(tools, column, band);
        }
    }
}

// Collects, for each block of the band, the tools that may get below the remaining material.
void OpenCutter::find_visits(std::span<const SweptTool* const> tools,
                             std::span<const std::uint32_t> of_band, std::size_t band) {
    for (std::vector<Visit>& each : visits_)
        each.clear();
    const BlockExtent y = extent_of(grid_.axes[1].at, band);
    const std::span<const std::int32_t> ceilings = rays_.ceilings(band);
    for (const std::uint32_t number : of_band) {
        const SweptTool& tool = *tools[number];
        const std::size_t begin = tool.box.begin[0] / kBlock;
        const std::size_t end = (tool.box.end[0] + kBlock - 1) / kBlock;
        if (begin >= end) continue;
        tool.bound_blocks(&columns_[begin], end - begin, y, lanes_, bounds_);
        for (std::size_t column = begin; column < end; ++column) {
            const std::size_t i = column - begin;
            if (bounds_.least[i] >= ceilings[column]) continue;
            visits_[column].push_back({bounds_[i], number});
        }
    }
}

void OpenCutter::cut_block(std::span<const SweptTool* const> tools, std::size_t column,
                           std::size_t band) {
    std::vector<Visit>& visits = visits_[column];
    // Tools that are low in the middle are low on most rays. The lowest tool is first, so that few
    // tools remain to be sorted; heights are relative to this tool's plane.
    const auto is_before = [](const Visit& a, const Visit& b) {
        return a.bound.middle != b.bound.middle ? a.bound.middle < b.bound.middle : a.tool < b.tool;
    };
    std::swap(*std::ranges::min_element(visits, is_before), visits.front());
    const BlockExtent x = columns_[column], y = extent_of(grid_.axes[1].at, band);
    lowest_.slope_x = visits.front().bound.slope_x;
    lowest_.slope_y = visits.front().bound.slope_y;
    load(column, band);
    // Relative to a level plane, heights of flat tools are not rounded, so equal heights are
    // recognised.
    const double rounding = lowest_.slope_x != 0.0 || lowest_.slope_y != 0.0 ? 1.0 : 0.0;
    const auto look_at = [&](const Visit& visit) {
        tools[visit.tool]->lower_block(&x_[column * kBlock], &y_[band * kBlock],
                                       std::min(kBlock, grid_.axes[1].at.size() - band * kBlock),
                                       visit.bound, static_cast<double>(visit.tool), lanes_,
                                       lowest_);
    };
    look_at(visits.front());
    visits.front() = visits.back();
    visits.pop_back();
    for (Visit& visit : visits) {
        visit.bound.middle -= rounding;
        visit.bound.least = tools[visit.tool]->lowest_above(visit.bound, lowest_, x.half, y.half);
    }
    std::erase_if(visits, [&](const Visit& v) { return v.bound.least > lowest_.highest; });
    std::ranges::sort(visits, is_before);
    for (const Visit& visit : visits) {
        if (visit.bound.least > lowest_.highest) continue;
        // The tool may reach the remaining height, but is not the first to do so.
        if (visit.bound.least == lowest_.highest && visit.tool > lowest_.last) continue;
        look_at(visit);
    }
    store(tools, column, band);
}

void OpenCutter::load(std::size_t column, std::size_t band) {
    const std::size_t rows = std::min(kBlock, grid_.axes[1].at.size() - band * kBlock);
    const std::size_t begin = column * kBlock;
    const std::size_t count = std::min(kBlock, grid_.axes[0].at.size() - begin);
    const BlockExtent x = columns_[column], y = extent_of(grid_.axes[1].at, band);
    lowest_.at.fill(-kFar);
    lowest_.number.fill(kNone);
    lowest_.group_highest.fill(-kFar);
    lowest_.highest = -kFar;
    lowest_.last = kNone;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::span<const Ray> rays = rays_.row(band * kBlock + row).subspan(begin, count);
        const double in_row = lowest_.slope_y * (y_[band * kBlock + row] - y.middle);
        for (std::size_t i = 0; i < count; ++i) {
            const auto intervals = rays[i].intervals();
            const std::size_t k = row * kBlock + i;
            lowest_.plane[k] = in_row + lowest_.slope_x * (x_[begin + i] - x.middle);
            if (intervals.empty()) continue;
            const double top = intervals.back().high.at;
            lowest_.at[k] = top;
            double& highest = lowest_.group_highest[i / kWidest * kBlock + row];
            highest = std::max(highest, top - lowest_.plane[k]);
            lowest_.highest = std::max(lowest_.highest, highest);
        }
    }
}

void OpenCutter::store(std::span<const SweptTool* const> tools, std::size_t column,
                       std::size_t band) {
    const std::size_t rows = std::min(kBlock, grid_.axes[1].at.size() - band * kBlock);
    const std::size_t begin = column * kBlock;
    const std::size_t count = std::min(kBlock, grid_.axes[0].at.size() - begin);
    std::int32_t ceiling = -Gap::kUnbounded;
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t v = band * kBlock + row;
        const std::span<Ray> rays = rays_.row(v).subspan(begin, count);
        const std::span<Gap> gaps = rays_.gaps(v).subspan(begin, count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = row * kBlock + i;
            const double at = lowest_.at[k];
            const std::int32_t low = whole_units(at);
            ceiling = std::max(ceiling, low);
            const auto number = static_cast<std::int32_t>(lowest_.number[k]);
            if (number < 0) continue;
            const SweptTool& tool = *tools[static_cast<std::size_t>(number)];
            gaps[i] = rays[i].cut_above(low, [&] {
                const Vec3 n = tool.normal(2, x_[begin + i], y_[v], false, at, lowest_.s[k]);
                return End{low, tool.origin, PackedNormal::of(-1.0 * n)};
            });
        }
    }
    rays_.ceilings(band)[column] = ceiling;
}

}  // namespace ncsim::dexel
