// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/machine/inverse.h"

#include "ncsim/machine/presets.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ncsim::machine {
namespace {

constexpr std::size_t kA = 3, kB = 4, kC = 5;

bool has(const std::vector<Turns>& found, std::size_t i, double qi, std::size_t j, double qj) {
    return std::ranges::any_of(found, [&](const Turns& t) {
        return std::abs(t.values[i] - qi) < 1e-3 && std::abs(t.values[j] - qj) < 1e-3;
    });
}

TEST(Inverse, FindsBothWaysOfACradle) {
    const Vec3 axis = normalized({0.557571, -0.769406, 0.311655});
    const auto found = orientation_solutions(*preset("xyzac-trt"), axis);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(has(found, kA, -71.841, kC, -35.93));
    EXPECT_TRUE(has(found, kA, 71.841, kC, 144.07));
}

TEST(Inverse, FindsBothWaysOfANutatingHead) {
    const Vec3 axis{0.362497596587, 0.298106103092, 0.883022221559};
    const auto found = orientation_solutions(*preset("nutating-cb"), axis);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(has(found, kB, 40, kC, 25));
    EXPECT_TRUE(has(found, kB, -40, kC, -126.134489913));
    EXPECT_TRUE(
        orientation_solutions(*preset("nutating-cb"), normalized({0.3, 0.2, -0.1})).empty());
}

TEST(Inverse, OfTheFrameOfG68_2) {
    const Vec3 z = normalized({0.321393805, -0.556670399, 0.766044443});
    const Chain table{{joint_of('C', true, {0, 0, 1}), joint_of('A', true, {1, 0, 0})}};
    EXPECT_TRUE(has(orientation_solutions(table, z), kA, 40, kC, 30));
    const Chain head{{joint_of('C', true, {0, 0, 1}), joint_of('B', true, {0, 1, 0})}};
    EXPECT_TRUE(has(orientation_solutions(head, z), kB, 40, kC, -60));
    EXPECT_TRUE(has(orientation_solutions(head, z), kB, -40, kC, 120));
}

TEST(Inverse, StaysWhereItIsWhereOneJointIsFree) {
    Values now{};
    now[kC] = 77.0;
    const auto found = orientation_solutions(*preset("xyzac-trt"), {0, 0, 1}, now);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].singular);
    EXPECT_EQ(found[0].values[kA], 0.0);
    EXPECT_EQ(found[0].values[kC], 77.0);
}

TEST(Inverse, OfOneJointIsThatOneOrNone) {
    const auto found = orientation_solutions(*preset("4axis-a"), {0, -0.6, 0.8});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].values[kA], 36.86989764584402, 1e-12);
    EXPECT_TRUE(orientation_solutions(*preset("4axis-a"), {0.6, 0, 0.8}).empty());
}

TEST(Inverse, LinearJointsOfOnePlaneReachNothing) {
    const Chain flat{{joint_of('X', false, {1, 0, 0}), joint_of('Y', false, {0, 1, 0}),
                      joint_of('Z', false, {1, 1, 0})}};
    EXPECT_FALSE(values_for(flat, {1, 2, 3}, {}));
}

Vec3 direction(test::Random& random) {
    for (;;) {
        const Vec3 v{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)};
        if (const double size = norm(v); size > 0.1 && size < 1.0) return normalized(v);
    }
}

// Returns a machine with two rotary joints at any position in the chain of linear joints.
Chain random_machine(test::Random& random) {
    Chain chain;
    const char letters[] = {'X', 'Y', 'Z'};
    const Vec3 along[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto first = random.between(0, 3), second = random.between(first, 3);
    const auto rotary = [&](char letter) {
        const Vec3 at{random.within(-200, 200), random.within(-200, 200), random.within(-200, 200)};
        const Vec3 u = random.one_in(2) ? direction(random) : along[random.between(0, 2)];
        chain.joints.push_back(
            joint_of(letter, true, u, at, random.one_in(2) ? Positive::Part : Positive::Tool));
    };
    for (std::int64_t i = 0; i <= 3; ++i) {
        if (i == first) rotary('C');
        if (i == second) rotary('A');
        if (i < 3) chain.joints.push_back(joint_of(letters[i], false, along[i]));
    }
    return chain;
}

TEST(Inverse, UndoesForwardOnAnyMachine) {
    test::Random random(2);
    int found = 0, same = 0, count = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Chain chain = random_machine(random);
        Values values{};
        for (std::size_t k = 0; k < 3; ++k)
            values[k] = random.within(-300, 300);
        values[kA] = random.within(-180, 180);
        values[kC] = random.within(-180, 180);
        const Pose X_WT = chain.pose(values);
        const Vec3 axis = axis_of(X_WT);
        const auto ways = orientation_solutions(chain, axis, values);
        ASSERT_FALSE(ways.empty()) << i;
        ++count;
        bool is_back = false;
        for (const Turns& way : ways) {
            const auto whole = values_for(chain, X_WT.translation, way.values);
            // If the joints turn the linear axes into a plane, no solution exists.
            if (!whole) continue;
            ++found;
            const Pose again = chain.pose(*whole);
            EXPECT_LT(norm(again.translation - X_WT.translation), 1e-6) << i;
            EXPECT_LT(norm(axis_of(again) - axis), 1e-9) << i;
            is_back |= std::abs(way.values[kA] - values[kA]) < 1e-4 &&
                       std::abs(way.values[kC] - values[kC]) < 1e-4 &&
                       std::abs((*whole)[0] - values[0]) < 1e-2;
            is_back |= way.singular;
        }
        same += is_back;
    }
    EXPECT_GT(found, 90'000);
    EXPECT_GT(same, count - 100);  // except if a joint is nearly free
}

}  // namespace
}  // namespace ncsim::machine
