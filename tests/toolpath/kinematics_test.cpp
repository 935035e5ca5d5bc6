// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machines from kinematic chains: bounds of the volume that hulls of poses miss and gain.
#include "ncsim/toolpath/kinematics.h"

#include "ncsim/machine/presets.h"
#include "ncsim/toolpath/extent.h"
#include "ncsim/toolpath/sampler.h"
#include "ncsim/toolpath/tool.h"

#include "../support/random.h"
#include "positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::toolpath {
namespace {

using gcode::Length;
using gcode::Position;
using machine::joint_of;

gcode::Motion line(const Position& from, const Position& to, gcode::Coordinates coordinates) {
    gcode::Motion m;
    m.action = gcode::Linear{from, to};
    m.coordinates = coordinates;
    return m;
}

Vec3 direction(test::Random& random) {
    for (;;) {
        const Vec3 v{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)};
        if (const double size = norm(v); size > 0.1 && size < 1.0) return normalized(v);
    }
}

// Returns a machine with one to three rotary joints, at any position in the chain with X, Y and Z.
Kinematics random_machine(test::Random& random) {
    Kinematics specified;
    const Vec3 along[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<std::int64_t> places;
    for (std::int64_t count = random.between(1, 3); count > 0; --count)
        places.push_back(random.between(0, 3));
    std::ranges::sort(places);
    std::size_t next = 0;
    for (std::int64_t i = 0; i <= 3; ++i) {
        for (; next < places.size() && places[next] == i; ++next) {
            const Vec3 through{random.within(-50, 50), random.within(-50, 50),
                               random.within(-50, 50)};
            const Vec3 about = random.one_in(3) ? direction(random) : along[random.between(0, 2)];
            specified.chain.joints.push_back(joint_of("CAB"[next], true, about, through));
        }
        if (i < 3) {
            specified.chain.joints.push_back(
                joint_of("XYZ"[i], false, along[static_cast<std::size_t>(i)]));
        }
    }
    specified.zero = {random.within(-30, 30), random.within(-30, 30), random.within(-30, 30)};
    if (random.one_in(3)) specified.chain.joints.push_back(machine::along_tool('W'));
    return specified;
}

struct Cylinder {
    double radius, height;
};

// Returns the support function of the tool at the pose in direction `d`.
double support(const Pose& X_WT, const Cylinder& tool, Vec3 d) {
    const Vec3 axis = axis_of(X_WT);
    const double lean = dot(axis, d);
    return dot(X_WT.translation, d) + std::max(0.0, tool.height * lean) +
           tool.radius * norm(d - lean * axis);
}

double distance_to(const Pose& X_WT, const Cylinder& tool, Vec3 p) {
    const Vec3 out = p - X_WT.translation;
    const double z = dot(out, axis_of(X_WT));
    const double aside = std::max(0.0, norm(out - z * axis_of(X_WT)) - tool.radius);
    const double above = std::max({0.0, -z, z - tool.height});
    return std::sqrt(aside * aside + above * above);
}

Position interpolate(const Position& a, const Position& b, double t) {
    const auto of = [t](double p, double q) { return p + t * (q - p); };
    Position p = at(of(a.x.mm(), b.x.mm()), of(a.y.mm(), b.y.mm()), of(a.z.mm(), b.z.mm()),
                    of(a.a.degrees(), b.a.degrees()), of(a.b.degrees(), b.b.degrees()),
                    of(a.c.degrees(), b.c.degrees()));
    for (const auto axis : {&Position::u, &Position::v, &Position::w})
        p.*axis = Length::from_mm(of((a.*axis).mm(), (b.*axis).mm()));
    return p;
}

struct Case {
    Kinematics specified;
    gcode::Motion motion;
    Cylinder tool{};
    Samples samples;

    explicit Case(test::Random& random) : specified(random_machine(random)) {
        const auto somewhere = [&](const Position* near) {
            const double way = near ? 8.0 : 30.0;
            const double turn = near ? 25.0 : 180.0;
            const auto of = [&](double from, double by) {
                return random.one_in(3) ? from : from + random.within(-by, by);
            };
            const Position zero;
            const Position& n = near ? *near : zero;
            return at(of(n.x.mm(), way), of(n.y.mm(), way), of(n.z.mm(), way),
                      of(n.a.degrees(), turn), of(n.b.degrees(), turn), of(n.c.degrees(), turn));
        };
        Position from = somewhere(nullptr), to = somewhere(&from);
        if (random.one_in(3)) {
            for (const auto axis : {&Position::u, &Position::v, &Position::w}) {
                from.*axis = Length::from_mm(random.one_in(2) ? 0.0 : random.within(-20, 20));
                to.*axis = random.one_in(2) ? from.*axis : Length::from_mm(random.within(-20, 20));
            }
        }
        const bool of_tip = random.one_in(2);
        motion = line(from, to, of_tip ? gcode::Coordinates::Tip : gcode::Coordinates::Axes);
        motion.length = Length::from_mm(random.within(0, 80));
        tool = {random.within(0.5, 6), random.within(1, 40)};
        SamplingOptions coarse;
        coarse.rotation_miss_mm = random.within(0.05, 1.0);
        coarse.rotation_gain_mm = random.within(0.5, 3.0);
        const ToolExtent extent = extent_of(flat_end_mill(2 * tool.radius, tool.height));
        std::optional<Box> place;
        if (random.one_in(2)) {
            place.emplace();
            place->add(Vec3{random.within(-60, 0), random.within(-60, 0), random.within(-60, 0)});
            place->add(Vec3{random.within(0, 60), random.within(0, 60), random.within(0, 60)});
        }
        samples = sample(motion, extent, coarse, place, &specified);
        where = place;
    }
    std::optional<Box> where;
    Pose pose(double t) const {
        const auto& m = std::get<gcode::Linear>(motion.action);
        return Poses(&specified, motion).at(interpolate(m.from, m.to, t));
    }
};

TEST(SpecifiedMachine, NoSweepIsMissedByMoreThanTheBound) {
    test::Random random(11);
    double worst = 0.0;
    for (int i = 0; i < 100'000; ++i) {
        const Case c(random);
        const auto steps = static_cast<double>(c.samples.poses.size() - 1);
        const auto k = static_cast<std::size_t>(random.between(0, static_cast<int>(steps) - 1));
        const Pose& A = c.samples.poses[k];
        const Pose& B = c.samples.poses[k + 1];
        for (int j = 0; j < 5; ++j) {
            const Pose now = c.pose((static_cast<double>(k) + random.unit()) / steps);
            const Vec3 d = direction(random);
            if (c.where) {  // the bound holds for points in the box only
                const double angle = random.within(0, 6.2831853);
                const Vec3 p =
                    now * Vec3{c.tool.radius * std::cos(angle), c.tool.radius * std::sin(angle),
                               random.within(0, c.tool.height)};
                if (!c.where->contains(p)) continue;
                const double out =
                    dot(p, d) - std::max(support(A, c.tool, d), support(B, c.tool, d));
                ASSERT_LE(out, c.samples.bounds.missed_mm + 1e-9) << i;
                continue;
            }
            const double beyond =
                support(now, c.tool, d) - std::max(support(A, c.tool, d), support(B, c.tool, d));
            ASSERT_LE(beyond, c.samples.bounds.missed_mm + 1e-9) << i;
            if (c.samples.bounds.missed_mm > 1e-6)
                worst = std::max(worst, beyond / c.samples.bounds.missed_mm);
        }
    }
    EXPECT_GT(worst, 0.3) << "the bound is no bound of this";
}

TEST(SpecifiedMachine, NoHullGainsMoreThanTheBound) {
    test::Random random(12);
    double worst = 0.0;
    int judged = 0;
    for (int i = 0; judged < 100'000; ++i) {
        const Case c(random);
        const auto steps = static_cast<double>(c.samples.poses.size() - 1);
        const auto k = static_cast<std::size_t>(random.between(0, static_cast<int>(steps) - 1));
        const PieceExtent whole =
            extent_of(flat_end_mill(2 * c.tool.radius, c.tool.height)).pieces[0];
        if (is_above(whole, c.samples.turning.top_mm)) continue;
        const double height = cut_off(whole, c.samples.turning.top_mm);
        const auto on_tool = [&] {
            const double angle = random.within(0, 6.2831853);
            const double r = random.one_in(2) ? c.tool.radius : random.within(0, c.tool.radius);
            const double z = random.one_in(2) ? height : random.within(0, height);
            return Vec3{r * std::cos(angle), r * std::sin(angle), z};
        };
        // Skipped if the tool is divided into slabs, because each slab has a separate hull.
        if (c.samples.turning.slab_mm < c.tool.height) continue;
        const double s = random.unit();
        const Vec3 x =
            (1 - s) * (c.samples.poses[k] * on_tool()) + s * (c.samples.poses[k + 1] * on_tool());
        if (c.where && !c.where->contains(x)) continue;
        ++judged;
        double nearest = std::numeric_limits<double>::infinity();
        double best = 0.0;
        const auto look = [&](double t) {
            const double d = distance_to(c.pose((static_cast<double>(k) + t) / steps), c.tool, x);
            if (d < nearest) nearest = d, best = t;
        };
        for (int j = 0; j <= 64; ++j)
            look(j / 64.0);
        for (double step = 1 / 128.0; step > 1e-7; step /= 2) {
            const double middle = best;
            look(std::max(0.0, middle - step));
            look(std::min(1.0, middle + step));
        }
        ASSERT_LE(nearest, c.samples.bounds.gained_mm + 1e-6) << i;
        if (c.samples.bounds.gained_mm > 1e-3)
            worst = std::max(worst, nearest / c.samples.bounds.gained_mm);
    }
    EXPECT_GT(worst, 0.1) << "the bound is no bound of this";
}

// For any motion: tools are truncated above the stated height.
TEST(SpecifiedMachine, NoPlaceBesideAToolThatTurnsIsHigherThanItTells) {
    test::Random random(13);
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 10'000; ++i) {
        Case c(random);
        if (!c.where) continue;
        auto& line = std::get<gcode::Linear>(c.motion.action);
        if (random.one_in(2)) line.to = interpolate(line.from, line.to, 0.001);
        if (random.one_in(3)) {
            gcode::Arc arc{line.from, line.to, gcode::Plane::XY, {}, {}, 1, {}};
            arc.centre_1 = Length::from_mm(random.within(-20, 20));
            arc.centre_2 = Length::from_mm(random.within(-20, 20));
            c.motion.action = arc;
        }
        const Kinematics* specified = random.one_in(3) ? nullptr : &c.specified;
        if (!specified) c.motion.coordinates = gcode::Coordinates::Axes;
        const ToolExtent tool = extent_of(flat_end_mill(2 * c.tool.radius, c.tool.height));
        const Samples samples = sample(c.motion, tool, {.max_steps = 50}, c.where, specified);
        for (const Pose& X_WT : samples.poses) {
            const double angle = random.within(0, 6.2831853);
            const double r = c.tool.radius + random.within(0, RotationBounds::kSideMargin);
            const double z = random.within(0, 100);
            if (!c.where->contains(X_WT * Vec3{r * std::cos(angle), r * std::sin(angle), z}))
                continue;
            ASSERT_LE(z, samples.turning.top_mm) << i;
            nearest = std::min(nearest, samples.turning.top_mm - z);
        }
    }
    EXPECT_LT(nearest, 0.5) << "the bound is no bound of this";
}

