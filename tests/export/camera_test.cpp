// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the frames and the extents of cameras.
#include "ncsim/export/camera.h"

#include "render/visibility.h"

#include <gtest/gtest.h>

namespace ncsim::exporter {
namespace {

constexpr std::array kViews{View::Iso,  View::Top,   View::Front, View::Back,
                            View::Left, View::Right, View::Bottom};

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_LT(norm(a - b), 1e-12);
}

TEST(Camera, NamesOfViewsReadBack) {
    for (const View view : kViews)
        EXPECT_EQ(parse_view(name(view)), view);
    EXPECT_EQ(parse_view("sideways"), std::nullopt);
    EXPECT_EQ(parse_view(""), std::nullopt);
}

TEST(Camera, AxesAreARightHandedFrame) {
    const Box box{{0, 0, 0}, {10, 20, 30}};
    for (const View view : kViews) {
        SCOPED_TRACE(name(view));
        const Camera c = fit_camera(box, view, 1.5);
        expect_near(cross(c.right, c.up), c.back);
        expect_near(cross(c.up, c.back), c.right);
        EXPECT_NEAR(norm(c.up), 1.0, 1e-15);
    }
}

TEST(Camera, LooksAsOneStandsAtTheMachine) {
    const Box box{{0, 0, 0}, {10, 20, 30}};
    expect_near(fit_camera(box, View::Front, 1.0).right, {1, 0, 0});
    expect_near(fit_camera(box, View::Right, 1.0).right, {0, 1, 0});
    expect_near(fit_camera(box, View::Left, 1.0).right, {0, -1, 0});
    expect_near(fit_camera(box, View::Back, 1.0).right, {-1, 0, 0});
    expect_near(fit_camera(box, View::Top, 1.0).right, {1, 0, 0});
    expect_near(fit_camera(box, View::Top, 1.0).up, {0, 1, 0});
}

TEST(Camera, SeesAllCornersOfTheBoxAndFillsThePicture) {
    const Box box{{-5, 100, 3}, {75, 140, 9}};
    for (const View view : kViews) {
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
            for (const double aspect : {0.5, 1.0, 2.0}) {
                SCOPED_TRACE(name(view));
                const ScreenMap map(fit_camera(box, view, aspect, projection), 1000 * aspect, 1000);
                double least_margin = 1e9;
                for (int i = 0; i < 8; ++i) {
                    const ScreenPoint p = map({(i & 1) != 0 ? box.max.x : box.min.x,
                                               (i & 2) != 0 ? box.max.y : box.min.y,
                                               (i & 4) != 0 ? box.max.z : box.min.z});
                    EXPECT_LT(std::abs(p.z / p.w), 1.0);
                    const double x = p.x / p.w;
                    const double y = p.y / p.w;
                    least_margin = std::min({least_margin, x, y, 1000 * aspect - x, 1000 - y});
                }
                EXPECT_GT(least_margin, 20.0);
                EXPECT_LT(least_margin, 130.0);
            }
        }
    }
}

TEST(Camera, NothingToSeeIsSeenAsAMillimetre) {
    EXPECT_GT(fit_camera(Box{}, View::Iso, 1.0).height, 1.0);
    EXPECT_LT(fit_camera(Box{}, View::Iso, 1.0).height, 3.0);
    const Box point{{7, 8, 9}, {7, 8, 9}};
    const Camera camera = fit_camera(point, View::Top, 1.0);
    expect_near(camera.target, {7, 8, 9});
    EXPECT_GT(camera.depth, 0.0);
}

TEST(Camera, AFlatBoxSeenFromItsEdgeStillHasASize) {
    const Box rod{{0, 0, 0}, {10, 0, 0}};
    EXPECT_GT(fit_camera(rod, View::Right, 1.0).height, 0.0);
}

}  // namespace
}  // namespace ncsim::exporter
