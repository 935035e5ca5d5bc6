// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collisions of links with links, the part, fixtures and the tool: found at an overlap of 0.01 mm,
// not at a gap of 0.01 mm; along whole motions, and open if a value is unknown.
#include "ncsim/cda/hull.h"
#include "ncsim/cda/separation.h"
#include "ncsim/verify/machine_bodies.h"

#include "free_space.h"
#include "pair_search.h"
#include "support/random.h"
#include "verify/expected.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ncsim::verify_test {
namespace {

using machine::Chain;
using machine::Joint;
using machine::joint_of;
using machine::Positive;
using verify::Certainty;
using verify::Finding;
using verify::LinkBodies;
using verify::LinkBody;
using verify::Setup;

TriangleMesh box(Vec3 a, Vec3 b) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

// Returns both meshes as a single mesh of two shells.
TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

const Joint kX = joint_of('X', false, {1, 0, 0}), kY = joint_of('Y', false, {0, 1, 0}),
            kZ = joint_of('Z', false, {0, 0, 1});
// Axis of the cradle, along X, 20 mm below the program's zero.
const Vec3 kAxis{0, 0, -320};

// Returns a tilting table (A) and a head that moves along X, Y and Z. The program's zero is at (0,
// 0, -300) of the machine; T1 is 80 mm long, so the nose is at Z - 220.
LinkBodies tilting() {
    const Chain cradle{{joint_of('A', true, {1, 0, 0}, kAxis)}};  // by the right hand
    LinkBodies specified;
    specified.part_moved_by = cradle;
    specified.tool_moved_by = {{kX, kY, kZ}};
    // Corners 50 mm from the axis and 30 mm below the axis; the top of the cradle is the bottom of
    // the block.
    specified.links.push_back({"cradle", box({-100, -50, -350}, {100, 50, -310}), cradle});
    specified.links.push_back({"head", box({-40, -40, 0}, {40, 40, 100}), specified.tool_moved_by});
    specified.links.push_back({"column", box({-200, 200, -500}, {200, 240, 100}), {}});
    return specified;
}

Setup setup_of(LinkBodies specified) {
    verify::Setup setup = plain_setup();
    toolpath::Kinematics machine;
    for (Joint joint : specified.part_moved_by.joints) {
        joint.direction = -joint.direction;
        machine.chain.joints.insert(machine.chain.joints.begin(), joint);
    }
    for (const Joint& joint : specified.tool_moved_by.joints)
        machine.chain.joints.push_back(joint);
    machine.zero = {0, 0, -300};
    setup.kinematics = std::make_shared<const toolpath::Kinematics>(machine);
    setup.axes_guess.clear();
    setup.machine.work_zero = machine.zero;
    setup.bodies = std::make_shared<const verify::MachineBodies>(std::move(specified));
    setup.uses_length_offsets = true;
    setup.selection.ignored = {{"over-travel", ""}, {"spindle-off", ""}, {"rapid-in-material", ""}};
    return setup;
}

// T1 is 80 mm long.
const std::string kLength = "G21 G90 G10 L1 P1 Z80\nT1 M6\nG43 H1\n";

std::vector<Finding> collisions(const std::string& program, const Setup& setup) {
    return findings_of(verdict_of(kLength + program, setup), "machine-collision");
}

std::string at_height(double z) {
    return "G0 X120 Y0 Z" + std::to_string(z) + "\n";
}

// Greatest height above the axis that a corner of the cradle reaches: sqrt(50² + 30²).
const double kCorner = std::sqrt(50.0 * 50.0 + 30.0 * 30.0);
// Program Z at which the nose has this height.
const double kTouching = kAxis.z + kCorner + 300.0 - 80.0;

TEST(MachineCollision, AHundredthOfAMillimetreIsFound) {
    // The highest position is inside the motion, at neither end.
    const auto found =
        collisions(at_height(100) + at_height(kTouching - 0.01) + "G0 A180\n", setup_of(tilting()));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    EXPECT_EQ(found[0].message, "the link 'head' meets the link 'cradle'");
    EXPECT_EQ(found[0].place.span.line, 6U);
    ASSERT_TRUE(found[0].quantity);
    EXPECT_NEAR(found[0].quantity->value, 0.01, 1e-4);
    ASSERT_TRUE(found[0].point);
}

TEST(MachineCollision, AHundredthOfAMillimetreBesideIsNone) {
    const auto verdict = verdict_of(
        kLength + at_height(100) + at_height(kTouching + 0.01) + "G0 A180\n", setup_of(tilting()));
    EXPECT_TRUE(findings_of(verdict, "machine-collision").empty());
    EXPECT_FALSE(doubts_of(verdict).contains("uncertain-contact"));
}

TEST(MachineCollision, WhatNobodyCanTellIsOpen) {
    const auto verdict = verdict_of(kLength + at_height(100) + at_height(kTouching) + "G0 A180\n",
                                    setup_of(tilting()));
    const auto found = findings_of(verdict, "machine-collision");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].certainty, Certainty::Within);
    EXPECT_TRUE(doubts_of(verdict).contains("uncertain-contact"));
}