TEST(SpecifiedMachine, AToolStraysNoFartherThanToldFromWhereItIsAtTheEnds) {
    test::Random random(14);
    double worst = 0.0;
    for (int i = 0; i < 4'000; ++i) {
        Case c(random);
        const auto line = std::get<gcode::Linear>(c.motion.action);
        if (random.one_in(3)) {
            gcode::Arc arc{line.from, line.to, gcode::Plane::XY, {}, {}, 1, {}};
            arc.centre_1 = Length::from_mm(random.within(-20, 20));
            arc.centre_2 = Length::from_mm(random.within(-20, 20));
            c.motion.action = arc;
        }
        const Kinematics* specified = random.one_in(3) ? nullptr : &c.specified;
        if (!specified) c.motion.coordinates = gcode::Coordinates::Axes;
        const Poses poses(specified, c.motion);
        const double reach =
            std::sqrt(c.tool.radius * c.tool.radius + c.tool.height * c.tool.height);
        const double strays = max_deviation_mm(c.motion, poses, reach).value();
        const ToolExtent tool = extent_of(flat_end_mill(2 * c.tool.radius, c.tool.height));
        const Pose A = poses.at(line.from), B = poses.at(line.to);
        for (const Pose& now : sample(c.motion, tool, {.max_steps = 30}, {}, specified).poses) {
            const Vec3 d = direction(random);
            const double beyond =
                support(now, c.tool, d) - std::max(support(A, c.tool, d), support(B, c.tool, d));
            ASSERT_LE(beyond, strays + 1e-9) << i;
            if (strays > 1e-3) worst = std::max(worst, beyond / strays);
        }
    }
    EXPECT_GT(worst, 0.6) << "the bound is no bound of this";
}

