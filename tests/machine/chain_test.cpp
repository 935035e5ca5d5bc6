// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forward kinematics: compared with the kinematics of LinuxCNC (5c41560e, compiled and run; tip in
// W), and with the formula for rotations about the origin.
#include "ncsim/machine/chain.h"

#include "ncsim/base/angles.h"
#include "ncsim/machine/presets.h"

#include "../support/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>

namespace ncsim::machine {
namespace {

constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

std::vector<Joint> linear() {
    return {joint_of('X', false, kX), joint_of('Y', false, kY), joint_of('Z', false, kZ)};
}

// Returns a chain of X, Y, Z, with `part` from the part outwards and `head` towards the tool.
Chain chain_of(std::vector<Joint> part, const std::vector<Joint>& head = {}) {
    for (const Joint& joint : linear())
        part.push_back(joint);
    part.insert(part.end(), head.begin(), head.end());
    return {std::move(part)};
}

// LinuxCNC specifies the position of C and the offset of the cradle axis from C.
Chain trt(Positive positive, Vec3 rotation_point, Vec3 offset, char cradle = 'A') {
    const Vec3 about = cradle == 'A' ? kX : kY;
    return chain_of({joint_of('C', true, kZ, rotation_point, positive),
                     joint_of(cradle, true, about, rotation_point + offset, positive)});
}

void expect_tip(const Chain& chain, const Values& values, Vec3 expected) {
    const Vec3 tip = chain.pose(values).translation;
    EXPECT_NEAR(tip.x, expected.x, 6e-10);
    EXPECT_NEAR(tip.y, expected.y, 6e-10);
    EXPECT_NEAR(tip.z, expected.z, 6e-10);
}

Values at(double x, double y, double z, double a, double b, double c) {
    return {x, y, z, a, b, c, 0, 0, 0};
}

TEST(Chain, TurnsTablesAsLinuxCNCsXyzacTrt) {
    expect_tip(trt(Positive::Part, {}, {}), at(10, 20, 30, 30, 0, 45),
               {29.925118244, 15.782982620, 15.980762114});
    expect_tip(trt(Positive::Tool, {}, {}), at(10, 20, 30, 30, 0, 45),
               {5.430220816, 8.711914808, 35.980762114});
    expect_tip(trt(Positive::Part, {}, {0, 20, 10}), at(10, 20, 30, -71.841, 0, -35.93),
               {7.512840792, 6.674535645, 16.233101057});
}

TEST(Chain, TurnsTablesUnderAToolOfSomeLength) {
    // With all joints at 0 the tip is at Z-50; the program's zero is placed there.
    constexpr double kLength = 50.0;
    const auto tip_of = [](const Chain& chain) { return chain.placed({0, 0, -kLength}, kLength); };
    const auto in_W = [](Vec3 p_M) { return p_M + Vec3{0, 0, kLength}; };
    const Vec3 point{1, 2, 3};
    expect_tip(tip_of(trt(Positive::Part, point, {0, 20, 10})), at(10, 20, 30, -30, 0, 45),
               in_W({31.948613673, 20.220691611, -16.578838325}));
    expect_tip(tip_of(trt(Positive::Tool, point, {0, 20, 10})), at(10, 20, 30, -30, 0, 45),
               in_W({6.113832168, 9.614089893, -14.578838325}));
    expect_tip(tip_of(trt(Positive::Part, point, {-20, 0, 10}, 'B')), at(10, 20, 30, 0, -30, 45),
               in_W({5.677325183, 22.778518939, -30.078838325}));
    const Chain tdr =
        chain_of({joint_of('A', true, kX, point + Vec3{0, 0, 15}), joint_of('B', true, kY, point)});
    expect_tip(tip_of(tdr), at(10, 20, 30, 30, 40, 0),
               in_W({-6.889715035, 36.790512608, -6.258935458}));
}

TEST(Chain, ThePresetsAreThoseMachines) {
    expect_tip(*preset("xyzac-trt"), at(10, 20, 30, 30, 0, 45),
               {29.925118244, 15.782982620, 15.980762114});
    Chain bridge = *preset("bridge-cb");
    for (Joint& joint : bridge.joints) {
        if (joint.turns) joint.through = {0, 0, 250};
    }
    expect_tip(bridge, at(10, 20, 30, 0, -30, 45), {-78.388347648, -68.388347648, 63.493649054});
    for (const Preset& known : presets()) {
        const auto chain = preset(known.name);
        ASSERT_TRUE(chain);
        for (const char letter : {'X', 'Y', 'Z'})
            EXPECT_TRUE(chain->find(letter)) << known.name;
        expect_tip(*chain, at(1, 2, 3, 0, 0, 0), {1, 2, 3});
    }
    EXPECT_FALSE(preset("no such machine"));
}

TEST(Chain, IsPlacedWhereTheProgramsZeroIs) {
    // A table: only the position of the zero relative to the axis matters, for any tool length.
    Chain table = *preset("4axis-a");
    table.joints.front().through = {0, 100, -250};
    for (const double length : {0.0, 80.0}) {
        const Chain placed = table.placed({0, 100, -200}, length);
        expect_tip(placed, at(5, 6, 7, 0, 0, 0), {5, 6, 7});
        // A point 50 mm above the axis is 50 mm behind the axis after a quarter turn.
        expect_tip(placed, at(0, 0, 0, 90, 0, 0), {0, -50, -50});
    }
    // A head: only the offset from the axis to the tip matters, for any zero.
    Chain head = *preset("bridge-cb");
    for (Joint& joint : head.joints) {
        if (joint.turns) joint.through = {0, 0, 150};
    }
    EXPECT_TRUE(head.has_head());
    EXPECT_FALSE(table.has_head());
    for (const Vec3 zero : {Vec3{0, 0, 0}, Vec3{-300, -200, -400}}) {
        const Chain placed = head.placed(zero, 50);
        expect_tip(placed, at(5, 6, 7, 0, 0, 0), {5, 6, 7});
        expect_tip(placed, at(0, 0, 0, 0, -90, 0), {-200, 0, 200});
    }
}

// Returns the pose by rotations A, then B, then C about the origin.
Pose before(const Values& v) {
    Pose X_WT;
    X_WT.translation = {v[0] + v[6], v[1] + v[7], v[2] + v[8]};
    if (v[3] != 0.0) {
        const SinCos a = sin_cos(v[3]);
        X_WT = Pose{{Vec3{1, 0, 0}, Vec3{0, a.cos, -a.sin}, Vec3{0, a.sin, a.cos}}, {}} * X_WT;
    }
    if (v[4] != 0.0) {
        const SinCos b = sin_cos(v[4]);
        X_WT = Pose{{Vec3{b.cos, 0, b.sin}, Vec3{0, 1, 0}, Vec3{-b.sin, 0, b.cos}}, {}} * X_WT;
    }
    if (v[5] != 0.0) {
        const SinCos c = sin_cos(v[5]);
        X_WT = Pose{{Vec3{c.cos, -c.sin, 0}, Vec3{c.sin, c.cos, 0}, Vec3{0, 0, 1}}, {}} * X_WT;
    }
    const bool is_least = v[5] == 0.0 && (v[3] == 0.0 || v[4] == 0.0);
    if (!is_least) X_WT.rows = least_rotation_to(axis_of(X_WT));
    return X_WT;
}

std::array<std::uint64_t, 12> bits(const Pose& pose) {
    std::array<std::uint64_t, 12> all{};
    std::size_t i = 0;
    for (const Vec3& v : {pose.rows[0], pose.rows[1], pose.rows[2], pose.translation}) {
        for (int axis = 0; axis < 3; ++axis)
            all[i++] = std::bit_cast<std::uint64_t>(v[axis]);
    }
    return all;
}

TEST(Chain, TheDefaultOneGivesThePosesOfBeforeBitForBit) {
    test::Random random(1);
    for (int i = 0; i < 200'000; ++i) {
        Values v{};
        for (std::size_t k = 0; k < v.size(); ++k) {
            const bool turns = k >= 3 && k < 6;
            switch (random.between(0, 3)) {
                case 0:
                    v[k] = turns ? 90.0 * static_cast<double>(random.between(-8, 8)) : 0.0;
                    break;
                case 1: v[k] = random.one_in(2) ? 0.0 : -0.0; break;
                default: v[k] = random.within(-500, 500); break;
            }
        }
        ASSERT_EQ(bits(default_chain().pose(v)), bits(before(v))) << i;
    }
}

TEST(Chain, TurnsAboutLeaningAxesAsALinuxCNCNutatingHead) {
    const Chain chain = chain_of(
        {joint_of('A', true, kX, {0, -700, -840})},
        {joint_of('C', true, kZ, {3, 16, 0}), joint_of('B', true, {0, 1, 1}, {0, 11, 210})});
    expect_tip(chain, at(10, 20, 30, 35, 40, 25), {-55.094052894, -670.979317182, 270.812289471});
}

}  // namespace
}  // namespace ncsim::machine
