// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts whose facets are wider than the distance between corners: the polyhedron has the corners in
// a wrong order.
#include "ncsim/brep/curve.h"
#include "ncsim/brep/measure.h"
#include "ncsim/setup/job.h"

#include "brep/made_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace ncsim::brep {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBlock = 80.0 * 60.0 * 20.0;

int cylinders_of(const Part& part) {
    return static_cast<int>(std::ranges::count_if(part.faces, [](const Face& face) {
        return std::holds_alternative<Cylinder>(face.surface.form);
    }));
}

// Returns the area (mm²) below `y` that a disc of `radius` covers on the line from (ax, ay) to (bx,
// by). Sums strips; the error is about 1e-6 mm².
double area_below(double ax, double ay, double bx, double by, double radius, double y) {
    const double length = std::hypot(bx - ax, by - ay);
    const double dx = (bx - ax) / length, dy = (by - ay) / length;
    // Returns the length of the level line at `h` that the disc covers.
    const auto chord = [&](double h) {
        double low = 1e9, high = -1e9;
        const auto reach = [&](double x) {
            low = std::min(low, x);
            high = std::max(high, x);
        };
        for (const auto& [cx, cy] : {std::pair(ax, ay), std::pair(bx, by)}) {
            const double square = radius * radius - (h - cy) * (h - cy);
            if (square < 0.0) continue;
            reach(cx - std::sqrt(square));
            reach(cx + std::sqrt(square));
        }
        for (const double side : {-radius, radius}) {
            // Intersection with the wall on this side of the path.
            const double along = (h - ay - side * dx) / dy;
            if (along >= 0.0 && along <= length) reach(ax + along * dx - side * dy);
        }
        return std::max(0.0, high - low);
    };
    constexpr int kStrips = 400'000;
    const double from = std::min(ay, by) - radius, step = (y - from) / kStrips;
    double sum = 0.0;
    for (int i = 0; i < kStrips; ++i)
        sum += step * chord(from + (i + 0.5) * step);
    return sum;
}

// The wall of the lower slot passes into its round end 0.1 mm before the wall of the upper slot,
// where the polyhedron has their corner. The three surfaces have no common point: on the way down
// the round end comes before the wall, so two corners swap.
TEST(Order, AWallEndsBeforeItComesOutBelowAnother) {
    for (const double tolerance : {0.05, 0.0125}) {
        SCOPED_TRACE(tolerance);
        const auto made = test::make_part("under",
                                          "T1 M6\nG0 X-10 Y38 Z5\nG1 Z-5\nG1 X90\nG0 Z5\n"
                                          "G0 X60 Y10\nG1 Z-8\nG1 X44 Y40.4\nG0 Z5\n",
                                          tolerance);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_EQ(made.solid.part.faces.size(), 18U);
        EXPECT_EQ(cylinders_of(made.solid.part), 2);
        const double slot = std::hypot(16.0, 30.4) * 10.0 + 25.0 * kPi;
        const double below = area_below(60, 10, 44, 40.4, 5, 33);
        const double above = slot - area_below(60, 10, 44, 40.4, 5, 43);
        EXPECT_NEAR(volume(made.solid.part), kBlock - 4000.0 - 3.0 * slot - 5.0 * (below + above),
                    1e-4);
    }
}

// A leaning wall ends in an oblique line, which emerges from behind a second wall far below the
// corner that the polyhedron has.
TEST(Order, AWallThatLeansEndsFarBelow) {
    std::optional<double> left;
    for (const double tolerance : {0.05, 0.0125}) {
        SCOPED_TRACE(tolerance);
        const auto made = test::make_part("lean",
                                          "T1 M6\nG0 X40 Y-20 Z30\nG0 A-4\nG0 Z-9\nG1 Y24\nG0 Z30\n"
                                          "G0 A0\nG0 X-10 Y29 Z5\nG1 Z-4\nG1 X90\nG0 Z5\n",
                                          tolerance);
        EXPECT_EQ(made.solid.facets_kept, 0U);
        EXPECT_EQ(made.solid.part.faces.size(), 16U);
        EXPECT_EQ(cylinders_of(made.solid.part), 1);
        if (!left) left = volume(made.solid.part);
        EXPECT_NEAR(volume(made.solid.part), *left, 1e-9 * *left);
    }
}

// A helix ends where a level line continues. The circle of the helix's floor touches the wall of
// that line.
TEST(Order, AHelixEndsBesideAWall) {
    for (const double tolerance : {0.05, 0.02, 0.0055}) {
        for (const std::string end : {"X28 Y33 Z-5 I8", "X32 Y37 Z-5 I12"}) {
            SCOPED_TRACE(end + " " + std::to_string(tolerance));
            const auto made = test::make_part(
                "helix", "T1 M6\nG0 X20 Y25 Z5\nG1 Z-2\nG2 " + end + " J0\nG1 X60\nG0 Z5\n",
                tolerance);
            EXPECT_EQ(made.solid.facets_kept, 0U);
            EXPECT_EQ(made.solid.part.faces.size(), 14U);
            EXPECT_EQ(cylinders_of(made.solid.part), 4);
        }
    }
}

// The circles in which two ramps begin overlap by 1 µm. Circles of the floor that end in the
// adjacent corner would cross there, and OpenCASCADE finds that the floor crosses itself.
TEST(Order, CirclesThatOughtToTouchEndWhereTheyDo) {
    const std::string program =
        "(T1 D=10. CR=0. - flat end mill)\n(T2 D=3.175 CR=0. - flat end mill)\n"
        "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\nG21 G90\n"
        "T1 M6\nG0 Z5\nG0 X-8 Y-4\nG1 Z-2 F100\nX8\nY0\nX-8\nY4\nX8\nG0 Z5\n"
        "T2 M6\nG0 X-1.587 Y0\nG1 Z-2\nX-6 Z-3\nG0 Z5\nX1.587\nG1 Z-2\nX6 Z-3\nG0 Z5\nM30\n";
    const Part part = test::make_part(setup::job_of({"circles.nc", program}), 0.05).solid.part;
    int touching = 0;
    for (const Edge& edge : part.edges) {
        const Vec3 from = part.vertices[edge.from], to = part.vertices[edge.to];
        const Track track(edge.curve, from, to);
        EXPECT_LT(norm(track.at(0.0) - from), 1e-6);
        EXPECT_LT(norm(track.at(1.0) - to), 1e-6);
        for (const Vec3 p : {from, to}) {
            if (norm(p - Vec3{0, 0, -2}) < 1e-6) ++touching;
        }
    }
    EXPECT_GE(touching, 4);
}

}  // namespace
}  // namespace ncsim::brep
