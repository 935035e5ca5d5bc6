// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/joint_path.h"

#include "ncsim/machine/presets.h"

#include "../support/random.h"
#include "motion/axis_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;
using gcode::Motion;
using gcode::Position;
using test::Random;

Position place(double x, double y, double z, double a = 0.0, double b = 0.0, double c = 0.0) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.a = Angle::from_degrees(a), p.b = Angle::from_degrees(b), p.c = Angle::from_degrees(c);
    return p;
}

Motion straight(const Position& from, const Position& to, bool of_tip) {
    Motion motion;
    motion.action = gcode::Linear{from, to};
    motion.coordinates = of_tip ? gcode::Coordinates::Tip : gcode::Coordinates::Axes;
    motion.length = Length::from_mm(80.0);
    return motion;
}

Kinematics machine_of(std::string_view name, Vec3 pivot = {}) {
    Kinematics machine{*machine::preset(name), {10, 20, -300}};
    for (machine::Joint& joint : machine.chain.joints) {
        if (joint.turns) joint.through = pivot;
    }
    return machine;
}

TEST(JointPath, IsThePlaceOfTheNoseInTheMachine) {
    const Kinematics machine = machine_of("xyzac-trt");
    const Motion motion = straight(place(1, 2, 3), place(5, 6, 7), false);
    const auto values = JointPath(machine, motion).at(1.0);
    ASSERT_TRUE(values);
    EXPECT_EQ((*values)[0], 15.0);
    EXPECT_EQ((*values)[1], 26.0);
    EXPECT_EQ((*values)[2], 7.0 - 300.0 + 80.0);
}

TEST(JointPath, BringsTheTipWhereItIsProgrammed) {
    for (const std::string_view name : {"xyzac-trt", "bridge-cb", "head-b-table-c"}) {
        SCOPED_TRACE(name);
        const Kinematics machine = machine_of(name, {0, 20, -310});
        const Motion motion =
            straight(place(1, 2, 3, 10, 20, 30), place(40, -6, 7, -20, 35, 90), true);
        const JointPath path(machine, motion);
        const machine::Chain placed = machine.chain.placed(machine.zero, 80.0);
        for (const double t : {0.0, 0.3, 1.0}) {
            auto values = path.at(t);
            ASSERT_TRUE(values);
            for (int i = 0; i < 3; ++i)
                (*values)[static_cast<std::size_t>(i)] -= machine.zero[i];
            (*values)[2] -= 80.0;
            const Vec3 tip = placed.pose(*values).translation;
            const Vec3 wanted = Vec3{1, 2, 3} + t * Vec3{39, -8, 4};
            EXPECT_LT(norm(tip - wanted), 1e-8);
        }
    }
}

// W along the tool is done by X, Y and Z of the machine, which has no joint for W.
TEST(JointPath, NoJointMovesAlongTheTool) {
    Kinematics machine = machine_of("bridge-cb", {0, 20, -310});
    machine.chain.joints.push_back(machine::along_tool('W'));
    const machine::Chain placed = machine.chain.placed(machine.zero, 80.0);
    for (const bool of_tip : {false, true}) {
        Position from = place(1, 2, 3, 0, -30, 40), to = place(1, 2, 3, 0, -60, 70);
        from.w = Length::from_mm(12), to.w = Length::from_mm(-15);
        const Motion motion = straight(from, to, of_tip);
        const JointPath path(machine, motion);
        for (const double t : {0.0, 0.4, 1.0}) {
            auto values = path.at(t);
            ASSERT_TRUE(values);
            EXPECT_EQ((*values)[8], 0.0);
            for (int i = 0; i < 3; ++i)
                (*values)[static_cast<std::size_t>(i)] -= machine.zero[i];
            (*values)[2] -= 80.0;
            const Vec3 tip = Poses(&machine, motion).at(interpolate(from, to, t)).translation;
            EXPECT_LT(norm(placed.pose(*values).translation - tip), 1e-8);
        }
    }
}

// Joint positions as the inverse of 5axiskins of LinuxCNC 2.9 computes them, pivot 250.
TEST(JointPath, AlongTheToolAsLinuxCncDoesIt) {
    Kinematics machine = machine_of("bridge-cb", {0, 0, 250});
    machine.zero = {};
    machine.chain.joints.push_back(machine::along_tool('W'));
    Position p = place(10, 20, 30, 0, -30, 45);
    p.w = Length::from_mm(-10);
    Motion motion = straight(p, p, true);
    motion.length = {};
    const auto values = JointPath(machine, motion).at(1.0);
    ASSERT_TRUE(values);
    EXPECT_NEAR((*values)[0], 94.852813742, 6e-10);
    EXPECT_NEAR((*values)[1], 104.852813742, 6e-10);
    EXPECT_NEAR((*values)[2], -12.153903092, 6e-10);
}

