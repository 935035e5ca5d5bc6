// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares each recorded state of the surface with the part.
#include "ncsim/cda/surface_recorder.h"

#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"

#include "support/passes.h"
#include "support/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ncsim::cda {
namespace {

using test::kLattice;
using test::mm_box;

const Cell kStock = mm_box(-3, -3, -3, 3, 3, 3);

// Volume within the pieces of a state, by the divergence theorem.
double volume_of(const SurfaceRecorder& recorder, std::uint32_t state) {
    double sum = 0.0;
    for (const SurfacePiece& piece : recorder.pieces()) {
        if (piece.first_state > state || piece.end_state <= state) continue;
        const auto corner = [&](std::uint32_t i) {
            return recorder.grid().position(recorder.corners()[piece.first_corner + i]);
        };
        for (std::uint32_t i = 1; i + 1 < piece.corners; ++i)
            sum += dot(corner(0), cross(corner(i), corner(i + 1))) / 6.0;
    }
    return sum;
}

// Removes the cuts one by one and records each state. Returns the volumes.
std::vector<double> record(WorkpieceModel& part, const std::vector<Cell>& cuts,
                           SurfaceRecorder& recorder) {
    std::vector<double> volumes{part.volume()};
    part.record_surface(recorder);
    for (const Cell& cut : cuts) {
        part.subtract_unmeasured(cut);
        volumes.push_back(part.volume());
        part.record_surface(recorder);
    }
    return volumes;
}

void expect_volumes(const SurfaceRecorder& recorder, const std::vector<double>& volumes) {
    ASSERT_EQ(recorder.states(), volumes.size());
    for (std::uint32_t state = 0; state < volumes.size(); ++state)
        EXPECT_NEAR(volume_of(recorder, state), volumes[state], 0.02) << "state " << state;
}

// The error of a corner is half a step of the grid, 1/20000 mm, and the cube has 216 mm3.
TEST(SurfaceRecorder, StatesHaveTheVolumeOfThePart) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const auto cuts =
            test::random_cuts(seed, 12, 60000 + static_cast<std::int64_t>(seed) * 5000);
        for (const std::uint32_t leaf : {6U, 80U}) {
            TreeCda part(kStock, kLattice, {leaf, 2});
            SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
            expect_volumes(recorder, record(part, cuts, recorder));
        }
    }
}

TEST(SurfaceRecorder, ModelsWithoutCellsInATreeRecordTheirBoundary) {
    const auto cuts = test::random_cuts(3, 6, 60000);
    FlatCda part(kStock, kLattice);
    SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
    expect_volumes(recorder, record(part, cuts, recorder));
}

TEST(SurfaceRecorder, FarFromACutPiecesAreStoredOnce) {
    TreeCda part(kStock, kLattice);
    SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
    part.record_surface(recorder);
    const std::size_t before = recorder.pieces().size();
    part.subtract_unmeasured(mm_box(2, 2, 2, 3, 3, 3));
    part.record_surface(recorder);
    const auto lasting =
        std::ranges::count(recorder.pieces(), SurfaceRecorder::kNever, &SurfacePiece::end_state);
    EXPECT_GT(lasting, 0);
    EXPECT_LT(recorder.pieces().size(), before + before / 2);
}

TEST(SurfaceRecorder, KeptStatesAreUnchanged) {
    const auto cuts = test::random_cuts(5, 30, 60000);
    TreeCda part(kStock, kLattice);
    SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
    const std::vector<double> volumes = record(part, cuts, recorder);
    const std::size_t before = recorder.pieces().size();
    const std::vector<std::uint32_t> kept{0, 15, 30};
    recorder.keep_states(kept);
    std::vector<double> expected;
    for (const std::uint32_t state : kept)
        expected.push_back(volumes[state]);
    expect_volumes(recorder, expected);
    EXPECT_LT(recorder.pieces().size(), before);
}

TEST(SurfaceRecorder, RecordingContinuesAfterStatesWereDropped) {
    const auto cuts = test::random_cuts(9, 30, 60000);
    TreeCda part(kStock, kLattice);
    SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
    part.record_surface(recorder);
    std::vector<double> volumes{part.volume()};
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        part.subtract_unmeasured(cuts[i]);
        part.record_surface(recorder);
        volumes.push_back(part.volume());
        if (i != 10 && i != 19) continue;
        // The last state is dropped in the first case and kept in the second.
        std::vector<std::uint32_t> kept;
        std::vector<double> rest;
        for (std::uint32_t state = 0; state < volumes.size(); state += 2) {
            kept.push_back(state);
            rest.push_back(volumes[state]);
        }
        recorder.keep_states(kept);
        volumes.swap(rest);
    }
    expect_volumes(recorder, volumes);
}

TEST(SurfaceRecorder, DoesNotDependOnTheNumberOfThreads) {
    const auto cuts = test::random_cuts(7, 20, 60000);
    std::vector<GridPoint> first;
    for (const std::uint32_t threads : {1U, 2U, 7U}) {
        TreeCda part(kStock, kLattice, {12, threads});
        SurfaceRecorder recorder(RecordGrid::around(kStock.bounds));
        record(part, cuts, recorder);
        const std::vector<GridPoint> corners(recorder.corners().begin(), recorder.corners().end());
        if (first.empty()) first = corners;
        EXPECT_EQ(corners, first);
    }
}

}  // namespace
}  // namespace ncsim::cda
