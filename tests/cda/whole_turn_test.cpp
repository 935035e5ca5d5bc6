// SPDX-License-Identifier: GPL-3.0-or-later
//
// Full turns without a core: a single cell for the whole turn, and the cells of the steps within
// that cell.
#include "ncsim/cda/hull.h"
#include "ncsim/cda/polytope.h"
#include "ncsim/cda/predicates.h"
#include "ncsim/cda/tree.h"

#include "polytope/within.h"
#include "support/random_shapes.h"
#include "support/rounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

// Returns the sweep of an upright tool from the height 0 to `height`, in units.
TranslationSweep prism(double radius, int sides, std::int64_t height, double first = 0.0) {
    std::vector<LatticePoint> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = first + 2 * std::numbers::pi * i / sides;
        const auto x = std::llround(radius * std::cos(angle));
        const auto y = std::llround(radius * std::sin(angle));
        points.push_back({x, y, 0});
        points.push_back({x, y, height});
    }
    return *TranslationSweep::of(points, kLattice);
}

// Returns the path of a full turn that descends by `pitch` units; `sense` is 1 or -1.
std::vector<LatticePoint> turn(LatticePoint middle, double radius, int steps, std::int64_t pitch,
                               int sense = 1, double first = 0.0) {
    std::vector<LatticePoint> way;
    for (int i = 0; i <= steps; ++i) {
        const double angle = first + sense * 2 * std::numbers::pi * (i % steps) / steps;
        way.push_back(middle + LatticePoint{std::llround(radius * std::cos(angle)),
                                            std::llround(radius * std::sin(angle)),
                                            -pitch * i / steps});
    }
    return way;
}

std::vector<Cell> steps_of(const TranslationSweep& body, const std::vector<LatticePoint>& way) {
    std::vector<Cell> cells;
    for (std::size_t i = 1; i < way.size(); ++i)
        cells.push_back(body(way[i - 1], way[i], Origin{1}));
    return cells;
}

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

// The steps remove the whole cell: after the steps, the cell removes exactly 0.
TEST(WholeTurn, IsInItsSteps) {
    Random random(1);
    int helices = 0;
    for (int i = 0; i < test::rounds(200); ++i) {
        SCOPED_TRACE(i);
        const double radius = static_cast<double>(random.between(60000, 150000));
        const TranslationSweep body = prism(radius, static_cast<int>(random.between(6, 24)), 500000,
                                            0.001 * static_cast<double>(random.between(0, 999)));
        const std::int64_t pitch = random.between(-1, 1) * random.between(0, 90000);
        helices += pitch != 0 ? 1 : 0;
        const auto way =
            turn(test::random_point(random, 50000),
                 radius * 0.01 * static_cast<double>(random.between(5, 80)),
                 static_cast<int>(random.between(3, 40)), pitch, random.between(0, 1) == 0 ? 1 : -1,
                 0.001 * static_cast<double>(random.between(0, 6000)));
        const auto all = body.around(way, Origin{2});
        ASSERT_TRUE(all);
        const std::vector<Cell> steps = steps_of(body, way);
        TreeCda part(kStock, kLattice);
        part.subtract_unmeasured(steps);
        EXPECT_EQ(part.subtract(*all), 0.0);
        TreeCda alone(kStock, kLattice);
        alone.subtract_unmeasured(*all);
        const auto polytope = ConvexPolytope::of(*all, kLattice);
        ASSERT_TRUE(polytope);
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(polytope->bounds().min[k], all->bounds.min[k] / kLattice.unit_mm - 1e-3);
            EXPECT_LE(polytope->bounds().max[k], all->bounds.max[k] / kLattice.unit_mm + 1e-3);
        }
        if (pitch != 0) continue;
        for (const Cell& step : steps)
            EXPECT_EQ(alone.subtract(step), 0.0);
    }
    EXPECT_GT(helices, test::rounds(50));
}

