// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/export/marks.h"

#include "ncsim/export/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace ncsim::exporter {
namespace {

constexpr Rgba8 kWhite{255, 255, 255};

Image blank(std::uint32_t width, std::uint32_t height) {
    Image image{width, height, {}};
    image.pixels.assign(std::size_t{width} * height, kWhite);
    return image;
}

constexpr double kStrip = 0.12;  // of a picture of 4:3

// A block of 100 x 60 x 20 mm with the program zero at a corner of its top.
const Box kBlock{{0, 0, -20}, {100, 60, 0}};

Camera camera_of(const Image& image, View view) {
    const double strip = mark_strip(image.width, image.height);
    const double rows = (1.0 - strip) * image.height;
    return with_mark_strip(fit_camera(kBlock, view, image.width / rows), strip);
}

struct Pixel {
    double x, y;
};

// Independent of the renderer: the pixel of a point of W.
Pixel pixel_of(const Image& image, const Camera& camera, Vec3 p) {
    const double per_mm = image.height / camera.height;
    const Vec3 q = p - camera.target;
    return {image.width / 2.0 + per_mm * dot(q, camera.right),
            image.height / 2.0 - per_mm * dot(q, camera.up)};
}

bool is_dark(Rgba8 c) {
    return c.r + c.g + c.b < 300;
}

TEST(Marks, LeaveAStripBelowThePart) {
    const Image image = blank(800, 600);
    for (const View view : {View::Iso, View::Top, View::Front, View::Left}) {
        const Camera camera = camera_of(image, view);
        double lowest = 0.0;
        double highest = image.height;
        for (int corner = 0; corner < 8; ++corner) {
            const Pixel at = pixel_of(image, camera,
                                      {(corner & 1) != 0 ? kBlock.max.x : kBlock.min.x,
                                       (corner & 2) != 0 ? kBlock.max.y : kBlock.min.y,
                                       (corner & 4) != 0 ? kBlock.max.z : kBlock.min.z});
            lowest = std::max(lowest, at.y);
            highest = std::min(highest, at.y);
            EXPECT_GE(at.x, 0.0);
            EXPECT_LE(at.x, image.width);
        }
        EXPECT_LE(lowest, (1.0 - kStrip) * image.height);
        EXPECT_GE(highest, 0.0);
    }
}

// In a tall picture, letters as high as its height suggests would not fit its width.
TEST(Marks, OfTallAndWidePicturesFit) {
    for (const auto& [width, height] : {std::pair{320U, 3000U}, {3000U, 320U}, {400U, 400U}}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
        Image image = blank(width, height);
        Marks marks;
        marks.axes = marks.scale = true;
        marks.size = {1234.5, 1234.5, 1234.5};
        marks.legend = {{{200, 30, 30}, "T1 ball end mill D6"}};
        draw_marks(image, camera_of(image, View::Top), Background::White, marks);
        EXPECT_FALSE(image == blank(width, height));
        for (std::uint32_t y = 0; y < height; ++y) {
            ASSERT_EQ(image.at(0, y), kWhite) << y;
            ASSERT_EQ(image.at(width - 1, y), kWhite) << y;
        }
        for (std::uint32_t x = 0; x < width; ++x)
            ASSERT_EQ(image.at(x, height - 1), kWhite) << x;
    }
}

TEST(Marks, NoneDrawsNothing) {
    Image image = blank(400, 300);
    draw_marks(image, camera_of(image, View::Top), Background::White, {});
    EXPECT_TRUE(image == blank(400, 300));
}

TEST(Marks, SmallPicturesHaveNone) {
    Image image = blank(kLeastMarkedSide - 1, 300);
    Marks marks;
    marks.axes = marks.zero = marks.scale = true;
    draw_marks(image, camera_of(image, View::Top), Background::White, marks);
    EXPECT_TRUE(image == blank(kLeastMarkedSide - 1, 300));
}

TEST(Marks, ZeroIsWhereTheProgramHasIt) {
    for (const View view : {View::Iso, View::Top, View::Front}) {
        Image image = blank(800, 600);
        const Camera camera = camera_of(image, view);
        Marks marks;
        marks.zero = true;
        draw_marks(image, camera, Background::White, marks);
        const Pixel at = pixel_of(image, camera, {});
        const auto colour = [&](double dx, double dy) {
            return image.at(static_cast<std::uint32_t>(at.x + dx),
                            static_cast<std::uint32_t>(at.y + dy));
        };
        // The upper right and the lower left quarter are dark.
        EXPECT_TRUE(is_dark(colour(3, -3)));
        EXPECT_TRUE(is_dark(colour(-3, 3)));
        EXPECT_FALSE(is_dark(colour(3, 3)));
        EXPECT_FALSE(is_dark(colour(-3, -3)));
    }
}

// In the view from above, x points to the right and y upwards; in that from the left, -y points to
// the right and z upwards.
TEST(Marks, AxesPointAsInThePart) {
    struct Case {
        View view;
        int right, up;  // axes
    };
    for (const Case& c :
         {Case{View::Top, 0, 1}, Case{View::Front, 0, 2}, Case{View::Right, 1, 2}}) {
        Image image = blank(800, 600);
        Marks marks;
        marks.axes = true;
        draw_marks(image, camera_of(image, c.view), Background::White, marks);
        // Centre of the coloured pixels of each axis, without the axis along the line of sight.
        double x[3] = {}, y[3] = {}, n[3] = {};
        for (std::uint32_t row = 0; row < image.height; ++row) {
            for (std::uint32_t column = 0; column < image.width; ++column) {
                const Rgba8 p = image.at(column, row);
                const int axis = p.r > p.g + 80 && p.r > p.b + 80   ? 0
                                 : p.g > p.r + 60 && p.g > p.b + 40 ? 1
                                 : p.b > p.r + 80 && p.b > p.g + 80 ? 2
                                                                    : 3;
                if (axis == 3) continue;
                x[axis] += column;
                y[axis] += row;
                ++n[axis];
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GT(n[axis], 0) << axis;
            x[axis] /= n[axis];
            y[axis] /= n[axis];
        }
        const int sight = 3 - c.right - c.up;
        EXPECT_GT(x[c.right], x[sight] + 5);
        EXPECT_GT(x[c.right], x[c.up] + 5);
        EXPECT_LT(y[c.up], y[sight] - 5);
        EXPECT_LT(y[c.up], y[c.right] - 5);
    }
}

// Returns the length of the bar in mm: the longest dark run of a row in the strip.
double bar_of(double mm_per_unit) {
    Image image = blank(800, 600);
    const Camera camera = camera_of(image, View::Top);
    Marks marks;
    marks.scale = true;
    marks.size = kBlock.size();
    marks.mm_per_unit = mm_per_unit;
    draw_marks(image, camera, Background::White, marks);
    std::uint32_t longest = 0;
    for (auto row = static_cast<std::uint32_t>((1.0 - kStrip) * image.height); row < image.height;
         ++row) {
        std::uint32_t run = 0;
        for (std::uint32_t column = 0; column < image.width; ++column) {
            run = is_dark(image.at(column, row)) ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    return longest * camera.height / image.height;
}

// The picture shows 114 mm. The bar is the largest of 1, 2, 5, 10 … units up to 16 % of the width:
// 10 mm or 0.5 inch.
TEST(Marks, ScaleBarHasTheLengthThatItNames) {
    EXPECT_NEAR(bar_of(1.0), 10.0, 0.5);
    EXPECT_NEAR(bar_of(25.4), 12.7, 0.5);
}

TEST(Marks, LegendShowsEachColourAndStopsAtTheEdge) {
    const Rgba8 colours[] = {{200, 30, 30}, {30, 160, 30}, {30, 30, 200}, {200, 160, 20}};
    Image image = blank(800, 600);
    Marks marks;
    for (const Rgba8& colour : colours)
        marks.legend.emplace_back(colour, "T1 flat end mill D8");
    draw_marks(image, camera_of(image, View::Top), Background::White, marks);
    for (const Rgba8& colour : colours)
        EXPECT_NE(std::ranges::count(image.pixels, colour), 0);
    // More entries than there is room for change nothing outside of the strip.
    for (int i = 0; i < 100; ++i)
        marks.legend.emplace_back(colours[0], "T1 flat end mill D8");
    Image full = blank(800, 600);
    draw_marks(full, camera_of(full, View::Top), Background::White, marks);
    const auto strip = static_cast<std::size_t>((1.0 - kStrip) * 600);
    for (std::size_t i = 0; i < 800 * strip; ++i)
        ASSERT_EQ(full.pixels[i], kWhite);
}

TEST(Marks, ScaleOfColoursGoesFromItsBeginToItsEnd) {
    Image image = blank(1280, 960);
    Marks marks;
    marks.scale_begin = "Z 0 mm";
    marks.scale_end = "Z -10 mm";
    draw_marks(image, camera_of(image, View::Top), Background::White, marks);
    // Yellow is left of violet.
    double yellow = 0.0;
    double violet = 0.0;
    for (std::uint32_t column = 0; column < image.width; ++column) {
        const Rgba8 p = image.at(column, static_cast<std::uint32_t>(960 * (1.0 - 0.5 * kStrip)));
        if (p.r > 200 && p.g > 180 && p.b < 120) yellow = column;
        if (violet == 0.0 && p.b > p.g + 25 && p.r > p.g + 10) violet = column;
    }
    EXPECT_GT(yellow, 0.0);
    EXPECT_GT(violet, yellow);
}

}  // namespace
}  // namespace ncsim::exporter
