// SPDX-License-Identifier: GPL-3.0-or-later
//
// engine_table [-t THREADS] PROGRAM…: prints the cost of a hull, from NC text to the watertight
// boundary: CPU microseconds per stage, and counts of the work. A row per program. With
// -DNCSIM_COUNT_FILTERS=ON also prints how often doubles cannot decide.
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/tree.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/toolpath/tool_spec.h"
#include "ncsim/toolpath/tool_table.h"
#include "ncsim/toolpath/trace.h"

#include "exact/filter_counts.h"
#include "measure.h"
#include "programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace ncsim;

using bench::cpu_seconds;

std::uint64_t for_each_hull(const gcode::SourceFile& program, const cda::Lattice& lattice,
                            const toolpath::Tool& tool,
                            const std::function<void(const cda::Cell&)>& take) {
    // The tolerance makes a coarse ball.
    toolpath::Cutter cutter(tool, lattice, {0.15});
    std::vector<cda::Cell> cells;
    std::uint64_t hulls = 0;
    std::uint32_t number = 0;
    gcode::interpret(program, {}, [&](const gcode::Motion& motion) {
        if (!toolpath::has_known_start(motion)) return;
        const auto samples = toolpath::sample(motion, cutter.extent(), {});
        const cda::Origin origin{++number};
        for (std::size_t i = 1; i < samples.poses.size(); ++i) {
            if (samples.poses[i - 1] == samples.poses[i]) continue;
            cells.clear();
            cutter.trace(samples.poses[i - 1], samples.poses[i], origin, cells);
            hulls += cells.size();
            for (const cda::Cell& cell : cells)
                take(cell);
        }
    });
    return hulls;
}

void measure(const std::string& name, std::uint32_t threads) {
    const gcode::SourceFile program{name, bench::program_named(name)};
    const auto notes = toolpath::read_notes(program);
    const Box box = notes.stock->box;
    const cda::Lattice lattice = cda::Lattice::for_stock(box);
    const toolpath::Tool tool = toolpath::make_tool(notes.tools.at(0).spec, 45.0);

    double checksum = 0.0;
    double start = cpu_seconds();
    const std::uint64_t hulls = for_each_hull(
        program, lattice, tool, [&](const cda::Cell& cell) { checksum += cell.bounds.min.x; });
    const double sweeping = cpu_seconds() - start;

    cda::TreeParameters parameters;
    parameters.threads = threads;
    cda::TreeCda part(cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice),
                      lattice, parameters);
    start = cpu_seconds();
    std::vector<cda::Cell> batch;
    const auto flush = [&] {
        part.subtract_unmeasured(batch);
        batch.clear();
    };
    for_each_hull(program, lattice, tool, [&](const cda::Cell& cell) {
        batch.push_back(cell);
        if (batch.size() == 1024) flush();
    });
    flush();
    part.settle();
    const double inserting = cpu_seconds() - start - sweeping;

    start = cpu_seconds();
    const double volume = part.volume();
    const double evaluating = cpu_seconds() - start;
    start = cpu_seconds();
    const cda::Boundary boundary = part.boundary();
    const double bounding = cpu_seconds() - start;

    const cda::TreeCounts& counts = part.counts();
    const auto n = static_cast<double>(hulls);
    const auto micro = [&](double seconds) { return 1e6 * seconds / n; };
    fmt::print(
        "{:<16}{:>9}{:>8.1f}{:>8.1f}{:>8.1f}{:>8.1f}{:>8.1f} |{:>8.0f}{:>7.1f}{:>7.2f}{:>8.2f}"
        "{:>8.2f}{:>8.2f}{:>7.2f} | {:.3f} {}\n",
        name, hulls, micro(sweeping), micro(inserting), micro(evaluating),
        micro(bounding - evaluating), micro(sweeping + inserting + bounding),
        static_cast<double>(counts.bytes) / n, static_cast<double>(counts.planes) / n,
        static_cast<double>(counts.nodes) / n, static_cast<double>(counts.leaves) / n,
        static_cast<double>(counts.facets_tested) / n, static_cast<double>(counts.pieces) / n,
        static_cast<double>(boundary.faces.size()) / n, volume, boundary.shells);
    std::fflush(stdout);
    if (checksum > 1e300) std::puts("");  // keeps the compiler from omitting work
}

// Prints the number of decisions, and the share that doubles cannot decide, in builds that count.
void print_filters() {
#ifdef NCSIM_COUNT_FILTERS
    constexpr std::array kNames{"points", "glances", "corners", "coordinates"};
    for (std::size_t i = 0; i < cda::kFilters; ++i) {
        const auto asked = static_cast<double>(cda::filter_counts[i].asked.exchange(0));
        const auto doubtful = static_cast<double>(cda::filter_counts[i].doubtful.exchange(0));
        const auto touching = static_cast<double>(cda::filter_counts[i].touching.exchange(0));
        fmt::print("    {:<12}{:>14.0f} asked{:>9.3f} % doubtful{:>9.3f} % touch\n", kNames[i],
                   asked, 100.0 * doubtful / std::max(asked, 1.0),
                   100.0 * touching / std::max(asked, 1.0));
    }
    std::fflush(stdout);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    std::uint32_t threads = 1;
    fmt::print(
        "CPU microseconds a hull: text to hulls, insertion, evaluation, stitching, all;\n"
        "a hull: bytes of the tree, planes, nodes, leaves, facets tested, pieces, faces;\n"
        "volume left, shells\n");
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "-t" && i + 1 < argc) {
            threads = static_cast<std::uint32_t>(std::atoi(argv[++i]));
        } else {
            measure(argument, threads);
            print_filters();
        }
    }
}
