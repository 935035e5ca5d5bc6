// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests that every model of a workpiece must pass.
#include "ncsim/cda/workpiece.h"

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/check.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/tree.h"
#include "ncsim/cda/triangulate.h"

#include "polytope/difference.h"
#include "support/oracle.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

template <class Model>
Model part_of(const Cell& stock, const std::vector<Cell>& cuts) {
    Model part(stock, kLattice);
    std::uint32_t number = 0;
    for (Cell cut : cuts) {
        cut.origin = Origin{++number};
        part.subtract(test::ranked(cut));
    }
    return part;
}

// Expects the properties that hold for any part.
void expect_sound(const WorkpieceModel& part) {
    const Boundary boundary = part.boundary();
    const SurfaceCheck surface = check(boundary);
    EXPECT_TRUE(surface.is_closed()) << surface.unpaired_edges << " unpaired, "
                                     << surface.repeated_edges << " repeated of " << surface.edges;
    EXPECT_LE(surface.relative_area_sum, 1e-12);
    EXPECT_NEAR(volume(boundary), part.volume(), 1e-9 * part.volume() + 1e-12);
    const TriangleMesh mesh = triangulate(boundary);
    EXPECT_TRUE(check(mesh).is_closed());
    EXPECT_NEAR(volume(mesh), part.volume(), 1e-9 * part.volume() + 1e-12);
    for (const BoundaryFace& face : boundary.faces) {
        for (const auto& loop : face.loops) {
            for (const std::uint32_t v : loop) {
                EXPECT_NEAR(dot(face.normal, boundary.vertices[v]), face.offset, 1e-9);
            }
        }
    }
}

void expect_volume_and_area(const WorkpieceModel& part, double expected_volume,
                            double expected_area) {
    EXPECT_NEAR(part.volume(), expected_volume, 1e-9);
    EXPECT_NEAR(area(part.boundary()), expected_area, 1e-9);
    expect_sound(part);
}

template <class Model>
class Workpiece : public testing::Test {};

class ModelNames {
public:
    template <class Model>
    static std::string GetName(int) {
        return std::is_same_v<Model, FlatCda> ? "Flat" : "Tree";
    }
};
using Models = testing::Types<FlatCda, TreeCda>;
TYPED_TEST_SUITE(Workpiece, Models, ModelNames);

TYPED_TEST(Workpiece, AnUnharmedBlockIsItsSixFaces) {
    const TypeParam part(mm_box(0, 0, 0, 4, 3, 2), kLattice);
    EXPECT_EQ(part.boundary().faces.size(), 6U);
    expect_volume_and_area(part, 24.0, 52.0);
}

TYPED_TEST(Workpiece, AStockWithoutVolumeIsRefused) {
    EXPECT_THROW(TypeParam(mm_box(0, 0, 0, 4, 3, 0), kLattice), std::invalid_argument);
}

TYPED_TEST(Workpiece, ASlotHasThreeNewFaces) {
    const TypeParam part =
        part_of<TypeParam>(mm_box(0, 0, 0, 4, 4, 4), {mm_box(-1, 1, 2, 5, 3, 5)});
    // Six faces of the block, with the top face in two; two walls and a floor.
    EXPECT_EQ(part.boundary().faces.size(), 10U);
    expect_volume_and_area(part, 64.0 - 16.0, 96.0 + 16.0 - 8.0);
}

TYPED_TEST(Workpiece, APocketIsAHoleInTheTopFace) {
    const TypeParam part = part_of<TypeParam>(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 1, 2, 3, 3, 5)});
    const Boundary boundary = part.boundary();
    EXPECT_EQ(boundary.faces.size(), 11U);
    EXPECT_EQ(std::count_if(boundary.faces.begin(), boundary.faces.end(),
                            [](const BoundaryFace& f) { return f.loops.size() == 2; }),
              1);
    expect_volume_and_area(part, 64.0 - 8.0, 96.0 + 16.0);
}

TYPED_TEST(Workpiece, ACavityIsAShellOfItsOwn) {
    const TypeParam part = part_of<TypeParam>(mm_box(0, 0, 0, 4, 4, 4), {mm_box(1, 1, 1, 3, 3, 3)});
    EXPECT_EQ(part.boundary().shells, 2U);
    expect_volume_and_area(part, 56.0, 96.0 + 24.0);
}

