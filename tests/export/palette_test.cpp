// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the colours of stock and tools.
#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace ncsim::exporter {
namespace {

using Entry = mesh::Provenance::Entry;

mesh::Provenance cut_by(std::initializer_list<std::uint32_t> tools) {
    mesh::Provenance provenance{{{}}, "a.nc"};
    for (const std::uint32_t tool : tools)
        provenance.entries.push_back({9, tool});
    return provenance;
}

TEST(Palette, StockEightToolsAndATool0HaveColoursOfTheirOwn) {
    const Palette palette(cut_by({0, 1, 2, 3, 4, 5, 6, 7, 8}));
    std::set<std::tuple<int, int, int>> colours;
    for (const FaceSource& maker : palette.face_sources()) {
        const Rgba8 c = palette.colour(maker);
        colours.insert({c.r, c.g, c.b});
    }
    EXPECT_EQ(colours.size(), 10U);
}

TEST(Palette, Tool0ChangesTheColourOfNoOtherTool) {
    const Palette without(cut_by({3, 12}));
    const Palette with(cut_by({0, 3, 12}));
    for (const Entry entry : {Entry{}, Entry{9, 3}, Entry{9, 12}})
        EXPECT_EQ(without.colour(entry), with.colour(entry));
}

// The curve of the sRGB standard. Tests may use the C library.
TEST(Palette, LinearSharesAreThoseOfSrgb) {
    for (int channel = 0; channel < 256; ++channel) {
        const double c = channel / 255.0;
        const double expected = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(linear_share(static_cast<std::uint8_t>(channel)), expected, 1e-7);
    }
    EXPECT_EQ(linear_share(0), 0.0);
    EXPECT_EQ(linear_share(255), 1.0);
}

TEST(Palette, NamesStockAndTools) {
    const Palette palette(cut_by({7, 0}));
    ASSERT_EQ(palette.face_sources().size(), 3U);
    EXPECT_EQ(palette.face_sources()[0].name(), "stock");
    EXPECT_EQ(palette.face_sources()[1].name(), "T0");
    EXPECT_EQ(palette.face_sources()[2].name(), "T7");
    EXPECT_EQ(palette.rank(Entry{}), 0U);
    EXPECT_EQ(palette.rank(Entry{5, 0}), 1U);
    EXPECT_EQ(palette.rank(Entry{5, 99}), 0U);
}

}  // namespace
}  // namespace ncsim::exporter
