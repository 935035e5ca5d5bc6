// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests that simplified boundaries stay closed and within the tolerance.
#include "ncsim/mesh/simplify.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"

#include "plain.h"
#include "support/box_part.h"
#include "support/polytope_part.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace ncsim::mesh {
namespace {

// Returns the distance from a point to a triangle: to the plane above the inside, otherwise to the
// edges.
double distance_to(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 n = normalized(cross(b - a, c - a));
    const auto left_of = [&](Vec3 from, Vec3 to) {
        return dot(cross(to - from, p - from), n) >= 0.0;
    };
    if (norm(n) > 0.5 && left_of(a, b) && left_of(b, c) && left_of(c, a))
        return std::abs(dot(n, p - a));
    const auto to_edge = [&](Vec3 from, Vec3 to) {
        const Vec3 along = to - from;
        const double length = dot(along, along);
        const double t = length > 0.0 ? std::clamp(dot(p - from, along) / length, 0.0, 1.0) : 0.0;
        return norm(p - from - t * along);
    };
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

// Returns the largest distance from `to` of the corners and middles of the triangles of `from`.
double farthest(const TriangleMesh& from, const TriangleMesh& to) {
    double result = 0.0;
    const auto look = [&](Vec3 p) {
        double nearest = Box::kInf;
        for (const auto& t : to.triangles) {
            nearest = std::min(
                nearest, distance_to(p, to.vertices[t[0]], to.vertices[t[1]], to.vertices[t[2]]));
        }
        result = std::max(result, nearest);
    };
    for (const auto& t : from.triangles) {
        const Vec3 a = from.vertices[t[0]];
        const Vec3 b = from.vertices[t[1]];
        const Vec3 c = from.vertices[t[2]];
        look(a);
        look((1.0 / 3.0) * (a + b + c));
    }
    return result;
}

double shortest_edge(const cda::Boundary& boundary) {
    double shortest = Box::kInf;
    for (const auto& face : boundary.faces) {
        for (const auto& loop : face.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec3 a = boundary.vertices[loop[i]];
                const Vec3 b = boundary.vertices[loop[(i + 1) % loop.size()]];
                shortest = std::min(shortest, norm(b - a));
            }
        }
    }
    return shortest;
}

TEST(Simplify, WithoutToleranceJoinsWhatIsCoplanar) {
    const auto part = test::grooved_part().tilted();
    const cda::Boundary boundary = test::boundary_of(part);
    const Simplified result = simplify(boundary, 0.0);
    EXPECT_EQ(result.boundary.faces.size(), 25U);
    EXPECT_EQ(result.origins.size(), 25U);
    EXPECT_LE(result.deviation_mm, 1e-12);
    EXPECT_TRUE(cda::check(result.boundary).is_closed());
    EXPECT_NEAR(cda::volume(result.boundary), cda::volume(boundary), 1e-12 * cda::volume(boundary));
}

TEST(Simplify, JoinsFacetsOfAFlatThatRoundingHasTornApart) {
    cda::Boundary boundary = test::boundary_of(test::grooved_part().tilted());
    // Moves every vertex by up to 5 nm along each axis, the same in each run.
    std::uint32_t state = 1;
    for (Vec3& v : boundary.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            state = state * 1664525U + 1013904223U;
            v[axis] += 1e-5 * (static_cast<double>(state >> 8) * 0x1p-24 - 0.5);
        }
    }
    for (auto& face : boundary.faces) {
        const Vec3 a = boundary.vertices[face.loops[0][0]];
        face.normal = normalized(cross(boundary.vertices[face.loops[0][1]] - a,
                                       boundary.vertices[face.loops[0][2]] - a));
        face.offset = dot(face.normal, a);
    }
    EXPECT_GT(simplify(boundary, 0.0).boundary.faces.size(), 100U);
    const Simplified result = simplify(boundary, 1e-2);
    EXPECT_EQ(result.boundary.faces.size(), 25U);
    EXPECT_TRUE(cda::check(result.boundary).is_closed());
    EXPECT_GT(result.deviation_mm, 1e-6);
    EXPECT_LT(result.deviation_mm, 1e-2);
}

