// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of recognition on a cube and on a prism of 32 sides in place of a cylinder: facets, groups,
// chains, loops. Then what is known of faces, curves near corners, splines and rims.
#include "ncsim/brep/facets.h"
#include "ncsim/brep/patch.h"

#include "brep/solids.h"
#include "geometry/envelope_contact.h"
#include "geometry/intersection_spline.h"
#include "geometry/rim.h"
#include "geometry/spline_surface.h"
#include "query/arc_crossings.h"
#include "query/face_map.h"
#include "recognise/chains.h"
#include "recognise/face_check_cache.h"
#include "recognise/face_groups.h"
#include "recognise/face_loops.h"
#include "recognise/facet_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace ncsim::brep {
namespace {

constexpr Vec3 kUp{0, 0, 1};
constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 5.0, kHeight = 10.0;
const cda::Origin kMotion{1};

/// A prism with `sides` walls around a cylinder of radius 5 along Z; the walls are of kMotion.
Facets prism(int sides) {
    Facets facets;
    cda::Boundary& boundary = facets.boundary;
    const auto n = static_cast<std::uint32_t>(sides);
    const double out = kRadius / std::cos(kPi / sides);
    for (const double z : {0.0, kHeight}) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * kPi * i / sides;
            boundary.vertices.push_back({out * std::cos(a), out * std::sin(a), z});
        }
    }
    const auto add = [&](const std::vector<std::uint32_t>& loop, cda::Origin origin) {
        cda::BoundaryFace face;
        const Vec3 a = boundary.vertices[loop[0]];
        face.normal =
            normalized(cross(boundary.vertices[loop[1]] - a, boundary.vertices[loop[2]] - a));
        face.offset = dot(face.normal, a);
        face.origin = origin;
        face.loops = {loop};
        boundary.faces.push_back(face);
        facets.origins.push_back({origin});
    };
    std::vector<std::uint32_t> top(n), bottom(n);
    std::iota(top.begin(), top.end(), n);
    std::iota(bottom.rbegin(), bottom.rend(), 0U);
    add(top, cda::kStockOrigin);
    add(bottom, cda::kStockOrigin);
    for (std::uint32_t i = 0; i < n; ++i)
        add({i, (i + 1) % n, (i + 1) % n + n, i + n}, kMotion);
    boundary.shells = 1;
    return facets;
}

std::map<cda::Origin, SweptSurfaces> sources_of(bool knows_the_cylinder) {
    std::map<cda::Origin, SweptSurfaces> sources;
    SweptSurfaces& source = sources[kMotion];
    source.error_mm = kRadius / std::cos(kPi / 32) - kRadius;
    if (!knows_the_cylinder) return sources;
    source.candidates.resize(1);
    source.candidates[0].surface = {Cylinder{{}, kUp, kRadius}, false};
    return sources;
}

std::vector<std::uint32_t> faces_of(const Facets& facets) {
    std::vector<std::uint32_t> faces(facets.boundary.faces.size());
    std::iota(faces.begin(), faces.end(), 0U);
    return faces;
}

