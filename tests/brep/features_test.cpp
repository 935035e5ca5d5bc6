// SPDX-License-Identifier: GPL-3.0-or-later
//
// Features of small parts, with the sizes that a calliper and a depth gauge measure.
#include "ncsim/brep/features.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/triangulate.h"

#include "brep/made_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace ncsim::brep {
namespace {

using test::Made;

constexpr double kExact = 1e-9;

Features measured(const Made& made) {
    const TriangleMesh mesh = cda::triangulate(made.boundary);
    return features_of(made.solid.part, TriangleTree(mesh));
}

Features measured(const std::string& name, const std::string& moves, bool is_bar = false) {
    return measured(test::make_part(name, moves, 0.05, 0, is_bar));
}

std::vector<double> lengths(const Features& features, bool is_void) {
    std::vector<double> mm;
    for (const Distance& d : features.distances) {
        if (d.is_void == is_void) mm.push_back(std::round(d.mm * 1e9) / 1e9);
    }
    return mm;
}

void expect_at(Vec3 p, Vec3 expected) {
    EXPECT_NEAR(p.x, expected.x, kExact);
    EXPECT_NEAR(p.y, expected.y, kExact);
    EXPECT_NEAR(p.z, expected.z, kExact);
}

TEST(Features, ADrilledHole) {
    const Features f = measured("drill", "T2 M6\nG0 X40 Y30 Z5\nG1 Z-10\nG0 Z5\n");
    ASSERT_EQ(f.bores.size(), 1U);
    const Bore& bore = f.bores.front();
    EXPECT_NEAR(bore.diameter, 6.0, kExact);
    expect_at(bore.mouth, {40, 30, 0});
    EXPECT_EQ(bore.end, BoreEnd::Cone);
    // The tip of 118 degrees is 3 / tan 59 high.
    EXPECT_NEAR(bore.depth, 10.0 - 3.0 / std::tan(59.0 * std::numbers::pi / 180.0), kExact);
    EXPECT_NEAR(bore.tip_depth.value(), 10.0, kExact);
    EXPECT_NEAR(bore.tip_angle_degrees.value(), 118.0, 1e-9);
    EXPECT_EQ(bore.covers_degrees, 360.0);
    EXPECT_TRUE(f.countersinks.empty()) << "the tip of a drilled hole";
}

// The cutter of 90° has its tip 4 mm deep, so its cone is 8 mm wide at the top and meets the bore
// of 6 mm at a depth of 1 mm.
TEST(Features, ACountersunkBoreAndASpot) {
    const Features f =
        measured("countersink",
                 "T2 M6\nG0 X40 Y30 Z5\nG1 Z-12\nG0 Z5\nT5 M6\nG0 X40 Y30\nG1 Z-4\nG0 Z5\n"
                 "G0 X20 Y20\nG1 Z-3\nG0 Z5\n");
    ASSERT_EQ(f.bores.size(), 1U);
    expect_at(f.bores[0].mouth, {40, 30, -1});
    ASSERT_EQ(f.countersinks.size(), 2U);
    const Countersink& sink = f.countersinks[0];
    EXPECT_NEAR(sink.diameter, 8.0, kExact);
    EXPECT_NEAR(sink.depth, 1.0, kExact);
    EXPECT_NEAR(sink.angle_degrees, 90.0, kExact);
    EXPECT_EQ(sink.covers_degrees, 360.0);
    EXPECT_FALSE(sink.has_tip);
    expect_at(sink.mouth, {40, 30, 0});
    expect_at(sink.axis, {0, 0, 1});
    const Countersink& spot = f.countersinks[1];
    EXPECT_NEAR(spot.diameter, 6.0, kExact);
    EXPECT_NEAR(spot.depth, 3.0, kExact);
    EXPECT_TRUE(spot.has_tip);
    expect_at(spot.mouth, {20, 20, 0});
    EXPECT_TRUE(f.chamfers.empty());
}

// The tip of the cutter of 90° passes 3 mm off the edge, 4 mm deep. The other three edges stay
// sharp, and a groove of the same cutter has no chamfer.
TEST(Features, AChamferedEdgeAndAGroove) {
    const Features f = measured("chamfer",
                                "T5 M6\nG0 X-10 Y-3 Z5\nG1 Z-4\nG1 X90\nG0 Z5\n"
                                "G0 X-10 Y30\nG1 Z-2\nG1 X90\nG0 Z5\n");
    ASSERT_EQ(f.chamfers.size(), 1U);
    const Chamfer& chamfer = f.chamfers[0];
    EXPECT_NEAR(chamfer.width, 1.0, kExact);
    EXPECT_NEAR(chamfer.height, 1.0, kExact);
    EXPECT_NEAR(chamfer.angle_degrees, 45.0, kExact);
    EXPECT_NEAR(chamfer.length, 80.0, kExact);
    expect_at(chamfer.at, {40, 1, 0});
    EXPECT_TRUE(f.countersinks.empty());
}

// A boss of 30 mm with its upper edge broken by the same cutter: a cone of material.
TEST(Features, AChamferedBoss) {
    const Features f = measured("chamfered_boss",
                                "T1 M6\nG0 X60 Y30 Z5\nG1 Z-6\nG2 X60 Y30 I-20 J0\nG0 Z5\n"
                                "T5 M6\nG0 X57 Y30\nG1 Z-3\nG2 X57 Y30 I-17 J0\nG0 Z5\n");
    ASSERT_EQ(f.bosses.size(), 1U);
    EXPECT_NEAR(f.bosses[0].height, 5.0, kExact);
    ASSERT_EQ(f.chamfers.size(), 1U);
    EXPECT_NEAR(f.chamfers[0].width, 1.0, kExact);
    EXPECT_NEAR(f.chamfers[0].height, 1.0, kExact);
    EXPECT_NEAR(f.chamfers[0].angle_degrees, 45.0, kExact);
}

TEST(Features, ABoreThroughAndOneThatIsMilledToAShoulder) {
    const Features f =
        measured("bores",
                 "T1 M6\nG0 X45 Y30 Z5\nG1 Z-25\nG3 X45 Y30 I-5 J0\nG0 Z5\nG0 X50 Y30\nG1 Z-5\n"
                 "G3 X50 Y30 I-10 J0\nG0 Z5\n");
    ASSERT_EQ(f.bores.size(), 2U);
    EXPECT_NEAR(f.bores[0].diameter, 20.0, kExact);
    EXPECT_EQ(f.bores[0].end, BoreEnd::Through);
    EXPECT_NEAR(f.bores[0].depth, 15.0, kExact);
    expect_at(f.bores[0].mouth, {40, 30, -5});
    EXPECT_NEAR(f.bores[1].diameter, 30.0, kExact);
    EXPECT_EQ(f.bores[1].end, BoreEnd::Shoulder);
    EXPECT_NEAR(f.bores[1].depth, 5.0, kExact);
    expect_at(f.bores[1].mouth, {40, 30, 0});
    expect_at(f.bores[1].axis, {0, 0, 1});
}

TEST(Features, BlindBoresByTheirBottoms) {
    const Features f =
        measured("bottoms",
                 "T1 M6\nG0 X15 Y30 Z5\nG1 Z-7\nG0 Z5\nT3 M6\nG0 X40 Y30\nG1 Z-9\nG0 Z5\n"
                 "T4 M6\nG0 X65 Y30\nG1 Z-6\nG0 Z5\n");
    ASSERT_EQ(f.bores.size(), 3U);
    EXPECT_EQ(f.bores[0].end, BoreEnd::Flat);
    EXPECT_NEAR(f.bores[0].depth, 7.0, kExact);
    EXPECT_EQ(f.bores[1].end, BoreEnd::Ball);
    EXPECT_NEAR(f.bores[1].depth, 5.0, kExact);
    EXPECT_NEAR(f.bores[1].tip_depth.value(), 9.0, kExact);
    EXPECT_EQ(f.bores[2].end, BoreEnd::Rounded);
    EXPECT_NEAR(f.bores[2].diameter, 12.0, kExact);
    EXPECT_NEAR(f.bores[2].depth, 4.0, kExact);
}

TEST(Features, APocketHasAFloorWidthsWallsAndCorners) {
    const Features f = measured(
        "pocket",
        "T1 M6\nG0 X20 Y20 Z5\nG1 Z-4\nG1 X50\nG1 Y35\nG1 X20\nG1 Y20\nG1 Y28\nG1 X50\nG0 Z5\n");
    EXPECT_TRUE(f.bores.empty());
    ASSERT_EQ(f.floors.size(), 2U);
    EXPECT_NEAR(f.floors[0].z, 0.0, kExact);
    EXPECT_FALSE(f.floors[0].is_closed);
    EXPECT_NEAR(f.floors[1].z, -4.0, kExact);
    EXPECT_TRUE(f.floors[1].is_closed);
    EXPECT_NEAR(f.floors[1].area, 1000.0 - (100.0 - 25.0 * std::numbers::pi), 1e-6);
    EXPECT_EQ(lengths(f, true), (std::vector<double>{25.0, 40.0}));
    // Left, front, below, back, the whole block, right.
    EXPECT_EQ(lengths(f, false), (std::vector<double>{15.0, 15.0, 16.0, 20.0, 20.0, 25.0}));
    ASSERT_EQ(f.corners.size(), 4U);
    for (const Corner& corner : f.corners) {
        EXPECT_NEAR(corner.radius, 5.0, kExact);
        EXPECT_TRUE(corner.is_inside);
        EXPECT_NEAR(corner.covers_degrees, 90.0, 1e-6);
    }
}

TEST(Features, AnOpenSlotHasItsWidth) {
    const Features f = measured("slot", "T1 M6\nG0 X-10 Y-5 Z5\nG1 Z-4\nG1 X90 Y65\nG0 Z5\n");
    EXPECT_EQ(lengths(f, true), std::vector<double>{10.0});
    ASSERT_FALSE(f.distances.empty());
    const auto slot = std::ranges::find_if(f.distances, &Distance::is_void);
    // The distance is measured across the path, from wall to wall.
    const Vec3 across = (1.0 / slot->mm) * (slot->to - slot->from);
    EXPECT_NEAR(dot(across, normalized({100, 70, 0})), 0.0, kExact);
    for (const Floor& floor : f.floors)
        EXPECT_FALSE(floor.is_closed);
}

// Two parallel slots. The material in between is a wall; the distance across both slots is no slot
// width.
TEST(Features, WhatStandsBetweenCounts) {
    const Features f = measured("slots",
                                "T1 M6\nG0 X-10 Y20 Z5\nG1 Z-4\nG1 X90\nG0 Z5\nG0 X-10 Y34\n"
                                "G1 Z-4\nG1 X90\nG0 Z5\n");
    EXPECT_EQ(lengths(f, true), (std::vector<double>{10.0, 10.0}));
    const std::vector<double> walls = lengths(f, false);
    EXPECT_EQ(walls.front(), 4.0);
    EXPECT_TRUE(std::ranges::find(walls, 24.0) == walls.end());
}

TEST(Features, ABossAndABar) {
    const Features boss =
        measured("boss", "T1 M6\nG0 X60 Y30 Z5\nG1 Z-4\nG2 X60 Y30 I-20 J0\nG0 Z5\n");
    ASSERT_EQ(boss.bosses.size(), 1U);
    EXPECT_NEAR(boss.bosses[0].diameter, 30.0, kExact);
    EXPECT_NEAR(boss.bosses[0].height, 4.0, kExact);
    expect_at(boss.bosses[0].foot, {40, 30, -4});
    ASSERT_EQ(boss.bores.size(), 1U);
    EXPECT_NEAR(boss.bores[0].diameter, 50.0, kExact);

    const Features bar = measured("bar", "T1 M6\nG0 X-40 Y0 Z5\nG1 Z-4\nG1 X40\nG0 Z5\n", true);
    ASSERT_EQ(bar.bosses.size(), 1U);
    EXPECT_NEAR(bar.bosses[0].diameter, 60.0, kExact);
}

// The floor of this helix is not a recognised surface. Its facets are counted, and no feature is
// derived from the facets.
TEST(Features, FacetsAreCountedAndNotMeasured) {
    const Features f =
        measured("ramp", "T5 M6\nG0 X20 Y30 Z5\nG1 Z-1\nG2 X60 Y30 I20 J0 Z-4\nG0 Z5\n");
    EXPECT_GT(f.facets, 0U);
    EXPECT_GT(f.facet_area, 10.0);
    for (const Floor& floor : f.floors)
        EXPECT_EQ(floor.z, 0.0);
}

TEST(Features, NameTheLinesThatCutThem) {
    const Made made = test::make_part(
        "two", "T2 M6\nG0 X20 Y30 Z5\nG1 Z-10\nG0 Z5\nG0 X60 Y30\nG1 Z-12\nG0 Z5\n");
    const Features f = measured(made);
    ASSERT_EQ(f.bores.size(), 2U);
    std::vector<std::uint32_t> lines;
    for (const Bore& bore : f.bores)
        lines.push_back(made.provenance.of(bore.origins.front()).nc_line);
    EXPECT_EQ(lines, (std::vector<std::uint32_t>{10, 13}));
}

}  // namespace
}  // namespace ncsim::brep