TEST(MachineCollision, IsFoundAtFeedAndAtRapid) {
    const std::string down = at_height(100) + at_height(kTouching - 1.0);
    for (const std::string turn : {"G0 A180\n", "G1 A180 F500\n", "G1 G93 A180 F2\n"}) {
        SCOPED_TRACE(turn);
        EXPECT_EQ(collisions(down + turn, setup_of(tilting())).size(), 1U);
    }
}

TEST(MachineCollision, TheHeadMeetsTheColumnOnItsWayAndNotBeforeIt) {
    // The side of the head is 40 mm from the nose; the column is at Y200.
    const std::string up = "G0 X0 Y0 Z200\n";
    EXPECT_TRUE(collisions(up + "G0 Y159.99\n", setup_of(tilting())).empty());
    const auto found = collisions(up + "G0 Y160.02\nY0\n", setup_of(tilting()));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'head' meets the link 'column'");
    EXPECT_NEAR(found[0].quantity->value, 0.02, 1e-4);
    // Along the column at a distance of 0.01 mm.
    EXPECT_TRUE(collisions(up + "G0 Y159.99\nX100\nZ-100\nX-100\n", setup_of(tilting())).empty());
}

TEST(MachineCollision, NeighboursAreAskedWhereThatIsTold) {
    // The column is fixed on the bed, and so is the bearing of the cradle.
    LinkBodies specified = tilting();
    specified.links[2].mesh = box({-200, 45, -500}, {200, 240, -330});
    const std::string program = "G0 X0 Y-100 Z200\nG0 A5\n";
    EXPECT_TRUE(collisions(program, setup_of(specified)).empty());
    specified.checked_neighbours = {{"column", "cradle"}};
    EXPECT_EQ(collisions(program, setup_of(specified)).size(), 1U);
    specified.ignored = specified.checked_neighbours;
    EXPECT_TRUE(collisions(program, setup_of(specified)).empty());
}

TEST(MachineCollision, TheToolMeetsTheCradle) {
    // T1 has a radius of 5 mm; the cradle ends at X100, 10 mm below the program's zero.
    const std::string aside = "G0 X120 Y0 Z20\nZ-15\n";
    EXPECT_TRUE(collisions(aside + "X105.02\n", setup_of(tilting())).empty());
    const auto found = collisions(aside + "X104.98\n", setup_of(tilting()));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the tool meets the link 'cradle'");
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
}

TEST(MachineCollision, AFixtureIsTurnedIntoTheHead) {
    verify::Setup setup = setup_of(tilting());
    verify::Fixture clamp;
    clamp.name = "clamp";
    clamp.box = {{60, 100, -10}, {100, 140, 0}};
    setup.machine.fixtures = {clamp};
    const auto found = collisions("G0 X30 Y0 Z35\nG0 A90\n", setup);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'head' meets the fixture 'clamp'");
    EXPECT_TRUE(collisions("G0 X30 Y0 Z35\nG0 A-90\n", setup).empty());
}

TEST(MachineCollision, APartsCornerMeetsTheColumn) {
    // The block is 10 mm high and extends 15 mm to either side of X: the distance from the axis to
    // its corner is 25 mm. A closer column blocks the rotation.
    LinkBodies specified = tilting();
    specified.links[0].mesh = {};
    const double reach = std::sqrt(15.0 * 15.0 + 20.0 * 20.0);
    const std::string program = "G0 X0 Y200 Z200\nG0 A90\n";
    specified.links[2].mesh = box({-200, -240, -500}, {200, -reach - 0.01, 100});
    EXPECT_TRUE(collisions(program, setup_of(specified)).empty());
    specified.links[2].mesh = box({-200, -240, -500}, {200, -reach + 0.01, 100});
    const auto found = collisions(program, setup_of(specified));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'column' meets the part");
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    // The point is of the block, in the frame of the part.
    ASSERT_TRUE(found[0].point);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE((*found[0].point)[axis], kBlock.min[axis] - 0.1);
        EXPECT_LE((*found[0].point)[axis], kBlock.max[axis] + 0.1);
    }
}

