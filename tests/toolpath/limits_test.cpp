// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values at the limits of tools, stock and paths: units that change, sizes below one, ways of all
// axes at once. The expected values are on paper.
#include "ncsim/cda/polytope.h"
#include "ncsim/machine/presets.h"
#include "ncsim/toolpath/joint_path.h"
#include "ncsim/toolpath/spline_arcs.h"
#include "ncsim/toolpath/stock.h"
#include "ncsim/toolpath/tool_file.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/toolpath/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::toolpath {
namespace {

using gcode::Angle;
using gcode::Length;
using gcode::Position;

// --- Comments and files ---

ProgramNotes notes(const std::string& program) {
    return read_notes({"t.nc", program});
}

TEST(Limits, CommentsWithoutAToolCall) {
    for (const char* program : {"G21\n(End mill 3mm)\n", "G21\n(End mill 3mm)\nM30\n"}) {
        const ProgramNotes made = notes(program);
        ASSERT_EQ(made.tools.size(), 1U) << program;
        EXPECT_EQ(made.tools[0].spec.number, 0) << program;
    }
}

TEST(Limits, CommentsBehindTheLastMoveAreOfTheToolInTheSpindle) {
    const ProgramNotes made = notes("G21\nT5 M6\nG0 X0\n(End mill 3mm)\nM30\n");
    ASSERT_EQ(made.tools.size(), 1U);
    EXPECT_EQ(made.tools[0].spec.number, 5);
}

TEST(Limits, NumbersOfToolsInComments) {
    const auto number = [](const std::string& comment) {
        const ProgramNotes made = notes("G21\n(" + comment + ")\n");
        return made.tools.empty() ? -1 : made.tools[0].spec.number;
    };
    EXPECT_EQ(number("T1 6mm end mill"), 1);
    EXPECT_EQ(number("T99999999 6mm end mill"), 99'999'999);
    EXPECT_EQ(number("T100000000 6mm end mill"), 0);
    EXPECT_EQ(number("T0 6mm end mill"), 0);
}

TEST(Limits, FirstUnitOfAProgramIsThatOfItsBlock) {
    // Lengths without a unit are in the first unit of the program, whatever follows.
    const auto size = [](const std::string& units) {
        const ProgramNotes made = notes("(STOCK/BLOCK,10.0, 5.0, 1.0, 0.0, 0.0, 1.0)\n" + units);
        return made.stock ? made.stock->box.size().x : 0.0;
    };
    EXPECT_NEAR(size("G21\nG0 X1\n"), 10.0, 1e-9);
    EXPECT_NEAR(size("G20\nG0 X1\n"), 254.0, 1e-9);
    EXPECT_NEAR(size("G20\nG0 X1\nG21\nG0 X2\n"), 254.0, 1e-9);
    EXPECT_NEAR(size("G21\nG0 X1\nG20\nG0 X2\n"), 10.0, 1e-9);
}

TEST(Limits, SignsOfDegreesAndBytesAtTheEnd) {
    const auto angle = [](const std::string& comment) {
        const ProgramNotes made = notes("G21\n;" + comment + "\n");
        return made.tools.empty() ? std::nullopt : made.tools[0].spec.angle;
    };
    EXPECT_EQ(angle("T1 V-BIT 6MM 60\xC2\xB0"), 60.0) << "degree sign, UTF-8";
    EXPECT_EQ(angle("T1 V-BIT 6MM 60\xB0"), 60.0) << "degree sign, Latin-1";
    EXPECT_EQ(angle("T1 V-BIT 6MM 60\xC2\xBA"), 60.0) << "ordinal sign, UTF-8";
    EXPECT_EQ(angle("T1 V-BIT 6MM 60\xBA"), 60.0) << "ordinal sign, Latin-1";
    // A comment that ends within a character of UTF-8: the byte is a letter of Latin-1.
    for (const char* end : {"\xC2", "\xC3", "\xE2"})
        EXPECT_EQ(angle(std::string("T1 V-BIT 6MM 60 DEG ") + end), angle("T1 V-BIT 6MM 60 DEG A"));
}

TEST(Limits, HandOfATapInATable) {
    const auto is_left = [](const std::string& remark) {
        const ToolFile file = read_tool_file({"t.tbl", "T1 P1 D5 ;" + remark + "\n"}, false);
        return file.tools.at(0).spec.left_hand;
    };
    for (const char* const left : {"left hand tap", "LH TAP", "tap, left-hand", "M5X0.8 TAP LH",
                                   "L.H. TAP", "TARAUD GAUCHE", "MACHO IZQUIERDO TAP"}) {
        EXPECT_TRUE(is_left(left)) << left;
    }
    for (const char* const right : {"right hand tap", "tap", "RH TAP", "TAP LENGTH 5"})
        EXPECT_FALSE(is_left(right)) << right;
}

TEST(Limits, HandOfATapInAComment) {
    for (const std::string hand : {"left", "right"}) {
        for (const std::string& comment :
             {"T4 D=6. CR=0. - ZMIN=-8. - " + hand + " hand tap", "T4 M6X1 " + hand + " HAND TAP",
              "T4 M6X1 TAP " + (hand == "left" ? std::string("LH") : std::string("RH"))}) {
            const ProgramNotes notes = read_notes({"a.nc", "(" + comment + ")\n"});
            ASSERT_EQ(notes.tools.size(), 1U) << comment;
            EXPECT_EQ(notes.tools[0].spec.left_hand, hand == "left") << comment;
        }
    }
}

TEST(Limits, ValuesOfFusionOfOtherKinds) {
    // TP is the pitch of taps alone; RE is not the corner of a flat end mill.
    const std::string all = R"({"data":[
        {"type":"tap right hand","unit":"millimeters","geometry":{"DC":6,"TP":1,"LCF":9},
         "post-process":{"number":1}},
        {"type":"tap left hand","unit":"inches","geometry":{"DC":0.25,"TP":0.05,"LCF":1},
         "post-process":{"number":2}},
        {"type":"flat end mill","unit":"millimeters","geometry":{"DC":6,"TP":1,"RE":1,"LCF":9},
         "post-process":{"number":3}},
        {"type":"bull nose end mill","unit":"millimeters","geometry":{"DC":6,"TP":1,"RE":1,"LCF":9},
         "post-process":{"number":4}}],"version":2})";
    const ToolFile file = read_tool_file({"", all});
    ASSERT_EQ(file.tools.size(), 4U);
    EXPECT_EQ(file.tools[0].spec.pitch, 1.0);
    EXPECT_FALSE(file.tools[0].spec.left_hand);
    EXPECT_NEAR(*file.tools[1].spec.pitch, 1.27, 1e-12);
    EXPECT_TRUE(file.tools[1].spec.left_hand);
    EXPECT_FALSE(file.tools[2].spec.pitch);
    EXPECT_FALSE(file.tools[2].spec.corner_radius);
    EXPECT_FALSE(file.tools[3].spec.pitch);
    EXPECT_EQ(file.tools[3].spec.corner_radius, 1.0);
}