TYPED_TEST(Workpiece, TakingTheSameCutTwiceChangesNothing) {
    TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    EXPECT_NEAR(part.subtract(mm_box(1, 1, 2, 3, 3, 5, Origin{1})), 8.0, 1e-12);
    EXPECT_EQ(part.subtract(mm_box(1, 1, 2, 3, 3, 5, Origin{2})), 0.0);
    EXPECT_EQ(part.subtract(mm_box(1, 1, 2, 3, 3, 5, Origin{3})), 0.0);
    expect_volume_and_area(part, 56.0, 112.0);
    // The walls keep the origin of the cut that made them.
    for (const BoundaryFace& face : part.boundary().faces) {
        EXPECT_LE(static_cast<std::uint32_t>(face.origin), 1U);
    }
}

TYPED_TEST(Workpiece, ACellInsideAnotherChangesNothing) {
    TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    part.subtract(mm_box(1, 1, 1, 3, 3, 5, Origin{1}));
    EXPECT_EQ(part.subtract(mm_box(2, 2, 2, 3, 3, 4, Origin{2})), 0.0);
    expect_volume_and_area(part, 52.0, 96.0 + 24.0);
}

TYPED_TEST(Workpiece, AbuttingPassesLeaveNoMembrane) {
    // A step-over as wide as the tool: two cells that touch in a plane.
    const TypeParam part = part_of<TypeParam>(mm_box(0, 0, 0, 4, 4, 4),
                                              {mm_box(1, 0, 2, 2, 4, 4), mm_box(2, 0, 2, 3, 4, 4)});
    expect_volume_and_area(part, 64.0 - 16.0, 96.0 + 16.0 - 8.0);
}

TYPED_TEST(Workpiece, DrillingInPecksIsOneHole) {
    // Each peck starts at the end of the preceding peck and passes through the same hole.
    const TypeParam part = part_of<TypeParam>(
        mm_box(0, 0, 0, 4, 4, 4),
        {mm_box(1, 1, 3, 2, 2, 5), mm_box(1, 1, 2, 2, 2, 3), mm_box(1, 1, 2, 2, 2, 5),
         mm_box(1, 1, 1, 2, 2, 5), mm_box(1, 1, -1, 2, 2, 1)});
    expect_volume_and_area(part, 60.0, 96.0 + 16.0 - 2.0);
}

TYPED_TEST(Workpiece, ThreeAndMoreCoincidentCellsInAnyOrder) {
    std::vector<Cell> cuts{mm_box(0, 1, 2, 3, 3, 4), mm_box(1, 1, 2, 4, 3, 4),
                           mm_box(1, 0, 2, 3, 4, 4), mm_box(1, 1, 2, 3, 3, 4)};
    std::vector<int> order{0, 1, 2, 3};
    do {
        std::vector<Cell> shuffled;
        for (const int i : order)
            shuffled.push_back(cuts[static_cast<std::size_t>(i)]);
        // A cross of two slots, 2 wide and 2 deep, in a block of 4: 12 of the 16 squares of a
        // layer.
        expect_volume_and_area(part_of<TypeParam>(mm_box(0, 0, 0, 4, 4, 4), shuffled), 64.0 - 24.0,
                               96.0 + 16.0 - 16.0);
    } while (std::next_permutation(order.begin(), order.end()));
}

TYPED_TEST(Workpiece, EverythingLeavesNothing) {
    TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    EXPECT_NEAR(part.subtract(mm_box(-1, -1, -1, 5, 5, 5, Origin{1})), 64.0, 1e-12);
    EXPECT_NEAR(part.volume(), 0.0, 1e-12);
    EXPECT_TRUE(part.boundary().faces.empty());
    EXPECT_TRUE(triangulate(part.boundary()).triangles.empty());
    EXPECT_FALSE(part.contains({2, 2, 2}));
}

// The cut ends in the face of the block or beyond the face.
TYPED_TEST(Workpiece, WhereAFaceOfTheStockIsCutAwayNothingIsLeft) {
    for (const int top : {4, 5}) {
        TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
        part.subtract(mm_box(1, 1, 3, 3, 3, top, Origin{1}));
        EXPECT_FALSE(part.contains({2, 2, 4})) << top;
        EXPECT_TRUE(part.contains({1, 2, 4})) << top << ": on the rim";
        EXPECT_TRUE(part.contains({2, 2, 3})) << top << ": on the floor";
    }
}

