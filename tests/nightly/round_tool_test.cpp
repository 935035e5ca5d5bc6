// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/round_tool.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::nightly {
namespace {

// Tool with its radius as a function of height: an independent description of the tool.
struct Known {
    std::string name;
    RoundTool tool;
    std::function<double(double h)> radius_at;
    double length;
};

std::vector<Known> known_tools() {
    const auto degrees = [](double d) { return d * std::numbers::pi / 180.0; };
    const auto rounded = [](double r, double corner) {
        return [r, corner](double h) {
            if (h >= corner) return r;
            return r - corner + std::sqrt(corner * corner - (corner - h) * (corner - h));
        };
    };
    const auto cone = [&](double tip, double r, double included) {
        const double slope = std::tan(degrees(included / 2));
        return [=](double h) { return std::min(r, tip + h * slope); };
    };
    return {
        {"flat D10", RoundTool::end_mill(10, 0, 25), rounded(5, 0), 25},
        {"ball D6", RoundTool::end_mill(6, 3, 20), rounded(3, 3), 20},
        {"ball D6, no longer than its radius", RoundTool::end_mill(6, 3, 2), rounded(3, 3), 3},
        {"bull D12 R2", RoundTool::end_mill(12, 2, 25), rounded(6, 2), 25},
        {"v D6 A60", RoundTool::cone(6, 0, 60, 20), cone(0, 3, 60), 20},
        {"v D6 P1 A90, nothing but a cone", RoundTool::cone(6, 1, 90, 1), cone(0.5, 3, 90), 2.5},
        {"drill D8 A118", RoundTool::cone(8, 0, 118, 40), cone(0, 4, 118), 40},
        {"taper D4 A10", RoundTool::tapered(4, 0, 10, 20), cone(2, 1e9, 20), 20},
        {"taper D3 R1.5 A5", RoundTool::tapered(3, 1.5, 5, 30),
         [=](double h) {
             const double touch = 1.5 - 1.5 * std::sin(degrees(5));
             if (h < touch) return rounded(1.5, 1.5)(h);
             return 1.5 * std::cos(degrees(5)) + (h - touch) * std::tan(degrees(5));
         },
         30},
        {"slot D20 L4 R1", RoundTool::end_mill(20, 1, 4), rounded(10, 1), 4},
        {"dovetail D12 A30 L5", RoundTool::dovetail(12, 30, 5),
         [=](double h) { return 6 - h * std::tan(degrees(30)); }, 5},
        {"dovetail D12 A45, as high as it can be", RoundTool::dovetail(12, 45, 9),
         [](double h) { return 6 - h; }, 5.7},
        {"lollipop D8", RoundTool::lollipop(8),
         [](double h) { return std::sqrt(16 - (h - 4) * (h - 4)); }, 8},
    };
}

TEST(RoundTool, IsInsideWhereItsRadiusSaysSo) {
    test::Random random(1);
    for (const Known& known : known_tools()) {
        SCOPED_TRACE(known.name);
        EXPECT_NEAR(known.tool.height(), known.length, 1e-12);
        const double reach = known.tool.radius() * 1.5;
        for (int i = 0; i < 20000; ++i) {
            const Vec p{random.within(-reach, reach), random.within(-reach, reach),
                        random.within(-2, known.length + 2)};
            const double aside = std::hypot(p[0], p[1]);
            const bool within = p[2] > 0 && p[2] < known.length && aside < known.radius_at(p[2]);
            const double distance = known.tool.signed_distance(p);
            if (std::abs(distance) > 1e-9) {
                ASSERT_EQ(distance < 0, within) << p[0] << ' ' << p[1] << ' ' << p[2];
            }
        }
    }
}

TEST(RoundTool, IsAsFarAsTheNearestOfMillionsOfPointsOfItsSurface) {
    test::Random random(2);
    for (const Known& known : known_tools()) {
        SCOPED_TRACE(known.name);
        // Points of the surface in a half-plane, by the radius at each height, and both discs.
        constexpr int kSteps = 20000;
        std::vector<std::pair<double, double>> meridian;
        for (int i = 0; i <= kSteps; ++i) {
            const double t = static_cast<double>(i) / kSteps;
            // Denser near the tip, where an arc begins horizontally.
            const double h = known.length * t * t;
            meridian.emplace_back(known.radius_at(h), h);
            meridian.emplace_back(t * known.radius_at(0), 0.0);
            meridian.emplace_back(t * known.radius_at(known.length), known.length);
        }
        for (int i = 0; i < 100; ++i) {
            const double reach = known.tool.radius() * 2;
            const Vec p{random.within(-reach, reach), random.within(-reach, reach),
                        random.within(-5, known.length + 5)};
            const double aside = std::hypot(p[0], p[1]);
            double nearest = 1e9;
            for (const auto& [r, h] : meridian)
                nearest = std::min(nearest, std::hypot(aside - r, p[2] - h));
            const double distance = std::abs(known.tool.signed_distance(p));
            ASSERT_LE(distance, nearest + 1e-12);
            ASSERT_GE(distance, nearest - 0.01);
        }
    }
}

TEST(RoundTool, DistanceIsConvexAndNeverSteeperThanOne) {
    test::Random random(3);
    for (const Known& known : known_tools()) {
        SCOPED_TRACE(known.name);
        const auto somewhere = [&] {
            const double reach = known.tool.radius() * 1.5;
            return Vec{random.within(-reach, reach), random.within(-reach, reach),
                       random.within(-3, known.length + 3)};
        };
        for (int i = 0; i < 20000; ++i) {
            const Vec p = somewhere();
            // Near and far.
            const Vec q = p + std::pow(10.0, random.within(-4.0, 0.0)) * (somewhere() - p);
            const double at_p = known.tool.signed_distance(p);
            const double at_q = known.tool.signed_distance(q);
            ASSERT_LE(known.tool.signed_distance(0.5 * (p + q)), 0.5 * (at_p + at_q) + 1e-12);
            ASSERT_LE(std::abs(at_p - at_q), norm(p - q) + 1e-12);
        }
    }
}

TEST(RoundTool, PointsOfItsSurfaceAreOnIt) {
    test::Random random(4);
    for (const Known& known : known_tools()) {
        SCOPED_TRACE(known.name);
        for (int i = 0; i < 1000; ++i) {
            const Vec p = known.tool.surface_point(random.unit(), random.unit());
            ASSERT_NEAR(known.tool.signed_distance(p), 0.0, 1e-12);
        }
    }
}

TEST(RoundTool, KnowsItsSharpestAngle) {
    const double quarter = std::numbers::pi / 4;
    EXPECT_NEAR(RoundTool::end_mill(10, 0, 20).sharpest_half_angle(), quarter, 1e-12);
    EXPECT_NEAR(RoundTool::cone(10, 0, 60, 20).sharpest_half_angle(), std::numbers::pi / 6, 1e-12);
    EXPECT_NEAR(RoundTool::dovetail(10, 30, 4).sharpest_half_angle(), std::numbers::pi / 6, 1e-12);
    EXPECT_NEAR(RoundTool::lollipop(10).sharpest_half_angle(), quarter, 1e-12);
    // Without a cylinder above the cone, the rim of a blunt cone is sharper than the tip.
    EXPECT_NEAR(RoundTool::cone(10, 0, 120, 1).sharpest_half_angle(), std::numbers::pi / 12, 1e-12);
}

}  // namespace
}  // namespace ncsim::nightly
