// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces and places on them: sets of equal surfaces, facets that fit, elements of profiles, paths
// as polynomials, cuts by planes, corners of paths, segments and circles on maps.
#include "ncsim/brep/candidate_filter.h"
#include "ncsim/brep/part_shading.h"
#include "ncsim/brep/profile_sweep.h"

#include "geometry/contact.h"
#include "geometry/cut_walk.h"
#include "geometry/path_corners.h"
#include "geometry/plane_cut.h"
#include "geometry/tolerances.h"
#include "query/map_segments.h"
#include "sources/label.h"
#include "sources/path_segments.h"
#include "sources/profile_elements.h"
#include "sources/surface_set.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr Vec3 kUp{0, 0, 1};
constexpr double kPi = std::numbers::pi;

// --- Tolerances ---

TEST(Tolerances, DirectionsAndDistances) {
    EXPECT_TRUE(is_parallel({1, 0, 0}, {-1, 0, 0}));
    EXPECT_TRUE(is_parallel({1, 0, 0}, {1, 0.9e-5, 0}));
    EXPECT_FALSE(is_parallel({1, 0, 0}, {1, 1.1e-5, 0}));
    EXPECT_TRUE(is_perpendicular({1, 0, 0}, {0.9e-5, 1, 0}));
    EXPECT_FALSE(is_perpendicular({1, 0, 0}, {1.1e-5, 1, 0}));
    EXPECT_TRUE(is_near(5.0, 5.0029) && is_near(5.0029, 5.0));
    EXPECT_FALSE(is_near(5.0, 5.0031));
    EXPECT_EQ(radial_vector({1, 2, 3}, kUp, {4, 6, 99}), (Vec3{3, 4, 0}));
}

// --- Sets of surfaces ---

TEST(SurfaceSet, EqualSurfacesHaveOneNumber) {
    const Vec3 lean = normalized({1, 2, 2});
    const std::vector<Form> forms{Plane{{1, 2, 3}, lean},
                                  Cylinder{{1, 2, 3}, lean, 5},
                                  Cone{{1, 2, 3}, lean, 0.5},
                                  Sphere{{1, 2, 3}, 5},
                                  Torus{{1, 2, 3}, lean, 8, 2},
                                  Extrusion{{1, 2, 3}, kUp, lean, 5},
                                  Dome{{1, 2, 3}, {0, 1, 0}, {1, 0, 0}, 8, 2},
                                  Coil{{1, 2, 3}, kUp, {1, 0, 0}, 8, 2, 0.4},
                                  Spiral{{1, 2, 3}, kUp, {1, 0, 0}, 20, 0.5, 3}};
    SurfaceSet set;
    for (std::uint32_t i = 0; i < forms.size(); ++i)
        EXPECT_EQ(set.add({forms[i], false}), i);
    for (std::uint32_t i = 0; i < forms.size(); ++i)
        EXPECT_EQ(set.add({forms[i], false}), i) << "in any order";
    // The same surface described by other values.
    EXPECT_EQ(set.add({Plane{Vec3{1, 2, 3} + 7.0 * cross(lean, kUp), lean}, false}), 0U);
    EXPECT_EQ(set.add({Cylinder{Vec3{1, 2, 3} - 30.0 * lean, -lean, 5}, false}), 1U);
    EXPECT_EQ(set.add({Cylinder{{1, 2, 3}, lean, 5 + 1e-5}, false}), 1U) << "within 2e-5 mm";
    EXPECT_EQ(set.add({Sphere{{1, 2, 3 + 1e-5}, 5}, false}), 3U);
    EXPECT_EQ(set.add({Extrusion{Vec3{1, 2, 3} + 9.0 * lean, kUp, lean, 5}, false}), 5U);
    const auto many = static_cast<std::uint32_t>(forms.size());
    EXPECT_EQ(set.add({Cylinder{{1, 2, 3}, lean, 5 + 1e-4}, false}), many);
    EXPECT_EQ(set.add({Cylinder{{1, 2, 3}, lean, 5}, true}), many + 1) << "hollow";
    EXPECT_EQ(set.add({Plane{{1, 2, 3}, -lean}, false}), many + 2) << "the other side";
    EXPECT_EQ(set.add({Cone{{1, 2, 3}, -lean, 0.5}, false}), many + 3) << "the other nappe";
    EXPECT_EQ(set.add_alone({forms[3], false}), many + 4);
    EXPECT_EQ(set.add({forms[3], false}), 3U) << "a number of its own is not found";
    EXPECT_EQ(std::get<Sphere>(set[3].form).radius, 5.0);
}

// --- Facets on surfaces ---