TYPED_TEST(Workpiece, TouchingFromOutsideIsNotCutting) {
    TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    EXPECT_EQ(part.subtract(mm_box(4, 0, 0, 6, 4, 4, Origin{1})), 0.0);
    EXPECT_EQ(part.subtract(mm_box(0, 0, 4, 4, 4, 9, Origin{2})), 0.0);
    EXPECT_EQ(part.subtract(mm_box(4, 4, 4, 9, 9, 9, Origin{3})), 0.0);
    expect_volume_and_area(part, 64.0, 96.0);
}

TYPED_TEST(Workpiece, AWallOfOneLatticeUnitStays) {
    TypeParam part(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    part.subtract(box_cell({0, 0, 0}, {50000, 100000, 100000}, kLattice, Origin{1}));
    part.subtract(box_cell({50001, 0, 0}, {100000, 100000, 100000}, kLattice, Origin{2}));
    EXPECT_NEAR(part.volume(), 1e-5, 1e-15);
    expect_sound(part);
}

TYPED_TEST(Workpiece, SolidsThatTouchInAnEdgeAreTwoManifolds) {
    const TypeParam part = part_of<TypeParam>(mm_box(0, 0, 0, 2, 2, 1),
                                              {mm_box(0, 0, 0, 1, 1, 1), mm_box(1, 1, 0, 2, 2, 1)});
    EXPECT_EQ(part.boundary().shells, 2U);
    expect_volume_and_area(part, 2.0, 12.0);
}

TYPED_TEST(Workpiece, SolidsThatTouchInACornerAreTwoManifolds) {
    TypeParam part = part_of<TypeParam>(mm_box(0, 0, 0, 2, 2, 2),
                                        {mm_box(0, 0, 0, 1, 1, 1), mm_box(1, 1, 1, 2, 2, 2)});
    expect_volume_and_area(part, 6.0, 24.0);
}

// Returns what the planes leave of the block, which is 20 × 20 × 10 mm.
Cell cone(const std::vector<Plane>& planes, Origin origin) {
    Cell cell = mm_box(0, 0, 0, 20, 20, 10);
    cell.origin = origin;
    cell.planes = planes;
    return cell;
}

// One motion leaves a floor on both sides of an edge that passes its corner: a wedge of floor
// touches the edge from outside, a notch from inside.
TYPED_TEST(Workpiece, AFloorTouchesItsOwnEdgeInACornerFromBothSides) {
    TypeParam part(mm_box(0, 0, 0, 20, 20, 10), kLattice);
    part.subtract(
        cone({{0, 0, -1, -500'000}, {2, -1, -1, 500'000}, {-2, -1, -1, -3'500'000}}, Origin{1}));
    part.subtract(cone({{0, 0, -1, -500'000}, {0, 1, -1, 500'000}}, Origin{1}));
    part.subtract(cone({{2, 1, -2, 2'000'000}, {-2, 1, -2, -2'000'000}}, Origin{2}));
    expect_sound(part);
}

// Tools that turn in their tip leave cells with many planes through one lattice point.
TYPED_TEST(Workpiece, CellsOfOneMotionHaveAnyPlanesThroughOnePoint) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        TypeParam part(mm_box(0, 0, 0, 20, 20, 10), kLattice);
        const std::int64_t cells = random.between(3, 5);
        for (std::int64_t i = 0; i < cells; ++i) {
            std::vector<Plane> planes{{0, 0, -1, -500'000}};
            const std::int64_t count = random.between(1, 3);
            for (std::int64_t k = 0; k < count; ++k) {
                const std::int64_t x = random.between(-2, 2), y = random.between(-2, 2);
                const Plane plane = canonical(x, y, -1, 1'000'000 * (x + y) - 500'000);
                if (std::ranges::find(planes, plane) == planes.end()) planes.push_back(plane);
            }
            part.subtract(cone(planes, Origin{static_cast<std::uint32_t>(random.between(1, 2))}));
        }
        ASSERT_NO_THROW(expect_sound(part));
    }
}

TYPED_TEST(Workpiece, DoesNotDependOnTheOrderOfCuts) {
    Random random(31);
    std::vector<Cell> cuts;
    for (std::uint32_t i = 0; i < 6; ++i) {
        cuts.push_back(test::random_hull(random, test::random_point(random, 250000), 200000, 12,
                                         Origin{i + 1}));
    }
    const Cell stock = mm_box(-3, -3, -3, 3, 3, 3);
    TypeParam forward(stock, kLattice);
    TypeParam backward(stock, kLattice);
    for (const Cell& cut : cuts)
        forward.subtract(cut);
    std::reverse(cuts.begin(), cuts.end());
    for (const Cell& cut : cuts)
        backward.subtract(cut);
    const Boundary a = forward.boundary();
    const Boundary b = backward.boundary();
    ASSERT_EQ(a.faces.size(), b.faces.size());
    EXPECT_TRUE(a.vertices == b.vertices);
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
        EXPECT_EQ(a.faces[i].loops, b.faces[i].loops);
        EXPECT_EQ(a.faces[i].origin, b.faces[i].origin);
    }
}

// Unit cubes: all coincidences occur, and volume and exposed area are exact.
TYPED_TEST(Workpiece, AgreesWithUnitCubes) {
    Random random(41);
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        test::UnitCubes cubes;
        TypeParam part(mm_box(0, 0, 0, 6, 6, 6), kLattice);
        const auto cuts = random.between(1, 12);
        double removed = 0.0;
        for (std::int64_t k = 0; k < cuts; ++k) {
            const auto b = test::random_grid_box(random);
            cubes.remove(b);
            removed += part.subtract(mm_box(b[0], b[1], b[2], b[3], b[4], b[5],
                                            Origin{static_cast<std::uint32_t>(k + 1)}));
        }
        EXPECT_NEAR(part.volume(), cubes.volume(), 1e-9);
        EXPECT_NEAR(removed, 216 - cubes.volume(), 1e-9);
        EXPECT_NEAR(area(part.boundary()), cubes.area(), 1e-9);
        expect_sound(part);
    }
}

