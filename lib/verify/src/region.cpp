// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gathers rows of the ledger into regions.
#include "ncsim/verify/region.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::verify {

namespace {

void absorb(Region& into, Region& from) {
    into.volume_mm3 += from.volume_mm3;
    into.box.add(from.box);
    into.lines.insert(into.lines.end(), from.lines.begin(), from.lines.end());
}

// Adds `row`, merged with all touching regions. A merged box is compared with all regions again,
// because a larger box may reach further regions.
void add_row(std::vector<Region>& regions, Region row) {
    for (std::size_t i = 0; i < regions.size();) {
        if (!regions[i].box.overlaps(row.box)) {
            ++i;
            continue;
        }
        absorb(regions[i], row);
        row = std::move(regions[i]);
        regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
    }
    regions.push_back(std::move(row));
}

}  // namespace

std::vector<LineRange> merged(std::vector<LineRange> lines) {
    std::ranges::sort(lines, {}, [](const LineRange& r) { return std::pair(r.file, r.first); });
    std::vector<LineRange> ranges;
    for (const LineRange& r : lines) {
        if (!ranges.empty() && ranges.back().file == r.file && r.first <= ranges.back().last + 1) {
            ranges.back().last = std::max(ranges.back().last, r.last);
        } else {
            ranges.push_back(r);
        }
    }
    return ranges;
}

std::vector<Region> regions_of(const Ledger& ledger) {
    std::vector<Region> regions;
    for (const LedgerRow& row : ledger.rows) {
        if (row.removed_mm3 <= 0.0) continue;
        add_row(regions, {row.removed_mm3, row.contact, {{row.file, row.line, row.line}}});
    }
    for (Region& region : regions)
        region.lines = merged(std::move(region.lines));
    std::ranges::stable_sort(regions, std::ranges::greater{}, &Region::volume_mm3);
    return regions;
}

std::string lines_text(const std::vector<LineRange>& lines) {
    constexpr std::size_t kShown = 6;
    std::string text;
    for (std::size_t i = 0; i < lines.size() && i < kShown; ++i) {
        text += fmt::format("{}{}", i == 0 ? "" : ", ", lines[i].first);
        if (lines[i].last != lines[i].first) text += fmt::format("-{}", lines[i].last);
    }
    if (lines.size() > kShown) text += fmt::format(" and {} more", lines.size() - kShown);
    return text;
}

}  // namespace ncsim::verify
