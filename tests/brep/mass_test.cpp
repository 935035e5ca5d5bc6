// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares areas, volumes and centroids of solids with formulas.
#include "ncsim/brep/measure.h"

#include "brep/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace ncsim::brep {
namespace {

constexpr double kPi = std::numbers::pi;

struct Paper {
    double area;
    Vec3 centroid;
};

// Returns the centroid of the box of 20 x 16 x 10 mm after removal of `volume` (mm³), whose
// centroid is at (`x`, `y`, `height`).
Vec3 box_without(double volume, double height, double x = 10.0, double y = 8.0) {
    const double box = 3200.0, left = box - volume;
    return {(box * 10.0 - volume * x) / left, (box * 8.0 - volume * y) / left,
            (box * 5.0 - volume * height) / left};
}

// Returns the area (mm²) of 10 mm of the side of the slanting cylinder. The section across the
// rulings is an ellipse with half-axes 4 and 3.2 mm.
double slanting_side() {
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = 2.0 * kPi * i / kSteps;
        sum += std::hypot(4.0 * std::sin(t), 3.2 * std::cos(t));
    }
    return 10.0 * sum * 2.0 * kPi / kSteps;
}

// Returns areas and centroids by the formulas of a book of tables.
std::map<std::string, Paper> papers() {
    const double slant = 5.0, box = 2.0 * (320.0 + 200.0 + 160.0);
    const double bore = 45.0 * kPi, tip = 6.0 * kPi;
    const double ball = 64.0 * kPi * 2.0 / 3.0;
    return {
        {"cylinder", {2.0 * 25.0 * kPi + 80.0 * kPi, {0, 0, 4}}},
        {"frustum", {(36.0 + 9.0 + 9.0 * slant) * kPi, {0, 0, (36.0 + 36.0 + 27.0) / 63.0}}},
        {"bored_box", {box - 18.0 * kPi + 60.0 * kPi, {10, 8, 5}}},
        {"drilled_box",
         {box - 9.0 * kPi + 30.0 * kPi + kPi * 3.0 * std::sqrt(13.0),
          box_without(bore + tip, (bore * 7.5 + tip * 4.5) / (bore + tip))}},
        {"slanting_cylinder", {2.0 * 16.0 * kPi + slanting_side(), {10, 8, 4}}},
        {"slanting_bore",
         {2.0 * (320.0 + 160.0 + 128.0) - 2.0 * 16.0 * kPi + slanting_side(), {10, 8, 4}}},
        {"dimpled_box", {box - 16.0 * kPi + 32.0 * kPi, box_without(ball, 10.0 - 1.5)}},
    };
}

// A face between an arc and its chord. The ends of both miss each other by as much as programs
// round. The area below the ball, a hundred times as large, must not count for that gap.
TEST(Mass, SicklesWithGapsAreNarrow) {
    Part part;
    part.vertices = {{24.12629328924804, 37.604813308075826, 0},
                     {24.18295916777496, 37.633311551141006, 0}};
    const Vec3 up{0, 0, 1}, centre{23, 40, 3};
    part.edges = {{0, 1, Circle{{23, 40, 0}, up, 2.646782171349927}}, {1, 0, Line{}}};
    Face sickle;
    sickle.surface.form = Sphere{centre, 4.0};
    sickle.frame = {centre, normalized(Vec3{-2, -1, 0}), up};
    sickle.loops = {{{0, true}, {1, true}}};
    EXPECT_LT(std::abs(measure(part, sickle, centre).area), 1e-4);
    EXPECT_LT(std::abs(measure(part, sickle, {0, 0, 0}).volume), 1e-3);
}

TEST(Mass, IsAsInABookOfTables) {
    const auto paper = papers();
    std::size_t known = 0;
    for (const test::NamedPart& solid : test::solids()) {
        SCOPED_TRACE(solid.name);
        const Mass mass = mass_of(solid.part);
        EXPECT_NEAR(mass.volume, solid.volume, 1e-10 * solid.volume);
        const auto found = paper.find(solid.name);
        if (found == paper.end()) continue;
        ++known;
        EXPECT_NEAR(mass.area, found->second.area, 1e-10 * mass.area);
        EXPECT_NEAR(norm(mass.centroid - found->second.centroid), 0.0, 1e-10);
    }
    EXPECT_EQ(known, paper.size());
}

TEST(Mass, OfAGroovedBarIsOnItsAxis) {
    for (const test::NamedPart& solid : test::solids()) {
        if (solid.name != "grooved_bar") continue;
        const Mass mass = mass_of(solid.part);
        EXPECT_NEAR(mass.centroid.x, 0.0, 1e-10);
        EXPECT_NEAR(mass.centroid.y, 0.0, 1e-10);
    }
}

// Each piece of a spline is a polynomial only from knot to knot. Integration in even steps makes
// the area wrong by some millionths.
TEST(Mass, KnowsWhereThePiecesOfASplineEnd) {
    const Spline spline{
        {{0, 0, 0}, {0, 1, 0}, {1, 3, 0}, {2, 3.2, 0}, {3, 2, 0}, {4, 5, 0}, {6, 1, 0}, {6, 0, 0}},
        {0.0, 1.0, 1.3, 5.0}};
    Part part;
    part.vertices = {{0, 0, 0}, {6, 0, 0}};
    part.edges = {{0, 1, spline}, {0, 1, Line{}}};
    Face face;
    face.surface = {Plane{{0, 0, 0}, {0, 0, 1}}, false};
    face.frame = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    face.loops = {{{1, true}, {0, false}}};
    const Track track(part.edges[0].curve, part.vertices[0], part.vertices[1]);
    // The short piece is between the parameters 0.2 and 0.26.
    double area = 0.0;
    const auto add = [&](double begin, double end) {
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i) {
            const double width = (end - begin) / kSteps;
            const Vec3 a = track.at(begin + i * width), b = track.at(begin + (i + 1) * width);
            area += 0.5 * (a.y + b.y) * (b.x - a.x);
        }
    };
    add(0.0, 0.2), add(0.2, 0.26), add(0.26, 1.0);
    EXPECT_NEAR(measure(part, face, {0, 0, 0}).area, area, 1e-7);
    EXPECT_EQ(track.start_of(2), 0.26);
}

TEST(Mass, OfNothingIsNothing) {
    const Mass mass = mass_of(Part{});
    EXPECT_EQ(mass.volume, 0.0);
    EXPECT_EQ(mass.area, 0.0);
}

}  // namespace
}  // namespace ncsim::brep
