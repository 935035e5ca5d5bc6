// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the dexel model with rays along all axes.
#include "ncsim/dexel/dexel.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/tree.h"

#include "support/random.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace ncsim::dexel {
namespace {

using cda::Boundary;
using cda::Cell;
using test::kLattice;
using test::mm_box;

std::unique_ptr<cda::WorkpieceModel> block(double resolution, std::size_t threads = 1) {
    return Dexel({threads, resolution}).create(mm_box(0, 0, 0, 10, 10, 6), kLattice);
}

void expect_closed(const Boundary& boundary) {
    EXPECT_TRUE(cda::check(boundary).is_closed());
}

TEST(Dexel, ABlockIsItself) {
    const auto part = block(0.3);
    EXPECT_NEAR(part->volume(), 600.0, 1e-9);
    const Boundary boundary = part->boundary();
    expect_closed(boundary);
    EXPECT_EQ(boundary.shells, 1U);
    // Normals are off by 1e-4, so corners are off by that share of a cell.
    EXPECT_NEAR(cda::volume(boundary), 600.0, 0.05);
    const Box bounds = cda::bounds(boundary);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.min[axis], 0.0, 1e-3);
        EXPECT_NEAR(bounds.max[axis], axis == 2 ? 6.0 : 10.0, 1e-3);
    }
}

// A facing cut is shallower than the pitch. Rays along X and Y may miss the cut; the mean of all
// directions then lacks two thirds of the removed volume.
TEST(Dexel, TellsByHowMuchAShallowCutIsMissed) {
    for (const double depth : {0.02, 0.05, 0.1}) {
        const auto part = block(0.5);
        part->subtract_unmeasured(cda::box_cell(kLattice.round({-1, -1, 6 - depth}),
                                                kLattice.round({5, 11, 7}), kLattice,
                                                cda::Origin{1}));
        EXPECT_LE(std::abs(part->volume() - (600.0 - 50.0 * depth)), part->volume_error());
    }
}

TEST(Dexel, ASlotHasItsWallsAndItsEdges) {
    const auto part = block(0.3);
    part->subtract_unmeasured(mm_box(-1, 3, 4, 11, 6, 7, cda::Origin{7}));
    EXPECT_NEAR(part->volume(), 600.0 - 60.0, 3.0);
    const Boundary boundary = part->boundary();
    expect_closed(boundary);
    EXPECT_NEAR(cda::volume(boundary), 540.0, 0.1);
    for (const cda::BoundaryFace& face : boundary.faces) {
        if (face.origin != cda::Origin{7}) continue;
        for (const std::uint32_t v : face.loops[0]) {
            EXPECT_GE(boundary.vertices[v].y, 3.0 - 0.31);
            EXPECT_LE(boundary.vertices[v].y, 6.0 + 0.31);
        }
    }
}

// Boxes of 2 to 8 pitches and random hulls. Thin places are missed, but the surface is closed.
TEST(Dexel, IsClosedWhateverIsCut) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto part = block(0.5);
        for (int i = 0; i < 25; ++i) {
            const std::int64_t x = static_cast<std::int64_t>(random.next() % 10);
            const std::int64_t y = static_cast<std::int64_t>(random.next() % 10);
            const std::int64_t z = static_cast<std::int64_t>(random.next() % 6);
            const auto half = [&](std::int64_t most) {
                return 1 +
                       static_cast<std::int64_t>(random.next() % static_cast<std::uint64_t>(most));
            };
            Cell cell = mm_box(x, y, z, x + half(4), y + half(4), z + half(3));
            if (random.one_in(2)) {
                std::vector<cda::LatticePoint> points;
                for (int k = 0; k < 6; ++k)
                    points.push_back(kLattice.round(
                        {random.within(-1, 11), random.within(-1, 11), random.within(-1, 7)}));
                if (const auto hull = cda::convex_hull(points, kLattice, cda::Origin{3}))
                    cell = *hull;
            }
            part->subtract_unmeasured(cell);
        }
        expect_closed(part->boundary());
    }
}

// Removes random cells as large as the cells of the grid. Corners of the grid then lie on all
// diagonals, where surfaces touch in edges.
TEST(Dexel, IsClosedWhereCellsMeetInEdgesAndCorners) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(1000 + seed);
        const auto part = block(1.0);
        for (std::int64_t x = 0; x < 10; ++x) {
            for (std::int64_t y = 0; y < 10; ++y) {
                for (std::int64_t z = 0; z < 6; ++z) {
                    if (random.one_in(2))
                        part->subtract_unmeasured(mm_box(x, y, z, x + 1, y + 1, z + 1));
                }
            }
        }
        expect_closed(part->boundary());
    }
}