TEST(FacetMesh, HalfEdgesAreTwinsAroundEachFacet) {
    const Facets facets = prism(32);
    const auto sources = sources_of(true);
    const auto faces = faces_of(facets);
    const FacetMesh mesh(facets, sources, faces);
    EXPECT_FALSE(mesh.is_broken());
    ASSERT_EQ(mesh.size(), 34U);
    EXPECT_EQ(mesh.corners(), 64U);
    ASSERT_EQ(mesh.edges().size(), 2 * 96U);
    for (std::uint32_t h = 0; h < mesh.edges().size(); ++h) {
        const HalfEdge& edge = mesh.edges()[h];
        ASSERT_NE(edge.twin, kNone);
        EXPECT_EQ(mesh.edges()[edge.twin].twin, h);
        EXPECT_EQ(mesh.edges()[edge.twin].from, mesh.to(h));
        EXPECT_EQ(mesh.edges()[edge.next].facet, edge.facet);
        EXPECT_NE(mesh.edges()[edge.twin].facet, edge.facet);
        EXPECT_NEAR(mesh.length(h), norm(mesh.point(mesh.to(h)) - mesh.point(edge.from)), 1e-12);
    }
    const double side = 2 * kRadius * std::tan(kPi / 32);
    for (std::uint32_t f = 0; f < mesh.size(); ++f) {
        const bool is_wall = mesh.corners_of(f).size() == 4;
        EXPECT_NEAR(mesh[f].area, is_wall ? side * kHeight : 16 * kRadius * side, 1e-9);
        EXPECT_EQ(mesh[f].was_labelled, is_wall);
        EXPECT_EQ(std::holds_alternative<Cylinder>(mesh.surface(mesh[f].label).form), is_wall);
    }
    EXPECT_EQ(mesh.demoted_count(), 0U);
    const std::vector<std::uint32_t> open(faces.begin() + 1, faces.end());
    EXPECT_TRUE(FacetMesh(facets, sources, open).is_broken()) << "an open shell";
}

TEST(FaceGroups, NeighboursOfOneSurfaceAreAFace) {
    const Facets facets = prism(32);
    const auto faces = faces_of(facets);
    for (const bool knows : {true, false}) {
        const auto sources = sources_of(knows);
        FacetMesh mesh(facets, sources, faces);
        Groups groups(mesh);
        groups.gather();
        ASSERT_EQ(groups.size(), knows ? 3U : 34U);
        double area = 0.0;
        for (std::uint32_t g = 0; g < groups.size(); ++g) {
            area += groups[g].area;
            double shared = 0.0;
            for (const auto& [other, length] : groups.neighbours(g)) {
                EXPECT_NE(other, g);
                shared += length;
                const auto back = groups.neighbours(other);
                EXPECT_TRUE(std::ranges::any_of(back, [&](const auto& n) { return n.first == g; }));
            }
            EXPECT_NEAR(shared, groups.perimeter(g), 1e-9);
            const bool is_round = std::holds_alternative<Cylinder>(groups.form_of(g));
            EXPECT_EQ(groups[g].facets.size(), is_round ? 32U : 1U);
            EXPECT_EQ(groups[g].is_analytic, is_round);
        }
        EXPECT_NEAR(area, 64 * kRadius * std::tan(kPi / 32) * (kHeight + kRadius), 1e-6);
    }
}

TEST(FaceChains, OfACylinderAreTwoCircles) {
    const Facets facets = prism(32);
    const auto faces = faces_of(facets);
    const auto sources = sources_of(true);
    FacetMesh mesh(facets, sources, faces);
    Groups groups(mesh);
    groups.gather();
    Failures failures;
    Chains chains(mesh, groups, failures);
    chains.trace();
    chains.solve();
    EXPECT_TRUE(failures.empty());
    ASSERT_EQ(chains.all().size(), 2U);
    for (const Chain& chain : chains.all()) {
        EXPECT_EQ(chain.edges.size(), 32U);
        EXPECT_FALSE(chain.has_failed || chain.has_vanished);
        const auto* circle = std::get_if<Circle>(&chain.curve);
        ASSERT_NE(circle, nullptr);
        EXPECT_NEAR(circle->radius, kRadius, 1e-9);
        EXPECT_NEAR(circle->centre.x, 0.0, 1e-9);
    }
    FaceLoops loops(groups, chains);
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
        const bool is_round = std::holds_alternative<Cylinder>(groups.form_of(g));
        EXPECT_EQ(loops[g].size(), is_round ? 2U : 1U);
        EXPECT_TRUE(loops.touching_corners(g, loops[g], 1e-3).empty());
    }
}