// The part is the remaining material, so a nose that fits into a pocket may enter the pocket.
TEST(MachineCollision, AHeadDipsIntoAPocketWhereItFits) {
    // A square nose 2 mm above the tip of T1, whose radius is 5 mm.
    const auto with_nose = [](double half) {
        LinkBodies specified = tilting();
        specified.links[1].mesh = box({-half, -half, -78}, {half, half, 100});
        return setup_of(specified);
    };
    const std::string slot = "S1000 M3\nG0 X0 Y0 Z5\nG1 Z-6 F200\nX10\nX0\nG0 Z5\n";
    EXPECT_TRUE(collisions(slot, with_nose(3.5)).empty());  // corner distance 4.95 mm
    const auto found = collisions(slot, with_nose(3.6));    // 5.09 mm
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'head' meets the part");
    EXPECT_EQ(found[0].certainty, Certainty::Certain);
    EXPECT_EQ(found[0].place.span.line, 6U);
}

// An arm ahead of the cutter meets material that the same move removes later. After the motion the
// material is gone, so the verdict is open.
TEST(MachineCollision, WhatGoesAheadOfTheCutterIsNotClear) {
    LinkBodies specified = tilting();
    specified.links[1].mesh = box({20, -2, -78}, {24, 2, 100});
    const std::string slot = "S1000 M3\nG0 X-60 Y0 Z5\nZ-6\nG1 X60 F200\n";
    const auto found = collisions(slot, setup_of(specified));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'head' meets the part");
    EXPECT_EQ(found[0].certainty, Certainty::Within);
    // A body above the cutter follows the cutter.
    specified.links[1].mesh = box({-2, -2, -78}, {2, 2, 100});
    EXPECT_TRUE(collisions(slot, setup_of(specified)).empty());
}

TEST(MachineNearMiss, IsToldWhereAClearanceIs) {
    LinkBodies specified = tilting();
    specified.links[1].clearance_mm = 2.0;
    const std::string program = at_height(100) + at_height(kTouching + 1.0) + "G0 A180\n";
    const auto verdict = verdict_of(kLength + program, setup_of(specified));
    EXPECT_TRUE(findings_of(verdict, "machine-collision").empty());
    const auto found = findings_of(verdict, "machine-near-miss");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].message, "the link 'head' comes closer than 2 mm to the link 'cradle'");
    const auto far = verdict_of(
        kLength + at_height(100) + at_height(kTouching + 2.01) + "G0 A180\n", setup_of(specified));
    EXPECT_TRUE(findings_of(far, "machine-near-miss").empty());
}

TEST(MachineCollision, SaysWhatWasNotAsked) {
    const std::string program = "G0 X0 Y0 Z100\n";
    EXPECT_EQ(skipped_because(verdict_of(program), "machine-collision"),
              "no mesh of a link is specified (machine.toml, [[link]] mesh)");
    LinkBodies specified = tilting();
    specified.links.push_back({"saddle", {}, {{kX}}});
    EXPECT_EQ(skipped_because(verdict_of(program, setup_of(specified)), "machine-collision"),
              "no mesh is specified for the link 'saddle'; the others were verified");
    EXPECT_EQ(skipped_because(verdict_of(program, setup_of(tilting())), "machine-near-miss"),
              "no clearance of a link is specified (machine.toml, [[link]] clearance)");
    verify::Setup nowhere = setup_of(tilting());
    nowhere.machine.work_zero.reset();
    EXPECT_EQ(skipped_because(verdict_of(program, nowhere), "machine-collision"),
              "the position of the work zero (G54) in the machine is not specified");
}

TEST(MachineCollision, LinksCanBeRequired) {
    LinkBodies specified = tilting();
    verify::Setup setup = setup_of(specified);
    setup.required = {"links"};
    EXPECT_FALSE(doubts_of(verdict_of(kLength, setup)).contains("required"));
    specified.links.push_back({"saddle", {}, {{kX}}});
    setup = setup_of(specified);
    setup.required = {"links"};
    EXPECT_TRUE(doubts_of(verdict_of(kLength, setup)).contains("required"));
}