// --- Tools and stock ---

TEST(Limits, WhatIsFilledIn) {
    ToolSpec spec;
    const ToolSpec nothing = filled(spec, 50.0);
    EXPECT_EQ(nothing.kind, ToolKind::FlatEndMill);
    EXPECT_EQ(nothing.diameter, 0.0);
    EXPECT_EQ(std::ranges::count(nothing.assumed, "kind"), 1);
    EXPECT_EQ(std::ranges::count(nothing.assumed, "diameter"), 1);
    spec.kind = ToolKind::FlatEndMill;
    spec.diameter = 6.0;
    const ToolSpec known = filled(spec, 50.0);
    EXPECT_EQ(std::ranges::count(known.assumed, "kind"), 0);
    EXPECT_EQ(std::ranges::count(known.assumed, "diameter"), 0);
    // An engraver is on a shank of 1/8", or is twice as wide as its tip.
    spec = {};
    spec.kind = ToolKind::VCutter;
    spec.tip_diameter = 0.2;
    EXPECT_EQ(filled(spec, 50.0).diameter, 3.175);
    spec.tip_diameter = 2.0;
    EXPECT_EQ(filled(spec, 50.0).diameter, 4.0);
    // The corner determines the kind.
    spec = {};
    spec.diameter = 6.0;
    spec.corner_radius = 1.0;
    EXPECT_EQ(std::ranges::count(filled(spec, 50.0).assumed, "kind"), 0);
}

