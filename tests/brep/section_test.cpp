// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections with known numbers of lines and arcs, radii and areas.
#include "ncsim/brep/section.h"

#include "ncsim/brep/measure.h"
#include "ncsim/setup/job.h"

#include "brep/cam_parts.h"
#include "brep/made_part.h"
#include "brep/random_parts.h"
#include "brep/solids.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr double kPi = std::numbers::pi;

// Numbers of lines, arcs, ellipses and chords.
using Curves = std::array<int, 4>;

Curves curves_of(const Section& section) {
    Curves curves{};
    for (const Outline& outline : section.outlines) {
        for (const SectionPiece& piece : outline)
            ++curves[piece.curve.index()];
    }
    return curves;
}

std::set<double> radii_of(const Section& section) {
    std::set<double> radii;
    for (const Outline& outline : section.outlines) {
        for (const SectionPiece& piece : outline) {
            if (const auto* arc = std::get_if<FlatArc>(&piece.curve))
                radii.insert(std::round(arc->radius * 1e9) / 1e9);
        }
    }
    return radii;
}

struct Drawing {
    std::string name, moves, plane;
    Curves curves;
    std::size_t outlines;
    std::set<double> radii;
    double area;
};

// Returns half the area of the segment that a chord at `distance` from the centre cuts off a
// circle.
double half_segment(double radius, double distance) {
    return 0.5 * (radius * radius * std::acos(distance / radius) -
                  distance * std::sqrt(radius * radius - distance * distance));
}

std::vector<Drawing> drawings() {
    const std::string slot = "T1 M6\nG0 X20 Y30 Z5\nG1 Z-4\nG1 X50\nG0 Z5\n";
    const std::string bore = "T1 M6\nG0 X45 Y30 Z5\nG1 Z-25\nG3 X45 Y30 I-5 J0\nG0 Z5\n";
    const std::string ball = "T3 M6\nG0 X20 Y30 Z5\nG1 Z-3\nG1 X60\nG0 Z5\n";
    const std::string ring = "T3 M6\nG0 X55 Y30 Z5\nG1 Z-3\nG2 X55 Y30 I-15 J0\nG0 Z5\n";
    const std::string drill = "T2 M6\nG0 X40 Y30 Z5\nG1 Z-10\nG0 Z5\n";
    const double tip = 3.0 / std::tan(59.0 * kPi / 180.0);
    const double groove = half_segment(4.0, 1.0) * 2.0;
    return {
        // The section in the plane of the floor shows the slot's walls; a section below shows none.
        {"slot", slot, "z=-4", {6, 2, 0, 0}, 2, {5.0}, 4800.0 - 300.0 - 25.0 * kPi},
        {"slot_below", slot, "z=-4.001", {4, 0, 0, 0}, 1, {}, 4800.0},
        {"slot_along", slot, "y=30", {8, 0, 0, 0}, 1, {}, 1600.0 - 40.0 * 4.0},
        {"slot_across", slot, "x=30", {8, 0, 0, 0}, 1, {}, 1200.0 - 40.0},
        // The plane touches the end of the slot.
        {"slot_end", slot, "x=55", {4, 0, 0, 0}, 1, {}, 1200.0},
        {"slot_begin", slot, "x=15", {4, 0, 0, 0}, 1, {}, 1200.0},
        {"bore", bore, "z=-16.3", {4, 1, 0, 0}, 2, {10.0}, 4800.0 - 100.0 * kPi},
        {"bore_bottom", bore, "z=-20", {4, 1, 0, 0}, 2, {10.0}, 4800.0 - 100.0 * kPi},
        {"bore_along", bore, "y=30", {8, 0, 0, 0}, 2, {}, 1600.0 - 400.0},
        {"ball_along", ball, "y=30", {6, 2, 0, 0}, 1, {4.0}, 1600.0 - 120.0 - 2.0 * groove / 2.0},
        {"ball_across", ball, "x=40", {5, 1, 0, 0}, 1, {4.0}, 1200.0 - groove},
        {"ball_level",
         ball,
         "z=-2",
         {6, 2, 0, 0},
         2,
         {std::round(std::sqrt(7.0) * 1e9) / 1e9},
         4800.0 - 40.0 * 2.0 * std::sqrt(7.0) - 7.0 * kPi},
        {"ball_bottom", ball, "z=-3", {4, 0, 0, 0}, 1, {}, 4800.0},
        {"ring_level",
         ring,
         "z=-2",
         {4, 2, 0, 0},
         3,
         {std::round((15.0 - std::sqrt(7.0)) * 1e9) / 1e9,
          std::round((15.0 + std::sqrt(7.0)) * 1e9) / 1e9},
         4800.0 - 60.0 * kPi * std::sqrt(7.0)},
        {"ring_middle", ring, "x=40", {6, 2, 0, 0}, 1, {4.0}, 1200.0 - 2.0 * groove},
        {"drill_along",
         drill,
         "x=40",
         {9, 0, 0, 0},
         1,
         {},
         1200.0 - 6.0 * (10.0 - tip) - 3.0 * tip},
        {"drill_tip",
         drill,
         "z=-9",
         {4, 1, 0, 0},
         2,
         {std::round(std::tan(59.0 * kPi / 180.0) * 1e9) / 1e9},
         4800.0 - kPi * std::pow(std::tan(59.0 * kPi / 180.0), 2)},
        {"ramp_level",
         "T1 M6\nG0 X20 Y30 Z0\nG1 X60 Z-4\nG0 Z5\n",
         "z=-2",
         {6, 2, 0, 0},
         2,
         {5.0},
         4800.0 - 200.0 - 25.0 * kPi},
        {"dip_level",
         "T1 M6\nG0 X20 Y30 Z0\nG18 G2 X26 Z-6 I6 K0\nG1 X44\nG2 X50 Z0 I0 K6\nG17\nG0 Z5\n",
         "z=-3",
         {6, 2, 0, 0},
         2,
         {5.0},
         4800.0 - 10.0 * (18.0 + 6.0 * std::sqrt(3.0)) - 25.0 * kPi},
        {"above", slot, "z=0", {0, 0, 0, 0}, 0, {}, 0.0},
    };
}