TEST(FaceChains, OfFacetsAreTheirEdges) {
    const Facets facets = prism(8);
    const auto faces = faces_of(facets);
    const std::map<cda::Origin, SweptSurfaces> sources;
    FacetMesh mesh(facets, sources, faces);
    Groups groups(mesh);
    groups.gather();
    Failures failures;
    Chains chains(mesh, groups, failures);
    chains.trace();
    chains.solve();
    EXPECT_TRUE(failures.empty());
    EXPECT_EQ(chains.all().size(), 24U);
    ASSERT_EQ(chains.vertices().size(), 16U);
    for (const Vertex& vertex : chains.vertices()) {
        EXPECT_EQ(vertex.groups.size(), 3U);
        EXPECT_NEAR(norm(vertex.at - vertex.start), 0.0, 1e-9);
    }
    for (const Chain& chain : chains.all())
        EXPECT_TRUE(std::holds_alternative<Line>(chain.curve));
}

// --- What is known of faces ---

TEST(FaceCheckCache, IsAskedAgainOnlyAfterAChange) {
    for (test::NamedPart& solid : test::solids()) {
        SCOPED_TRACE(solid.name);
        FaceCheckCache cache({});
        double volume = 0.0;
        for (std::uint32_t f = 0; f < solid.part.faces.size(); ++f) {
            FaceCheckCache::Entry& entry = cache.lookup(solid.part, solid.part.faces[f], f);
            volume += entry.measure.volume;
            EXPECT_FALSE(entry.tolerance_mm) << "not checked";
            double miss = 0.0;
            EXPECT_FALSE(FaceCheckCache::is_faulty(entry, solid.part, f, 1e-6, 1e-6, miss));
            EXPECT_EQ(entry.tolerance_mm, 1e-6);
            EXPECT_EQ(&cache.lookup(solid.part, solid.part.faces[f], f), &entry);
            EXPECT_EQ(entry.tolerance_mm, 1e-6) << "still known";
        }
        EXPECT_NEAR(volume, solid.volume, 1e-9 * solid.volume);
        // A vertex moves: the faces at it are unknown.
        const Edge& edge = solid.part.edges[solid.part.faces[0].loops[0][0].edge];
        solid.part.vertices[edge.from].x += 1e-3;
        EXPECT_FALSE(cache.lookup(solid.part, solid.part.faces[0], 0).tolerance_mm);
    }
}

TEST(FaceMap, KeepsDistancesOnPlanesAndCylinders) {
    for (const test::NamedPart& solid : test::solids()) {
        for (const Face& face : solid.part.faces) {
            const bool is_plane = std::holds_alternative<Plane>(face.surface.form);
            const FaceMap map(solid.part, face);
            ProjectionSeed seed;
            for (const Loop& loop : face.loops) {
                for (const EdgeUse& use : loop) {
                    const Edge& edge = solid.part.edges[use.edge];
                    const Track track(edge.curve, solid.part.vertices[edge.from],
                                      solid.part.vertices[edge.to]);
                    for (const double t : {0.0, 0.3, 0.7}) {
                        const Vec3 p = track.at(t), q = track.at(t + 1e-5);
                        const FaceMap::Place place = map.place(p, seed);
                        EXPECT_NEAR(place.deviation, 0.0, 1e-9) << solid.name;
                        const Vec2 a = map(p), b = map(q);
                        const double ratio = std::hypot(b.x - a.x, b.y - a.y) / norm(q - p);
                        if (is_plane) {
                            EXPECT_NEAR(ratio, 1.0, 1e-6) << solid.name;
                        }
                        EXPECT_GT(ratio, 1e-3) << solid.name << ": no point is a whole edge";
                        EXPECT_EQ(map(p).x, place.at.x);
                    }
                }
            }
            EXPECT_EQ(map.is_cone(), std::holds_alternative<Cone>(face.surface.form));
            if (is_plane) {
                EXPECT_TRUE(map.keeps_lines());
            }
        }
    }
}

