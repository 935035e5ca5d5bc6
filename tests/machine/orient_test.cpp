// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choice of the control between several orientations: the order of Fanuc, the words of LinuxCNC and
// Heidenhain.
#include "ncsim/machine/orient.h"

#include "ncsim/machine/presets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ncsim::machine {
namespace {

constexpr std::size_t kA = 3, kB = 4, kC = 5;
// Normal of the plane of G68.2 I30 J40 K-20.
const Vec3 kNormal = normalized({0.321393804843, -0.556670399226, 0.766044443119});

Chain with_iso_signs(Chain chain) {
    for (Joint& joint : chain.joints) {
        if (joint.turns &&
            (joint.direction.x < 0 || joint.direction.y < 0 || joint.direction.z < 0))
            joint.direction = -joint.direction;
    }
    return chain;
}

// Returns the values of the rotary joints; linear joints are 0.
Values at(double a, double b, double c) {
    Values values{};
    values[kA] = a, values[kB] = b, values[kC] = c;
    return values;
}

void expect(const std::optional<Turns>& turns, std::size_t i, double qi, std::size_t j, double qj) {
    ASSERT_TRUE(turns);
    EXPECT_NEAR(turns->values[i], qi, 1e-6);
    EXPECT_NEAR(turns->values[j], qj, 1e-6);
}

TEST(Orient, TheTableOfTwoIsTheMasterAndOfTwoAlikeTheOneOnTheBed) {
    EXPECT_EQ(master_of(*preset("xyzac-trt"))->letter, 'A');
    EXPECT_EQ(master_of(*preset("bridge-cb"))->letter, 'C');
    EXPECT_EQ(master_of(*preset("head-b-table-c"))->letter, 'C');
    EXPECT_FALSE(master_of(*preset("4axis-a")));
}

TEST(Orient, TakesTheLeastWayOfTheMaster) {
    const Chain table = with_iso_signs(*preset("xyzac-trt"));
    expect(orient(table, kNormal, at(0, 0, 0)), kA, 40, kC, 30);
    // A start near the second solution gives the second solution: A-40 C-150 or C210.
    expect(orient(table, kNormal, at(-30, 0, 0)), kA, -40, kC, -150);
    expect(orient(table, kNormal, at(-30, 0, 100)), kA, -40, kC, 210);
    const Chain head{{joint_of('X', false, {1, 0, 0}), joint_of('Y', false, {0, 1, 0}),
                      joint_of('Z', false, {0, 0, 1}), joint_of('C', true, {0, 0, 1}),
                      joint_of('B', true, {0, 1, 0})}};
    expect(orient(head, kNormal, at(0, 0, 0)), kB, 40, kC, -60);
}

TEST(Orient, StaysWithinTheTravels) {
    const Chain table = with_iso_signs(*preset("xyzac-trt"));
    expect(orient(table, kNormal, at(0, 0, 0), {{'A', {-120, 30}}}), kA, -40, kC, -150);
    expect(orient(table, kNormal, at(0, 0, 0), {{'A', {-120, 30}}, {'C', {0, 360}}}), kA, -40, kC,
           210);
    EXPECT_FALSE(orient(table, kNormal, at(0, 0, 0), {{'A', {-30, 30}}}));
    // For any distance of the start.
    expect(orient(table, kNormal, at(0, 0, 5000), {{'C', {-180, 180}}}), kA, 40, kC, 30);
}

TEST(Orient, GoesTheWayThatIsAskedFor) {
    const Chain table = with_iso_signs(*preset("xyzac-trt"));
    expect(orient(table, kNormal, at(50, 0, 0), {}, SolutionPreference::PositiveMotion), kA, 320,
           kC, -150);
    expect(orient(table, kNormal, at(50, 0, 0), {}, SolutionPreference::NegativeMotion), kA, 40, kC,
           30);
    expect(
        orient(table, kNormal, at(0, 0, 0), {{'A', {-180, 180}}}, SolutionPreference::EndNegative),
        kA, -40, kC, -150);
    expect(orient(table, kNormal, at(-40, 0, 0), {{'A', {-180, 180}}},
                  SolutionPreference::EndPositive),
           kA, 40, kC, 30);
}

TEST(Orient, LeavesAFreeJointWhereItIs) {
    const auto turns = orient(*preset("xyzac-trt"), {0, 0, 1}, at(10, 0, 725));
    ASSERT_TRUE(turns);
    EXPECT_TRUE(turns->singular);
    expect(turns, kA, 0, kC, 725);
}

TEST(Orient, OfOneJointOrNone) {
    const auto turns = orient(*preset("4axis-b"), {1, 0, 0}, {});
    ASSERT_TRUE(turns);
    EXPECT_EQ(turns->values[kB], 90.0);
    EXPECT_FALSE(orient(*preset("4axis-b"), {0, 1, 0}, {}));
    const Chain none{{joint_of('X', false, {1, 0, 0})}};
    EXPECT_TRUE(orient(none, {0, 0, 1}, {}));
    EXPECT_FALSE(orient(none, {0, 1, 0}, {}));
}

}  // namespace
}  // namespace ncsim::machine