// Walls of columns that touch in edges: vertices are kept on one side of an edge of a wall alone.
TEST(Dexel, IsClosedWhereColumnsMeet) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(1100 + seed);
        const auto part = block(0.5);
        for (std::int64_t x = 0; x < 10; ++x) {
            for (std::int64_t y = 0; y < 10; ++y) {
                const auto depth = static_cast<std::int64_t>(random.next() % 6);
                if (random.one_in(2) && depth > 0)
                    part->subtract_unmeasured(
                        mm_box(x, y, 6 - depth, x + 1, y + 1, 7, cda::Origin{7}));
            }
        }
        const Boundary boundary = part->boundary();
        expect_closed(boundary);
        EXPECT_NEAR(cda::volume(boundary), part->volume(), 0.02 * part->volume());
    }
}

// Walls parallel to Z have vertices where they begin and end alone.
TEST(Dexel, DeepWallsHaveNoMoreTrianglesThanShallowOnes) {
    const auto triangles_of = [](std::int64_t depth) {
        const auto part = block(0.25);
        part->subtract_unmeasured(mm_box(3, 3, 6 - depth, 7, 7, 7, cda::Origin{7}));
        const Boundary boundary = part->boundary();
        expect_closed(boundary);
        EXPECT_EQ(boundary.shells, 1U);
        EXPECT_NEAR(cda::volume(boundary), 600.0 - 16.0 * static_cast<double>(depth), 0.05);
        return boundary.faces.size();
    };
    EXPECT_EQ(triangles_of(2), triangles_of(5));
}

// A wall that bends little by little, within one row of cells: vertices at the bends are kept.
TEST(Dexel, ABentWallKeepsItsBends) {
    const auto part = block(0.25);
    const std::vector<Vec3> outline{{5.02, 0, -1},  {5.02, 0, 1.6}, {5.03, 0, 2.4},
                                    {5.07, 0, 3.2}, {5.14, 0, 4.0}, {5.24, 0, 4.8},
                                    {5.7, 0, 7.2},  {11, 0, -1},    {11, 0, 7.2}};
    std::vector<cda::LatticePoint> points;
    for (const Vec3& p : outline) {
        for (const double y : {-1.0, 11.0})
            points.push_back(kLattice.round({p.x, y, p.z}));
    }
    part->subtract_unmeasured(*cda::convex_hull(points, kLattice, cda::Origin{7}));
    const Boundary boundary = part->boundary();
    expect_closed(boundary);
    const auto wall_at = [&](double z) {
        std::size_t i = 1;
        while (outline[i].z < z)
            ++i;
        const Vec3 &from = outline[i - 1], &to = outline[i];
        return from.x + (z - from.z) / (to.z - from.z) * (to.x - from.x);
    };
    std::size_t faces = 0;
    for (const cda::BoundaryFace& face : boundary.faces) {
        if (face.origin != cda::Origin{7}) continue;
        ++faces;
        Vec3 middle;
        for (const std::uint32_t v : face.loops[0])
            middle = middle + (1.0 / 3.0) * boundary.vertices[v];
        EXPECT_NEAR(middle.x, wall_at(middle.z), 0.004) << middle.z;
    }
    EXPECT_GT(faces, 0U);
}

// Compares with the exact model: the volume, and points farther than a pitch from places where both
// models may differ.
TEST(Dexel, HasWhatTheExactPartHas) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(2000 + seed);
        const double pitch = 0.2;
        const auto part = block(pitch, 2);
        cda::TreeCda exact(mm_box(0, 0, 0, 10, 10, 6), kLattice);
        for (int i = 0; i < 12; ++i) {
            std::vector<cda::LatticePoint> points;
            const Vec3 middle{random.within(0, 10), random.within(0, 10), random.within(0, 6)};
            for (int k = 0; k < 8; ++k)
                points.push_back(
                    kLattice.round(middle + Vec3{random.within(-3, 3), random.within(-3, 3),
                                                 random.within(-3, 3)}));
            const auto hull = cda::convex_hull(points, kLattice, cda::Origin{1});
            if (!hull) continue;
            part->subtract_unmeasured(*hull);
            exact.subtract_unmeasured(*hull);
        }
        const Boundary surface = exact.boundary();
        EXPECT_NEAR(part->volume(), exact.volume(), 0.02 * pitch * cda::area(surface));
        EXPECT_NEAR(cda::volume(part->boundary()), exact.volume(),
                    0.02 * pitch * cda::area(surface));
        for (int i = 0; i < 500; ++i) {
            const Vec3 p{random.within(0, 10), random.within(0, 10), random.within(0, 6)};
            const bool expected = exact.contains(p);
            // If the exact part is uniform as far as the nearest ray, the dexel part agrees.
            bool is_near = false;
            for (int x = -6; x <= 6; ++x) {
                for (int y = -6; y <= 6; ++y)
                    is_near |=
                        exact.contains(p + Vec3{x * 0.1 * pitch, y * 0.1 * pitch, 0}) != expected;
            }
            if (!is_near) {
                EXPECT_EQ(part->contains(p), expected);
            }
        }
    }
}