TEST(Limits, LeastFluteLengths) {
    // 1.25 diameters, or the shaped end if it is longer; a drill has its point and 3 diameters.
    EXPECT_NEAR(least_flute_length(flat_end_mill(10, 30)), 12.5, 1e-9);
    EXPECT_NEAR(least_flute_length(ball_end_mill(10, 30)), 12.5, 1e-9);
    EXPECT_NEAR(least_flute_length(bull_nose_end_mill(10, 2, 30)), 12.5, 1e-9);
    EXPECT_NEAR(least_flute_length(drill(10, 90, 60)), 5.0 + 30.0, 1e-9);
    EXPECT_NEAR(least_flute_length(v_cutter(10, 0, 90, 30)), 5.0, 1e-9);
    EXPECT_NEAR(least_flute_length(v_cutter(10, 4, 90, 30)), 3.0, 1e-9);
    EXPECT_NEAR(least_flute_length(v_cutter(10, 0, 60, 30)), 5.0 * std::sqrt(3.0), 1e-6);
}

TEST(Limits, LeastFluteLengthOfAFaceMillIsItsCorner) {
    // A tenth of the diameter, or the rounded corner if it is higher.
    Tool mill = bull_nose_end_mill(50, 6, 30);
    mill.kind = ToolKind::FaceMill;
    EXPECT_NEAR(least_flute_length(mill), 6.0, 1e-9);
    mill = bull_nose_end_mill(50, 4, 30);
    mill.kind = ToolKind::FaceMill;
    EXPECT_NEAR(least_flute_length(mill), 5.0, 1e-9);
}