using Loops = std::vector<std::vector<std::uint32_t>>;

TEST(Label, AreaAndCentroidOfAnL) {
    const std::vector<Vec3> points{{0, 0, 5}, {2, 0, 5}, {2, 1, 5},
                                   {1, 1, 5}, {1, 2, 5}, {0, 2, 5}};
    Vec3 centroid;
    EXPECT_NEAR(area_of({{0, 1, 2, 3, 4, 5}}, points, kUp, centroid), 3.0, 1e-12);
    EXPECT_NEAR(norm(centroid - Vec3{2.5 / 3, 2.5 / 3, 5}), 0.0, 1e-12);
    // Any corner may be the first.
    EXPECT_NEAR(area_of({{3, 4, 5, 0, 1, 2}}, points, kUp, centroid), 3.0, 1e-12);
    EXPECT_NEAR(norm(centroid - Vec3{2.5 / 3, 2.5 / 3, 5}), 0.0, 1e-12);
    EXPECT_NEAR(area_of({{5, 4, 3, 2, 1, 0}}, points, kUp, centroid), -3.0, 1e-12);
    EXPECT_EQ(centroid, points[5]) << "no area: the first corner";
    // A hole is subtracted.
    const std::vector<Vec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                   {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
    EXPECT_NEAR(area_of({{0, 1, 2, 3}, {4, 5, 6, 7}}, square, kUp, centroid), 15.0, 1e-12);
    EXPECT_NEAR(centroid.x, (16 * 2.0 - 1.5) / 15, 1e-12);
}

/// A facet of a prism of `sides` sides around a cylinder of radius 5 along Z.
struct PrismFacet {
    PrismFacet(int sides, double height) {
        const double half = kPi / sides, out = 5.0 / std::cos(half), y = out * std::sin(half);
        points = {{5, -y, 0}, {5, y, 0}, {5, y, height}, {5, -y, height}};
    }
    FlatFace face() const { return {{1, 0, 0}, {5, 0, points[2].z / 2}, loops, points}; }
    std::vector<Vec3> points;
    Loops loops{{0, 1, 2, 3}};
};

TEST(Label, FacetsFitWithinTheirErrorAndTurn) {
    const PrismFacet facet(16, 10);
    const double off = norm(Vec3{facet.points[0].x, facet.points[0].y, 0}) - 5.0;  // 0.098 mm
    const Surface cylinder{Cylinder{{}, kUp, 5}, false};
    double score = 0.0;
    EXPECT_TRUE(fits(facet.face(), cylinder, 1.01 * off, 0.1, &score));
    EXPECT_GE(score, 0.0);
    EXPECT_FALSE(fits(facet.face(), cylinder, 0.99 * off, 0.1)) << "corners are too far off";
    EXPECT_FALSE(fits(facet.face(), {Cylinder{{}, kUp, 5}, true}, 1.01 * off, 0.1))
        << "the material is on the other side";
    EXPECT_FALSE(fits(facet.face(), {Cylinder{{}, kUp, 4.5}, false}, 1.01 * off, 0.1));
    EXPECT_TRUE(fits(facet.face(), {Plane{{5, 0, 0}, {1, 0, 0}}, false}, 1e-9, 1e-9));
    EXPECT_FALSE(fits(facet.face(), {Plane{{5, 0, 0}, normalized({1, 0.2, 0})}, false}, 9, 0.1));
}

TEST(Label, TheBestCandidateTurnsLeast) {
    const PrismFacet facet(32, 10);
    std::vector<CandidateSurface> candidates(3);
    candidates[0].surface = {Cylinder{{0.01, 0.3, 0}, kUp, 5}, false};
    candidates[1].surface = {Cylinder{{}, kUp, 5}, false};
    candidates[2].surface = {Cylinder{{}, kUp, 6}, false};
    for (int order = 0; order < 2; ++order) {
        double best = 1.0;
        const CandidateSurface* found = best_of(facet.face(), candidates, 0.05, 0.2, best);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(std::get<Cylinder>(found->surface.form).origin, Vec3{});
        EXPECT_LT(best, 1.0);
        double better = best;
        EXPECT_EQ(best_of(facet.face(), candidates, 0.05, 0.2, better), nullptr)
            << "no candidate is better than the best";
        std::ranges::reverse(candidates);
    }
    double best = 1.0;
    EXPECT_EQ(best_of(facet.face(), {}, 0.05, 0.2, best), nullptr);
    candidates.resize(1);  // too large
    candidates[0].surface = {Cylinder{{}, kUp, 6}, false};
    EXPECT_EQ(best_of(facet.face(), candidates, 0.05, 0.2, best), nullptr);
    EXPECT_EQ(best, 1.0);
}

/// Two facets of a prism of 16 sides about Z, of the motions 1 and 2, and a top of motion 1.
cda::Boundary prism_boundary() {
    cda::Boundary boundary;
    const PrismFacet facet(16, 10);
    boundary.vertices = facet.points;
    for (const std::uint32_t motion : {2U, 1U, 1U}) {
        cda::BoundaryFace face;
        face.origin = cda::Origin{motion};
        face.normal = {1, 0, 0};
        face.offset = 5.0;
        face.loops = facet.loops;
        boundary.faces.push_back(face);
    }
    return boundary;
}

TEST(CandidateFilter, FacesOfAnOriginThatLieOnACandidate) {
    const cda::Boundary boundary = prism_boundary();
    const FacesByOrigin faces(boundary);
    const auto of = [&](std::uint32_t motion) {
        const auto span = faces.of(cda::Origin{motion});
        return std::vector<std::uint32_t>(span.begin(), span.end());
    };
    EXPECT_EQ(of(1), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(of(2), std::vector<std::uint32_t>{0});
    EXPECT_TRUE(of(3).empty());
    SweptSurfaces source;
    source.error_mm = 0.1;
    source.candidates.resize(2);
    source.candidates[0].surface = {Cylinder{{}, kUp, 5}, false};
    source.candidates[1].surface = {Cylinder{{}, kUp, 7}, false};
    const CandidateFilter filter(boundary);
    EXPECT_EQ(filter.fitting(cda::Origin{1}, source, 1.0), (std::vector<bool>{true, false}));
    EXPECT_EQ(filter.fitting(cda::Origin{3}, source, 1.0), (std::vector<bool>{false, false}));
}

TEST(Shading, RoundFacetsHaveTheNormalsOfTheirSurface) {
    const cda::Boundary boundary = prism_boundary();
    SweptSurfaces source;
    source.error_mm = 0.1;
    source.candidates.resize(1);
    source.candidates[0].surface = {Cylinder{{}, kUp, 5}, false};
    ShadingMaker maker(boundary);
    maker.take(cda::Origin{1}, source);
    const Shading shading = maker.finish();
    EXPECT_EQ(shading.recognition(0), Shading::Recognition::Unknown) << "of another motion";
    EXPECT_EQ(shading.recognition(1), Shading::Recognition::Curved);
    EXPECT_EQ(shading.recognition(99), Shading::Recognition::Unknown);
    EXPECT_EQ(shading.surface_of(0), nullptr);
    ASSERT_NE(shading.surface_of(1), nullptr);
    const Vec3 own{1, 0, 0};
    for (std::uint32_t v = 0; v < 4; ++v) {
        const Vec3 p = boundary.vertices[v];
        EXPECT_EQ(shading.normal(0, own, v, p), own);
        const Vec3 n = shading.normal(1, own, v, p);
        EXPECT_NEAR(norm(n - normalized({p.x, p.y, 0})), 0.0, 1e-12);
        EXPECT_EQ(shading.normal(1, -own, v, p), -own) << "more than 60 degrees away";
    }
    EXPECT_EQ(Shading().recognition(0), Shading::Recognition::Unknown);
}

// --- Profiles ---

TEST(ProfileElements, CloseTheProfileWithDiscs) {
    const auto flat = elements_of({{{5, 0, 0}, {5, 20, 0}}});
    ASSERT_EQ(flat.size(), 3U);
    EXPECT_EQ(flat[0].widening(), 5.0);
    EXPECT_EQ(flat[0].rise(), 0.0);
    EXPECT_EQ(flat[1].rise(), 20.0);
    EXPECT_EQ(flat[1].radius, 5.0);
    EXPECT_EQ(flat[2].widening(), -5.0);
    // A ball end: no disc below, an arc about (0, 5), the wall from 5 mm upwards.
    const auto ball = elements_of({{{5, 0, 5}, {5, 20, 0}}});
    ASSERT_EQ(ball.size(), 3U);
    EXPECT_NEAR(ball[0].radius, 0.0, 1e-12);
    EXPECT_NEAR(ball[0].height, 5.0, 1e-12);
    EXPECT_EQ(ball[0].fillet, 5.0);
    EXPECT_NEAR(ball[1].height, 5.0, 1e-12);
    EXPECT_NEAR(ball[1].rise(), 15.0, 1e-12);
    // A cone from its tip.
    const auto cone = elements_of({{{0, 0, 0}, {5, 5, 0}}});
    ASSERT_EQ(cone.size(), 2U);
    EXPECT_EQ(cone[0].widening(), 5.0);
    EXPECT_TRUE(elements_of({}).empty());
    // Straight elements join, whatever the corner radius.
    for (const double r : {0.5, 1.0, 2.5}) {
        const auto bull = elements_of({{{5, 0, r}, {5, 20, 0}}});
        ASSERT_EQ(bull.size(), 4U);
        EXPECT_NEAR(bull[0].end_radius, 5 - r, 1e-12);
        EXPECT_NEAR(bull[1].radius, 5 - r, 1e-12);
        EXPECT_NEAR(bull[1].height, r, 1e-12);
        EXPECT_NEAR(bull[2].height, r, 1e-12);
    }
}

// --- Paths ---

TEST(RotaryPath, FollowsATurningTool) {
    const auto pose = [](double t) -> TipAndAxis {
        const double a = 0.6 * t, b = 0.3 * t * t;
        return {{10 * t, 5 * std::sin(a), 2 * std::cos(b)},
                {std::sin(a), -std::sin(b) * std::cos(a), std::cos(b) * std::cos(a)}};
    };
    const auto path = fit_rotary_path(pose);
    ASSERT_TRUE(path);
    for (const double t : {-0.25, 0.0, 0.3, 1.0, 1.25}) {
        const ToolFrame at = tool_frame(*path, t);
        EXPECT_NEAR(norm(at.tip - pose(t).tip), 0.0, 2e-9);
        EXPECT_NEAR(norm(at.axis - pose(t).axis), 0.0, 2e-11);
        if (t < 0.0 || t > 1.0) continue;
        // Derivatives by differences.
        const double h = 1e-4;
        const ToolFrame before = tool_frame(*path, t - h), after = tool_frame(*path, t + h);
        EXPECT_NEAR(norm(at.speed - (0.5 / h) * (after.tip - before.tip)), 0.0, 1e-6);
        EXPECT_NEAR(norm(at.turn - (0.5 / h) * (after.axis - before.axis)), 0.0, 1e-6);
        EXPECT_NEAR(norm(at.change - (0.5 / h) * (after.speed - before.speed)), 0.0, 1e-5);
        EXPECT_NEAR(norm(at.bend - (0.5 / h) * (after.turn - before.turn)), 0.0, 1e-5);
    }
    EXPECT_FALSE(fit_rotary_path([](double t) -> TipAndAxis {
        return {{0, 0, 0}, {std::sin(90 * t), 0, std::cos(90 * t)}};
    })) << "14 turns";
}

TEST(Sweep, MovesAlongItsPath) {
    const Sweep straight(Fillet{3, 2, 2}, StraightPath{{0, 0, 0}, {30, 40, 0}, kUp});
    EXPECT_NEAR(straight.length_mm(), 50.0, 1e-9);
    EXPECT_FALSE(straight.is_ball() || straight.is_rim());
    EXPECT_EQ(straight.at(0.5).tip, (Vec3{15, 20, 0}));
    EXPECT_EQ(straight.at(0.5).speed, (Vec3{30, 40, 0}));
    EXPECT_EQ(lowest_centre(straight), 2.0);
    const PathFrame frame = path_frame(straight, straight.at(0));
    EXPECT_NEAR(norm(frame.ahead - Vec3{0.6, 0.8, 0}), 0.0, 1e-12);
    EXPECT_NEAR(norm(cross(frame.ahead, frame.up) - frame.side), 0.0, 1e-12);
    EXPECT_EQ(frame.centre, (Vec3{0, 0, 2}));
    EXPECT_TRUE(Sweep(Fillet{0, 5, 5}, StraightPath{}).is_ball());
    EXPECT_TRUE(Sweep(Fillet{5, 0, 0}, StraightPath{}).is_rim());
    // A half turn of radius 10 that rises by 3 mm.
    const Sweep helix(Fillet{0, 5, 5}, HelixPath{{}, kUp, {1, 0, 0}, 10, 0, 3 / kPi, kPi, kUp});
    EXPECT_NEAR(norm(helix.at(0).tip - Vec3{10, 0, 0}), 0.0, 1e-12);
    EXPECT_NEAR(norm(helix.at(0.5).tip - Vec3{0, 10, 1.5}), 0.0, 1e-12);
    EXPECT_NEAR(norm(helix.at(1).tip - Vec3{-10, 0, 3}), 0.0, 1e-12);
    EXPECT_NEAR(helix.length_mm(), std::hypot(10 * kPi, 3), 0.1);
    const double h = 1e-5;
    EXPECT_NEAR(
        norm(helix.at(0.3).speed - (0.5 / h) * (helix.at(0.3 + h).tip - helix.at(0.3 - h).tip)),
        0.0, 1e-6);
    EXPECT_NEAR(norm(velocity_at(helix.at(0.3), 7.0) - helix.at(0.3).speed), 0.0, 1e-12)
        << "the axis does not turn";
}

std::optional<ArcPath> path_of(Vec3 from, Vec3 to, Vec3 centre, bool clockwise) {
    const auto at = [](Vec3 p) {
        gcode::Position position;
        position.x = gcode::Length::from_mm(p.x);
        position.y = gcode::Length::from_mm(p.y);
        position.z = gcode::Length::from_mm(p.z);
        return position;
    };
    gcode::Arc arc;
    arc.from = at(from), arc.to = at(to);
    arc.centre_1 = gcode::Length::from_mm(centre.x);
    arc.centre_2 = gcode::Length::from_mm(centre.y);
    arc.turns = clockwise ? -1 : 1;
    gcode::Motion motion;
    motion.action = arc;
    return arc_path(arc, toolpath::Poses(nullptr, motion));
}

TEST(ArcPath, HasTheAngleAndTheRiseOfTheArc) {
    struct Row {
        Vec3 to;
        bool clockwise;
        double degrees, rise_mm;
    };
    for (const Row& row : {Row{{0, 10, 0}, false, 90, 0}, Row{{0, 10, 0}, true, 270, 0},
                           Row{{-10, 0, 4}, false, 180, 4}, Row{{-10, 0, -4}, true, 180, -4},
                           Row{{10, 0, 6}, false, 360, 6}}) {
        const auto path = path_of({10, 0, 0}, row.to, {}, row.clockwise);
        ASSERT_TRUE(path);
        EXPECT_NEAR(path->radius, 10.0, 1e-9);
        EXPECT_NEAR(std::abs(path->swept), row.degrees * kPi / 180, 1e-9);
        EXPECT_NEAR(path->rise * path->swept, row.rise_mm, 1e-9);
        EXPECT_EQ(path->is_level, row.rise_mm == 0.0);
        EXPECT_FALSE(path->spiral);
        EXPECT_NEAR(norm(path->ahead - Vec3{1, 0, 0}), 0.0, 1e-9);
    }
    const auto spiral = path_of({10, 0, 0}, {0, 10.5, 0}, {}, false);
    ASSERT_TRUE(spiral);
    EXPECT_TRUE(spiral->spiral);
    EXPECT_NEAR(spiral->growth * spiral->swept, 0.5, 1e-9);
    EXPECT_FALSE(path_of({10, 0, 0}, {0, 20, 0}, {}, false)) << "far more than a fifth per radian";
}

// --- Cuts by planes ---

TEST(PlaneCut, BranchesLieOnFormAndPlane) {
    const std::vector<std::pair<Form, Vec3>> forms{
        // A form, and a point on it.
        {Plane{{}, normalized({1, 0, 1})}, {1, 7, -1}},
        {Cylinder{{1, 2, 0}, kUp, 5}, {6, 2, 3}},
        {Cone{{1, 2, 0}, kUp, 0.5}, {3, 2, 4}},
        {Sphere{{1, 2, 3}, 5}, {6, 2, 3}},
        {Torus{{1, 2, 3}, kUp, 8, 2}, {11, 2, 3}},
        {Extrusion{{1, 2, 0}, kUp, normalized({1, 0, 2}), 5}, {6, 2, 0}}};
    for (std::size_t f = 0; f < forms.size(); ++f) {
        for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0.3, 0.5, 1}}) {
            const auto& [form, p] = forms[f];
            ASSERT_NEAR(distance(form, p), 0.0, 1e-9);
            const Vec3 normal = normalized(direction);
            const CutPlane plane{normal, dot(normal, p)};
            const PlaneCut cut(form, plane);
            SCOPED_TRACE(testing::Message() << f << ' ' << direction.x << ' ' << direction.y);
            if (!cut.is_known() || cut.apex()) continue;
            ASSERT_GE(cut.branches(), 1U);
            const std::size_t branch = cut.branch_of(p);
            const double place = cut.place_of(p);
            EXPECT_NEAR(norm(cut.at(branch, place) - p), 0.0, 1e-9);
            for (const double step : {-1.0, 0.5, 2.0}) {
                const Vec3 q = cut.at(branch, place + step);
                EXPECT_NEAR(distance(form, q), 0.0, 1e-9);
                EXPECT_NEAR(plane.height(q), 0.0, 1e-9);
                EXPECT_EQ(cut.branch_of(q), branch);
                EXPECT_EQ(cut.grows(p, q - p), step > 0.0);
            }
        }
    }
}

