// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the removed volumes that a model books per origin with volumes measured cut by cut.
#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"

#include "support/oracle.h"
#include "support/passes.h"
#include "support/rounds.h"
#include "support/straight_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;
using test::Random;

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

RemovalByMotion booked(const std::vector<Cell>& cuts, const TreeParameters& parameters) {
    TreeCda part(kStock, kLattice, parameters);
    part.track_removal();
    part.subtract_unmeasured(cuts);
    return part.account();
}

RemovalByMotion measured(const std::vector<Cell>& cuts) {
    TreeCda part(kStock, kLattice);
    RemovalByMotion account;
    for (const Cell& cut : cuts) {
        const double volume = part.subtract(cut);
        account[cut.origin].volume += volume;
        if (volume > 0.0) account[cut.origin].bounds.add(cut.bounds);
    }
    return account;
}

void expect_booked(const std::vector<Cell>& cuts, double tolerance = 1e-11) {
    const RemovalByMotion expected = measured(cuts);
    // Inserts cells singly, in groups or all at once, into leaves that split early or late.
    for (const TreeParameters& parameters :
         {TreeParameters{12, 1, 1}, TreeParameters{12, 1, 7}, TreeParameters{12, 1, 8192},
          TreeParameters{80, 1, 25}, TreeParameters{80, 1, 8192}}) {
        SCOPED_TRACE(testing::Message() << parameters.leaf << ' ' << parameters.batch);
        const RemovalByMotion account = booked(cuts, parameters);
        for (const auto& [origin, taken] : expected) {
            const auto found = account.find(origin);
            const RemovedVolume got = found == account.end() ? RemovedVolume{} : found->second;
            EXPECT_NEAR(got.volume, taken.volume, tolerance) << static_cast<std::uint32_t>(origin);
            // The entry of an origin that removes nothing is empty.
            if (taken.volume == 0.0) {
                EXPECT_EQ(got, RemovedVolume{}) << static_cast<std::uint32_t>(origin);
            }
        }
        for (const auto& [origin, taken] : account)
            EXPECT_TRUE(taken.volume == 0.0 || expected.contains(origin));
    }
}

TEST(RemovalByMotion, OfHullsOfAllKinds) {
    for (std::uint64_t seed = 0; seed < test::rounds(12U); ++seed) {
        SCOPED_TRACE(seed);
        expect_booked(test::random_cuts(seed, 60, 60000 + static_cast<std::int64_t>(seed) * 15000));
    }
}

TEST(RemovalByMotion, OfPassesOnFloorsAndWallsOfEachOther) {
    for (std::uint64_t seed = 0; seed < test::rounds(12U); ++seed) {
        SCOPED_TRACE(seed);
        expect_booked(test::passes_of_several_tools(seed, 120));
    }
}

// Passes a lattice unit or two apart, in part repeated. Nearly parallel planes meet in lines that
// doubles resolve only to a hundredth of a unit.
TEST(RemovalByMotion, OfPassesNextToEachOther) {
    for (std::uint64_t seed = 0; seed < test::rounds(6U); ++seed) {
        SCOPED_TRACE(seed);
        auto passes = test::jittered_passes(seed, 60);
        for (std::size_t i = 10; i < passes.size(); i += 3) {
            passes[i] = passes[i / 2];
            passes[i].origin = Origin{static_cast<std::uint32_t>(i + 1)};
        }
        expect_booked(passes, 1e-8);
    }
}

// An arc is many cells with the same origin. In a loop, an origin returns later.
TEST(RemovalByMotion, OfOriginsWithManyCells) {
    for (std::uint64_t seed = 0; seed < test::rounds(8U); ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        auto passes = test::passes_of_several_tools(seed + 100, 120);
        std::uint32_t origin = 1;
        for (Cell& pass : passes) {
            if (random.one_in(4)) origin = static_cast<std::uint32_t>(random.between(1, 20));
            pass.origin = Origin{origin};
        }
        expect_booked(passes);
    }
}

TEST(RemovalByMotion, OfStepsThatWentStraightOn) {
    for (std::uint64_t seed = 0; seed < test::rounds(6U); ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<test::StraightWay> ways = test::straight_ways(seed, 20);
        std::vector<Cell> steps;
        for (const test::StraightWay& way : ways)
            steps.insert(steps.end(), way.steps.begin(), way.steps.end());
        const RemovalByMotion expected = measured(steps);
        for (const TreeParameters& parameters :
             {TreeParameters{12, 1, 1}, TreeParameters{12, 1, 7}, TreeParameters{12, 1, 32768},
              TreeParameters{80, 2, 32768}}) {
            SCOPED_TRACE(testing::Message() << parameters.leaf << ' ' << parameters.batch);
            TreeCda part(kStock, kLattice, parameters), alone(kStock, kLattice, parameters);
            part.track_removal();
            std::span<const Cell> before;
            for (const test::StraightWay& way : ways) {
                for (const Cell& step : way.steps) {
                    part.subtract_step(std::span(&step, 1), {}, std::exchange(before, {}));
                    alone.subtract_step(std::span(&step, 1));
                }
                before = std::span(&way.all, 1);
            }
            part.subtract_step({}, {}, before);
            const RemovalByMotion account = part.account();
            for (const auto& [origin, taken] : expected) {
                const auto found = account.find(origin);
                const RemovedVolume got = found == account.end() ? RemovedVolume{} : found->second;
                EXPECT_NEAR(got.volume, taken.volume, 1e-11) << static_cast<std::uint32_t>(origin);
                EXPECT_EQ(got.bounds, taken.bounds) << static_cast<std::uint32_t>(origin);
            }
            EXPECT_NEAR(part.volume(), alone.volume(), 1e-10);
            EXPECT_LE(part.counts().nodes, alone.counts().nodes);
        }
    }
}