TEST(MachineCollision, ALengthThatNobodyToldIsADoubt) {
    const auto verdict =
        verdict_of("G21 G90\nT1 M6\nG43 H1\nG0 X0 Y0 Z100\nG0 A10\n", setup_of(tilting()));
    EXPECT_TRUE(doubts_of(verdict).contains("length-offset"));
}

// With length 0 no tool is left below the nose; the verdict is a doubt and not clean.
TEST(MachineCollision, ALengthThatLeavesNoToolIsADoubt) {
    const std::string program = "G0 X0 Y0 Z100\nG0 A10\n";
    for (const char* length : {"Z0", "Z-5"}) {
        const auto verdict =
            verdict_of("G21 G90 G10 L1 P1 " + std::string(length) + "\nT1 M6\nG43 H1\n" + program,
                       setup_of(tilting()));
        EXPECT_TRUE(doubts_of(verdict).contains("length-offset")) << length;
    }
    EXPECT_FALSE(
        doubts_of(verdict_of(kLength + program, setup_of(tilting()))).contains("length-offset"));
    // Only the motion without a length is in doubt.
    const auto count = [&](const std::string& after) {
        const auto verdict = verdict_of(
            "G21 G90 G10 L1 P1 Z0\nT1 M6\nG43 H1\nG0 X0 Y0 Z100\n" + after, setup_of(tilting()));
        std::uint64_t sum = 0;
        for (const verify::Doubt& doubt : verdict.doubts)
            sum += doubt.reason == "length-offset" ? doubt.count : 0;
        return sum;
    };
    const std::string known = "G10 L1 P1 Z80\nG43 H1\nG0 A5\n";
    EXPECT_EQ(count(known), count(known + "G0 A10\nG0 A15\nG0 A20\n"));
}

TEST(MachineCollision, AMeshCountsAsItsHullWhereThatWasTold) {
    LinkBodies specified = tilting();
    specified.links[0].mesh =
        both(box({-100, -50, -350}, {100, 50, -310}), box({-100, -20, -340}, {100, 20, -330}));
    const std::string deep = at_height(100) + at_height(kTouching - 5.0) + "G0 A180\n";
    // Bodies of a single mesh may overlap.
    const auto known = collisions(deep, setup_of(specified));
    ASSERT_EQ(known.size(), 1U);
    EXPECT_EQ(known[0].certainty, Certainty::Certain);
    specified.links[0].as_hull = true;
    const auto found = collisions(deep, setup_of(specified));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].certainty, Certainty::Within);
    EXPECT_TRUE(
        collisions(at_height(100) + at_height(kTouching + 0.01) + "G0 A180\n", setup_of(specified))
            .empty());
}

// A shell with inward orientation is not a hole in a body: the shell is refused and replaced by its
// hull.
TEST(MachineCollision, AShellThatIsInsideOutIsRefused) {
    LinkBodies specified = tilting();
    TriangleMesh cradle = box({-100, -50, -350}, {100, 50, -310});
    for (auto& t : cradle.triangles)
        std::swap(t[0], t[1]);
    // The remaining shell of the link, far from all bodies, is larger and has outward orientation.
    specified.links[0].mesh = both(box({-400, -400, -2000}, {400, 400, -1500}), cradle);
    const std::string deep = at_height(100) + at_height(kTouching - 5.0) + "G0 A180\n";
    EXPECT_THROW(setup_of(specified), std::runtime_error);
    specified.links[0].as_hull = true;
    EXPECT_FALSE(collisions(deep, setup_of(specified)).empty());
}

// A mesh with a deviation of up to 0.1 mm does not prove a contact at a smaller depth.
TEST(MachineCollision, WhatAMeshMayBeOffIsOpen) {
    LinkBodies specified = tilting();
    specified.links[0].deflection_mm = 0.1;
    const auto found = [&](double beside) {
        return collisions(at_height(100) + at_height(kTouching + beside) + "G0 A180\n",
                          setup_of(specified));
    };
    ASSERT_EQ(found(0.05).size(), 1U);
    EXPECT_EQ(found(0.05)[0].certainty, Certainty::Within);
    EXPECT_EQ(found(-0.05)[0].certainty, Certainty::Within);
    EXPECT_EQ(found(-0.5)[0].certainty, Certainty::Certain);
    EXPECT_TRUE(found(0.11).empty());
}

