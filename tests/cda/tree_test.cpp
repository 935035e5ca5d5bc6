// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the tree model with the flat aggregate, with unit cubes, and with itself for different
// parameters.
#include "ncsim/cda/tree.h"

#include "ncsim/cda/check.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/triangulate.h"

#include "support/oracle.h"
#include "support/passes.h"
#include "support/random_shapes.h"
#include "support/rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

namespace ncsim::cda {
namespace {

using test::jittered_passes;
using test::kLattice;
using test::mm_box;
using test::passes_of_several_tools;
using test::Random;
using test::random_cuts;

void expect_same(const Boundary& a, const Boundary& b) {
    ASSERT_EQ(a.faces.size(), b.faces.size());
    EXPECT_TRUE(a.vertices == b.vertices);
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
        EXPECT_EQ(a.faces[i].origin, b.faces[i].origin);
        EXPECT_EQ(a.faces[i].loops, b.faces[i].loops);
    }
}

template <class Model>
Boundary milled(Model part, const std::vector<Cell>& cuts) {
    for (const Cell& cut : cuts)
        part.subtract_unmeasured(cut);
    return part.boundary();
}

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

// Compares the tree with the simple aggregate, face by face and corner by corner.
TEST(TreeCda, HasTheSameBoundaryAsTheFlatAggregate) {
    for (std::uint64_t seed = 0; seed < test::rounds(40U); ++seed) {
        SCOPED_TRACE(seed);
        const auto cuts = random_cuts(seed, 10, 60000 + static_cast<std::int64_t>(seed) * 5000);
        expect_same(milled(TreeCda(kStock, kLattice), cuts),
                    milled(FlatCda(kStock, kLattice), cuts));
    }
}

TEST(TreeCda, DoesNotDependOnHowItSplits) {
    const auto cuts = random_cuts(77, 60, 60000);
    const Boundary expected = milled(TreeCda(kStock, kLattice), cuts);
    for (const std::uint32_t leaf : {6U, 12U, 40U, 200U, 10000U}) {
        SCOPED_TRACE(leaf);
        const TreeParameters parameters{leaf};
        expect_same(milled(TreeCda(kStock, kLattice, parameters), cuts), expected);
    }
}

TEST(TreeCda, DoesNotDependOnTheNumberOfThreads) {
    const auto cuts = random_cuts(79, 80, 60000);
    TreeCda one(kStock, kLattice, {12, 1});
    for (const Cell& cut : cuts)
        one.subtract_unmeasured(cut);
    for (const std::uint32_t threads : {2U, 8U}) {
        TreeCda many(kStock, kLattice, {12, threads});
        for (const Cell& cut : cuts)
            many.subtract_unmeasured(cut);
        EXPECT_EQ(many.volume(), one.volume());  // to the last bit
        expect_same(many.boundary(), one.boundary());
    }
}

// Enough faces and lines for several tasks in each step of stitching.
TEST(TreeCda, DoesNotDependOnTheNumberOfThreadsWhereThereAreManyFaces) {
    const auto milled_by = [](std::uint32_t threads) {
        TreeCda part(mm_box(0, 0, 0, 128, 128, 4), kLattice, {.threads = threads});
        std::uint32_t motion = 0;
        for (int i = 0; i < 32; ++i) {
            for (int j = 0; j < 32; ++j) {
                // Every third box meets its neighbour.
                const int more = j % 3 == 0 ? 2 : 0;
                part.subtract_unmeasured(mm_box(4 * i + 1, 4 * j + 1, 1 + (i + j) % 2, 4 * i + 3,
                                                4 * j + 3 + more, 5, Origin{motion++}));
            }
        }
        return part.boundary();
    };
    const Boundary one = milled_by(1);
    EXPECT_GT(one.faces.size(), 4000U);
    for (const std::uint32_t threads : {2U, 5U})
        expect_same(milled_by(threads), one);
}

TEST(TreeCda, DoesNotDependOnTheOrderOfCuts) {
    auto cuts = random_cuts(78, 60, 60000);
    const Boundary expected = milled(TreeCda(kStock, kLattice), cuts);
    std::reverse(cuts.begin(), cuts.end());
    expect_same(milled(TreeCda(kStock, kLattice), cuts), expected);
}

// A diamond-shaped top has a pocket whose tip is the leftmost corner of the diamond. The outline of
// the top visits its least corner twice. Its start must not depend on the order of the cuts.
TEST(TreeCda, AnOutlineThatTouchesItselfInItsLeastCornerHasOneBeginning) {
    const auto prism = [](std::vector<LatticePoint> corners, std::int64_t bottom, Origin origin) {
        std::vector<LatticePoint> points;
        for (LatticePoint p : corners) {
            for (const std::int64_t z : {bottom, std::int64_t{500000}}) {
                p.z = z;
                points.push_back(p);
            }
        }
        return *convex_hull(points, kLattice, origin);
    };
    constexpr std::int64_t k = 100000;
    std::vector<Cell> cuts{
        prism({{-k, -k, 0}, {3 * k, -k, 0}, {-k, 3 * k, 0}}, -k, Origin{1}),
        prism({{-k, 5 * k, 0}, {3 * k, 5 * k, 0}, {-k, k, 0}}, -k, Origin{2}),
        prism({{0, 2 * k, 0}, {2 * k, k, 0}, {2 * k, 2 * k, 0}}, 2 * k, Origin{3}),
        prism({{0, 2 * k, 0}, {2 * k, 2 * k, 0}, {2 * k, 3 * k, 0}}, 2 * k, Origin{4})};
    const Cell stock = mm_box(0, 0, 0, 4, 4, 4);
    const Boundary expected = milled(FlatCda(stock, kLattice), cuts);
    EXPECT_TRUE(check(expected).is_closed());
    const auto by_origin = [](const Cell& a, const Cell& b) { return a.origin < b.origin; };
    do {
        expect_same(milled(TreeCda(stock, kLattice), cuts), expected);
        expect_same(milled(FlatCda(stock, kLattice), cuts), expected);
    } while (std::next_permutation(cuts.begin(), cuts.end(), by_origin));
}

// Unit cubes: all coincidences occur, and volume and exposed area are exact.
TEST(TreeCda, AgreesWithUnitCubesFiveThousandTimes) {
    Random random(42);
    for (int i = 0; i < test::rounds(5000); ++i) {
        SCOPED_TRACE(i);
        test::UnitCubes cubes;
        TreeCda part(mm_box(0, 0, 0, 6, 6, 6), kLattice, {12});
        const auto cuts = random.between(1, 12);
        for (std::int64_t k = 0; k < cuts; ++k) {
            const auto b = test::random_grid_box(random);
            cubes.remove(b);
            part.subtract_unmeasured(mm_box(b[0], b[1], b[2], b[3], b[4], b[5],
                                            Origin{static_cast<std::uint32_t>(k + 1)}));
        }
        const Boundary boundary = part.boundary();
        ASSERT_NEAR(volume(boundary), cubes.volume(), 1e-9);
        ASSERT_NEAR(area(boundary), cubes.area(), 1e-9);
        ASSERT_TRUE(check(boundary).is_closed());
        if (i % 20 == 0) {
            ASSERT_TRUE(check(triangulate(boundary)).is_closed());
        }
    }
}

TEST(TreeCda, TakesTheSameCutAThousandTimes) {
    TreeCda part(kStock, kLattice);
    const auto cuts = random_cuts(5, 1, 200000);
    for (int i = 0; i < 1000; ++i)
        part.subtract_unmeasured(cuts[0]);
    expect_same(part.boundary(), milled(FlatCda(kStock, kLattice), cuts));
}

TEST(TreeCda, PassesThatDifferByOneUnitLeaveWallsOfOneUnit) {
    TreeCda part(mm_box(0, 0, 0, 1, 1, 1), kLattice);
    for (std::int64_t i = 0; i < 100; ++i) {
        part.subtract_unmeasured(box_cell({-1, i * 1000, 0}, {100001, i * 1000 + 999, 200000},
                                          kLattice, Origin{static_cast<std::uint32_t>(i + 1)}));
    }
    const Boundary boundary = part.boundary();
    EXPECT_EQ(boundary.shells, 100U);
    EXPECT_NEAR(volume(boundary), 100 * 1e-5, 1e-12);
    EXPECT_TRUE(check(boundary).is_closed());
    EXPECT_TRUE(check(triangulate(boundary)).is_closed());
}

TEST(TreeCda, MeasuresWhatACutRemovesBeforeItIsMade) {
    TreeCda part(kStock, kLattice);
    FlatCda reference(kStock, kLattice);
    for (const Cell& cut : random_cuts(9, 30, 120000)) {
        const double expected = reference.subtract(cut);
        EXPECT_NEAR(part.common_volume(cut), expected, 1e-9);
        part.subtract_unmeasured(cut);
        EXPECT_EQ(part.common_volume(cut), 0.0);
    }
    EXPECT_NEAR(part.volume(), reference.volume(), 1e-9);
}

TEST(TreeCda, IsTheSameWhetherItIsMeasuredOrNot) {
    for (std::uint64_t seed = 0; seed < test::rounds(12U); ++seed) {
        SCOPED_TRACE(seed);
        const auto passes = jittered_passes(seed, 100);
        TreeCda measured(kStock, kLattice);
        for (const Cell& pass : passes)
            EXPECT_GE(measured.subtract(pass), 0.0);
        expect_same(measured.boundary(), milled(TreeCda(kStock, kLattice), passes));
    }
}

// Shared normals save work and do not change the result. Neither do normals of a different pass.
TEST(TreeCda, IsTheSameWhetherNormalsAreSharedOrNot) {
    for (std::uint64_t seed = 0; seed < test::rounds(12U); ++seed) {
        SCOPED_TRACE(seed);
        const auto passes = passes_of_several_tools(seed, 150);
        auto alone = passes;
        auto wrong = passes;
        for (std::size_t i = 0; i < passes.size(); ++i) {
            ASSERT_TRUE(passes[i].normals);
            alone[i].normals.reset();
            if (i % 2 == 0) wrong[i].normals = passes[(i + 7) % passes.size()].normals;
        }
        for (const std::uint32_t leaf : {12U, 80U}) {
            const Boundary shared = milled(TreeCda(kStock, kLattice, {.leaf = leaf}), passes);
            expect_same(shared, milled(TreeCda(kStock, kLattice, {.leaf = leaf}), alone));
            expect_same(shared, milled(TreeCda(kStock, kLattice, {.leaf = leaf}), wrong));
            expect_same(shared,
                        milled(TreeCda(kStock, kLattice, {.leaf = leaf, .batch = 7}), passes));
        }
    }
}

TEST(TreeCda, HasContactWhereThereIsVolumeInCommon) {
    // Passes on, below and above each other. Many lie in an earlier pass; contact() checks this
    // case first, common_volume() does not.
    std::size_t contacts = 0;
    std::size_t inner_contacts = 0;
    std::size_t questions = 0;
    for (std::uint64_t seed = 0; seed < test::rounds(8U); ++seed) {
        SCOPED_TRACE(seed);
        TreeCda part(kStock, kLattice);
        for (Cell& pass : jittered_passes(seed, 60)) {
            const bool in_common = part.common_volume(pass) > 0.0;
            EXPECT_EQ(part.contact(pass).has_value(), in_common);
            contacts += in_common ? 1 : 0;
            ++questions;
            if (questions % 3 != 0) part.subtract_unmeasured(pass);
            EXPECT_EQ(part.contact(pass).has_value(), in_common && questions % 3 == 0);
            for (Plane& plane : pass.planes) {
                const auto inwards =
                    20 * (std::abs(plane.nx) + std::abs(plane.ny) + std::abs(plane.nz));
                plane = canonical(plane.nx, plane.ny, plane.nz, plane.d - inwards);
            }
            pass.normals.reset();
            const bool inner = part.common_volume(pass) > 0.0;
            EXPECT_EQ(part.contact(pass).has_value(), inner);
            inner_contacts += inner ? 1 : 0;
        }
    }
    EXPECT_GT(contacts, test::rounds(40U));
    EXPECT_GT(inner_contacts, test::rounds(40U));
    EXPECT_LT(inner_contacts, questions - test::rounds(40U));
}

TEST(TreeCda, AnswersAsIfNoCellHadToWait) {
    for (std::uint64_t seed = 0; seed < test::rounds(20U); ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto cuts = random_cuts(seed, 40, 90000);
        const auto questions = random_cuts(seed + 1000, 40, 90000);
        TreeCda patient(kStock, kLattice, {.batch = 1000});
        TreeCda eager(kStock, kLattice, {.batch = 1});
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            patient.subtract_unmeasured(cuts[i]);
            eager.subtract_unmeasured(cuts[i]);
            switch (random.between(0, 5)) {
                case 0:
                    EXPECT_EQ(patient.contact(questions[i]).has_value(),
                              eager.contact(questions[i]).has_value());
                    break;
                case 1:
                    // Trees of different shapes sum in different order.
                    EXPECT_NEAR(patient.common_volume(questions[i]),
                                eager.common_volume(questions[i]), 1e-9);
                    break;
                case 2: {
                    const Vec3 p = kLattice.to_mm(test::random_point(random, 300000));
                    EXPECT_EQ(patient.contains(p), eager.contains(p));
                    break;
                }
                case 3:
                    EXPECT_NEAR(patient.subtract(questions[i]), eager.subtract(questions[i]), 1e-9);
                    break;
                case 4:
                    EXPECT_NEAR(patient.clone()->volume(), eager.clone()->volume(), 1e-9);
                    break;
                default: break;
            }
        }
        EXPECT_NEAR(patient.volume(), eager.volume(), 1e-9);
        expect_same(patient.boundary(), eager.boundary());
    }
}

