// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/toolpath/tool.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ncsim::toolpath
