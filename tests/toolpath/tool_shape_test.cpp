// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of tools and their profiles, with heights and radii on paper.
#include "ncsim/toolpath/tool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::toolpath {
namespace {

using Points = std::vector<std::pair<double, double>>;  // radius and height, mm

void expect_near(const ToolPiece& piece, const Points& points) {
    ASSERT_EQ(piece.profile.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(piece.profile[i].radius, points[i].first, 1e-9) << i;
        EXPECT_NEAR(piece.profile[i].height, points[i].second, 1e-9) << i;
    }
}

TEST(ToolKinds, AreConicalAxialOrUndercutting) {
    std::string conical, axial, undercutting;
    for (int i = 0; i <= static_cast<int>(ToolKind::Other); ++i) {
        const auto kind = static_cast<ToolKind>(i);
        const std::string name = std::string(name_of(kind)) + "; ";
        if (is_conical(kind)) conical += name;
        if (is_axial(kind)) axial += name;
        if (is_undercutting(kind)) undercutting += name;
    }
    EXPECT_EQ(conical, "v-cutter; chamfer mill; countersink; ");
    EXPECT_EQ(axial, "drill; tap; reamer; boring bar; ");
    EXPECT_EQ(undercutting, "slot mill; dovetail mill; lollipop mill; ");
    EXPECT_FALSE(is_conical(std::nullopt));
}

TEST(ToolShapes, HaveTheHeightsOfTheirFormulas) {
    expect_near(flat_end_mill(10, 20).pieces.front(), {{5, 0}, {5, 20}});
    expect_near(ball_end_mill(10, 2).pieces.front(), {{5, 0}, {5, 5}});
    expect_near(bull_nose_end_mill(10, 2, 1).pieces.front(), {{5, 0}, {5, 2}});
    EXPECT_EQ(bull_nose_end_mill(10, 7, 20).pieces.front().profile.front().fillet, 5.0);
    expect_near(v_cutter(10, 0, 90, 20).pieces.front(), {{0, 0}, {5, 5}, {5, 20}});
    expect_near(v_cutter(10, 4, 90, 3).pieces.front(), {{2, 0}, {5, 3}});
    expect_near(v_cutter(10, 10, 90, 20).pieces.front(), {{5, 0}, {5, 20}});
    expect_near(v_cutter(10, 12, 90, 20).pieces.front(), {{5, 0}, {5, 20}});
    expect_near(drill(10, 90, 60).pieces.front(), {{0, 0}, {5, 5}, {5, 60}});
    const double slope = std::tan(std::acos(-1.0) / 18.0);  // 10 degrees
    expect_near(tapered_end_mill(6, 0, 10, 20).pieces.front(), {{3, 0}, {3 + 20 * slope, 20}});
    expect_near(dovetail_mill(20, 45, 4).pieces.front(), {{10, 0}, {6, 4}});
    expect_near(dovetail_mill(20, 45, 50).pieces.front(), {{10, 0}, {0.5, 9.5}});
    expect_near(dovetail_mill(20, 0, 4).pieces.front(), {{10, 0}, {10, 4}});
    expect_near(slot_mill(20, 5, 4).pieces.front(), {{10, 0}, {10, 4}});
    EXPECT_EQ(slot_mill(20, 5, 4).pieces.front().profile.front().fillet, 4.0);
    expect_near(lollipop_mill(12).pieces.front(), {{6, 0}, {6, 12}});
}

TEST(ToolShapes, OfAConcaveRadiusAreOnItsCircle) {
    struct Row {
        double diameter, tip, radius, length;
        double arc_height, height;
        std::size_t shoulders;
    };
    for (const Row& row :
         {Row{14, 6, 4, 0, 4, 4, 0}, Row{20, 6, 4, 9, 4, 9, 1}, Row{20, 6, 4, 4, 4, 4, 0},
          // The arc ends at the diameter: 2 = 4 (1 - cos 60 degrees).
          Row{10, 6, 4, 0, 4 * std::sqrt(0.75), 4 * std::sqrt(0.75), 0}}) {
        SCOPED_TRACE(row.diameter);
        const Tool tool = corner_rounding_mill(row.diameter, row.tip, row.radius, row.length);
        EXPECT_NEAR(height_of(tool), row.height, 1e-9);
        const std::size_t chords = tool.pieces.size() - row.shoulders;
        double low = 0.0, farthest = 0.0;
        for (std::size_t i = 0; i < chords; ++i) {
            const ToolPiece& piece = tool.pieces[i];
            ASSERT_EQ(piece.profile.size(), 2U);
            EXPECT_TRUE(piece.cutting);
            EXPECT_NEAR(piece.profile.front().height, low, 1e-12) << "no gap";
            low = piece.profile.back().height;
            for (const ProfilePoint& p : piece.profile) {
                const double x = p.radius - row.tip / 2 - row.radius;
                EXPECT_NEAR(std::hypot(x, p.height), row.radius, 1e-9) << "on the circle";
            }
            const double x = (piece.profile.front().radius + piece.profile.back().radius) / 2 -
                             row.tip / 2 - row.radius;
            const double z = (piece.profile.front().height + piece.profile.back().height) / 2;
            farthest = std::max(farthest, row.radius - std::hypot(x, z));
        }
        EXPECT_NEAR(low, row.arc_height, 1e-9);
        EXPECT_LE(farthest, kConcaveChord * 1.001);
        EXPECT_GT(farthest, kConcaveChord / 4) << "no more chords than needed";
        if (row.shoulders == 1) {
            expect_near(tool.pieces.back(),
                        {{row.diameter / 2, row.arc_height}, {row.diameter / 2, row.height}});
        }
    }
}

TEST(ToolSlice, IsThePartBetweenTwoHeights) {
    const ToolPiece mill = flat_end_mill(10, 20).pieces.front();
    expect_near(slice(mill, 0, 20), {{5, 0}, {5, 20}});
    expect_near(slice(mill, 5, 8), {{5, 5}, {5, 8}});
    expect_near(slice(mill, -5, 8), {{5, 0}, {5, 8}});
    expect_near(slice(mill, 15, 30), {{5, 15}, {5, 20}});
    for (const auto& [low, high] : Points{{20, 30}, {-5, 0}, {8, 8}})
        EXPECT_TRUE(slice(mill, low, high).profile.empty()) << low;
    expect_near(slice(v_cutter(10, 0, 90, 20).pieces.front(), 1, 7), {{1, 1}, {5, 5}, {5, 7}});
    ToolPiece body = mill;
    body.cutting = false;
    body.assumed = true;
    EXPECT_FALSE(slice(body, 1, 2).cutting);
    EXPECT_TRUE(slice(body, 1, 2).assumed);
}

TEST(ToolSlice, OfARoundingHasChordsOnItsArc) {
    for (const auto& [diameter, radius] : Points{{10, 5}, {10, 2}, {1, 0.003}, {400, 200}}) {
        SCOPED_TRACE(radius);
        const ToolPiece mill = bull_nose_end_mill(diameter, radius, 300).pieces.front();
        const ToolPiece part = slice(mill, 0, 300);
        // At least two chords; no chord is farther than a micrometre from the arc.
        std::size_t on_arc = 0;
        for (std::size_t i = 0; i < part.profile.size(); ++i) {
            const double x = part.profile[i].radius - (diameter / 2 - radius);
            const double z = part.profile[i].height - radius;
            if (z > 1e-12) continue;
            ++on_arc;
            EXPECT_NEAR(std::hypot(x, z), radius, 1e-9);
            if (i == 0) continue;
            const double mx =
                (part.profile[i].radius + part.profile[i - 1].radius) / 2 - (diameter / 2 - radius);
            const double mz = (part.profile[i].height + part.profile[i - 1].height) / 2 - radius;
            if (std::abs(mz + radius) > 1e-12) {  // not the floor
                EXPECT_GE(std::hypot(mx, mz), radius - 1.001e-3);
            }
        }
        EXPECT_GE(on_arc, 3U);
    }
}

TEST(ToolHeights, AreOfAllPiecesOrOfThoseThatCut) {
    Tool tool = flat_end_mill(10, 5);
    add_holder_segment(tool, 12, 30, 25);
    EXPECT_EQ(height_of(tool), 30.0);
    EXPECT_EQ(cutting_height_of(tool), 5.0);
    EXPECT_EQ(cutting_diameter_of(tool), 10.0);
    expect_near(tool.pieces.back(), {{6, 5}, {15, 30}});
    EXPECT_FALSE(tool.pieces.back().cutting);
    EXPECT_EQ(height_of(Tool{}), 0.0);
}

}  // namespace
}  // namespace ncsim::toolpath