// At 15 degrees the tool leaves the upper side of a wide stock at once.
TEST(SpecifiedMachine, AToolIsCutOffWhereItLeavesTheStock) {
    const Box stock{{-100, -100, -30}, {100, 100, 0}};
    const ToolExtent tool = extent_of(flat_end_mill(6, 40));
    const auto top_of = [&](const gcode::Motion& motion, const Kinematics* specified) {
        return sample(motion, tool, {}, stock, specified).turning.top_mm;
    };
    Kinematics specified{*machine::preset("xyzab-table"), {}};
    const gcode::Motion of_tip =
        line(at(0, 0, -5, 15, 0), at(1, 0, -5, 16, 0), gcode::Coordinates::Tip);
    EXPECT_LT(top_of(of_tip, &specified), 8.0);
    EXPECT_GT(top_of(of_tip, &specified), 5.0);
    const gcode::Motion of_axes =
        line(at(0, 0, -5, 15, 0), at(1, 0, -5, 16, 0), gcode::Coordinates::Axes);
    EXPECT_LT(top_of(of_axes, nullptr), 8.0);
}

// A head inclined by 30 degrees drills with W the same hole that a second program drills with X and
// Z.
TEST(SpecifiedMachine, AWordAlongTheToolIsAMoveOfXAndZ) {
    Kinematics specified{*machine::preset("bridge-cb"), {5, 6, 7}};
    for (machine::Joint& joint : specified.chain.joints)
        joint.through = {0, 0, 250};
    specified.chain.joints.push_back(machine::along_tool('W'));
    const double s = 0.5, c = std::sqrt(0.75);
    Position from = at(1, 2, 3, 0, -30, 0), to = from;
    to.w = Length::from_mm(-10);
    for (const auto mode : {gcode::Coordinates::Tip, gcode::Coordinates::Axes}) {
        const gcode::Motion m = line(from, to, mode);
        const Samples samples = sample(m, extent_of(flat_end_mill(6, 40)), {}, {}, &specified);
        ASSERT_EQ(samples.poses.size(), 2U);
        EXPECT_EQ(samples.bounds, SampleBounds{});
        const Vec3 way = samples.poses[1].translation - samples.poses[0].translation;
        EXPECT_LT(norm(way - Vec3{-10 * s, 0, -10 * c}), 1e-12);
        EXPECT_LT(norm(axis_of(samples.poses[1]) - Vec3{s, 0, c}), 1e-15);
        const Box box = extent_of_path(m, {&specified, m});
        if (mode == gcode::Coordinates::Axes) continue;
        EXPECT_LT(norm(box.min - Vec3{1 - 10 * s, 2, 3 - 10 * c}), 1e-12);
        EXPECT_EQ(box.max, (Vec3{1, 2, 3}));
    }
    // With a turned table the spindle also moves along the tool, and along no axis of the part.
    const Kinematics table{*machine::preset("xyzac-trt"), {}};
    Position at_90 = at(1, 2, 3, 90, 0, 0);
    at_90.w = Length::from_mm(-10);
    const Poses poses(&table, line(at_90, at_90, gcode::Coordinates::Tip));
    EXPECT_EQ(poses.place(at_90), (Vec3{1, 2, 3}) - 10.0 * axis_of(poses.at(at_90)));
}