// Threads insert waiting cells while queries, copies, moves and destruction come in between.
TEST(TreeCda, IsTheSameWhereCellsComeWhileOthersGoDown) {
    for (std::uint64_t seed = 0; seed < test::rounds(6U); ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto cuts = random_cuts(seed, 300, 90000);
        const auto questions = random_cuts(seed + 1000, 300, 90000);
        TreeCda busy(kStock, kLattice, {.threads = 4, .batch = 20});
        TreeCda one(kStock, kLattice, {.threads = 1, .batch = 20});
        TreeCda eager(kStock, kLattice, {.threads = 1, .batch = 1});
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            for (TreeCda* part : {&busy, &one, &eager})
                part->subtract_step(std::span(&cuts[i], 1));
            switch (random.between(0, 60)) {
                case 0:
                    EXPECT_EQ(busy.contact(questions[i]).has_value(),
                              eager.contact(questions[i]).has_value());
                    break;
                case 1: {
                    TreeCda moved = std::move(busy);
                    busy = std::move(moved);
                    break;
                }
                case 2: {
                    const TreeCda copy = busy;
                    busy = copy;
                    break;
                }
                default: break;
            }
        }
        TreeCda given_up = busy;
        for (const Cell& cut : random_cuts(seed + 2000, 20, 90000))
            given_up.subtract_step(std::span(&cut, 1));
        EXPECT_NEAR(busy.volume(), one.volume(), 1e-9);
        expect_same(busy.boundary(), eager.boundary());
        expect_same(one.boundary(), eager.boundary());
    }
}