// Under tip control the head moves around a tip that rests on the part.
TEST(MachineCollision, TheWayOfTheAxesUnderTipControlCounts) {
    verify::Setup setup = setup_of(tilting());
    gcode::Motion motion;
    const auto place = [](double y, double z, double a) {
        gcode::Position p;
        p.y = gcode::Length::from_mm(y);
        p.z = gcode::Length::from_mm(z);
        p.a = gcode::Angle::from_degrees(a);
        return p;
    };
    motion.action = gcode::Linear{place(0, 100, 0), place(0, 100, 60)};
    motion.coordinates = gcode::Coordinates::Tip;
    motion.length = gcode::Length::from_mm(80.0);
    const toolpath::JointPath path(*setup.kinematics, motion);
    // 120 mm above the axis, turned by 60 degrees: 103.9 mm to the side, 60 mm above.
    const auto values = path.at(1.0);
    ASSERT_TRUE(values);
    EXPECT_NEAR(std::abs((*values)[1]), 120.0 * std::sqrt(3.0) / 2.0, 1e-9);
    EXPECT_NEAR((*values)[2], -320.0 + 60.0 + 80.0, 1e-9);
}

// The axis is 20 mm below the tip, which moves around the axis on an arc.
TEST(PathDeviation, IsTheSagittaOfATurn) {
    verify::Setup setup = setup_of(tilting());
    const std::string turn = "G0 X120 Y0 Z50\nZ0\nG1 A60 F500\n";
    EXPECT_EQ(skipped_because(verdict_of(kLength + turn, setup), "path-deviation"),
              "the allowed deviation of the tip from its line is not specified (machine.toml, "
              "path_deviation)");
    const double sagitta = 20.0 * (1.0 - std::cos(std::numbers::pi / 6));
    setup.machine.path_deviation = sagitta + 0.01;
    EXPECT_TRUE(findings_of(verdict_of(kLength + turn, setup), "path-deviation").empty());
    setup.machine.path_deviation = sagitta - 0.01;
    const Finding f = only(verdict_of(kLength + turn, setup), "path-deviation");
    expect_at(f, 6, sagitta, 1e-3);
    // Rapid moves do not cut.
    const std::string rapid = "G0 X120 Y0 Z50\nZ0\nG0 A60\n";
    EXPECT_TRUE(findings_of(verdict_of(kLength + rapid, setup), "path-deviation").empty());
}

// Returns the distance of two bodies of a single piece each, mm.
double distance(const verify::RigidBody& one, const verify::RigidBody& other,
                const machine::Pose& X, const cda::Lattice& lattice) {
    std::vector<cda::LatticePoint> a, b;
    for (const Vec3& p : one.pieces()[0].outer)
        a.push_back(lattice.round(p));
    for (const Vec3& p : other.pieces()[0].outer)
        b.push_back(lattice.round(X * p));
    // Larger than any distance here.
    return cda::body_distance(a, b, std::int64_t{1} << 35).distance * lattice.unit_mm;
}