TEST(PlaneCut, ExactCurvesOfACylinder) {
    const Cylinder cylinder{{}, kUp, 5};
    const auto level = PlaneCut(cylinder, {kUp, 3}).exact(0);
    ASSERT_TRUE(level);
    EXPECT_NEAR(norm(level->centre - Vec3{0, 0, 3}), 0.0, 1e-12);
    EXPECT_NEAR(norm(level->x), 5.0, 1e-12);
    EXPECT_NEAR(norm(level->y), 5.0, 1e-12);
    const PlaneCut walls(cylinder, {{1, 0, 0}, 3});
    EXPECT_EQ(walls.branches(), 2U);
    EXPECT_TRUE(walls.is_straight());
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(std::abs(walls.exact(i)->centre.y), 4.0, 1e-12);
    EXPECT_EQ(PlaneCut(cylinder, {{1, 0, 0}, 5.1}).branches(), 0U) << "outside the cylinder";
    const double a = 60 * kPi / 180;
    const auto oblique = PlaneCut(cylinder, {{std::sin(a), 0, std::cos(a)}, 0}).exact(0);
    ASSERT_TRUE(oblique);
    EXPECT_NEAR(std::max(norm(oblique->x), norm(oblique->y)), 10.0, 1e-9) << "5 / cos 60°";
    EXPECT_NEAR(std::min(norm(oblique->x), norm(oblique->y)), 5.0, 1e-9);
    const auto apex = PlaneCut(Cone{{1, 2, 3}, kUp, 0.5}, {{1, 0, 0}, 1}).apex();
    ASSERT_TRUE(apex);
    EXPECT_NEAR(norm(*apex - Vec3{1, 2, 3}), 0.0, 1e-12);
    EXPECT_FALSE(PlaneCut(Cone{{1, 2, 3}, kUp, 0.5}, {{1, 0, 0}, 1.5}).apex());
}