class SimplifyBy : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Tolerances, SimplifyBy, testing::Values(1e-5, 1e-3, 0.1, 0.5));

// Returns the triangles of the shells of `before` that `after` has, too.
TriangleMesh of_shells_in(const cda::Boundary& after, const cda::Boundary& before) {
    TriangleMesh mesh = cda::triangulate(before);
    TriangleMesh result;
    result.vertices = mesh.vertices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t shell = before.faces[mesh.face[t]].shell;
        if (std::any_of(after.faces.begin(), after.faces.end(),
                        [&](const auto& face) { return face.shell == shell; })) {
            result.triangles.push_back(mesh.triangles[t]);
        }
    }
    return result;
}

// No position of this part is regular.
TEST_P(SimplifyBy, StaysClosedAndWithinTheDeviationItReports) {
    const double tolerance = GetParam();
    const cda::Boundary boundary = test::polytope_part().boundary();
    const Simplified result = simplify(boundary, tolerance);
    EXPECT_LE(result.boundary.faces.size(), boundary.faces.size());
    EXPECT_LE(result.deviation_mm, tolerance);
    EXPECT_TRUE(cda::check(result.boundary).is_closed());
    const TriangleMesh before = of_shells_in(result.boundary, boundary);
    const TriangleMesh after = cda::triangulate(result.boundary);
    EXPECT_TRUE(cda::check(after).is_closed());
    const double rounding = 1e-9;
    // The code only tests whether most points are nearer than the farthest point so far. The slow
    // computation gives the same result.
    EXPECT_NEAR(std::max(farthest(before, after), farthest(after, before)), result.deviation_mm,
                rounding);
    EXPECT_NEAR(cda::volume(after), cda::volume(before),
                cda::area(boundary) * result.deviation_mm + rounding);
    // Shells that vanished are thinner than the tolerance.
    EXPECT_NEAR(cda::volume(before), cda::volume(boundary), cda::area(boundary) * tolerance);
}

// Returns a part of hulls of all sizes, with needles and flakes.
cda::Boundary random_part(std::uint64_t seed) {
    ncsim::test::Random random(seed);
    cda::TreeCda part(ncsim::test::mm_box(0, 0, 0, 20, 20, 10), ncsim::test::kLattice);
    const std::int64_t cuts = random.between(5, 25);
    for (std::int64_t i = 0; i < cuts; ++i) {
        const cda::LatticePoint about = ncsim::test::random_point(random, 1000000);
        const std::int64_t reach = std::array{20000, 200000, 800000}[random.next() % 3];
        const bool is_flat = random.next() % 5 == 0;
        const bool is_upright = random.next() % 7 == 0;
        std::vector<cda::LatticePoint> points;
        for (std::int64_t k = random.between(4, 15); k > 0; --k) {
            cda::LatticePoint p = ncsim::test::random_point(random, reach);
            if (is_flat) p.z /= 1000;
            if (is_upright) p.x = random.between(0, 4);
            points.push_back(
                p + cda::LatticePoint{about.x + 1000000, about.y + 1000000, about.z / 2 + 500000});
        }
        const auto hull = cda::convex_hull(points, ncsim::test::kLattice,
                                           cda::Origin{static_cast<std::uint32_t>(i + 1)});
        if (hull) part.subtract(*hull);
    }
    return part.boundary();
}

// Returns the number of vertices that no triangle of the mesh has.
std::size_t count_unused(const TriangleMesh& mesh) {
    std::vector<bool> is_used(mesh.vertices.size(), false);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle)
            is_used[v] = true;
    }
    return static_cast<std::size_t>(std::ranges::count(is_used, false));
}