// Random bodies on random paths, compared at hundreds of times.
TEST(PairSearch, IsRightAtHundredsOfTimes) {
    test::Random random(11);
    const auto vector = [&](double reach) {
        return Vec3{random.within(-reach, reach), random.within(-reach, reach),
                    random.within(-reach, reach)};
    };
    int clear = 0, certain = 0, open = 0, shallow = 0, kept_apart = 0;
    constexpr cda::Lattice kLattice{1e-4};
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const auto body = [&](Vec3 centre) {
            std::vector<cda::LatticePoint> points;
            for (int k = 0; k < 9; ++k)
                points.push_back(kLattice.round(vector(40.0)));
            const auto hull = cda::convex_hull(points, kLattice, cda::kStockOrigin);
            const auto polytope = cda::ConvexPolytope::of(*hull, kLattice);
            return verify::RigidBody({verify::piece_of(*polytope, kLattice, centre)}, 0.0);
        };
        const verify::RigidBody table = body({0, 0, -330}), head = body({0, 0, 30});
        toolpath::Kinematics machine;
        machine.chain.joints = {joint_of('A', true, vector(1.0), vector(100.0)), kX, kY, kZ};
        machine.zero = {0, 0, -300};
        Joint turns = machine.chain.joints[0];
        turns.direction = -turns.direction;
        gcode::Motion motion;
        const auto place = [&] {
            gcode::Position p;
            p.x = gcode::Length::from_mm(random.within(-60, 60));
            p.y = gcode::Length::from_mm(random.within(-60, 60));
            p.z = gcode::Length::from_mm(random.within(-60, 40));
            p.a = gcode::Angle::from_degrees(random.within(-90, 90));
            return p;
        };
        gcode::Position begin = place(), end = place();
        // Half of the motions are as short as moves in programs, some of them high above.
        if (i % 2 == 0) {
            begin.z = begin.z + gcode::Length::from_mm(i % 4 == 0 ? 60.0 : 0.0);
            end = toolpath::interpolate(begin, end, 0.05);
        }
        motion.action = gcode::Linear{begin, end};
        if (random.one_in(2)) motion.coordinates = gcode::Coordinates::Tip;
        const toolpath::JointPath path(machine, motion);
        const auto from = path.at(0.0), to = path.at(1.0);
        const Chain way = machine::seen_from({{turns}}, {{kX, kY, kZ}});
        const bool of_both = random.one_in(2);
        const verify::PairOnLeg pair{path, from, to, 0.0, way, of_both, {}};
        const verify::Encounter found = verify::find_contact(pair, table, head, kLattice, true);
        bool meets = false;
        double deepest = 0.0;
        // Distance of the bodies at a different position, and the motion from there.
        machine::Values before = *from;
        for (const std::size_t axis : {0U, 1U, 2U, 3U})
            before[axis] += random.within(-3, 3);
        constexpr double kMost = 150.0;
        const verify::FreeSpace space =
            verify::free_space(way, before, table, head, kLattice, kMost);
        const auto ways =
            verify::joint_motion_bounds(before, from, path.joint_motion(0.0, *from, 1.0, *to));
        const double apart = space.apart_mm;
        const machine::Pose X_before = pose_of(way, before);
        const double truly_apart = distance(table, head, X_before, kLattice);
        EXPECT_LE(apart, std::min(kMost, truly_apart));
        EXPECT_GE(apart, std::min(kMost, 0.97 * truly_apart - 0.01));
        double head_strays = 0.0, table_strays = 0.0;
        for (int k = 0; k <= 500; ++k) {
            const auto values = path.at(k / 500.0);
            const machine::Pose X = pose_of(way, *values);
            for (const Vec3& p : head.pieces()[0].outer)
                head_strays = std::max(head_strays, norm(X * p - X_before * p));
            for (const Vec3& p : table.pieces()[0].outer)
                table_strays = std::max(table_strays, norm(inverse(X) * p - inverse(X_before) * p));
            std::vector<cda::LatticePoint> a, b;
            for (const Vec3& p : table.pieces()[0].outer)
                a.push_back(kLattice.round(p));
            for (const Vec3& p : head.pieces()[0].outer)
                b.push_back(kLattice.round(X * p));
            if (cda::body_distance(a, b, 0).is_apart) continue;
            meets = true;
            if (k % 20 != 0) continue;
            const auto turned = [&X](std::vector<Vec3> directions) {
                for (Vec3& d : directions)
                    d = X * d - X.translation;
                return directions;
            };
            const verify::ConvexPiece& one = table.pieces()[0];
            const verify::ConvexPiece& other = head.pieces()[0];
            std::vector<Vec3> corners;
            for (const Vec3& p : other.inner)
                corners.push_back(X * p);
            deepest = std::max(deepest, cda::depth(one.inner, one.directions, corners,
                                                   {turned(other.directions.normals),
                                                    turned(other.directions.edges)}));
        }
        if (stays_separated(space, ways.value(), 0.0)) {
            EXPECT_LT(std::min(head_strays, table_strays), apart);
            EXPECT_FALSE(meets);
            ++kept_apart;
        }
        const bool is_certain = found.closeness == verify::Closeness::Certain;
        if (found.closeness == verify::Closeness::Clear) {
            EXPECT_FALSE(meets);
            ++clear;
        }
        if (meets) {
            EXPECT_NE(found.closeness, verify::Closeness::Clear);
        }
        if (is_certain) {
            EXPECT_GT(found.amount_mm, 0.0);
            ++certain;
            shallow += found.amount_mm < 0.9 * deepest ? 1 : 0;
        }
        open += found.closeness == verify::Closeness::Open ? 1 : 0;
    }
    EXPECT_GT(clear, 30);
    EXPECT_GT(certain, 30);
    EXPECT_EQ(open, 0);
    EXPECT_GT(kept_apart, 5);
    // The search looks for the largest depth without a proof.
    EXPECT_LT(shallow, certain / 20);
}

}  // namespace
}  // namespace ncsim::verify_test