TEST(SpecifiedMachine, TheExtentHoldsTheWayWhateverUVWDo) {
    test::Random random(15);
    for (int i = 0; i < 4'000; ++i) {
        Case c(random);
        const auto line = std::get<gcode::Linear>(c.motion.action);
        if (random.one_in(2)) {
            const gcode::Plane plane = random.one_in(3) ? gcode::Plane::UV : gcode::Plane::XY;
            gcode::Arc arc{line.from, line.to, plane, {}, {}, 1, {}};
            arc.centre_1 = Length::from_mm(random.within(-20, 20));
            arc.centre_2 = Length::from_mm(random.within(-20, 20));
            c.motion.action = arc;
        }
        c.motion.coordinates = gcode::Coordinates::Tip;
        const Poses poses(&c.specified, c.motion);
        const Box box = extent_of_path(c.motion, poses);
        for (const Pose& pose : sample(c.motion, {}, {.max_steps = 40}, {}, &c.specified).poses) {
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(pose.translation[axis], box.min[axis] - 1e-9) << i;
                ASSERT_LE(pose.translation[axis], box.max[axis] + 1e-9) << i;
            }
        }
    }
}

TEST(SpecifiedMachine, TheTipStaysInItsPlaceWhileTheTableTurns) {
    const Kinematics specified{*machine::preset("xyzac-trt"), {}};
    const gcode::Motion turn =
        line(at(10, 20, 30, 0, 0, 0), at(10, 20, 30, -60, 0, 75), gcode::Coordinates::Tip);
    const Samples samples = sample(turn, extent_of(ball_end_mill(3, 20)), {}, {}, &specified);
    ASSERT_GT(samples.poses.size(), 10U);
    for (const Pose& pose : samples.poses)
        EXPECT_EQ(pose.translation, (Vec3{10, 20, 30}));
    EXPECT_LT(
        norm(axis_of(samples.poses.back()) - axis_of(specified.chain.pose({0, 0, 0, -60, 0, 75}))),
        1e-15);
}

