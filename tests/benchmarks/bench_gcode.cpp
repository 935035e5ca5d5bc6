// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines per second that are parsed and interpreted. Items are lines.
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/parser.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace {

using namespace ncsim::gcode;

/// Returns a finishing pass: G1 lines with three axes and three decimals, as CAM systems write.
SourceFile plain_lines(std::int64_t lines) {
    SourceFile file{"plain.nc", "G21 G90\nG0 Z10\nF500\n"};
    std::uint32_t random = 1;
    const auto number = [&] {
        random = random * 1664525U + 1013904223U;
        const std::uint32_t value = random >> 8U;
        return std::to_string(value % 200)
            .append(".")
            .append(std::to_string(100 + value / 200 % 900));
    };
    for (std::int64_t i = 0; i < lines; ++i) {
        file.text.append("G1 X").append(number()).append(" Y").append(number());
        file.text.append(" Z-").append(number()).append("\n");
    }
    return file.text += "M2\n", file;
}

void parse(benchmark::State& state) {
    const SourceFile file = plain_lines(state.range(0));
    for (auto _ : state) {
        BlockReader reader(file);
        Block block;
        double sum = 0.0;
        while (reader.next(block)) {
            if (!block.words.empty()) sum += block.words.back().number;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file.text.size()));
}
BENCHMARK(parse)->Range(1 << 14, 1 << 20)->Unit(benchmark::kMillisecond);

void interpret_lines(benchmark::State& state) {
    const SourceFile file = plain_lines(state.range(0));
    for (auto _ : state) {
        double sum = 0.0;
        const auto result = interpret(file, {}, [&](const Motion& motion) {
            if (const Position* end = end_of(motion)) sum += end->x.mm();
        });
        benchmark::DoNotOptimize(sum);
        benchmark::DoNotOptimize(result.motions);
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file.text.size()));
}
BENCHMARK(interpret_lines)->Range(1 << 14, 1 << 20)->Unit(benchmark::kMillisecond);

/// Measures a loop: expressions, parameters, and a jump per iteration.
void interpret_loop(benchmark::State& state) {
    const SourceFile file{
        "loop.ngc", "G21 G90 F500\n#1=0\no100 while [#1 LT " + std::to_string(state.range(0)) +
                        "]\nG1 X[#1 * 0.1] Y[sin[#1]]\n#1=[#1 + 1]\no100 endwhile\nM2\n"};
    for (auto _ : state)
        benchmark::DoNotOptimize(interpret(file, {}, {}).motions);
    state.SetItemsProcessed(state.iterations() * state.range(0) * 4);
}
BENCHMARK(interpret_loop)->Arg(1 << 14)->Unit(benchmark::kMillisecond);

}  // namespace
