// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of a part by three of its points.
#include "job/three_points.h"

#include "ncsim/setup/job_file.h"
#include "ncsim/setup/stock_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>

namespace ncsim::setup {
namespace {

using Points = std::array<Vec3, 3>;

constexpr Points kCorners{{{-40, -25, 0}, {40, -25, 0}, {-40, 25, 3}}};

Vec3 placed(const std::string& turn, Vec3 move, Vec3 p) {
    const auto rows = parse_any_turn(turn.empty() ? "X0" : turn).rows;
    Vec3 to = move;
    for (std::size_t i = 0; i < 3; ++i)
        to[static_cast<int>(i)] += rows[i][0] * p.x + rows[i][1] * p.y + rows[i][2] * p.z;
    return to;
}

Points placed(const std::string& turn, Vec3 move, const Points& points) {
    Points to;
    for (std::size_t i = 0; i < 3; ++i)
        to[i] = placed(turn, move, points[i]);
    return to;
}

void expect_motion(const std::string& turn, Vec3 move) {
    const TurnAndMove found = motion_of(kCorners, placed(turn, move, kCorners));
    // Points off the plane of the three, on both sides.
    for (const Vec3 p : {Vec3{0, 0, 50}, Vec3{100, 7, -30}})
        EXPECT_LT(norm(placed(found.turn, found.move, p) - placed(turn, move, p)), 1e-6)
            << turn << " instead of " << found.turn;
}

TEST(ThreePoints, GiveTheTurnThatMovedThem) {
    std::mt19937 random(20261129);
    std::uniform_real_distribution<double> angle(-180, 180), length(-200, 200);
    for (int i = 0; i < 500; ++i) {
        expect_motion(
            fmt::format("X{:.3f},Z{:.3f},Y{:.3f}", angle(random), angle(random), angle(random)),
            {length(random), length(random), length(random)});
    }
}

TEST(ThreePoints, GiveRightAnglesExactly) {
    for (const char* x : {"X0", "X90", "X180", "X-90"}) {
        for (const char* y : {"Y0", "Y90", "Y180", "Y-90"}) {
            for (const char* z : {"Z0", "Z90", "Z180", "Z-90"}) {
                const std::string turn = fmt::format("{},{},{}", x, y, z);
                expect_motion(turn, {1, 2, -24});
                const TurnAndMove found = motion_of(kCorners, placed(turn, {1, 2, -24}, kCorners));
                const auto is = parse_any_turn(found.turn.empty() ? "X0" : found.turn).placement;
                ASSERT_TRUE(is) << found.turn;
                EXPECT_EQ(is->rows, parse_any_turn(turn).placement->rows) << turn;
                EXPECT_EQ(found.move, (Vec3{1, 2, -24})) << turn;
            }
        }
    }
}

TEST(ThreePoints, AreMeasuredWithinATolerance) {
    Points now = placed("X180", {0, 0, -20}, kCorners);
    now[2].y += 0.009;
    EXPECT_NO_THROW((void)motion_of(kCorners, now));
    now[2].y += 0.01;
    EXPECT_THROW((void)motion_of(kCorners, now), std::invalid_argument);
    EXPECT_THROW((void)motion_of({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}}, kCorners),
                 std::invalid_argument);
    EXPECT_THROW((void)motion_of(kCorners, Points{}), std::invalid_argument);
}

TEST(ThreePoints, AreReadFromAJob) {
    const std::string head =
        "[[setup]]\nprogram = \"a.nc\"\n[[setup]]\nprogram = \"b.nc\"\n"
        "points = { before = [[-40, -25, 0], [40, -25, 0], [-40, 25, 0]], ";
    const JobFile file = parse_job_file(
        {"job.toml", head + "now = [[-40, 25, -24], [40, 25, -24], [-40, -25, -24]] }\n"});
    EXPECT_EQ(file.set_ups.at(1).turn, "X180");
    EXPECT_EQ(file.set_ups.at(1).move, (Vec3{0, 0, -24}));
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            (void)parse_job_file({"job.toml", text});
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return "accepted";
    };
    EXPECT_EQ(
        refusal(head + "now = [[-40, 25, -24], [41, 25, -24], [-40, -25, -24]] }\n"),
        "job.toml:5:10: 'setup.points': the points 1 and 2 are 80 mm apart before, 81 mm now");
    EXPECT_EQ(refusal(head + "now = [[0, 0, 0], [80, 0, 0], [160, 0, 0]] }\n"),
              "job.toml:5:10: 'setup.points': the points 'now' are on a line");
    EXPECT_EQ(refusal(head.substr(0, head.size() - 2) + " }\n"),
              "job.toml:5:10: 'setup.points': expected before and now");
    const std::string both =
        head + "now = [[-40, 25, -24], [40, 25, -24], [-40, -25, -24]] }\nmove = [0, 0, 1]\n";
    EXPECT_EQ(refusal(both), "job.toml:5:10: a set-up has points, or turn and move, not both");
}

}  // namespace
}  // namespace ncsim::setup
