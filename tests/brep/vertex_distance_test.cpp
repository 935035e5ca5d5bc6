// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the minimum distance of vertices in parts and in their facets.
#include "heal/vertex_distance.h"

#include "ncsim/export/step.h"
#include "ncsim/mesh/simplify.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"

#include "brep/tilted_parts.h"
#include "query/part_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::brep {
namespace {

// Returns a cube of 10 mm with a three-sided pit in its bottom. The pit narrows towards the top,
// where it leaves a triangular hole of width `size`.
cda::Boundary pit_through(double size) {
    cda::Boundary boundary;
    boundary.vertices = {{0, 0, 0},  {10, 0, 0},  {10, 10, 0},  {0, 10, 0},
                         {0, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10},
                         {3, 3, 0},  {7, 3, 0},   {5, 7, 0}};
    const Vec3 tip{5, 4, 10};
    for (std::size_t i = 8; i < 11; ++i) {
        const Vec3 v = boundary.vertices[i];
        boundary.vertices.push_back(tip + 0.25 * size * Vec3{v.x - tip.x, v.y - tip.y, 0.0});
    }
    const auto face = [&](std::vector<std::vector<std::uint32_t>> loops) {
        cda::BoundaryFace made;
        const Vec3 a = boundary.vertices[loops[0][0]], b = boundary.vertices[loops[0][1]],
                   c = boundary.vertices[loops[0][2]];
        made.normal = normalized(cross(b - a, c - a));
        made.loops = std::move(loops);
        boundary.faces.push_back(made);
    };
    face({{3, 2, 1, 0}, {8, 9, 10}});
    face({{4, 5, 6, 7}, {13, 12, 11}});
    for (std::uint32_t i = 0; i < 4; ++i)
        face({{i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4}});
    for (std::uint32_t i = 0; i < 3; ++i)
        face({{8 + (i + 1) % 3, 8 + i, 11 + i, 11 + (i + 1) % 3}});
    boundary.shells = 1;
    return boundary;
}

Part part_of(double size) {
    const cda::Boundary boundary = pit_through(size);
    Part part = faceted(boundary, std::vector<std::vector<cda::Origin>>(boundary.faces.size()));
    enforce_min_vertex_distance(part);
    return part;
}

TEST(KeepApart, AHoleTooSmallForReadersIsAPoint) {
    Part part = part_of(1e-7);
    EXPECT_EQ(part.faces.size(), 9U);
    EXPECT_EQ(part.faces[0].loops.size(), 2U);
    EXPECT_EQ(part.faces[1].loops.size(), 1U);  // the top
    for (std::size_t f = 6; f < 9; ++f)
        EXPECT_EQ(part.faces[f].loops.front().size(), 3U);
    EXPECT_TRUE(check_part(part, 1e-6).empty());
}

TEST(KeepApart, AHoleThatCanBeSeenStays) {
    Part part = part_of(1e-2);
    EXPECT_EQ(part.faces[1].loops.size(), 2U);
    EXPECT_TRUE(check_part(part, 1e-6).empty());
}

// The piece between two faces at a common corner vanishes. Neither face may keep an edge from that
// corner to itself.
TEST(Facets, NoLoopComesToACornerTwiceInARow) {
    simulation::Plan plan = test::plan_of(test::tilted_part(3000160), "part.nc");
    const simulation::Survey survey = simulation::survey(plan);
    const simulation::Simulation milled = simulation::simulate(plan, survey, {}, {});
    const mesh::Simplified flat = mesh::simplify(*milled.boundary, exporter::kStepTolerance);
    for (const cda::BoundaryFace& face : flat.boundary.faces) {
        for (const auto& loop : face.loops) {
            EXPECT_EQ(std::ranges::adjacent_find(loop), loop.end());
            EXPECT_NE(loop.front(), loop.back());
        }
    }
}

// Vertices of facets move to the intersections of adjacent recognised surfaces, here by up to 0.04
// mm. The facets must follow.
TEST(Facets, LieInTheirPlanes) {
    simulation::Plan plan = test::plan_of(test::tilted_part(3001006), "part.nc");
    const simulation::Survey survey = simulation::survey(plan);
    simulation::Verification nothing;
    nothing.keep_cuts = true;
    const simulation::Simulation milled = simulation::simulate(plan, survey, nothing, {});
    Recognised solid = simulation::solid_of(plan, survey, milled, exporter::kStepTolerance);
    std::size_t facets = 0;
    double farthest = 0.0;
    for (const Face& face : solid.part.faces) {
        if (!face.is_facet) continue;
        ++facets;
        for (const Loop& loop : face.loops) {
            for (const EdgeUse& use : loop) {
                const Vec3 corner = solid.part.vertices[solid.part.edges[use.edge].from];
                farthest = std::max(farthest, std::abs(distance(face.surface.form, corner)));
            }
        }
    }
    EXPECT_GT(facets, 100U);
    EXPECT_EQ(facets, solid.facets_kept);
    EXPECT_LE(farthest, exporter::kStepTolerance);
    for (const Fault& fault : check_part(solid.part, 0.1))
        EXPECT_NE(fault.what, "an edge does not have two faces");
}

}  // namespace
}  // namespace ncsim::brep