TEST(Simplify, AnyPartStaysClosed) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const cda::Boundary part = random_part(seed);
        EXPECT_TRUE(cda::check(cda::triangulate(part)).is_closed()) << "seed " << seed;
        for (const double tolerance : {1e-4, 1e-2, 1.0}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(tolerance) + " mm");
            const Simplified result = simplify(part, tolerance);
            EXPECT_TRUE(cda::check(result.boundary).is_closed());
            EXPECT_TRUE(cda::check(cda::triangulate(result.boundary)).is_closed());
            EXPECT_LE(result.deviation_mm, tolerance);
            // Files have the vertices of the mesh.
            EXPECT_EQ(count_unused(result.mesh), 0U);
            EXPECT_GE(result.mesh.vertices.size(), result.boundary.vertices.size());
        }
    }
}

void expect_same(const Simplified& a, const Simplified& b) {
    EXPECT_EQ(a.boundary.vertices, b.boundary.vertices);
    EXPECT_EQ(a.boundary.shells, b.boundary.shells);
    EXPECT_EQ(a.origins, b.origins);
    ASSERT_EQ(a.boundary.faces.size(), b.boundary.faces.size());
    for (std::size_t f = 0; f < a.boundary.faces.size(); ++f) {
        const cda::BoundaryFace& one = a.boundary.faces[f];
        const cda::BoundaryFace& other = b.boundary.faces[f];
        EXPECT_EQ(one.normal, other.normal);
        EXPECT_EQ(one.offset, other.offset);
        EXPECT_EQ(one.origin, other.origin);
        EXPECT_EQ(one.shell, other.shell);
        EXPECT_EQ(one.loops, other.loops);
    }
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.face, b.mesh.face);
}

// Returns a plate with n × n octagonal holes, rotated by `turn` times 45°. Each hole has a motion
// of its own.
cda::Boundary drilled_plate(int n, double turn = 0.3) {
    cda::TreeCda part(ncsim::test::mm_box(0, 0, 0, 20, 20, 10), ncsim::test::kLattice);
    const double pitch = 20.0 / n, radius = 0.3 * pitch;
    for (int i = 0; i < n * n; ++i) {
        std::vector<cda::LatticePoint> points;
        for (int k = 0; k < 8; ++k) {
            const double angle = 0.25 * std::numbers::pi * (k + turn);
            const Vec3 about{pitch * (i % n + 0.5), pitch * (i / n + 0.5), 0.0};
            for (const double z : {2.0, 11.0}) {
                points.push_back(ncsim::test::kLattice.round(
                    about + Vec3{radius * std::cos(angle), radius * std::sin(angle), z}));
            }
        }
        const auto hull = cda::convex_hull(points, ncsim::test::kLattice,
                                           cda::Origin{static_cast<std::uint32_t>(i + 1)});
        if (hull) part.subtract(*hull);
    }
    return part.boundary();
}

TEST(Simplify, RecognisesAPlateWithHolesInWhichNothingIsToSimplify) {
    const cda::Boundary plate = drilled_plate(4);
    for (const double tolerance : {1e-6, 1e-4, 1e-3}) {
        SCOPED_TRACE(tolerance);
        const auto plain = plain_boundary(plate, 0.25 * tolerance, nullptr);
        ASSERT_TRUE(plain);
        EXPECT_EQ(plain->boundary.faces.size(), 6U + 16U * 9U);
        expect_same(*plain, simplify_any(plate, tolerance, nullptr));
        expect_same(*plain, simplify(plate, tolerance));
    }
    // A boundary with sides below the tolerance is not plain.
    EXPECT_FALSE(plain_boundary(plate, 2.0, nullptr));
    EXPECT_FALSE(plain_boundary(test::polytope_part().boundary(), 1e-3, nullptr));
}

TEST(Simplify, OfAPlainBoundaryIsThatOfAnyBoundary) {
    int plain_parts = 0;
    for (int i = 0; i < 60; ++i) {
        // Random parts have facets of some nanometres; plates have none.
        const bool is_plate = i % 2 == 0;
        const cda::Boundary part = is_plate ? drilled_plate(1 + i % 5, i / 60.0)
                                            : random_part(static_cast<std::uint64_t>(i));
        for (const double tolerance : {1e-6, 1e-4, 1e-2, 1.0}) {
            SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(tolerance) + " mm");
            const auto plain = plain_boundary(part, 0.25 * tolerance, nullptr);
            if (!plain) continue;
            ++plain_parts;
            expect_same(*plain, simplify_any(part, tolerance, nullptr));
        }
    }
    EXPECT_GT(plain_parts, 60);
}

