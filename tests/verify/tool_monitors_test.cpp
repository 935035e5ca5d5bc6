// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of a tool that are watched: which a tool and a selection need, and their sizes.
#include "tool_monitors.h"

#include "verify/verified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace ncsim::verify_test {
namespace {

using toolpath::Pose;
using toolpath::Tool;
using verify::Body;
using verify::ToolFacts;
using verify::ToolMonitors;

ToolFacts facts_of(const Tool& tool) {
    ToolFacts facts;
    facts.tool = tool;
    return facts;
}

ToolMonitors watched(const ToolFacts& facts, const std::string& ignored = {}) {
    verify::Selection selection;
    if (!ignored.empty()) selection.ignored[ignored] = "--ignore";
    return watch(facts, selection, cda::Lattice::for_stock(kBlock), {});
}

/// Returns the box of a body of an upright tool with its tip at the origin.
Box bounds_of(Body body) {
    const Pose pose;
    Box box;
    for (const cda::Cell& cell : body.cells({pose, pose, {}, {}, {}, {}, false, {}, {}}, 0.0,
                                            toolpath::Side::Circumscribed))
        box.add(cell.bounds);
    return box;
}

/// Expects a cylinder about Z, whose polygon may be larger by the tolerance of tools.
void expect_cylinder(const Body& body, double radius, double low, double high) {
    const Box box = bounds_of(body);
    const double tolerance = 2 * toolpath::ToolAccuracy{}.tolerance_mm + 1e-4;
    for (int axis : {0, 1}) {
        EXPECT_NEAR(box.min[axis], -radius, tolerance);
        EXPECT_NEAR(box.max[axis], radius, tolerance);
    }
    EXPECT_NEAR(box.min.z, low, 1e-4);
    EXPECT_NEAR(box.max.z, high, 1e-4);
}

TEST(ToolMonitors, ShapeOfTheCutter) {
    struct Row {
        const char* name;
        Tool tool;
        bool prism, widens;
        double straight_from_mm;
    };
    const double point = 5.0 / std::tan(59.0 * std::numbers::pi / 180.0);
    const double cone = 3.0;  // 45 degrees from a flat of 4 mm to 10 mm
    for (const Row& row : {
             Row{"flat", toolpath::flat_end_mill(10, 20), true, true, 0.0},
             Row{"ball", toolpath::ball_end_mill(10, 20), false, true, 5.0},
             Row{"bull nose", toolpath::bull_nose_end_mill(10, 2, 20), false, true, 2.0},
             Row{"bull nose of radius 0", toolpath::bull_nose_end_mill(10, 0, 20), true, true, 0.0},
             Row{"drill", toolpath::drill(10, 118, 50), false, true, point},
             Row{"chamfer", toolpath::v_cutter(10, 4, 90, 20), false, true, cone},
             Row{"dovetail", toolpath::dovetail_mill(10, 15, 5), false, false, 5.0},
             Row{"lollipop", toolpath::lollipop_mill(10), false, false, 10.0},
             Row{"slot", toolpath::slot_mill(10, 0, 4), true, true, 0.0},
             Row{"slot with a round edge", toolpath::slot_mill(10, 1, 4), false, true, 1.0},
             Row{"taper", toolpath::tapered_end_mill(4, 0, 10, 20), false, true, 20.0},
         }) {
        SCOPED_TRACE(row.name);
        const ToolMonitors monitors = watched(facts_of(row.tool));
        EXPECT_EQ(monitors.prism, row.prism);
        EXPECT_EQ(monitors.widens, row.widens);
        EXPECT_NEAR(monitors.straight_from_mm, row.straight_from_mm, 1e-6);
        EXPECT_TRUE(monitors.bodies.empty());
        // Probes are strictly inside the smallest cylinder and not all in one plane.
        ASSERT_GE(monitors.probes_T.size(), 4U);
        Box box;
        for (const Vec3& p : monitors.probes_T) {
            EXPECT_LT(std::hypot(p.x, p.y), toolpath::cutting_diameter_of(row.tool) / 2);
            EXPECT_GT(p.z, 0.0);
            EXPECT_LT(p.z, toolpath::cutting_height_of(row.tool));
            box.add(p);
        }
        EXPECT_GT(std::min({box.size().x, box.size().y, box.size().z}), 0.5);
    }
}

TEST(ToolMonitors, ShanksAndHoldersAreWatchedIfTheirRuleIsSelected) {
    const ToolFacts facts = setup_with_holder().tools.at(1);
    const ToolMonitors monitors = watched(facts);
    ASSERT_EQ(monitors.bodies.size(), 2U);
    EXPECT_EQ(monitors.bodies[0].piece, 1U);
    expect_cylinder(monitors.bodies[0].body, 5.0, 5.0, 30.0);
    EXPECT_EQ(monitors.bodies[1].piece, 2U);
    expect_cylinder(monitors.bodies[1].body, 20.0, 30.0, 60.0);
    EXPECT_TRUE(watched(facts, "non-cutting-contact").bodies.empty());
    EXPECT_TRUE(monitors.prism) << "only cutting pieces count";
    EXPECT_EQ(monitors.straight_from_mm, 0.0);
    for (const Vec3& p : monitors.probes_T)
        EXPECT_LT(p.z, 5.0);
}

/// Height of the flutes above a limit, and below; -1: not watched.
void expect_flutes(const verify::FlutesAbove& flutes, double from) {
    ASSERT_EQ(flutes.bodies.size(), from < 0 ? 0U : 1U);
    ASSERT_EQ(flutes.below.size(), from <= 0 ? 0U : 1U);
    if (from < 0) return;
    EXPECT_EQ(flutes.from_mm, from);
    expect_cylinder(flutes.bodies[0], 5.0, from, 20.0);
    if (from > 0) expect_cylinder(flutes.below[0], 5.0, 0.0, from);
}

TEST(ToolMonitors, LimitsOfTheFlutesCountBelowTheirHeight) {
    for (const double limit : {0.0, 0.5, 12.0, 19.9, 20.0, 25.0}) {
        SCOPED_TRACE(limit);
        const double from = limit < 20.0 ? limit : -1.0;
        ToolFacts deep = facts_of(toolpath::flat_end_mill(10, 20));
        deep.max_depth = limit;
        expect_flutes(watched(deep).too_high, from);
        expect_flutes(watched(deep, "depth-limit").too_high, -1.0);
        expect_flutes(watched(deep).uncertain, -1.0);
        ToolFacts uncertain = facts_of(toolpath::flat_end_mill(10, 20));
        uncertain.certain_flutes = limit;
        expect_flutes(watched(uncertain).uncertain, from);
        expect_flutes(watched(uncertain).too_high, -1.0);
    }
}

TEST(ToolMonitors, CoreReachesAsHighAsTheCutter) {
    ToolFacts facts = facts_of(toolpath::flat_end_mill(10, 20));
    EXPECT_FALSE(watched(facts).core) << "unspecified";
    facts.blind_diameter = 0.0;
    EXPECT_FALSE(watched(facts).core) << "cuts to the centre";
    facts.blind_diameter = 4.0;
    EXPECT_FALSE(watched(facts, "plunge").core);
    ASSERT_TRUE(watched(facts).core);
    expect_cylinder(*watched(facts).core, 2.0, 0.0, 20.0);
}

TEST(ToolMonitors, WallReachesIntoTheThread) {
    ToolFacts facts = facts_of(toolpath::flat_end_mill(10, 20));
    EXPECT_FALSE(watched(facts).wall) << "no thread mill";
    facts.tool.kind = toolpath::ToolKind::ThreadMill;
    EXPECT_FALSE(watched(facts, "thread-retract").wall);
    // Half the pitch deep, from the second turn upwards.
    facts.pitch = 1.5;
    expect_cylinder(*watched(facts).wall, 5.75, 1.5, 20.0);
    facts.pitch = 15.0;
    expect_cylinder(*watched(facts).wall, 12.5, 10.0, 20.0);
    facts.pitch.reset();
    expect_cylinder(*watched(facts).wall, 5.05, 1.0, 20.0);
}

TEST(ToolMonitors, MouthAndTipAreThoseOfTheirTools) {
    ToolFacts sink = facts_of(toolpath::v_cutter(10, 2, 90, 20));
    EXPECT_FALSE(watched(sink).mouth);
    sink.tool.kind = toolpath::ToolKind::Countersink;
    EXPECT_FALSE(watched(sink, "countersink-depth").mouth);
    ASSERT_TRUE(watched(sink).mouth);
    const Box mouth = bounds_of(*watched(sink).mouth);
    EXPECT_LE(mouth.max.x, 5.0) << "keeps away from the wall of a hole of its diameter";
    EXPECT_NEAR(mouth.max.x, 5.0, 0.2);
    EXPECT_NEAR(mouth.min.z, 0.0, 1e-4);
    ToolFacts drill = facts_of(toolpath::drill(8, 118, 50));
    EXPECT_FALSE(watched(drill).mouth);
    drill.flute_length = 40.0;
    EXPECT_TRUE(watched(drill).mouth);
    EXPECT_FALSE(watched(drill, "drill-depth").mouth);
    ToolFacts chamfer = facts_of(toolpath::v_cutter(10, 6, 90, 20));
    EXPECT_FALSE(watched(chamfer).tip);
    chamfer.flat_tip = 6.0;
    ASSERT_TRUE(watched(chamfer).tip);
    expect_cylinder(*watched(chamfer).tip, 3.0, 0.0, 0.05);
    EXPECT_FALSE(watched(chamfer, "tip-cut").tip);
}

}  // namespace
}  // namespace ncsim::verify_test