// Arcs of radius 10.2 and 3 with a common corner; the small one is off by `miss`.
TEST(ArcCrossings, AreThoseThatMissTheirTangency) {
    const auto found = [](double miss) {
        Part part;
        part.vertices = {{-10.2, 0, 0}, {10.2, 0, 0}, {4.2, 0, 0}, {-4.2, 0, 0}};
        part.edges = {{0, 1, Circle{{}, kUp, 10.2}},
                      {1, 2, Circle{{7.2 + miss, 0, 0}, -kUp, 3.0}},
                      {3, 2, Circle{{}, kUp, 4.2}},
                      {0, 3, Circle{{-7.2, 0, 0}, -kUp, 3.0}}};
        Face face;
        face.surface.form = Plane{{}, kUp};
        face.frame = {{}, kUp, {1, 0, 0}};
        face.loops = {{{0, true}, {1, true}, {2, false}, {3, false}}};
        part.faces.push_back(face);
        return arcs_crossing_near_corner(part, part.faces[0]);
    };
    EXPECT_FALSE(found(0.0));
    for (const double miss : {1e-7, 1e-6, 1e-5}) {
        const auto edges = found(miss);
        ASSERT_TRUE(edges) << miss;
        EXPECT_EQ(std::min((*edges)[0], (*edges)[1]), 0U);
        EXPECT_EQ(std::max((*edges)[0], (*edges)[1]), 1U);
    }
}

// --- Splines and rims ---

TEST(IntersectionSpline, LiesOnBothForms) {
    const Form thin = Cylinder{{}, kUp, 3}, wide = Cylinder{{}, {1, 0, 0}, 5};
    const auto at = [](double degrees) {
        const double a = degrees * kPi / 180, y = 3 * std::sin(a);
        return Vec3{3 * std::cos(a), y, std::sqrt(25 - y * y)};
    };
    const std::vector<Vec3> points{at(0), at(20), at(45), at(70), at(90)};
    const auto spline = intersection_spline(thin, wide, points);
    ASSERT_TRUE(spline);
    EXPECT_EQ(spline->points.size(), 2 * spline->knots.size());
    EXPECT_NEAR(norm(spline->points.front() - points.front()), 0.0, 1e-12);
    EXPECT_NEAR(norm(spline->points.back() - points.back()), 0.0, 1e-12);
    const Curve curve = *spline;
    const Track track(curve, points.front(), points.back());
    for (int i = 0; i <= 100; ++i) {
        const Vec3 p = track.at(i / 100.0);
        EXPECT_LT(std::abs(distance(thin, p)), 1e-5);
        EXPECT_LT(std::abs(distance(wide, p)), 1e-5);
        EXPECT_GT(p.z, 0.0);
    }
    const auto other = intersection_spline(wide, thin, points);
    ASSERT_TRUE(other) << "in any order";
    EXPECT_EQ(other->points.back(), spline->points.back());
}

TEST(SplineSurface, PointsAndDerivativesOfAPlanePatch) {
    Patch patch;
    patch.degree = 3;
    patch.around = patch.along = {0, 2};
    for (int i = 0; i < 4; ++i) {
        auto& row = patch.net.emplace_back();
        for (int k = 0; k < 4; ++k)
            row.push_back({3.0 * i, 5.0 * k, 1.0 * i + 2.0 * k});
    }
    for (const double u : {0.0, 0.5, 2.0}) {
        for (const double v : {0.0, 1.3, 2.0}) {
            const PatchPoint p = point_of(patch, u, v);
            EXPECT_NEAR(norm(p.at - Vec3{4.5 * u, 7.5 * v, 1.5 * u + 3 * v}), 0.0, 1e-12);
            EXPECT_NEAR(norm(p.by_around - Vec3{4.5, 0, 1.5}), 0.0, 1e-12);
            EXPECT_NEAR(norm(p.by_along - Vec3{0, 7.5, 3}), 0.0, 1e-12);
        }
    }
    EXPECT_EQ(point_of(patch, -5, 9).at, point_of(patch, 0, 2).at) << "limited to the patch";
    EXPECT_FALSE(is_spline_in_files(Cylinder{}));
    EXPECT_TRUE(is_spline_in_files(Dome{}) && is_spline_in_files(Coil{}) &&
                is_spline_in_files(Spiral{}));
}

