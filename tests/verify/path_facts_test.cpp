// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facts about a single path: lengths and radii, positions in the machine, what passes above all
// bodies, and which moves need a tool length.
#include "path_facts.h"

#include "ncsim/machine/presets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>

namespace ncsim::verify {
namespace {

using gcode::Length;
using gcode::MoveKind;
using gcode::Position;

Position at(double x, double y, double z) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    return p;
}

gcode::Motion line(const Position& from, const Position& to, MoveKind kind = MoveKind::Rapid) {
    gcode::Motion motion;
    motion.action = gcode::Linear{from, to};
    motion.kind = kind;
    return motion;
}

/// A block from Z-10 to Z0, and a fixture up to Z5 with a clearance of 2 mm.
class PathFactsTest : public testing::Test {
protected:
    PathFactsTest() {
        Fixture jaw;
        jaw.name = "jaw";
        jaw.box = {{50, 0, -10}, {60, 10, 5}};
        jaw.clearance_mm = 2.0;
        setup_.machine.fixtures.push_back(jaw);
        setup_.home_z = 300.0;
    }

    /// Facts of a motion after `first`, which may be null.
    Move facts(const gcode::Motion& motion, const gcode::Motion* first = nullptr) {
        PathFacts paths(setup_, {{0, 0, -10}, {40, 30, 0}});
        paths.set_frame(frame_);
        FindingLog log(setup_);
        if (first) take(paths, *first, log);
        Move move = take(paths, motion, log);
        Verdict verdict;
        log.finish(verdict);
        doubts_ = verdict.doubts.size();
        return move;
    }
    bool passes(const gcode::Motion& motion) { return facts(motion).passes_above; }