TEST(WholeTurn, IsNothingWhereACoreMayBe) {
    const TranslationSweep body = prism(100000, 12, 500000);
    EXPECT_TRUE(body.around(turn({}, 96000, 36, 0), Origin{1}));
    EXPECT_FALSE(body.around(turn({}, 97000, 36, 0), Origin{1}));  // next to a side of the tool
    EXPECT_FALSE(body.around(turn({}, 200000, 36, 0), Origin{1}));
    // A turn must descend by less than the length of the tool.
    EXPECT_TRUE(body.around(turn({}, 50000, 36, 499999), Origin{1}));
    EXPECT_FALSE(body.around(turn({}, 50000, 36, 500000), Origin{1}));
}

TEST(WholeTurn, IsNothingIfItIsNone) {
    const TranslationSweep body = prism(100000, 12, 500000);
    const auto round = turn({}, 50000, 12, 0);
    EXPECT_TRUE(body.around(round, Origin{1}));
    auto open = round;
    open.back().x += 1;
    EXPECT_FALSE(body.around(open, Origin{1}));
    EXPECT_FALSE(body.around(std::span(round).first(12), Origin{1}));
    auto dented = round;
    dented[5] = {-30000, 10000, 0};
    EXPECT_FALSE(body.around(dented, Origin{1}));
    auto twice = round;
    twice.insert(twice.end(), round.begin() + 1, round.end());
    EXPECT_FALSE(body.around(twice, Origin{1}));
    // A star of five points turns left everywhere, but twice around.
    std::vector<LatticePoint> star;
    for (const int i : {0, 2, 4, 1, 3, 0})
        star.push_back(turn({}, 50000, 5, 0)[static_cast<std::size_t>(i)]);
    EXPECT_FALSE(body.around(star, Origin{1}));
    EXPECT_FALSE(body.around(std::vector<LatticePoint>{{}, {1, 0, 0}, {}}, Origin{1}));
    EXPECT_FALSE(body.around({}, Origin{1}));
}

TEST(WholeTurn, OfWhatIsNoPrismIsNothing) {
    const std::vector<LatticePoint> cone{
        {0, 0, 0}, {90000, 0, 90000}, {-90000, 0, 90000}, {0, 90000, 90000}, {0, -90000, 90000}};
    const auto body = TranslationSweep::of(cone, kLattice);
    EXPECT_FALSE(body->around(turn({}, 20000, 12, 0), Origin{1}));
    // A prism whose axis is outside.
    std::vector<LatticePoint> beside;
    for (const std::int64_t z : {0, 500000}) {
        for (const std::int64_t y : {-100000, 100000}) {
            beside.push_back({0, y, z});
            beside.push_back({200000, y, z});
        }
    }
    EXPECT_FALSE(TranslationSweep::of(beside, kLattice)->around(turn({}, 20000, 12, 0), Origin{1}));
}

// Checks "lies within" corner by corner. The steps of turns above are found.
TEST(LiesWithin, IsSoAndFindsTheStepsOfTurns) {
    const Box place = ConvexPolytope::of(kStock, kLattice)->bounds();
    Random random(2);
    int found = 0, missed = 0;
    for (int i = 0; i < test::rounds(300); ++i) {
        SCOPED_TRACE(i);
        const TranslationSweep body =
            prism(100000, static_cast<int>(random.between(6, 24)), 900000);
        const double radius = static_cast<double>(random.between(5000, 90000));
        const int steps = static_cast<int>(random.between(5, 40));
        const std::int64_t z = random.between(-100000, 100000);
        const auto outer = body.around(turn({0, 0, z}, radius, steps, 0), Origin{2});
        if (!outer) continue;
        const double other = radius + static_cast<double>(random.between(-1, 1) * 3);
        const std::int64_t above = z + random.between(-10, 50000);
        for (const Cell& step : steps_of(body, turn({0, 0, above}, other, steps, 5000))) {
            const bool is_within = lies_within(step, *outer, place);
            const ConvexPolytope polytope = *ConvexPolytope::of(step, kLattice);
            bool is_so = true;
            for (const Plane& plane : outer->planes) {
                if (classify_box(place, plane) == Side::Below) continue;
                for (const auto& corner : polytope.vertices())
                    is_so &= classify(corner, plane) != Side::Above;
            }
            EXPECT_TRUE(is_so || !is_within);
            found += is_within && is_so ? 1 : 0;
            missed += !is_within && is_so ? 1 : 0;
        }
    }
    EXPECT_GT(found, test::rounds(1000));
    EXPECT_EQ(missed, 0);
}