TEST(RemovalByMotion, SumsUpToWhatThePartLost) {
    const auto passes = test::passes_of_several_tools(3, 200);
    TreeCda part(kStock, kLattice);
    const double before = part.volume();
    part.track_removal();
    part.subtract_unmeasured(passes);
    const RemovalByMotion account = part.account();
    const double sum =
        std::accumulate(account.begin(), account.end(), 0.0,
                        [](double all, const auto& one) { return all + one.second.volume; });
    EXPECT_NEAR(sum, before - part.volume(), 1e-10);
}

TEST(RemovalByMotion, DoesNotDependOnTheNumberOfThreads) {
    const auto passes = test::passes_of_several_tools(7, 300);
    const RemovalByMotion one = booked(passes, {.threads = 1, .batch = 100});
    EXPECT_EQ(one, booked(passes, {.threads = 2, .batch = 100}));
    EXPECT_EQ(one, booked(passes, {.threads = 5, .batch = 100}));
}

// Six cells of the same origin in a row; the first four pass through empty space.
TEST(RemovalByMotion, IsWhereSomethingWasTaken) {
    for (const std::uint32_t batch : {1U, 3U, 8192U}) {
        TreeCda part(kStock, kLattice, {.batch = batch});
        part.track_removal();
        part.subtract_unmeasured(mm_box(-3, -3, 0, 1, 3, 3, Origin{1}));
        for (std::int64_t x = -3; x < 3; x += 1)
            part.subtract_unmeasured(mm_box(x, -1, 1, x + 1, 1, 2, Origin{2}));
        part.subtract_unmeasured(mm_box(-3, -1, 1, 3, 1, 2, Origin{3}));
        const RemovalByMotion account = part.account();
        EXPECT_NEAR(account.at(Origin{2}).volume, 4.0, 1e-12);
        EXPECT_EQ(account.at(Origin{2}).bounds, (Box{{1, -1, 1}, {3, 1, 2}}));
        EXPECT_TRUE(!account.contains(Origin{3}) || account.at(Origin{3}) == RemovedVolume{});
    }
}

TEST(RemovalByMotion, OfTheFlatAggregateIsTheSame) {
    const auto cuts = test::random_cuts(4, 30, 120000);
    FlatCda flat(kStock, kLattice);
    flat.track_removal();
    flat.subtract_unmeasured(cuts);
    const RemovalByMotion expected = flat.account();
    for (const auto& [origin, taken] : booked(cuts, {})) {
        const auto found = expected.find(origin);
        const RemovedVolume other = found == expected.end() ? RemovedVolume{} : found->second;
        EXPECT_NEAR(taken.volume, other.volume, 1e-11);
        EXPECT_EQ(taken.bounds, other.bounds);
    }
}

// Neither queries in between nor cells that wait change the account.
TEST(RemovalByMotion, GoesOnWhereQuestionsAreAsked) {
    const auto passes = test::passes_of_several_tools(11, 80);
    TreeCda part(kStock, kLattice);
    part.track_removal();
    RemovalByMotion expected;
    TreeCda reference(kStock, kLattice);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        expected[passes[i].origin].volume += reference.subtract(passes[i]);
        part.subtract_unmeasured(passes[i]);
        if (i % 5 == 0) {
            EXPECT_EQ(part.contact(passes[i]), std::nullopt);
        }
        if (i % 17 == 0) {
            EXPECT_NEAR(part.volume(), reference.volume(), 1e-9);
        }
    }
    const TreeCda copy(part);
    for (const TreeCda* model : {static_cast<const TreeCda*>(&part), &copy}) {
        const RemovalByMotion account = model->account();
        for (const auto& [origin, taken] : expected) {
            const auto found = account.find(origin);
            const double got = found == account.end() ? 0.0 : found->second.volume;
            EXPECT_NEAR(got, taken.volume, 1e-11);
        }
    }
}

TEST(RemovalByMotion, OfNobodyIsEmpty) {
    TreeCda part(kStock, kLattice);
    part.subtract_unmeasured(mm_box(0, 0, 0, 1, 1, 1, Origin{1}));
    EXPECT_TRUE(part.account().empty());
    part.track_removal();
    part.subtract_unmeasured(mm_box(0, 0, 0, 1, 1, 2, Origin{2}));
    const RemovalByMotion account = part.account();
    ASSERT_EQ(account.size(), 1U);
    EXPECT_NEAR(account.at(Origin{2}).volume, 1.0, 1e-12);
}

}  // namespace
}  // namespace ncsim::cda