// The results are equal to the last bit: the number of steps decides when blocks go down, for any
// number of threads.
TEST(TreeCda, GoesDownWhereNobodyComesWhateverTheThreads) {
    TreeCda one(kStock, kLattice, {.threads = 1});
    TreeCda three(kStock, kLattice, {.threads = 3});
    const auto passes = random_cuts(7, 200, 30000);
    for (std::size_t i = 0; i < 12000; ++i) {
        for (TreeCda* part : {&one, &three})
            part->subtract_step(std::span(&passes[i / 60], 1));
    }
    EXPECT_EQ(one.volume(), three.volume());
    EXPECT_EQ(one.counts().nodes, three.counts().nodes);
}

// A query inserts waiting cells, in whichever thread is first; copies share the state. The thread
// sanitizer sees more of this than the results show.
TEST(TreeCda, AnswersManyThreadsAtATime) {
    const auto cuts = random_cuts(5, 300, 50000);
    TreeCda part(kStock, kLattice, {.leaf = 20, .threads = 2});
    part.track_removal();
    part.subtract_unmeasured(cuts);
    const TreeCda& asked = part;
    const Boundary expected = TreeCda(part).boundary();
    const double volume = TreeCda(part).volume();
    constexpr std::size_t kThreads = 4;
    std::array<bool, kThreads> same{};
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < kThreads; ++t) {
            threads.emplace_back([&, t] {
                const auto contact = asked.contact(kStock);
                const bool inside = contact && asked.contains(*contact);
                TreeCda copy(asked);
                const double removed = copy.subtract(kStock);
                same[t] = inside && asked.common_volume(kStock) == removed &&
                          asked.volume() == volume && copy.volume() == 0.0 &&
                          asked.boundary().vertices == expected.vertices &&
                          asked.account().size() ==
                              dynamic_cast<const VerifyingModel&>(*asked.clone()).account().size();
            });
        }
    }
    for (std::size_t t = 0; t < kThreads; ++t)
        EXPECT_TRUE(same[t]) << t;
}

}  // namespace
}  // namespace ncsim::cda