TEST(EnvelopeContact, EndsOfAPath) {
    const auto envelope = [](const Meridian& meridian, const ToolPath& path) {
        return Envelope{std::make_shared<const Sweep>(meridian, path)};
    };
    // A quarter of a circle of radius 10 about the origin, for a ball of radius 5.
    const HelixPath arc{{}, kUp, {1, 0, 0}, 10, 0, 0, kPi / 2, kUp};
    const Envelope ball = envelope(Fillet{0, 5, 5}, arc);
    EXPECT_EQ(end_at(ball, {10, 0, 5}), 0.0);
    EXPECT_EQ(end_at(ball, {0, 10, 5}), 1.0);
    EXPECT_FALSE(end_at(ball, {10, 0, 0})) << "the tip";
    EXPECT_FALSE(end_at(ball, {7.07, 7.07, 5})) << "on the way";
    EXPECT_EQ(end_on_axis(ball, {10, 0, -100}, kUp), 0.0);
    EXPECT_EQ(end_on_axis(ball, {0, 10, 77}, kUp), 1.0);
    EXPECT_FALSE(end_on_axis(ball, {10, 0, 0}, {1, 0, 0}));
    EXPECT_FALSE(end_on_axis(ball, {}, kUp));
    EXPECT_FALSE(is_of_turning_tool(ball));
    EXPECT_FALSE(is_of_turning_tool(Cylinder{}));
    const auto path = fit_rotary_path([](double t) -> TipAndAxis {
        return {{10 * t, 0, 0}, {std::sin(0.3 * t), 0, std::cos(0.3 * t)}};
    });
    ASSERT_TRUE(path);
    EXPECT_TRUE(is_of_turning_tool(envelope(Fillet{0, 5, 5}, *path)));
}

TEST(Rim, ClosestPointIsOnTheCircle) {
    const Fillet rim{5, 2, 0};
    const Sweep sweep(rim, StraightPath{{0, 0, 0}, {10, 0, -4}, kUp});
    const ToolFrame tool = sweep.at(0.5);  // the circle is about (5, 0, 0)
    for (const double degrees : {0.0, 50.0, 123.0, 270.0}) {
        const double a = degrees * kPi / 180;
        const Vec3 out{std::cos(a), std::sin(a), 0};
        const Vec3 centre{5, 0, 0};
        // Along the normal of the surface that the circle sweeps, this time is the nearest.
        const Vec3 on = centre + 5.0 * out;
        const Vec3 normal = normalized(cross(cross(kUp, out), tool.speed));
        for (const double away : {-0.5, 0.1, 0.5}) {
            const ClosestPoint closest = closest_point_on_rim(rim, tool, on + away * normal);
            EXPECT_NEAR(norm(closest.foot - on), 0.0, 1e-9);
            EXPECT_NEAR(std::abs(closest.deviation), std::abs(away), 1e-9);
            EXPECT_NEAR(closest.rate, 0.0, 1e-9);
            EXPECT_NEAR(std::abs(dot(closest.normal, normal)), 1.0, 1e-9);
        }
        const double place = place_on_rim(sweep, tool, on);
        EXPECT_NEAR(norm(point_on_rim(sweep, tool, place) - on), 0.0, 1e-9) << "the inverse";
    }
    // The tool descends, so 180 degrees is behind, and 90 degrees is on the side of the frame.
    EXPECT_NEAR(norm(point_on_rim(sweep, tool, 180) - Vec3{0, 0, 0}), 0.0, 1e-9);
    const Vec3 side = point_on_rim(sweep, tool, 90) - Vec3{5, 0, 0};
    EXPECT_NEAR(dot(side, path_frame(sweep, tool).side), 5.0, 1e-9);
}

}  // namespace
}  // namespace ncsim::brep
