// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/surface.h"

#include <gtest/gtest.h>

namespace ncsim::nightly {
namespace {

// Returns a cube of 2 mm with square faces.
Surface cube() {
    Surface s;
    for (std::uint32_t i = 0; i < 8; ++i) {
        s.vertices.push_back({i & 1 ? 2.0 : 0.0, i & 2 ? 2.0 : 0.0, i & 4 ? 2.0 : 0.0});
    }
    s.loops = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return s;
}

Surface triangles(const Surface& s) {
    Surface t{s.vertices, {}};
    for (const auto& loop : s.loops) {
        for (std::size_t i = 2; i < loop.size(); ++i)
            t.loops.push_back({loop[0], loop[i - 1], loop[i]});
    }
    return t;
}

TEST(Surface, OfACubeIsClosedUntilAFaceIsMissingTwiceOrTurned) {
    EXPECT_TRUE(is_closed(cube()));
    EXPECT_TRUE(is_closed(triangles(cube())));
    Surface missing = cube();
    missing.loops.pop_back();
    EXPECT_FALSE(is_closed(missing));
    Surface twice = cube();
    twice.loops.push_back(twice.loops.back());
    EXPECT_FALSE(is_closed(twice));
    Surface turned = cube();
    turned.loops[0] = {1, 3, 2, 0};
    EXPECT_FALSE(is_closed(turned));
}

TEST(Surface, OfACubeEnclosesItsVolume) {
    EXPECT_DOUBLE_EQ(enclosed_volume(cube()), 8.0);
    EXPECT_DOUBLE_EQ(enclosed_volume(triangles(cube())), 8.0);
    EXPECT_EQ(enclosed_volume({}), 0.0);
}

TEST(Surface, GoesOnceRoundWhatIsInside) {
    const Surface t = triangles(cube());
    for (const double gap : {1.0, 1e-3, 1e-9}) {
        EXPECT_NEAR(winding_number(t, {gap, 0.7, 1.1}), 1.0, 1e-6);
        EXPECT_NEAR(winding_number(t, {-gap, 0.7, 1.1}), 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace ncsim::nightly