// The definition: a point of the part is in the stock and in no cut. The volume is the sum of
// convex pieces.
TYPED_TEST(Workpiece, AgreesWithMembershipAndWithConvexPieces) {
    Random random(51);
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        const Cell stock = mm_box(-3, -3, -3, 3, 3, 3);
        std::vector<Cell> cuts;
        for (int k = 0; k < 8; ++k) {
            cuts.push_back(
                test::random_hull(random, test::random_point(random, 300000), 150000, 10));
        }
        const TypeParam part = part_of<TypeParam>(stock, cuts);
        expect_sound(part);
        std::vector<ConvexPolytope> bodies;
        for (const Cell& cut : cuts)
            bodies.push_back(*ConvexPolytope::of(cut, kLattice));
        std::vector<const ConvexPolytope*> taken;
        for (const ConvexPolytope& body : bodies)
            taken.push_back(&body);
        double sum = 0.0;
        for (const auto& piece : difference(*ConvexPolytope::of(stock, kLattice), taken)) {
            sum += piece.volume();
        }
        EXPECT_NEAR(sum * 1e-15, part.volume(), 1e-10 * part.volume());
        for (int k = 0; k < 2000; ++k) {
            const LatticePoint p = test::random_point(random, 310000);
            const auto strictly_in = [&](const Cell& cell) {
                return std::all_of(cell.planes.begin(), cell.planes.end(), [&](const Plane& h) {
                    return h.nx * p.x + h.ny * p.y + h.nz * p.z < h.d;
                });
            };
            const bool expected =
                std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 300000 &&
                std::none_of(cuts.begin(), cuts.end(), strictly_in);
            EXPECT_EQ(part.contains(kLattice.to_mm(p)), expected);
        }
    }
}

TYPED_TEST(Workpiece, IsIndependent) {
    TypeParam part(mm_box(0, 0, 0, 4, 4, 4), kLattice);
    part.subtract(mm_box(0, 0, 3, 4, 4, 4, Origin{1}));
    const auto copy = part.clone();
    part.subtract(mm_box(0, 0, 2, 4, 4, 4, Origin{2}));
    EXPECT_NEAR(copy->volume(), 48.0, 1e-12);
    EXPECT_NEAR(part.volume(), 32.0, 1e-12);
}

}  // namespace
}  // namespace ncsim::cda
