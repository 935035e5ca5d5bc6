// SPDX-License-Identifier: GPL-3.0-or-later
#include "nightly/nc_writer.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::nightly {
namespace {

constexpr std::array<bool, 3> kNone{};

// Returns a writer in millimetres with three decimals, at X1 Y2 Z3.
NcWriter writer() {
    NcWriter nc(false, 3);
    nc.begin(false, {1000, 2000, 3000});
    return nc;
}

std::string last_block(const NcWriter& nc) {
    const std::string& text = nc.text();
    const std::size_t begin = text.rfind('\n', text.size() - 2) + 1;
    return text.substr(begin, text.size() - 1 - begin);
}

void expect_near(const Vec& a, const Vec& b) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], 1e-12);
}

// Returns the tip at the end of the last move, or at parameter `t` of the last move.
Vec end(const NcWriter& nc, double t = 1.0) {
    return nc.moves().back().course.to_workpiece(t, {});
}

TEST(NcWriter, BeginsWithAMoveFromNowhere) {
    const NcWriter nc = writer();
    EXPECT_EQ(nc.text(), "G21 G90 G17 G40 G49 G80 G94\nG91.1\nT1 M6\nS1000 M3\nG0 X1. Y2. Z3.\n");
    EXPECT_TRUE(nc.moves().empty());
}

TEST(NcWriter, SaysAPlaceAbsoluteIncrementalAndShifted) {
    NcWriter nc = writer();
    nc.straight({{1000, 2500, 3000}, {0, 30500, 0}}, false, {true, false, false}, " F100");
    EXPECT_EQ(last_block(nc), "G1 X1. Y2.5 B30.5 F100");
    EXPECT_EQ(nc.moves().back().line, 6U);
    nc.set_incremental(true);
    nc.straight({{1000, 2500, 2999}, {0, 30000, 0}}, true, kNone, "");
    EXPECT_EQ(last_block(nc), "G0 Z-0.001 B-0.5");
    nc.set_incremental(false);
    nc.name_place({0, 500, 2999});
    EXPECT_EQ(last_block(nc), "G92 X0. Y0.5 Z2.999");
    nc.straight({{0, 0, 2999}, {}}, false, kNone, "");
    EXPECT_EQ(last_block(nc), "G1 X-1. Y-2. B0.");
    expect_near(end(nc), {0, 0, 2.999});
}

TEST(NcWriter, CountsInchesWhereItWritesThem) {
    NcWriter nc(true, 4);
    EXPECT_EQ(nc.ticks(25.4), 10000);
    EXPECT_DOUBLE_EQ(nc.mm(5000), 12.7);
}

TEST(NcWriter, TurnsAnArcTheWayThePlaneSays) {
    // A quarter from X1 Y2 Z3 about (X1 Z0): clockwise seen from +Y leads from +Z to −X.
    NcWriter nc = writer();
    ArcMove arc;
    arc.plane = kPlanes[1];
    arc.counter_clockwise = false;
    arc.to = {{-2000, 2000, 0}, {}};
    arc.centre = {-3000, 0};
    nc.arc(arc, kNone, " F50");
    EXPECT_EQ(nc.text().substr(nc.text().find("G18")), "G18\nG2 X-2. Z0. K-3. I0. F50\n");
    expect_near(end(nc, 0.5), {1 - 3 * std::sqrt(0.5), 2, 3 * std::sqrt(0.5)});
    expect_near(end(nc), {-2, 2, 0});
}

TEST(NcWriter, FindsTheCentreOfAnArcByRadius) {
    NcWriter nc = writer();
    ArcMove arc;
    arc.to = {{2000, 3000, 3000}, {}};
    arc.radius = 1000;
    nc.arc(arc, kNone, "");
    EXPECT_EQ(last_block(nc), "G3 X2. Y3. R1.");
    expect_near(end(nc, 0.5), {1 + std::sqrt(0.5), 3 - std::sqrt(0.5), 3});
    arc.to = {{1000, 2000, 3000}, {}};
    arc.radius = -1000;
    nc.arc(arc, kNone, "");
    EXPECT_EQ(last_block(nc), "G3 X1. Y2. R-1.");
    expect_near(end(nc, 0.5), {1 - std::sqrt(0.5), 3 + std::sqrt(0.5), 3});
}

TEST(NcWriter, DrillsFromRToTheBottomAndOutAgain) {
    NcWriter nc = writer();
    Drilling d;
    d.r = 1000;
    d.bottom = -4000;
    d.holes = {{5000, 5000, 0}, {6000, 5000, 0}};
    nc.drill(d);
    EXPECT_EQ(nc.text().substr(nc.text().find("G98")), "G98 G81 X5. Y5. Z-4. R1.\nX6. Y5.\nG80\n");
    ASSERT_EQ(nc.moves().size(), 8U);
    expect_near(nc.moves()[2].course.to().x, {5, 5, -4});
    expect_near(nc.moves()[4].course.from().x, {5, 5, 3});
    expect_near(end(nc), {6, 5, 3});
    EXPECT_EQ(nc.moves().back().line, 7U);
}

TEST(NcWriter, RepeatsHolesByIncrements) {
    NcWriter nc = writer();
    nc.set_incremental(true);
    Drilling d;
    d.to_r = true;
    d.r = 1000;
    d.bottom = -4000;
    d.holes = {{3000, 2000, 0}};
    d.repeats = 3;
    nc.drill(d);
    EXPECT_NE(nc.text().find("G99 G81 X2. Y0. Z-5. R-2. L3\n"), std::string::npos);
    expect_near(end(nc), {7, 2, 1});
}

}  // namespace
}  // namespace ncsim::nightly
