// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places views and removes empty rows and columns.
#include "run/sheet_layout.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>

namespace ncsim::app {

namespace {

using exporter::SheetCell;
using exporter::View;

SheetCell cell_of(View view, bool has_top) {
    switch (view) {
        case View::Top: return {1, 0};
        case View::Left: return {0, 1};
        case View::Front: return {1, 1};
        case View::Right: return {2, 1};
        case View::Back: return {3, 1};
        case View::Bottom: return {1, 2};
        case View::Iso: break;
    }
    return has_top ? SheetCell{2, 0} : SheetCell{4, 1};
}

// Replaces the numbers of the used rows or columns by 0, 1, …
void close_gaps(std::vector<SheetCell>& cells, std::uint32_t SheetCell::*number) {
    std::set<std::uint32_t> used;
    for (const SheetCell& cell : cells)
        used.insert(cell.*number);
    for (SheetCell& cell : cells) {
        cell.*number =
            static_cast<std::uint32_t>(std::distance(used.begin(), used.find(cell.*number)));
    }
}

}  // namespace

std::vector<SheetCell> third_angle(std::span<const View> views) {
    const std::set<View> different(views.begin(), views.end());
    if (different.size() != views.size() || !different.contains(View::Front)) return {};
    std::vector<SheetCell> cells;
    for (const View view : views)
        cells.push_back(cell_of(view, different.contains(View::Top)));
    close_gaps(cells, &SheetCell::column);
    close_gaps(cells, &SheetCell::row);
    return cells;
}

std::uint32_t columns_of(std::span<const View> views) {
    const std::vector<SheetCell> cells = third_angle(views);
    if (cells.empty()) return exporter::columns_for(views.size());
    return 1 + std::ranges::max_element(cells, {}, &SheetCell::column)->column;
}

}  // namespace ncsim::app