TEST(Limits, PiecesAboveTheTip) {
    Tool tool = flat_end_mill(10, 5);
    add_holder_segment(tool, 10, 10, 25);
    add_holder_segment(tool, 40, 30, 20);
    const PieceExtent shank = extent_of(tool.pieces[1]);
    EXPECT_EQ(shank.low_mm, 5.0);
    EXPECT_EQ(shank.high_mm, 30.0);
    EXPECT_EQ(shank.radius_mm, 5.0);
    const PieceExtent holder = extent_of(tool.pieces[2]);
    EXPECT_EQ(holder.low_mm, 30.0);
    EXPECT_EQ(holder.high_mm, 50.0);
    EXPECT_EQ(holder.radius_mm, 20.0);
    // The shank has the corners of the flutes, and does not cut.
    const cda::Lattice lattice{1e-5};
    EXPECT_TRUE(approximate(tool.pieces[0], lattice, {}).cutting);
    const PiecePolytope above = approximate_above(tool.pieces[0], tool.pieces[1], lattice, {});
    EXPECT_FALSE(above.cutting);
    EXPECT_TRUE(approximate_above(tool.pieces[1], tool.pieces[0], lattice, {}).cutting);
    for (const cda::LatticePoint& p : above.points_T)
        EXPECT_TRUE(p.z == 500'000 || p.z == 3'000'000) << p.z;
}

TEST(Limits, BarsBelowAMillimetre) {
    const auto bar = [](const std::string& text) {
        std::string message;
        return parse_stock_option(text, message);
    };
    const auto small = bar("D0.5x0.25");
    ASSERT_TRUE(small);
    EXPECT_NEAR(small->box.max.x, 0.25, 1e-12);
    EXPECT_NEAR(small->box.min.z, -0.25, 1e-12);
    EXPECT_FALSE(bar("D0x5"));
    EXPECT_FALSE(bar("D5x0"));
    EXPECT_FALSE(bar("D5x-1"));
}

// --- Paths ---

Position place(double x, double y, double z, double u = 0.0, double v = 0.0, double w = 0.0) {
    Position p;
    p.x = Length::from_mm(x), p.y = Length::from_mm(y), p.z = Length::from_mm(z);
    p.u = Length::from_mm(u), p.v = Length::from_mm(v), p.w = Length::from_mm(w);
    return p;
}

TEST(Limits, SpeedOfAnArcBoundsItsFastestPart) {
    // Quarters of a circle, of a helix and of spirals, also with a move along W.
    struct Row {
        Position from, to;
    };
    for (const Row& row :
         {Row{place(10, 0, 0), place(0, 10, 0)}, Row{place(10, 0, 0), place(0, 10, 30)},
          Row{place(1, 0, 0), place(0, 100, 0)}, Row{place(100, 0, 5), place(0, 1, -20)},
          Row{place(10, 0, 0), place(0, 10, 0, 0, 0, 60)}}) {
        Kinematics machine{*machine::preset("xyzac-trt"), {0, 0, 0}};
        machine.chain.joints.push_back(machine::along_tool('W'));
        gcode::Motion motion;
        gcode::Arc arc;
        arc.from = row.from, arc.to = row.to;
        motion.action = arc;
        const JointPath path(machine, motion);
        const auto begin = path.at(0.0), end = path.at(1.0);
        ASSERT_TRUE(begin && end);
        const auto bound = path.joint_motion(0.0, *begin, 1.0, *end);
        ASSERT_TRUE(bound);
        double fastest = 0.0;
        auto last = *begin;
        constexpr int kParts = 200;
        for (int i = 1; i <= kParts; ++i) {
            const auto now = *path.at(static_cast<double>(i) / kParts);
            const Vec3 way{now[0] - last[0], now[1] - last[1], now[2] - last[2]};
            fastest = std::max(fastest, kParts * norm(way));
            last = now;
        }
        EXPECT_GE(bound->all_speed, fastest - 1e-6);
    }
}

TEST(Limits, LegsOfASplineAreNear) {
    // A half wave of 20 mm height: chords are within 10 µm.
    gcode::Spline spline;
    spline.order = 4;
    spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    for (const auto& [x, y] :
         std::vector<std::pair<double, double>>{{0, 0}, {10, 40}, {30, -40}, {40, 0}})
        spline.control_points.push_back({Length::from_mm(x), Length::from_mm(y), 1.0});
    spline.from = place(0, 0, 0);
    spline.to = place(40, 0, 0);
    gcode::Motion motion;
    motion.action = spline;
    const Legs legs = legs_of(motion, {});
    EXPECT_GT(legs.missed_mm, 0.0);
    ASSERT_GT(legs.motions.size(), 4U);
    EXPECT_EQ(*gcode::start_of(legs.motions.front()), spline.from);
    EXPECT_EQ(*gcode::end_of(legs.motions.back()), spline.to);
    // Each point of the curve is near a chord.
    for (int i = 0; i <= 400; ++i) {
        const double t = i / 400.0, s = 1.0 - t;
        const Vec3 p{30 * s * s * t + 90 * s * t * t + 40 * t * t * t,
                     120 * s * s * t - 120 * s * t * t, 0.0};
        double least = 1e9;
        for (const gcode::Motion& leg : legs.motions) {
            const Position& a = *gcode::start_of(leg);
            const Position& b = *gcode::end_of(leg);
            const Vec3 from{a.x.mm(), a.y.mm(), 0}, along{b.x.mm() - from.x, b.y.mm() - from.y, 0};
            const double u = std::clamp(dot(p - from, along) / dot(along, along), 0.0, 1.0);
            least = std::min(least, norm(p - from - u * along));
        }
        EXPECT_LE(least, legs.missed_mm) << t;
    }
}

TEST(Limits, ArcsOfASplineInBothDirections) {
    // The same quarter of a circle to the left and to the right, by one rational segment.
    for (const double side : {1.0, -1.0}) {
        gcode::Spline spline;
        spline.order = 3;
        spline.knots = {0, 0, 0, 1, 1, 1};
        const double weight = std::numbers::sqrt2 / 2.0;
        for (const auto& [x, y, w] :
             std::vector<std::array<double, 3>>{{10, 0, 1}, {10, 10, weight}, {0, 10, 1}})
            spline.control_points.push_back({Length::from_mm(x), Length::from_mm(side * y), w});
        spline.from = place(10, 0, 0);
        spline.to = place(0, side * 10, 0);
        double swept = 0.0;
        for (const SplinePiece& piece : arcs_of(spline, 0.001)) {
            EXPECT_NEAR(piece.radius, 10.0, 1e-3);
            swept += piece.swept_degrees;
        }
        EXPECT_NEAR(swept, side * 90.0, 1e-3);
    }
}

TEST(Limits, InwardCellsAreWithinOutwardCells) {
    // A tool that turns by 5 degrees about X while it moves.
    const cda::Lattice lattice{1e-5};
    const auto pose = [](double x, double a) {
        Position p = place(x, 0, 0);
        p.a = Angle::from_degrees(a);
        return pose_at(p);
    };
    const auto volume = [&](Side side) {
        ToolAccuracy accuracy;
        accuracy.side = side;
        Cutter cutter(flat_end_mill(10, 20), lattice, accuracy);
        std::vector<cda::Cell> cells;
        cutter.trace(pose(0, 0), pose(2, 5), cda::Origin{1}, cells);
        double sum = 0.0;
        for (const cda::Cell& cell : cells)
            sum += cda::ConvexPolytope::of(cell, lattice)->volume();
        return sum;
    };
    EXPECT_LT(volume(Side::Inscribed), volume(Side::Circumscribed));
}

}  // namespace
}  // namespace ncsim::toolpath