// If joined faces were off by more than the tolerance, simplify() would begin again with less.
TEST(JoinFaces, AreThoseOfSimplifyWithoutAMeasurement) {
    for (int i = 0; i < 60; ++i) {
        const cda::Boundary part = i % 2 == 0 ? drilled_plate(1 + i % 5, i / 60.0)
                                              : random_part(static_cast<std::uint64_t>(i));
        for (const double tolerance : {0.0, 1e-4, 1e-2, 0.3, 1.0}) {
            SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(tolerance) + " mm");
            const Simplified whole = simplify(part, tolerance);
            const JoinedFaces faces = join_faces(part, tolerance);
            expect_same(whole, {faces, whole.deviation_mm, whole.mesh});
        }
    }
}

TEST(Simplify, HandsOutTheTrianglesOfItsBoundary) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Simplified result = simplify(random_part(seed), 1e-2);
        const TriangleMesh mesh = cda::triangulate(result.boundary);
        EXPECT_EQ(result.mesh.triangles, mesh.triangles) << "seed " << seed;
        EXPECT_EQ(result.mesh.vertices, mesh.vertices) << "seed " << seed;
    }
}

TEST(Simplify, AFlakeThinnerThanTheToleranceVanishesAndNothingElse) {
    test::BoxPart part;
    part.stock = {{0, 0, 0}, {4, 4, 3}};
    part.cuts = {{{-1, -1, 1}, {5, 5, 2}}};
    cda::Boundary boundary = test::boundary_of(part);
    for (Vec3& v : boundary.vertices) {
        if (v.z == 3.0) v.z = 2.0001;
    }
    for (auto& face : boundary.faces)
        face.offset = dot(face.normal, boundary.vertices[face.loops[0][0]]);
    ASSERT_EQ(boundary.shells, 2U);
    EXPECT_EQ(simplify(boundary, 1e-4).boundary.faces.size(), 12U);
    const Simplified result = simplify(boundary, 1e-3);
    EXPECT_TRUE(cda::check(result.boundary).is_closed());
    EXPECT_EQ(result.boundary.faces.size(), 6U);
    EXPECT_DOUBLE_EQ(cda::volume(result.boundary), 16.0);
    EXPECT_LE(result.deviation_mm, 1e-12);
}

TEST(Simplify, LeavesNoEdgeThatAReaderTakesForAPoint) {
    const cda::Boundary boundary = test::polytope_part().boundary();
    const double before = shortest_edge(boundary);
    const double after = shortest_edge(simplify(boundary, 0.04).boundary);
    EXPECT_LT(before, 0.01) << "else there is nothing to see";
    EXPECT_GE(after, 0.01);
}

TEST(Simplify, KeepsWhoCutWhat) {
    const auto part = test::grooved_part();
    const Simplified result = simplify(test::boundary_of(part), 1e-3);
    std::size_t most = 0;
    for (std::size_t f = 0; f < result.origins.size(); ++f) {
        EXPECT_EQ(result.boundary.faces[f].origin, result.origins[f].front());
        most = std::max(most, result.origins[f].size());
    }
    EXPECT_EQ(most, 3U) << "the floor of the groove was cut in three passes";
}

TEST(Simplify, APartSmallerThanTheToleranceVanishes) {
    test::BoxPart box;
    box.stock = {{0, 0, 0}, {1, 1, 1}};
    box.cell_mm = 1e-6;
    EXPECT_TRUE(cda::check(simplify(test::boundary_of(box), 1e-3).boundary).is_closed());
    EXPECT_LE(simplify(test::boundary_of(box), 1e-3).boundary.faces.size(), 6U);
    EXPECT_TRUE(simplify({}, 1e-3).boundary.faces.empty());
}

}  // namespace
}  // namespace ncsim::mesh
