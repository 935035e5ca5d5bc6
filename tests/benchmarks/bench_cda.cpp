// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cost of a hull in the tree: a raster of short ball-nose moves over crossed sines. Step and
// step-over shrink with the number of moves, as in real finishing.
#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/toolpath/trace.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace ncsim;

const cda::Lattice kLattice{1e-5};

cda::Cell stock() {
    return cda::box_cell(kLattice.round({0, 0, -40}), kLattice.round({100, 100, 0}), kLattice);
}

std::vector<cda::Cell> wave(std::int64_t moves) {
    // A tolerance of 0.15 mm makes a coarse ball.
    toolpath::Cutter cutter(toolpath::ball_end_mill(6.0, 20.0), kLattice, {0.15});
    const auto rows = static_cast<int>(std::sqrt(static_cast<double>(moves)));
    const auto columns = static_cast<int>(moves / rows);
    std::vector<cda::Cell> cells;
    std::uint32_t number = 0;
    for (int row = 0; row < rows; ++row) {
        toolpath::Pose from;
        for (int k = 0; k <= columns; ++k) {
            const double x = 100.0 * (row % 2 == 0 ? k : columns - k) / columns;
            const double y = 100.0 * row / (rows - 1);
            toolpath::Pose to;
            to.translation = {x, y, -6.0 + 2.0 * std::sin(0.25 * x) * std::cos(0.25 * y)};
            if (k > 0) cutter.trace(from, to, cda::Origin{++number}, cells);
            from = to;
        }
    }
    return cells;
}

void report(benchmark::State& state, std::size_t hulls) {
    state.counters["hulls"] = static_cast<double>(hulls);
    state.counters["per_hull"] =
        benchmark::Counter(static_cast<double>(hulls) * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void Insert(benchmark::State& state) {
    const auto cells = wave(state.range(0));
    for (auto _ : state) {
        cda::TreeCda part(stock(), kLattice);
        for (const cda::Cell& cell : cells)
            part.subtract_unmeasured(cell);
        benchmark::DoNotOptimize(part);
    }
    report(state, cells.size());
}
BENCHMARK(Insert)->RangeMultiplier(4)->Range(1024, 65536)->Unit(benchmark::kMillisecond);

void BoundaryOfTree(benchmark::State& state) {
    const auto cells = wave(state.range(0));
    cda::TreeCda part(stock(), kLattice);
    for (const cda::Cell& cell : cells)
        part.subtract_unmeasured(cell);
    for (auto _ : state)
        benchmark::DoNotOptimize(part.boundary());
    report(state, cells.size());
    const cda::TreeCounts counts = part.counts();
    const auto per_hull = [&](std::uint64_t n) {
        return static_cast<double>(n) / static_cast<double>(cells.size());
    };
    state.counters["planes"] = per_hull(counts.planes);
    state.counters["leaves"] = per_hull(counts.leaves);
    state.counters["facets_tested"] = per_hull(counts.facets_tested);
    state.counters["facets_alive"] = per_hull(counts.facets_alive);
    state.counters["pieces"] = per_hull(counts.pieces);
}
BENCHMARK(BoundaryOfTree)->RangeMultiplier(4)->Range(1024, 16384)->Unit(benchmark::kMillisecond);

void SubtractFlat(benchmark::State& state) {
    const auto cells = wave(state.range(0));
    for (auto _ : state) {
        cda::FlatCda part(stock(), kLattice);
        for (const cda::Cell& cell : cells)
            part.subtract(cell);
        benchmark::DoNotOptimize(part);
    }
    report(state, cells.size());
}
BENCHMARK(SubtractFlat)->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