// The steps of a straight motion are within the whole motion.
TEST(LiesWithin, FindsPartsOfAStraightWay) {
    const Box place = ConvexPolytope::of(kStock, kLattice)->bounds();
    Random random(3);
    for (int i = 0; i < test::rounds(200); ++i) {
        SCOPED_TRACE(i);
        std::vector<LatticePoint> points;
        for (int k = 0; k < 12; ++k)
            points.push_back(test::random_point(random, 100000));
        const auto body = TranslationSweep::of(points, kLattice);
        ASSERT_TRUE(body);
        const LatticePoint a = test::random_point(random, 100000);
        const LatticePoint u = test::random_point(random, 30000);
        const auto on = [&](std::int64_t times) {
            return a + LatticePoint{times * u.x, times * u.y, times * u.z};
        };
        const auto k = random.between(1, 3), m = random.between(4, 6);
        const Cell all = (*body)(a, on(m), Origin{2});
        EXPECT_TRUE(lies_within((*body)(a, on(k), Origin{1}), all, place));
        EXPECT_TRUE(lies_within((*body)(on(k), on(m), Origin{1}), all, place));
        EXPECT_TRUE(lies_within(all, all, place));
        EXPECT_FALSE(lies_within(all, (*body)(a, on(k), Origin{1}), place));
    }
}

// The part is the same for any number of waiting cells and any queries in between.
TEST(WholeTurn, CoversWhatWaits) {
    const TranslationSweep body = prism(100000, 16, 900000);
    TreeCda plain(kStock, kLattice), covered(kStock, kLattice), booked(kStock, kLattice),
        asked(kStock, kLattice);
    booked.track_removal();
    std::int64_t z = 200000;
    std::uint32_t motion = 0;
    for (int i = 0; i < 5; ++i, z -= 60000) {
        const auto way = turn({0, 0, z}, 60000, 24, i < 4 ? 60000 : 0);
        const Origin origin{++motion};
        std::vector<Cell> steps = steps_of(body, way);
        for (Cell& step : steps) {
            step.origin = origin;
            step.rank = 0;
        }
        Cell all = *body.around(way, origin);
        all.rank = -1;
        plain.subtract_step(steps);
        covered.subtract_step(steps, std::span(&all, 1));
        booked.subtract_step(steps, std::span(&all, 1));
        asked.subtract_step(steps, std::span(&all, 1));
        if (i == 2) {
            EXPECT_NEAR(asked.volume(), plain.volume(), 1e-9);
        }
    }
    EXPECT_NEAR(covered.volume(), plain.volume(), 1e-9);
    EXPECT_NEAR(asked.volume(), plain.volume(), 1e-9);
    EXPECT_LT(covered.counts().nodes, plain.counts().nodes);
    // Each turn has the volume that it removed, although the last turn covers all turns.
    double sum = 0.0;
    for (std::uint32_t i = 1; i <= motion; ++i) {
        EXPECT_GT(booked.account().at(Origin{i}).volume, 0.1);
        sum += booked.account().at(Origin{i}).volume;
    }
    EXPECT_NEAR(216.0 - sum, plain.volume(), 1e-9);
}

}  // namespace
}  // namespace ncsim::cda