class SectionOf : public testing::TestWithParam<Drawing> {};

TEST_P(SectionOf, IsAsDrawn) {
    const Drawing& drawing = GetParam();
    const auto made = test::make_part(drawing.name, drawing.moves);
    const auto section = section_of(made.solid.part, *parse_section_plane(drawing.plane));
    ASSERT_TRUE(section.has_value());
    EXPECT_EQ(section->outlines.size(), drawing.outlines);
    EXPECT_EQ(curves_of(*section), drawing.curves);
    EXPECT_EQ(radii_of(*section), drawing.radii);
    EXPECT_NEAR(section->area_mm2, drawing.area, 1e-8 * (1.0 + drawing.area));
}

INSTANTIATE_TEST_SUITE_P(Drawings, SectionOf, testing::ValuesIn(drawings()),
                         [](const auto& tested) { return tested.param.name; });

// Slices of a body have the volume of the body (Cavalieri).
TEST(Section, SlicesHaveTheVolumeOfTheBody) {
    for (const test::NamedPart& body : test::solids()) {
        SCOPED_TRACE(body.name);
        Box box;
        for (const Vec3& v : body.part.vertices)
            box.add(v - Vec3{30, 30, 1}), box.add(v + Vec3{30, 30, 1});
        for (int axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE(axis);
            constexpr int kSlices = 600;
            const double step = box.size()[axis] / kSlices;
            double sum = 0.0;
            for (int i = 0; i < kSlices; ++i) {
                const auto slice = section_of(body.part, {axis, box.min[axis] + (i + 0.5) * step});
                ASSERT_TRUE(slice.has_value()) << box.min[axis] + (i + 0.5) * step;
                for (const Outline& outline : slice->outlines) {
                    for (std::size_t k = 0; k < outline.size(); ++k)
                        EXPECT_EQ(outline[k].to, outline[(k + 1) % outline.size()].from);
                }
                sum += slice->area_mm2 * step;
            }
            EXPECT_NEAR(sum, body.volume, 1e-2 * body.volume);
        }
    }
}

// Sections of recognised surfaces are as large as sections of the polyhedron.
TEST(Section, OfRandomPartsIsThatOfTheirPolyhedra) {
    std::size_t known = 0, all = 0;
    std::vector<std::string> programs;
    for (std::uint64_t seed = 0; seed < 12; ++seed)
        programs.push_back(test::random_part(seed));
    // Programs that leave spindle tori (minor radius > major radius).
    for (const std::uint64_t seed : {10U, 28U, 31U, 65U, 73U, 90U})
        programs.push_back(test::cam_part(test::kCam + seed));
    for (std::size_t i = 0; i < programs.size(); ++i) {
        SCOPED_TRACE(i);
        const auto made = test::make_part(setup::job_of({"part.nc", programs[i]}), 0.05);
        const std::vector<std::vector<cda::Origin>> none(made.boundary.faces.size());
        const Part polyhedron = faceted(made.boundary, none);
        const Box box = cda::bounds(made.boundary);
        for (int axis = 0; axis < 3; ++axis) {
            for (const double share : {0.11, 0.37, 0.5, 0.83, 0.97}) {
                const double at = box.min[axis] + share * box.size()[axis];
                SCOPED_TRACE(name_of({axis, at}));
                const auto flat = section_of(polyhedron, {axis, at});
                const auto section = section_of(made.solid.part, {axis, at});
                ++all;
                ASSERT_TRUE(flat.has_value());
                if (!section) continue;
                ++known;
                constexpr double kError = 0.06;  // by tools and chords
                EXPECT_NEAR(section->area_mm2, flat->area_mm2,
                            kError * std::max(section->area_per_mm, flat->area_per_mm));
            }
        }
    }
    // No torus is tilted. 14 planes cut spindle tori parallel to their axes, which is
    // not supported.
    EXPECT_EQ(known + 14, all);
}

TEST(Section, PlanesAreReadAsTheyAreWritten) {
    EXPECT_EQ(parse_section_plane("z=-4"), (SectionPlane{2, -4.0}));
    EXPECT_EQ(parse_section_plane("X=1.5"), (SectionPlane{0, 1.5}));
    EXPECT_EQ(name_of({1, 0.25}), "y=0.25");
    for (const char* wrong : {"", "z", "z=", "a=1", "z=1mm", "z=nan", "z=1e300", "z=--1", "=4"})
        EXPECT_FALSE(parse_section_plane(wrong).has_value()) << wrong;
}

}  // namespace
}  // namespace ncsim::brep
