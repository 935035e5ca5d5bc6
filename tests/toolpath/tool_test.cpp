// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ncsim::toolpath {
namespace {

using Profile = std::vector<ProfilePoint>;

TEST(Tool, FlatEndMillIsACylinder) {
    const Tool tool = flat_end_mill(10, 30);
    ASSERT_EQ(tool.pieces.size(), 1U);
    EXPECT_EQ(tool.pieces[0].profile, (Profile{{5, 0, 0}, {5, 30, 0}}));
    EXPECT_TRUE(tool.pieces[0].cutting);
    EXPECT_EQ(cutting_diameter_of(tool), 10);
}

TEST(Tool, BallEndMillIsACylinderWithAFilletOfItsRadius) {
    EXPECT_EQ(ball_end_mill(6, 20).pieces[0].profile, (Profile{{3, 0, 3}, {3, 20, 0}}));
}

TEST(Tool, ABallThatIsTooShortStillHasItsHemisphere) {
    EXPECT_EQ(ball_end_mill(6, 1).pieces[0].profile, (Profile{{3, 0, 3}, {3, 3, 0}}));
}

TEST(Tool, ACornerRadiusIsAtMostTheToolsRadius) {
    EXPECT_EQ(bull_nose_end_mill(6, 5, 20).pieces[0].profile,
              ball_end_mill(6, 20).pieces[0].profile);
}

TEST(Tool, VCutterOfNinetyDegreesRisesAsItWidens) {
    const Tool tool = v_cutter(6, 1, 90, 10);
    ASSERT_EQ(tool.pieces[0].profile.size(), 3U);
    EXPECT_EQ(tool.pieces[0].profile[0], (ProfilePoint{0.5, 0, 0}));
    EXPECT_NEAR(tool.pieces[0].profile[1].height, 2.5, 1e-12);
    EXPECT_EQ(tool.pieces[0].profile[2], (ProfilePoint{3, 10, 0}));
}

TEST(Tool, DrillHasAPoint) {
    const Tool tool = drill(10, 90, 40);
    EXPECT_EQ(tool.pieces[0].profile[0], (ProfilePoint{0, 0, 0}));
    EXPECT_NEAR(tool.pieces[0].profile[1].height, 5, 1e-12);
}

TEST(Tool, TaperedEndMillWithoutTaperIsABullNose) {
    EXPECT_EQ(tapered_end_mill(6, 1, 0, 20).pieces[0].profile,
              bull_nose_end_mill(6, 1, 20).pieces[0].profile);
}

TEST(Tool, HolderSegmentsStandOnTheToolAndDoNotCut) {
    Tool tool = flat_end_mill(10, 30);
    add_holder_segment(tool, 12, 12, 20);
    add_holder_segment(tool, 30, 40, 25);
    ASSERT_EQ(tool.pieces.size(), 3U);
    EXPECT_FALSE(tool.pieces[2].cutting);
    EXPECT_EQ(tool.pieces[2].profile, (Profile{{15, 50, 0}, {20, 75, 0}}));
    EXPECT_EQ(height_of(tool), 75);
    EXPECT_EQ(cutting_height_of(tool), 30);
    EXPECT_EQ(cutting_diameter_of(tool), 10);
}

TEST(Tool, MillsThatCutUnderThemselvesAreWidestBelow) {
    EXPECT_EQ(slot_mill(20, 0, 4).pieces[0].profile, (Profile{{10, 0, 0}, {10, 4, 0}}));
    const Tool dovetail = dovetail_mill(20, 45, 6);
    EXPECT_EQ(dovetail.pieces[0].profile[0], (ProfilePoint{10, 0, 0}));
    EXPECT_NEAR(dovetail.pieces[0].profile[1].radius, 4, 1e-12);
    // The tapered sides would meet below the requested height.
    EXPECT_GT(dovetail_mill(4, 60, 30).pieces[0].profile[1].radius, 0.0);
    EXPECT_EQ(lollipop_mill(6).pieces[0].profile, (Profile{{3, 0, 3}, {3, 6, 3}}));
}

TEST(Slice, IsWhatLiesBetweenTwoHeights) {
    const ToolPiece flat = flat_end_mill(10, 30).pieces[0];
    EXPECT_EQ(slice(flat, 5, 12).profile, (Profile{{5, 5, 0}, {5, 12, 0}}));
    EXPECT_EQ(slice(flat, 0, 30).profile, flat.profile);
    EXPECT_EQ(slice(flat, 20, 99).profile, (Profile{{5, 20, 0}, {5, 30, 0}}));
    EXPECT_TRUE(slice(flat, 30, 40).profile.empty());
    EXPECT_TRUE(slice(flat, 12, 12).profile.empty());
    const ToolPiece point = drill(10, 90, 40).pieces[0];
    EXPECT_EQ(slice(point, 2, 5).profile.size(), 2U);
    EXPECT_NEAR(slice(point, 2, 5).profile[0].radius, 2, 1e-9);
}

TEST(Slice, OfABallFollowsItsArc) {
    const ToolPiece ball = ball_end_mill(10, 30).pieces[0];
    const ToolPiece low = slice(ball, 0, 3);
    ASSERT_GT(low.profile.size(), 10U);
    EXPECT_EQ(low.profile.front().height, 0.0);
    EXPECT_EQ(low.profile.back().height, 3.0);
    for (const ProfilePoint& p : low.profile) {
        const double h = p.height - 5.0;
        const double distance = std::sqrt(p.radius * p.radius + h * h);
        EXPECT_NEAR(distance, 5.0, 1.1e-3);
        EXPECT_LT(distance, 5.0 + 1e-9);
    }
    const ToolPiece whole = slice(lollipop_mill(6).pieces[0], 0, 6);
    EXPECT_NEAR(whole.profile.back().radius, 0.0, 1e-9);
}

}  // namespace
}  // namespace ncsim::toolpath
