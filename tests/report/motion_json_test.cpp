// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion_json.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::report {
namespace {

using gcode::Length;

gcode::Motion line() {
    gcode::Motion motion;
    gcode::Linear way;
    way.to.x = Length::from_mm(1.0 / 3.0);
    way.to.a = gcode::Angle::from_degrees(90);
    way.to.w = Length::from_mm(-2);
    motion.action = way;
    motion.span.line = 12;
    motion.feed = 300;
    motion.tool = 4;
    return motion;
}

TEST(MotionJson, HasValuesThatDifferFromTheUsual) {
    gcode::Motion motion = line();
    EXPECT_EQ(to_json(motion).dump(),
              R"({"line":12,"what":"line","from":{"x":0.0,"y":0.0,"z":0.0},)"
              R"("to":{"x":0.333333333,"y":0.0,"z":0.0,"a":90.0,"w":-2.0},)"
              R"("kind":"feed","feed":300.0,"feed_mode":"per_minute","tool":4})");
    motion.kind = gcode::MoveKind::Rapid;
    motion.file = 1;
    motion.spindle = gcode::SpindleTurning::Counterclockwise;
    motion.spindle_rpm = 900;
    motion.machine_coordinates = true;
    motion.known_start = {false, true, false};
    motion.start_assumed = true;
    const Json json = to_json(motion);
    EXPECT_FALSE(json.contains("feed"));
    EXPECT_EQ(json["file"], 1);
    EXPECT_EQ(json["spindle_rpm"], -900.0);
    EXPECT_EQ(json["machine_coordinates"], true);
    EXPECT_EQ(json["unknown_start"], "xz");
    EXPECT_EQ(json["start_assumed"], true);
    motion.spindle = gcode::SpindleTurning::Clockwise;
    EXPECT_EQ(to_json(motion)["spindle_rpm"], 900.0);
}

TEST(MotionJson, NamesModesAndPlanes) {
    gcode::Motion motion = line();
    motion.feed_mode = gcode::FeedMode::InverseTime;
    EXPECT_EQ(to_json(motion)["feed_mode"], "inverse_time");
    motion.feed_mode = gcode::FeedMode::PerRevolution;
    EXPECT_EQ(to_json(motion)["feed_mode"], "per_revolution");
    motion.kind = gcode::MoveKind::Probe;
    EXPECT_EQ(to_json(motion)["kind"], "probe");
    std::string planes;
    for (const gcode::Plane plane : {gcode::Plane::XY, gcode::Plane::ZX, gcode::Plane::YZ,
                                     gcode::Plane::UV, gcode::Plane::WU, gcode::Plane::VW}) {
        gcode::Arc arc;
        arc.plane = plane;
        arc.centre_2 = Length::from_mm(5);
        arc.turns = -2;
        motion.action = arc;
        const Json json = to_json(motion);
        planes += json["plane"].get<std::string>();
        EXPECT_EQ(json["centre"], Json::array({0.0, 5.0}));
        EXPECT_EQ(json["turns"], -2);
        EXPECT_FALSE(json.contains("tilted"));
    }
    EXPECT_EQ(planes, "XYZXYZUVWUVW");
}

TEST(MotionJson, HasPointsOfSplinesAndNoKindOfDwellsAndChanges) {
    gcode::Motion motion;
    gcode::Spline spline;
    spline.order = 3;
    spline.control_points = {{Length::from_mm(1), Length::from_mm(2), 0.5}};
    spline.knots = {0, 1};
    motion.action = spline;
    EXPECT_EQ(to_json(motion)["control_points"], Json::parse("[[1.0,2.0,0.5]]"));
    EXPECT_EQ(to_json(motion)["knots"], Json::parse("[0.0,1.0]"));
    EXPECT_EQ(to_json(motion)["order"], 3);
    motion.action = gcode::Dwell{2.5};
    EXPECT_EQ(to_json(motion).dump(), R"({"line":0,"what":"dwell","seconds":2.5})");
    gcode::ToolChange change{7, {}};
    change.at.z = Length::from_mm(100);
    motion.action = change;
    EXPECT_EQ(to_json(motion).dump(),
              R"({"line":0,"what":"tool_change","tool":7,"at":{"x":0.0,"y":0.0,"z":100.0}})");
}

}  // namespace
}  // namespace ncsim::report