// C turns the part under an upright tool. A round tool is invariant under the rotation, so the hull
// is exact.
TEST(SpecifiedMachine, AnUprightToolUnderTipControlOnlyMoves) {
    const Kinematics specified{*machine::preset("xyzac-trt"), {}};
    const Samples samples =
        sample(line(at(0, 0, 0), at(50, 0, 0, 0, 0, 300), gcode::Coordinates::Tip),
               extent_of(flat_end_mill(10, 40)), {}, {}, &specified);
    EXPECT_EQ(samples.poses.size(), 2U);
    EXPECT_EQ(samples.bounds, SampleBounds{});
    EXPECT_EQ(samples.poses.front().rows, samples.poses.back().rows);
}

// The same poses, given as positions of the tip and of the axes.
TEST(SpecifiedMachine, BothModesMeetInTheSamePoses) {
    test::Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Kinematics specified = random_machine(random);
        Position p =
            at(random.within(-50, 50), random.within(-50, 50), random.within(-50, 50),
               random.within(-180, 180), random.within(-180, 180), random.within(-180, 180));
        const gcode::Motion axes = line(p, p, gcode::Coordinates::Axes);
        const Pose X_WT = Poses(&specified, axes).at(p);
        Position tip = p;
        tip.x = Length::from_mm(X_WT.translation.x);
        tip.y = Length::from_mm(X_WT.translation.y);
        tip.z = Length::from_mm(X_WT.translation.z);
        EXPECT_EQ(Poses(&specified, line(tip, tip, gcode::Coordinates::Tip)).at(tip), X_WT);
        // U, V and W move the tip equally in both modes.
        for (const auto axis : {&Position::u, &Position::v, &Position::w})
            p.*axis = tip.*axis = Length::from_mm(random.within(-20, 20));
        const Vec3 by_axes = Poses(&specified, axes).at(p).translation;
        const Vec3 by_tip = Poses(&specified, line(tip, tip, gcode::Coordinates::Tip)).place(tip);
        EXPECT_LT(norm(by_axes - by_tip), 1e-12 * (1.0 + norm(by_axes)));
    }
}

TEST(SpecifiedMachine, WithoutOneThePosesAreThoseOfBefore) {
    const gcode::Motion m =
        line(at(1, 2, 3, 4, 5, 6), at(7, 8, 9, 10, 11, 12), gcode::Coordinates::Axes);
    const Poses poses(nullptr, m);
    EXPECT_EQ(poses.chain(), nullptr);
    EXPECT_EQ(poses.at(at(1, 2, 3, 4, 5, 6)), pose_at(at(1, 2, 3, 4, 5, 6)));
}

}  // namespace
}  // namespace ncsim::toolpath