    verify::Setup setup_;
    gcode::ProgramFrame frame_;
    std::size_t doubts_ = 0;

private:
    static Move take(PathFacts& paths, const gcode::Motion& motion, FindingLog& log) {
        Move move;
        move.motion = &motion;
        move.is_move = true;
        paths.take(move, *gcode::start_of(motion), *gcode::end_of(motion), log);
        return move;
    }
};

TEST_F(PathFactsTest, LengthDirectionAndRadius) {
    const gcode::Motion straight = line(at(1, 2, 3), at(4, 6, 15));
    const Move move = facts(straight);
    EXPECT_EQ(move.length_mm, 13.0);
    EXPECT_EQ(move.enters, (Vec3{3.0 / 13, 4.0 / 13, 12.0 / 13}));
    EXPECT_EQ(move.leaves, move.enters);
    EXPECT_EQ(move.path, (Box{{1, 2, 3}, {4, 6, 15}}));
    EXPECT_EQ(move.radius_mm, 0.0);
    gcode::Motion round;
    gcode::Arc arc;
    arc.from = at(10, 0, 0), arc.to = at(0, 10, 0);
    round.action = arc;
    const Move curved = facts(round);
    EXPECT_NEAR(curved.length_mm, 5 * std::numbers::pi, 0.02);
    EXPECT_NEAR(curved.radius_mm, 10.0, 1e-9);
    EXPECT_NEAR(curved.enters.y, 1.0, 0.01);
    EXPECT_NEAR(curved.leaves.x, -1.0, 0.01);
    EXPECT_NEAR(norm(curved.enters), 1.0, 1e-12);
}

TEST_F(PathFactsTest, RadiusIsTheSmallerOneInEachPlane) {
    struct Row {
        gcode::Plane plane;
        Length Position::*first;
        Length Position::*second;
    };
    for (const Row& row : {Row{gcode::Plane::XY, &Position::x, &Position::y},
                           Row{gcode::Plane::ZX, &Position::z, &Position::x},
                           Row{gcode::Plane::YZ, &Position::y, &Position::z},
                           Row{gcode::Plane::UV, &Position::u, &Position::v},
                           Row{gcode::Plane::WU, &Position::w, &Position::u},
                           Row{gcode::Plane::VW, &Position::v, &Position::w}}) {
        for (const bool shrinks : {false, true}) {
            gcode::Arc arc;
            arc.plane = row.plane;
            arc.centre_1 = Length::from_mm(2), arc.centre_2 = Length::from_mm(3);
            Position near, far;
            near.*row.first = Length::from_mm(2 + 3), near.*row.second = Length::from_mm(3 + 4);
            far.*row.first = Length::from_mm(2 - 6), far.*row.second = Length::from_mm(3 + 8);
            arc.from = shrinks ? far : near, arc.to = shrinks ? near : far;
            gcode::Motion motion;
            motion.action = arc;
            EXPECT_NEAR(facts(motion).radius_mm, 5.0, 1e-6);
        }
    }
}

TEST_F(PathFactsTest, AnUnknownStartHasNoLength) {
    gcode::Motion motion = line(at(1, 2, 3), at(4, 6, 15));
    motion.known_start.y = false;
    const Move move = facts(motion);
    EXPECT_EQ(move.length_mm, 0.0);
    EXPECT_EQ(move.path, (Box{{4, 6, 15}, {4, 6, 15}}));
}

TEST_F(PathFactsTest, BoxOfAllPathsGrows) {
    const gcode::Motion first = line(at(0, 0, 50), at(10, 0, 50));
    const gcode::Motion second = line(at(10, 0, 50), at(10, 20, 60));
    const Move move = facts(second, &first);
    EXPECT_EQ(move.previous_path_box, (Box{{0, 0, 50}, {10, 0, 50}}));
    EXPECT_EQ(move.way, (Box{{0, 0, 50}, {10, 20, 60}}));
}

TEST_F(PathFactsTest, PlaceInTheMachineIncludesTheToolOffset) {
    const gcode::Motion motion = line(at(0, 0, 5), at(10, 0, 5));
    EXPECT_FALSE(facts(motion).machine_path);
    setup_.machine.work_zero = Vec3{-100, -200, -300};
    EXPECT_EQ(facts(motion).machine_path, (Box{{-100, -200, -295}, {-90, -200, -295}}));
    frame_.tool_offset[gcode::kX] = 1.0;
    frame_.tool_offset[gcode::kZ] = 2.0;
    EXPECT_EQ(facts(motion).machine_path, (Box{{-99, -200, -293}, {-89, -200, -293}}));
    frame_.inches = true;
    EXPECT_EQ(facts(motion).machine_path,
              (Box{{-100 + 25.4, -200, -295 + 50.8}, {-90 + 25.4, -200, -295 + 50.8}}));
    EXPECT_NEAR(facts(motion).length_offset, 50.8, 1e-12);
    gcode::Motion open = motion;
    open.known_end.x = false;
    EXPECT_FALSE(facts(open).machine_path);
}

TEST_F(PathFactsTest, TravelsOfTiltedTipsAreADoubtOnlyWithTravels) {
    setup_.kinematics = std::make_shared<const toolpath::Kinematics>(
        toolpath::Kinematics{*machine::preset("head-b-table-c"), {}});
    gcode::Motion motion = line(at(0, 0, 5), at(10, 0, 5), MoveKind::Feed);
    motion.coordinates = gcode::Coordinates::Tip;
    EXPECT_FALSE(facts(motion).is_tilted_tip) << "rotary axes at 0";
    auto& linear = std::get<gcode::Linear>(motion.action);
    linear.from.b = linear.to.b = gcode::Angle::from_degrees(30);
    EXPECT_TRUE(facts(motion).is_tilted_tip);
    EXPECT_EQ(doubts_, 0U);
    EXPECT_TRUE(facts(motion).way.is_empty());
    setup_.machine.travel[1] = AxisRange{0, 100};
    EXPECT_FALSE(facts(motion).machine_path);
    EXPECT_EQ(doubts_, 1U);
    setup_.machine.work_zero = Vec3{};
    EXPECT_FALSE(facts(motion).machine_path) << "a head that leans needs a tool length";
    motion.length = Length::from_mm(80);
    setup_.axes_guess.clear();
    EXPECT_TRUE(facts(motion).machine_path);
    EXPECT_EQ(doubts_, 0U);
}

TEST_F(PathFactsTest, PassesAboveTheFixtureWithItsClearance) {
    // The fixture ends at Z5 + 2.
    EXPECT_FALSE(passes(line(at(0, 0, 7), at(90, 0, 7))));
    EXPECT_TRUE(passes(line(at(0, 0, 7.001), at(90, 0, 7.001))));
    EXPECT_FALSE(passes(line(at(0, 0, 50), at(90, 0, 7))));
    EXPECT_FALSE(passes(line(at(0, 0, 7), at(90, 0, 50))));
    EXPECT_TRUE(passes(line(at(0, 0, 1), at(0, 0, 1)))) << "no motion";
    gcode::Motion motion = line(at(0, 0, 50), at(90, 0, 50));
    motion.start_assumed = true;
    EXPECT_FALSE(passes(motion));
    motion.start_assumed = false;
    motion.offset_unknown = true;
    EXPECT_FALSE(passes(motion));
    motion.offset_unknown = false;
    motion.known_start.z = false;
    EXPECT_FALSE(passes(motion));
    motion.known_start.z = true;
    motion.known_end.z = false;
    EXPECT_FALSE(passes(motion));
    motion = line(at(0, 0, 50), at(90, 0, 50));
    std::get<gcode::Linear>(motion.action).to.a = gcode::Angle::from_degrees(1);
    EXPECT_FALSE(passes(motion)) << "the table turns";
}

TEST_F(PathFactsTest, PassesAboveOnTheWayHome) {
    gcode::Motion home = line(at(3, 4, 0), at(3, 4, 300));
    home.machine_coordinates = true;
    EXPECT_TRUE(passes(home));
    std::get<gcode::Linear>(home.action).to.z = Length::from_mm(299.9);
    EXPECT_FALSE(passes(home)) << "below the reference point";
    home = line(at(3, 4, 0), at(3, 5, 300));
    home.machine_coordinates = true;
    EXPECT_FALSE(passes(home)) << "sideways from below";
    home = line(at(3, 4, 50), at(3, 5, 300));
    home.machine_coordinates = true;
    EXPECT_TRUE(passes(home));
    home = line(at(3, 4, 50), at(3, 5, 60));
    home.machine_coordinates = true;
    EXPECT_TRUE(passes(home));
    setup_.home_assumption = "the zero of the machine is 300 mm above";
    EXPECT_FALSE(passes(home)) << "the place of the machine is assumed";
}

TEST_F(PathFactsTest, TheFirstLiftComesFromAbove) {
    gcode::Motion lift = line(at(0, 0, 0), at(0, 0, 15));
    lift.known_start = {false, false, false};
    lift.known_end = {false, false, true};
    EXPECT_TRUE(passes(lift));
    std::get<gcode::Linear>(lift.action).to.z = Length::from_mm(7);
    EXPECT_FALSE(passes(lift)) << "as high as the fixture";
    std::get<gcode::Linear>(lift.action).to.z = Length::from_mm(15);
    const gcode::Motion good = lift;
    lift.kind = MoveKind::Feed;
    EXPECT_FALSE(passes(lift));
    lift = good, lift.known_end.x = true;
    EXPECT_FALSE(passes(lift)) << "sideways";
    lift = good, lift.offset_unknown = true;
    EXPECT_FALSE(passes(lift));
    lift = good, lift.start_assumed = true;
    EXPECT_FALSE(passes(lift));
    lift = good, lift.machine_coordinates = true;
    EXPECT_FALSE(passes(lift));
}

TEST_F(PathFactsTest, MovesThatDescendOrCutNeedALength) {
    const auto needs = [this](gcode::Motion motion) { return facts(motion).needs_length; };
    EXPECT_FALSE(needs(line(at(0, 0, 5), at(9, 0, 5))));
    EXPECT_FALSE(needs(line(at(0, 0, 5), at(9, 0, 6))));
    EXPECT_TRUE(needs(line(at(0, 0, 5), at(9, 0, 4.999))));
    EXPECT_TRUE(needs(line(at(0, 0, 5), at(9, 0, 5), MoveKind::Feed)));
    EXPECT_TRUE(needs(line(at(0, 0, 50), at(9, 0, 50), MoveKind::Probe)));
    EXPECT_FALSE(needs(line(at(0, 0, 50), at(9, 0, 50), MoveKind::Feed))) << "above all bodies";
    gcode::Motion motion = line(at(0, 0, 5), at(9, 0, 4));
    motion.machine_coordinates = true;
    EXPECT_FALSE(needs(motion));
    motion = line(at(0, 0, 0), at(9, 0, 4));
    motion.known_start.z = false;
    EXPECT_TRUE(needs(motion)) << "Z is set for the first time";
    motion.known_end.z = false;
    EXPECT_FALSE(needs(motion));
}

TEST_F(PathFactsTest, PositionsOfTheMachineAreOfTheSpindleNose) {
    gcode::Motion machine = line(at(0, 0, 50), at(0, 0, 90));
    machine.machine_coordinates = true;
    const Move up = facts(machine);
    EXPECT_FALSE(up.starts_at_nose);
    EXPECT_TRUE(up.ends_at_nose);
    const gcode::Motion across = line(at(0, 0, 90), at(9, 0, 90));
    const Move sideways = facts(across, &machine);
    EXPECT_TRUE(sideways.starts_at_nose);
    EXPECT_TRUE(sideways.ends_at_nose) << "Z stays where the machine has it";
    const gcode::Motion down = line(at(0, 0, 90), at(0, 0, 80));
    EXPECT_FALSE(facts(down, &machine).ends_at_nose);
    gcode::Motion level = line(at(0, 0, 50), at(9, 0, 50));
    level.machine_coordinates = true;
    EXPECT_FALSE(facts(level).ends_at_nose) << "X of the machine says nothing about Z";
    gcode::Motion same = line(at(0, 0, 50), at(0, 0, 50));
    same.machine_coordinates = true;
    EXPECT_TRUE(facts(same).ends_at_nose);
}

TEST_F(PathFactsTest, ToolLengthIsThatOfTheToolOrOfItsRegister) {
    const auto length = [this](std::optional<double> tool, int number, bool specified) {
        frame_.tool_length = tool;
        frame_.length_register = number;
        frame_.length_specified = specified;
        PathFacts paths(setup_, {});
        paths.set_frame(frame_);
        gcode::Motion motion = line(at(0, 0, 0), at(1, 0, 0));
        motion.length = Length::from_mm(80);
        return paths.tool_length(motion);
    };
    EXPECT_TRUE(length({}, gcode::kNoLength, false).nose_known == setup_.uses_length_offsets);
    setup_.uses_length_offsets = true;
    EXPECT_TRUE(length({}, gcode::kNoLength, true).nose_known);
    EXPECT_FALSE(length({}, gcode::kNoLength, true).gauge_mm);
    EXPECT_FALSE(length({}, 3, false).nose_known);
    EXPECT_TRUE(length({}, 3, true).nose_known);
    EXPECT_EQ(length({}, 3, true).gauge_mm, 80.0);
    EXPECT_EQ(length(75.0, 3, true).gauge_mm, 75.0);
    EXPECT_FALSE(length({}, 3, false).gauge_mm);
}

}  // namespace
}  // namespace ncsim::verify
