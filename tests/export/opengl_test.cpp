// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the rasteriser with OpenGL: OSMesa, and EGL (Mesa's, unless a different EGL is
// installed).
#include "opengl/offscreen_egl.h"
#include "render/opengl_buffer.h"
#include "render/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <vector>

namespace ncsim::exporter::test {
namespace {

constexpr std::uint32_t kWidth = 320, kHeight = 240;

// Returns a convex polygon in a plane that is not seen edge-on. Some polygons extend beyond the
// picture. In perspective, w is linear over the picture, too.
std::vector<ScreenPoint> random_polygon(std::mt19937& random, bool in_perspective) {
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random() % 100001) / 100000.0);
    };
    const double x = between(-40, kWidth + 40.0), y = between(-40, kHeight + 40.0);
    const double radius = between(0.3, 120);
    const double along_x = between(-1e-3, 1e-3), along_y = between(-1e-3, 1e-3);
    const double at = between(-0.5, 0.5);
    const int corners = 3 + static_cast<int>(random() % 6);
    std::vector<ScreenPoint> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307 * (i + between(0.05, 0.9)) / corners;
        const double dx = radius * std::cos(angle), dy = radius * std::sin(angle);
        const double z = at + along_x * dx + along_y * dy;
        const double w = in_perspective ? 1.0 + 0.4 * z : 1.0;
        polygon.push_back({(x + dx) * w, (y + dy) * w, z * w, w});
    }
    return polygon;
}

// Expects equal samples away from edges, and few differences in total.
void expect_same(std::span<const SurfaceId> found, std::span<const SurfaceId> expected) {
    ASSERT_EQ(found.size(), expected.size());
    std::size_t different = 0, inside = 0;
    for (std::size_t y = 1; y + 1 < kHeight; ++y) {
        for (std::size_t x = 1; x + 1 < kWidth; ++x) {
            const std::size_t i = y * kWidth + x;
            if (found[i] == expected[i]) continue;
            ++different;
            bool is_inside = true;
            for (const std::size_t j : {i - 1, i + 1, i - kWidth, i + kWidth})
                is_inside = is_inside && expected[j] == expected[i] && found[j] == found[i];
            inside += is_inside ? 1 : 0;
        }
    }
    EXPECT_EQ(inside, 0U);
    EXPECT_LE(different, found.size() / 500);
}

using MakeContext = std::unique_ptr<OffscreenContext> (*)();

class Rasteriser : public testing::TestWithParam<MakeContext> {};

INSTANTIATE_TEST_SUITE_P(OpenGl, Rasteriser, testing::Values(&osmesa_context, &egl_context));

TEST_P(Rasteriser, SeesWhatOpenGlSees) {
    for (const bool in_perspective : {false, true}) {
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            SCOPED_TRACE(seed);
            std::mt19937 random(seed);
            OpenGlBuffer expected(GetParam()());
            expected.begin({0, 0, kWidth, kHeight});
            VisibilityBuffer found;
            found.begin({0, 0, kWidth, kHeight});
            for (SurfaceId id = 1; id <= 60; ++id) {
                const auto polygon = random_polygon(random, in_perspective);
                expected.draw(polygon, id);
                found.draw(polygon, id);
            }
            expect_same(found.ids(), expected.ids());
        }
    }
}

TEST_P(Rasteriser, MasksAsOpenGlDoes) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        OpenGlBuffer expected(GetParam()());
        expected.begin({0, 0, kWidth, kHeight});
        VisibilityBuffer found;
        found.begin({0, 0, kWidth, kHeight});
        for (SurfaceId id = 1; id <= 30; ++id) {
            const auto polygon = random_polygon(random, false);
            std::vector<std::vector<ScreenPoint>> masks;
            for (int i = 0; i < 4; ++i)
                masks.push_back(random_polygon(random, false));
            expected.draw(polygon, id, masks);
            found.draw(polygon, id, masks);
        }
        expect_same(found.ids(), expected.ids());
    }
}

// Each sample sees the same surface, whatever the position and the size of the rectangle.
TEST(RasteriserAlone, WhatASampleSeesDoesNotDependOnTheRectangle) {
    std::mt19937 random(7);
    std::vector<std::vector<ScreenPoint>> polygons;
    for (int i = 0; i < 300; ++i)
        polygons.push_back(random_polygon(random, i % 2 != 0));
    const auto draw = [&](VisibilityBuffer& buffer, const SampleRect& rect) {
        buffer.begin(rect);
        for (std::size_t i = 0; i < polygons.size(); ++i)
            buffer.draw(polygons[i], static_cast<SurfaceId>(i + 1));
    };
    VisibilityBuffer whole, part;
    draw(whole, {0, 0, kWidth, kHeight});
    for (const SampleRect rect :
         {SampleRect{-4, -4, 50, 60}, SampleRect{17, 91, 1, 1}, SampleRect{200, 3, 140, 300}}) {
        draw(part, rect);
        for (std::int64_t y = 0; y < rect.height; ++y) {
            for (std::int64_t x = 0; x < rect.width; ++x) {
                const std::int64_t u = rect.x + x, v = rect.y + y;
                if (u < 0 || v < 0 || u >= kWidth || v >= kHeight) continue;
                ASSERT_EQ(part.ids()[static_cast<std::size_t>(y * rect.width + x)],
                          whole.ids()[static_cast<std::size_t>(v * kWidth + u)]);
            }
        }
    }
}

// Three triangles around the middle of a random triangle cover each of its samples once: no gaps,
// no overlaps.
TEST(RasteriserAlone, NeighboursShareNoSampleAndLeaveNone) {
    std::mt19937 random(11);
    for (int round = 0; round < 50; ++round) {
        const auto polygon = random_polygon(random, false);
        const ScreenPoint &a = polygon[0], &b = polygon[1], &c = polygon[2];
        const ScreenPoint middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3,
                                 (a.z + b.z + c.z) / 3, 1.0};
        std::vector<int> count(std::size_t{kWidth} * kHeight);
        VisibilityBuffer buffer;
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
            buffer.begin({0, 0, kWidth, kHeight});
            buffer.draw(std::vector{middle, p, q}, 1);
            for (std::size_t i = 0; i < count.size(); ++i)
                count[i] += static_cast<int>(buffer.ids()[i]);
        }
        buffer.begin({0, 0, kWidth, kHeight});
        buffer.draw(std::vector{a, b, c}, 1);
        for (std::size_t i = 0; i < count.size(); ++i)
            ASSERT_EQ(count[i], static_cast<int>(buffer.ids()[i]));
    }
}

}  // namespace
}  // namespace ncsim::exporter::test