// Straight moves, arcs, and tip control, under which all axes follow curves.
TEST(JointPath, TheAxesKeepTheirBounds) {
    Random random(5);
    double closest = 0.0;
    for (int i = 0; i < 1200; ++i) {
        SCOPED_TRACE(i);
        constexpr std::string_view kNames[] = {"xyzac-trt", "xyzbc-trt", "bridge-cb",
                                               "head-b-table-c", "hmc-b"};
        Kinematics machine =
            machine_of(kNames[i % 5], {random.within(-50, 50), random.within(-50, 50), -320});
        if (random.one_in(3)) machine.chain.joints.push_back(machine::along_tool('W'));
        const auto any = [&] {
            const auto mm = [&] { return random.within(-80, 80); };
            const auto degrees = [&] { return random.within(-40, 40); };
            Position p = place(mm(), mm(), mm(), degrees(), degrees(), degrees());
            if (!random.one_in(3)) return p;
            for (const auto axis : {&Position::u, &Position::v, &Position::w})
                p.*axis = Length::from_mm(random.one_in(2) ? 0.0 : 0.3 * mm());
            return p;
        };
        Motion motion = straight(any(), any(), !random.one_in(3));
        if (random.one_in(3)) {
            gcode::Arc arc;
            arc.from = *gcode::start_of(motion);
            arc.to = *gcode::end_of(motion);
            arc.turns = random.one_in(2) ? 1 : -1;
            motion.action = arc;
        }
        const JointPath path(machine, motion);
        const double low = random.within(0.0, 0.5), high = random.within(0.5, 1.0);
        const auto from = path.at(low), to = path.at(high);
        ASSERT_TRUE(from && to);
        const auto joint_motion = path.joint_motion(low, *from, high, *to);
        ASSERT_TRUE(joint_motion);
        const auto xyz = [](const machine::Values& v) { return Vec3{v[0], v[1], v[2]}; };
        for (int k = 1; k < 16; ++k) {
            const double t = k / 16.0;
            const auto now = path.at(low + t * (high - low));
            ASSERT_TRUE(now);
            const Vec3 gone = xyz(*now) - xyz(*from);
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_LE(std::abs(gone[axis]),
                          joint_motion->speed[static_cast<std::size_t>(axis)] + 1e-8);
            ASSERT_LE(norm(gone), joint_motion->all_speed + 1e-8);
            const double bent = norm(gone - t * (xyz(*to) - xyz(*from)));
            ASSERT_LE(bent, joint_motion->bend / 8.0 + 1e-8);
            if (joint_motion->bend > 0.0)
                closest = std::max(closest, 8.0 * bent / joint_motion->bend);
            const Vec3 straight_turn{(*now)[3], (*now)[4], (*now)[5]};
            const Vec3 wanted =
                Vec3{(*from)[3], (*from)[4], (*from)[5]} +
                t * Vec3{(*to)[3] - (*from)[3], (*to)[4] - (*from)[4], (*to)[5] - (*from)[5]};
            ASSERT_LT(norm(straight_turn - wanted), 1e-9);
        }
    }
    EXPECT_GT(closest, 0.8);
}

// Chords are within their stated distance of the curve, and half as many would not be.
TEST(JointPath, SplinesAreNotMoreLegsThanNeeded) {
    for (const double size : {1.0, 10.0, 100.0, 1000.0}) {
        SCOPED_TRACE(size);
        gcode::Spline spline;
        spline.order = 4;
        spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
        const Vec3 points[] = {{0, 0, 0}, {1, 2, 0}, {2, -1, 0}, {3, 1, 0}};
        for (const Vec3& p : points)
            spline.control_points.push_back(
                {Length::from_mm(size * p.x), Length::from_mm(size * p.y), 1.0});
        spline.to = place(3 * size, size, 0);
        Motion motion;
        motion.action = spline;
        const Legs legs = legs_of(motion, RapidPath{});
        const SplineCurve curve(spline);
        const auto farthest = [&](std::size_t chords) {
            double most = 0.0;
            const auto at = [&](double t) { return linear_axes(curve.at(t)); };
            const double n = static_cast<double>(chords);
            for (std::size_t k = 0; k < chords; ++k) {
                const double i = static_cast<double>(k);
                const Vec3 a = at(i / n), b = at((i + 1) / n);
                for (const double t : {0.125, 0.25, 0.5, 0.75, 0.875})
                    most = std::max(most, norm(at((i + t) / n) - a - t * (b - a)));
            }
            return most;
        };
        const std::size_t chords = legs.motions.size();
        EXPECT_LE(farthest(chords), legs.missed_mm);
        if (chords > 4) {
            EXPECT_GT(farthest(chords / 2), 0.5 * legs.missed_mm);
        }
        for (std::size_t k = 0; k < chords; ++k) {
            const Position from = *gcode::start_of(legs.motions[k]);
            EXPECT_EQ(from, k == 0 ? spline.from : *gcode::end_of(legs.motions[k - 1]));
        }
        EXPECT_EQ(*gcode::end_of(legs.motions.back()), spline.to);
    }
}

TEST(JointPath, DogLegsAreLegs) {
    Motion motion = straight(place(0, 0, 0), place(10, 20, 0), false);
    motion.kind = gcode::MoveKind::Rapid;
    EXPECT_EQ(legs_of(motion, RapidPath{}).motions.size(), 1U);
    RapidPath dog_leg;
    dog_leg.dog_leg = true;
    EXPECT_EQ(legs_of(motion, dog_leg).motions.size(), 2U);
    motion.action = gcode::Dwell{};
    EXPECT_TRUE(legs_of(motion, RapidPath{}).motions.empty());
}

}  // namespace
}  // namespace ncsim::toolpath