// Vertices are ends of rays, as in the thesis, so edges are cut off.
TEST(Dexel, MarchingCubesHaveTheEndsOfRaysAndNoEdges) {
    const auto part = Dexel({1, 0.3, Directions::Three, Mesher::MarchingCubes})
                          .create(mm_box(0, 0, 0, 10, 10, 6), kLattice);
    part->subtract_unmeasured(mm_box(-1, 3, 4, 11, 6, 7, cda::Origin{7}));
    const Boundary boundary = part->boundary();
    const double volume = cda::volume(boundary);
    EXPECT_LT(volume, 540.0 - 0.5);
    EXPECT_GT(volume, 540.0 - 5.0);
    // Each edge of a triangle has an opposite edge, except where polygons touch.
    expect_closed(boundary);
    for (const Vec3& v : boundary.vertices) {
        EXPECT_GT(v.x, -1e-9);
        EXPECT_LT(v.x, 10 + 1e-9);
    }
}

// Origins count from 1; all have origin 1 if `have_one_origin`.
std::vector<Cell> some_cuts(std::uint64_t seed, bool have_one_origin = false) {
    test::Random random(seed);
    std::vector<Cell> cuts;
    for (int i = 0; i < 60; ++i) {
        const auto x = static_cast<std::int64_t>(random.next() % 9);
        const auto y = static_cast<std::int64_t>(random.next() % 9);
        const auto origin = static_cast<std::uint32_t>(have_one_origin ? 1 : i + 1);
        cuts.push_back(mm_box(x, y, 1 + static_cast<std::int64_t>(random.next() % 5), x + 2, y + 1,
                              7, cda::Origin{origin}));
    }
    return cuts;
}

TEST(Dexel, DoesNotDependOnThreads) {
    const auto cuts = some_cuts(5);
    const auto one = block(0.3, 1);
    one->subtract_unmeasured(cuts);
    const Boundary expected = one->boundary();
    for (const std::size_t threads : {2U, 8U}) {
        const auto many = block(0.3, threads);
        many->subtract_unmeasured(cuts);
        const Boundary boundary = many->boundary();
        EXPECT_EQ(boundary.vertices, expected.vertices);
        ASSERT_EQ(boundary.faces.size(), expected.faces.size());
        for (std::size_t i = 0; i < boundary.faces.size(); ++i) {
            EXPECT_EQ(boundary.faces[i].loops, expected.faces[i].loops);
            EXPECT_EQ(boundary.faces[i].origin, expected.faces[i].origin);
        }
        EXPECT_EQ(many->volume(), one->volume());
    }
}

// Walls have vertices where their origin changes, too, and of two cuts the first leaves the wall.
TEST(Dexel, DoesNotDependOnTheOrderOfCuts) {
    auto cuts = some_cuts(6, true);
    const auto there = block(0.3);
    there->subtract_unmeasured(cuts);
    std::reverse(cuts.begin(), cuts.end());
    const auto back = block(0.3);
    back->subtract_unmeasured(cuts);
    EXPECT_EQ(there->volume(), back->volume());
    EXPECT_EQ(there->boundary().vertices, back->boundary().vertices);
}

TEST(Dexel, ACopyIsItsOwn) {
    const auto part = block(0.5);
    part->subtract_unmeasured(mm_box(-1, -1, 3, 11, 5, 7));
    const auto copy = part->clone();
    copy->subtract_unmeasured(mm_box(-1, 4, 3, 11, 11, 7));
    EXPECT_NEAR(part->volume(), 600 - 150, 1e-9);
    EXPECT_NEAR(copy->volume(), 300, 1e-9);
}

TEST(Dexel, RefusesWhatItCannotDo) {
    EXPECT_THROW(block(1e-4), std::invalid_argument);  // 10^10 rays
    EXPECT_THROW(Dexel().create(mm_box(0, 0, 0, 0, 1, 1), kLattice), std::invalid_argument);
}

// A ball moves over a plane as an exact round sweep. Vertices of the groove are within 0.01 mm of
// the ball.
TEST(Dexel, ABallLeavesAGrooveOfItsOwnRadius) {
    const auto part = block(0.2);
    cda::RoundSweep sweep;
    sweep.radius = 2;
    sweep.height = 10;
    sweep.tip_height = 2;
    sweep.from = {-3, 5, 4};
    sweep.to = {13, 5, 4};
    sweep.origin = cda::Origin{1};
    sweep.bounds.add(Vec3{-5, 3, 4}), sweep.bounds.add(Vec3{15, 7, 14});
    dynamic_cast<cda::SweepModel&>(*part).subtract_sweep(sweep);
    const double half_circle = 4 * std::acos(0.0);
    EXPECT_NEAR(part->volume(), 600 - 10 * half_circle, 0.4);
    for (const Vec3& v : part->boundary().vertices) {
        if (v.z > 5.99 || v.z < 0.01 || v.x < 0.3 || v.x > 9.7 || v.y < 0.3 || v.y > 9.7) continue;
        EXPECT_NEAR(std::hypot(v.y - 5, v.z - 6), 2.0, 0.01);
    }
}

}  // namespace
}  // namespace ncsim::dexel