TEST(PlaneCut, ThroughAnApexHasOnePlaceForEachRuling) {
    const Vec3 apex{1, 2, 3};
    for (const double slope : {0.25, 0.5, 1.0}) {
        for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, normalized({3, 4, 0})}) {
            const PlaneCut cut(Cone{apex, kUp, slope}, {normal, dot(normal, apex)});
            ASSERT_TRUE(cut.apex());
            const Vec3 side = cross(kUp, normal);
            for (const double sign : {1.0, -1.0}) {
                const double place = cut.place_of(apex + kUp + (sign * slope) * side);
                const double further = cut.place_of(apex + 7.0 * (kUp + (sign * slope) * side));
                EXPECT_NEAR(place, further, 1e-9);
                EXPECT_LT(norm(cut.at(0, place) - apex), 1e-9) << "not a number is not less";
            }
            for (const double place : {-180.0, -90.0, 0.0, 45.0, 90.0, 180.0, 270.0})
                EXPECT_LT(norm(cut.at(0, place) - apex), 1e-9) << place;
        }
    }
}

TEST(CutWalk, FollowsTheCutToAnEnd) {
    // A dome's cut by an oblique plane is no curve with a name; a sphere's is a circle, so the walk
    // can be compared with it.
    const Surface ball{Sphere{{}, 5}, false};
    const CutPlane plane{kUp, 3};
    const Vec3 begin{4, 0, 3}, quarter{0, 4, 3}, half{-4, 0, 3};
    const std::vector<Vec3> ends{half, quarter};
    const auto walk = walk_along_cut(ball, plane, begin, ends, 0.01);
    ASSERT_TRUE(walk);
    double turned = 0.0;
    Vec3 last = begin;
    for (const Vec3& p : walk->between) {
        EXPECT_NEAR(norm(p), 5.0, 1e-6);
        EXPECT_NEAR(p.z, 3.0, 1e-9);
        turned += std::atan2(cross(last, p).z, last.x * p.x + last.y * p.y);
        last = p;
    }
    // With the material on the left, seen from above, the walk is counter-clockwise.
    EXPECT_EQ(walk->end, 1U);
    EXPECT_GT(turned, 0.0);
    EXPECT_LT(turned, kPi / 2);
    const auto hollow = walk_along_cut({Sphere{{}, 5}, true}, plane, begin, ends, 0.01);
    ASSERT_TRUE(hollow);
    EXPECT_EQ(hollow->end, 0U) << "clockwise, half of the circle comes first";
}

