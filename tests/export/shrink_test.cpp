// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/export/shrink.h"

#include <gtest/gtest.h>

namespace ncsim::exporter {
namespace {

TEST(Shrink, AveragesSquaresAndLeavesOutTheRest) {
    Image image{5, 2, {}};
    for (std::uint8_t i = 0; i < 10; ++i)
        image.pixels.push_back({i, 255, static_cast<std::uint8_t>(10 * i), 255});
    // Columns 0 and 1: 0, 1, 5, 6; columns 2 and 3: 2, 3, 7, 8.
    EXPECT_EQ(shrink(image, 2), (Image{2, 1, {{3, 255, 30, 255}, {5, 255, 50, 255}}}));
    EXPECT_EQ(shrink(image, 1), image);
}

}  // namespace
}  // namespace ncsim::exporter
