// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words that turn the tool, on machines with a specified chain of joints.
#include "ncsim/machine/presets.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/sampler.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ncsim::simulation {
namespace {

using gcode::Motion;
using toolpath::Pose;

// Returns the moves of a program on the machine of `chain`, from the start X0 Y0 Z0.
std::vector<Motion> moves_of(const std::string& program, const machine::Chain& chain,
                             const machine::Travels& travels = {}) {
    setup::JobOptions options;
    options.start = Vec3{0, 0, 0};
    Plan plan;
    plan.job = setup::job_of({"a.nc",
                              "(T1 D=6. CR=0. - flat end mill)\n"
                              "(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\nG21 G90 G17 T1 M6\n"
                              "G0 X0 Y0 Z0\n" +
                                  program},
                             options);
    plan.job.interpreter.tip_control.m_codes = {{428, gcode::Coordinates::Tip},
                                                {429, gcode::Coordinates::Axes}};
    plan.kinematics.emplace();
    plan.kinematics->chain = chain;
    plan.kinematics->travels = travels;
    survey(plan);
    std::vector<Motion> moves;
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const Motion& motion) {
        if (start_of(motion)) moves.push_back(motion);
    });
    return moves;
}

machine::Chain with_iso_signs(machine::Chain chain) {
    for (machine::Joint& joint : chain.joints) {
        const Vec3& u = joint.direction;
        if (joint.turns && (u.x < 0 || u.y < 0 || u.z < 0)) joint.direction = -u;
    }
    return chain;
}

const std::string kPlane = "G68.2 X0 Y0 Z0 I30 J40 K-20\nG53.1\n";

TEST(Orientation, OfATableAndOfAHead) {
    const auto table = moves_of(kPlane, with_iso_signs(*machine::preset("xyzac-trt")));
    EXPECT_NEAR(end_of(table.back())->a.degrees(), 40, 1e-9);
    EXPECT_NEAR(end_of(table.back())->c.degrees(), 30, 1e-9);
    const auto head = moves_of(kPlane, with_iso_signs(*machine::preset("bridge-cb")));
    EXPECT_NEAR(end_of(head.back())->b.degrees(), 40, 1e-9);
    EXPECT_NEAR(end_of(head.back())->c.degrees(), -60, 1e-9);
    const auto other =
        moves_of(kPlane, with_iso_signs(*machine::preset("bridge-cb")), {{'C', {0, 180}}});
    EXPECT_NEAR(end_of(other.back())->b.degrees(), -40, 1e-9);
    EXPECT_NEAR(end_of(other.back())->c.degrees(), 120, 1e-9);
}

// On each machine, the tip reaches the position in the plane, and the tool is perpendicular to the
// plane.
TEST(Orientation, IsTheSameOnThePartOnEveryMachine) {
    for (const char* name :
         {"xyzac-trt", "xyzbc-trt", "bridge-cb", "head-b-table-c", "nutating-cb"}) {
        machine::Chain chain = *machine::preset(name);
        for (machine::Joint& joint : chain.joints) {
            if (joint.turns) joint.through = {3, -4, -120};
        }
        const auto moves = moves_of(
            "G0 Z50\nG68.2 X10 Y20 Z-5 I30 J40 K-20\nG53.1\nG0 X1 Y2 Z3\n"
            "G1 Z2 F100\nG69\nG1 X5\n",
            chain);
        ASSERT_EQ(moves.size(), 6U) << name;
        const gcode::FeatureFrame frame =
            gcode::turn_about(2, 30) * gcode::turn_about(0, 40) * gcode::turn_about(2, -20);
        const toolpath::Kinematics placed{chain, {}};
        const Pose X_WT = toolpath::Poses(&placed, moves[4]).at(*end_of(moves[4]));
        const gcode::Triple tip = frame.direction_to_parent({1, 2, 2}), axis = frame.normal();
        EXPECT_LT(norm(X_WT.translation - Vec3{tip[0] + 10, tip[1] + 20, tip[2] - 5}), 1e-9);
        EXPECT_LT(norm(axis_of(X_WT) - Vec3{axis[0], axis[1], axis[2]}), 1e-9) << name;
        // Each move starts at the end of the previous move, in either mode of coordinates.
        for (std::size_t i = 1; i < moves.size(); ++i) {
            const Pose before = toolpath::Poses(&placed, moves[i - 1]).at(*end_of(moves[i - 1]));
            const Pose after = toolpath::Poses(&placed, moves[i]).at(*start_of(moves[i]));
            EXPECT_LT(norm(before.translation - after.translation), 1e-9) << name << " " << i;
        }
    }
}

// The offset of the tip by U, V and W is the same in both modes of coordinates.
TEST(Orientation, TheTipStaysWhereItIsWhenTheModeChanges) {
    machine::Chain quill = *machine::preset("bridge-cb");
    for (machine::Joint& joint : quill.joints)
        joint.through = {0, 0, 100};
    quill.joints.push_back(machine::along_tool('W'));
    for (const machine::Chain& chain : {*machine::preset("xyzbc-trt"), quill}) {
        const auto moves = moves_of("G0 B30 C20 W5 U2\nM428\nG91 G1 Z1 F100\nM429\nG1 X1\n", chain);
        const toolpath::Kinematics placed{chain, {}};
        ASSERT_GE(moves.size(), 3U);
        for (std::size_t i = moves.size() - 2; i < moves.size(); ++i) {
            const Motion &before = moves[i - 1], &after = moves[i];
            EXPECT_NE(before.coordinates, after.coordinates);
            const Pose end = toolpath::Poses(&placed, before).at(*end_of(before));
            const Pose start = toolpath::Poses(&placed, after).at(*start_of(after));
            EXPECT_LT(norm(end.translation - start.translation), 1e-9) << i;
        }
    }
}

TEST(Orientation, AnArcInAPlaneIsRoundOnThePart) {
    const auto moves =
        moves_of(kPlane + "G0 X10 Y0 Z0\nG3 X0 Y10 I-10 F100\n", *machine::preset("xyzac-trt"));
    const toolpath::Kinematics placed{*machine::preset("xyzac-trt"), {}};
    const toolpath::Samples samples =
        toolpath::sample(moves.back(), {}, {.chord_tolerance_mm = 0.001}, {}, &placed);
    EXPECT_GT(samples.poses.size(), 50U);
    const gcode::FeatureFrame frame =
        gcode::turn_about(2, 30) * gcode::turn_about(0, 40) * gcode::turn_about(2, -20);
    const Box box = toolpath::extent_of_path(moves.back(), {nullptr, moves.back()});
    for (const Pose& pose : samples.poses) {
        const gcode::Triple p =
            frame.from_parent({pose.translation.x, pose.translation.y, pose.translation.z});
        EXPECT_NEAR(p[0] * p[0] + p[1] * p[1], 100, 1e-9);
        EXPECT_NEAR(p[2], 0, 1e-9);
        EXPECT_GE(p[0], -1e-9);
        EXPECT_GE(p[1], -1e-9);
        EXPECT_TRUE(box.contains(pose.translation));
    }
}

}  // namespace
}  // namespace ncsim::simulation