// --- Curves of two forms ---

TEST(IntersectionCurve, HasANameWhereItCan) {
    const Cylinder pipe{{}, kUp, 5};
    const auto circle =
        intersection_curve(pipe, Plane{{0, 0, 3}, kUp}, {5, 0, 3}, {0, 5, 3}, {3.5, 3.5, 3});
    ASSERT_TRUE(circle && std::holds_alternative<Circle>(*circle));
    EXPECT_NEAR(std::get<Circle>(*circle).radius, 5.0, 1e-12);
    EXPECT_NEAR(norm(std::get<Circle>(*circle).centre - Vec3{0, 0, 3}), 0.0, 1e-12);
    const auto line =
        intersection_curve(pipe, Plane{{3, 0, 0}, {1, 0, 0}}, {3, 4, 0}, {3, 4, 9}, {3, 4, 5});
    EXPECT_TRUE(line && std::holds_alternative<Line>(*line));
    const Vec3 lean = normalized({1, 0, 1});
    const auto ellipse =
        intersection_curve(pipe, Plane{{}, lean}, {5, 0, -5}, {-5, 0, 5}, {0, 5, 0});
    ASSERT_TRUE(ellipse && std::holds_alternative<Ellipse>(*ellipse));
    EXPECT_NEAR(std::get<Ellipse>(*ellipse).major_radius, 5 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(std::get<Ellipse>(*ellipse).minor_radius, 5.0, 1e-9);
    // The order of the forms does not matter.
    EXPECT_EQ(intersection_curve(Plane{{0, 0, 3}, kUp}, pipe, {5, 0, 3}, {0, 5, 3}, {3.5, 3.5, 3})
                  .has_value(),
              true);
    // Cylinders of different radii that cross meet in no curve with a name.
    const Vec3 p{0, 3, 4}, q{0, -3, 4};
    EXPECT_FALSE(
        intersection_curve(Cylinder{{}, kUp, 3}, Cylinder{{}, {1, 0, 0}, 5}, p, q, {3, 0, 5}));
}

TEST(TangencySurface, IsAcrossBothForms) {
    const Cylinder pipe{{}, kUp, 5};
    for (const double degrees : {0.0, 30.0, 200.0}) {
        const double a = degrees * kPi / 180;
        const Vec3 out{std::cos(a), std::sin(a), 0};
        const Plane wall{5.0 * out, out};
        for (const auto& third : {tangency_surface(pipe, wall), tangency_surface(wall, pipe)}) {
            ASSERT_TRUE(third) << degrees;
            const Vec3 on = 5.0 * out + Vec3{0, 0, 7};
            EXPECT_NEAR(distance(*third, on), 0.0, 1e-9);
            EXPECT_NEAR(dot(gradient(*third, on), out), 0.0, 1e-9) << "crosses both";
        }
    }
    EXPECT_FALSE(tangency_surface(pipe, Plane{{3, 0, 0}, {1, 0, 0}})) << "the plane crosses";
    EXPECT_FALSE(tangency_surface(pipe, Plane{{0, 0, 0}, kUp}));
}

TEST(PathCorners, CylindersOfEqualRadiusMeetInEllipses) {
    const Cylinder a{{1, 2, 3}, {1, 0, 0}, 5}, b{{1, 2, 3}, normalized({1, 2, 0}), 5};
    const auto planes = mitre_planes(a, b);
    ASSERT_TRUE(planes);
    EXPECT_NEAR(dot((*planes)[0].normal, (*planes)[1].normal), 0.0, 1e-9) << "bisectors";
    for (const Plane& plane : *planes) {
        EXPECT_NEAR(distance(Form{plane}, {1, 2, 3}), 0.0, 1e-9);
        // Points of the first cylinder in the plane are on the second.
        const PlaneCut cut(a, {plane.normal, dot(plane.normal, plane.origin)});
        for (const double degrees : {10.0, 100.0, 250.0})
            EXPECT_NEAR(distance(Form{b}, cut.at(0, degrees)), 0.0, 1e-9);
    }
    EXPECT_FALSE(mitre_planes(a, Cylinder{{1, 2, 3}, {0, 1, 0}, 6})) << "another radius";
    EXPECT_FALSE(mitre_planes(a, Cylinder{{1, 2, 4}, {0, 1, 0}, 5})) << "the axes miss";
    EXPECT_TRUE(is_nearer({{}, kUp}, {{0, 0, 10}, kUp}, {0, 0, 4.9}));
    EXPECT_FALSE(is_nearer({{}, kUp}, {{0, 0, 10}, kUp}, {0, 0, 5.1}));
}

// --- Segments and circles on a map ---

/// A level face that carries the map.
struct MappedPlane {
    MappedPlane() {
        face.surface.form = Plane{{}, kUp};
        face.frame = {{}, kUp, {1, 0, 0}};
    }
    Part part;
    Face face;
};

const Curve kLine = Line{};
const Track kTrack(kLine, {0, 0, 0}, {1, 0, 0});

MapSegment segment(std::uint32_t number, Vec2 a, Vec2 b) {
    return {a, b, 2ULL * number, 2ULL * number + 1, &kTrack, 0.0, 1.0, true, number};
}

double cross_of(Vec2 a, Vec2 b, Vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance_of(Vec2 p, const MapSegment& s) {
    const Vec2 way{s.b.x - s.a.x, s.b.y - s.a.y};
    const double length = way.x * way.x + way.y * way.y;
    const double t = std::clamp(((p.x - s.a.x) * way.x + (p.y - s.a.y) * way.y) / length, 0.0, 1.0);
    return std::hypot(p.x - s.a.x - t * way.x, p.y - s.a.y - t * way.y);
}

double distance_of(const MapSegment& s, const MapSegment& t) {
    const bool crosses = cross_of(s.a, s.b, t.a) * cross_of(s.a, s.b, t.b) < 0 &&
                         cross_of(t.a, t.b, s.a) * cross_of(t.a, t.b, s.b) < 0;
    if (crosses) return 0.0;
    return std::min(
        {distance_of(s.a, t), distance_of(s.b, t), distance_of(t.a, s), distance_of(t.b, s)});
}

TEST(MapSegments, InterfereAsEveryPairSays) {
    const MappedPlane plane;
    const FaceMap map(plane.part, plane.face);
    test::Random random(7);
    int met = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<MapSegment> segments;
        for (std::uint32_t i = 0; i < 12; ++i) {
            const auto at = [&] { return static_cast<double>(random.between(0, 1000)); };
            const Vec2 a{at(), at()};
            const auto way = [&] { return static_cast<double>(random.between(-160, 160)) + 0.5; };
            segments.push_back(segment(i, a, {a.x + way(), a.y + way()}));
        }
        constexpr double kClear = 1.0;
        double nearest = 1e9;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            for (std::size_t k = i + 1; k < segments.size(); ++k)
                nearest = std::min(nearest, distance_of(segments[i], segments[k]));
        }
        if (std::abs(nearest - kClear) < 1e-9) continue;
        const auto found = any_interfere(map, segments, kClear);
        EXPECT_EQ(found.has_value(), nearest < kClear) << nearest;
        met += found ? 1 : 0;
        if (!found) continue;
        EXPECT_LT(distance_of(segments[(*found)[0]], segments[(*found)[1]]), kClear);
        std::ranges::reverse(segments);
        EXPECT_TRUE(any_interfere(map, segments, kClear)) << "in any order";
    }
    EXPECT_GT(met, 50);
    EXPECT_LT(met, 250);
    EXPECT_FALSE(any_interfere(map, {}, 1.0));
}

TEST(MapSegments, RoundsNearOthersAsEveryPairSays) {
    test::Random random(11);
    for (int round = 0; round < 200; ++round) {
        std::vector<FaceMap::Round> rounds;
        std::vector<MapSegment> segments;
        const auto at = [&] { return static_cast<double>(random.between(0, 1000)); };
        for (int i = 0; i < 10; ++i) {
            rounds.push_back({{at(), at()}, static_cast<double>(random.between(5, 90)), 0.0});
            const Vec2 a{at(), at()};
            segments.push_back(
                segment(static_cast<std::uint32_t>(i), a, {a.x + at() / 10 + 1, a.y + 7}));
        }
        constexpr double kClear = 1.0;
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < rounds.size(); ++i) {
            const auto& c = rounds[i];
            double nearest = 1e9;
            for (std::size_t k = 0; k < rounds.size(); ++k) {
                if (k == i) continue;
                const double apart =
                    std::hypot(c.centre.x - rounds[k].centre.x, c.centre.y - rounds[k].centre.y);
                nearest = std::min(nearest,
                                   std::max({apart - c.radius - rounds[k].radius,
                                             std::abs(c.radius - rounds[k].radius) - apart, 0.0}));
            }
            for (const MapSegment& s : segments) {
                const double low = distance_of(c.centre, s);
                const double high = std::max(std::hypot(c.centre.x - s.a.x, c.centre.y - s.a.y),
                                             std::hypot(c.centre.x - s.b.x, c.centre.y - s.b.y));
                nearest = std::min(nearest, std::max({low - c.radius, c.radius - high, 0.0}));
            }
            if (nearest < kClear) expected.push_back(i);
        }
        std::vector<std::size_t> found = rounds_near_others(rounds, segments, kClear);
        std::ranges::sort(found);
        EXPECT_EQ(found, expected);
    }
    EXPECT_TRUE(rounds_near_others({}, {}, 1.0).empty());
}

}  // namespace
}  // namespace ncsim::brep
