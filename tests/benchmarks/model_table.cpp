// SPDX-License-Identifier: GPL-3.0-or-later
//
// model_table [PROGRAM…]: prints the cost of the models of the workpiece and the errors of inexact
// models, with a single thread. PROGRAM is wave-10000 and so on (programs.h), or a file. Each row
// is a model in a separate process, so memory is that of a single model.
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/check.h"
#include "ncsim/dexel/dexel.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/draft.h"
#include "ncsim/simulation/models.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/toolpath/walk.h"

#include "measure.h"
#include "nef/nef_part.h"
#include "programs.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace ncsim;

using bench::cpu_seconds;

struct Row {
    std::string title, model;
    double resolution = 0.0;
    simulation::RayDirections rays = simulation::RayDirections::Chosen;
};

struct Program {
    std::string name;
    gcode::SourceFile text;
};

Program program_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    if (!file) return {name, {name, bench::program_named(name)}};
    return {std::filesystem::path(name).stem().string(),
            {name, std::string(std::istreambuf_iterator<char>(file), {})}};
}

simulation::Plan plan_for(const Program& program, const Row& row) {
    simulation::Plan plan;
    plan.job = setup::job_of(program.text);
    plan.model = row.model;
    plan.resolution = row.resolution;
    plan.rays = row.rays;
    plan.threads = 1;
    plan.keep_boundary = true;
    return plan;
}

// CPU seconds in the model alone, and the number of moves.
struct Cutting {
    double seconds = 0.0;
    std::size_t moves = 0;
};

class Bodies {
public:
    Bodies(cda::WorkpieceModel& part, Cutting& cutting) : part_(part), cutting_(cutting) {}
    ~Bodies() { flush(); }
    Bodies(const Bodies&) = delete;
    Bodies& operator=(const Bodies&) = delete;

    void take(const toolpath::Step& step) {
        sweeps_.insert(sweeps_.end(), step.sweeps.begin(), step.sweeps.end());
        cells_.insert(cells_.end(), step.cells.begin(), step.cells.end());
        cutting_.moves += step.sweeps.size() + step.cells.size();
        constexpr std::size_t kChunk = 4096;
        if (sweeps_.size() + cells_.size() >= kChunk) flush();
    }

private:
    void flush() {
        const double start = cpu_seconds();
        for (const cda::RoundSweep& sweep : sweeps_)
            dynamic_cast<cda::SweepModel&>(part_).subtract_sweep(sweep);
        if (!cells_.empty()) part_.subtract_unmeasured(cells_);
        cutting_.seconds += cpu_seconds() - start;
        sweeps_.clear();
        cells_.clear();
    }

    cda::WorkpieceModel& part_;
    Cutting& cutting_;
    std::vector<cda::RoundSweep> sweeps_;
    std::vector<cda::Cell> cells_;
};

Cutting cut_alone(const simulation::Plan& plan, const simulation::Survey& survey,
                  const cda::WorkpieceModel& prototype,
                  std::unique_ptr<cda::WorkpieceModel>& part) {
    const cda::Shape stock = toolpath::stock_shape(*survey.stock, plan.tool_tolerance);
    part = cda::create(prototype, stock);
    toolpath::ToolAccuracy accuracy;
    accuracy.tolerance_mm = plan.tool_tolerance;
    toolpath::Walk walk(stock.lattice, survey.stock->box,
                        {.accuracy = accuracy,
                         .prefers_sweeps = dynamic_cast<cda::SweepModel*>(part.get()) != nullptr});
    for (const auto& [number, used] : survey.tools)
        walk.add_tool(number, used.tool);
    Cutting cutting;
    {
        Bodies bodies(*part, cutting);
        std::uint32_t number = 0;
        gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
            walk.take(motion, cda::Origin{++number},
                      [&](const toolpath::Step& step) { bodies.take(step); });
        });
    }
    const double start = cpu_seconds();
    static_cast<void>(part->volume());  // cuts the waiting cells
    cutting.seconds += cpu_seconds() - start;
    return cutting;
}

// Prints rows for the surface alone: dual contouring, and marching cubes as in the thesis.
void print_mesher_rows(const Program& program, double resolution, double exact_volume) {
    simulation::Plan plan = plan_for(program, {"", "dexel", resolution});
    const simulation::Survey survey = simulation::survey(plan);
    for (const auto& [title, mesher] : {std::pair{"dual contouring", dexel::Mesher::DualContouring},
                                        {"marching cubes", dexel::Mesher::MarchingCubes}}) {
        const dexel::Dexel prototype({1, resolution, dexel::Directions::Three, mesher});
        std::unique_ptr<cda::WorkpieceModel> part;
        cut_alone(plan, survey, prototype, part);
        const double start = cpu_seconds();
        const cda::Boundary boundary = part->boundary();
        const double seconds = cpu_seconds() - start;
        fmt::print("| {} | {:g} xyz, {} | {} | - | {:.2f} | - | - | - | {:+.3g} |\n", program.name,
                   resolution, title, cda::check(boundary).is_closed() ? "yes" : "NO", seconds,
                   cda::volume(boundary) - exact_volume);
        std::fflush(stdout);
    }
}

// Prints the row of boundary evaluation, a Boolean operation per hull.
void print_nef_row(const Program& program, double exact_volume) {
    simulation::Plan plan = plan_for(program, {"nef", "cda"});
    const double start = cpu_seconds();
    const simulation::Survey survey = simulation::survey(plan);
    const Box box = survey.stock->box;
    const cda::Lattice lattice = cda::Lattice::for_stock(box);
    toolpath::ToolAccuracy accuracy;
    accuracy.tolerance_mm = plan.tool_tolerance;
    toolpath::Walk walk(lattice, box, {accuracy});
    for (const auto& [number, used] : survey.tools)
        walk.add_tool(number, used.tool);
    test::NefPart part(cda::box_cell(lattice.round(box.min), lattice.round(box.max), lattice));
    double seconds = 0.0;
    std::size_t hulls = 0;
    std::uint32_t number = 0;
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
        walk.take(motion, cda::Origin{++number}, [&](const toolpath::Step& step) {
            const double before = cpu_seconds();
            for (const cda::Cell& cell : step.cells)
                part.subtract(cell);
            seconds += cpu_seconds() - before;
            hulls += step.cells.size();
        });
    });
    const double volume = part.volume() * lattice.cubic_unit_mm3();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(
        "| {} | boundary evaluation (CGAL Nef) | - | {:.2f} | {:.2f} | {} | {:+.3g} | 0 | - |\n",
        program.name, 1e6 * seconds / static_cast<double>(std::max<std::size_t>(hulls, 1)),
        cpu_seconds() - start, usage.ru_maxrss / 1024, volume - exact_volume);
    std::fflush(stdout);
}

void print_row(const Program& program, const Row& row, double exact_volume) {
    simulation::Plan plan = plan_for(program, row);
    const double start = cpu_seconds();
    const simulation::Survey survey = simulation::survey(plan);
    if (!survey.is_ready()) throw std::runtime_error("cannot be simulated");
    simulation::choose_rays(plan, survey);
    simulation::choose_resolution(plan, survey);
    const simulation::Simulation done = simulation::simulate(plan, survey, {}, {});
    const double whole = cpu_seconds() - start;
    const bool is_closed = cda::check(*done.boundary).is_closed();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    simulation::ModelParameters parameters;
    parameters.threads = 1;
    parameters.resolution_mm = plan.resolution;
    parameters.only_along_z = plan.rays == simulation::RayDirections::AlongZ;
    std::unique_ptr<cda::WorkpieceModel> part;
    const Cutting cutting =
        cut_alone(plan, survey, *simulation::make_model(plan.model, parameters), part);
    const auto moves = static_cast<double>(std::max<std::size_t>(cutting.moves, 1));
    const double volume = done.part_volume;
    fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {} | {:+.3g} | {:.3g} | {:+.3g} |\n",
               program.name, row.title, is_closed ? "yes" : "NO", 1e6 * cutting.seconds / moves,
               whole, usage.ru_maxrss / 1024, volume - exact_volume, done.part_volume_error,
               cda::volume(*done.boundary) - exact_volume);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    using simulation::RayDirections;
    const std::vector<Row> rows{
        {"dexel 0.4 xyz", "dexel", 0.4, RayDirections::AlongAll},
        {"dexel 0.2 xyz", "dexel", 0.2, RayDirections::AlongAll},
        {"dexel 0.4 z", "dexel", 0.4, RayDirections::AlongZ},
        {"dexel 0.2 z", "dexel", 0.2, RayDirections::AlongZ},
        {"dexel 0.1 z", "dexel", 0.1, RayDirections::AlongZ},
    };
    // The flat aggregate is quadratic.
    constexpr std::size_t kMostForFlat = 30'000, kMostForNef = 8'000;  // characters
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty()) {
        names = {NCSIM_SOURCE_DIR "/samples/simple.nc",
                 NCSIM_SOURCE_DIR "/samples/complex.nc",
                 NCSIM_SOURCE_DIR "/samples/wave.nc",
                 "wave-10000",
                 "wave-100000",
                 "finish-35000",
                 "pocket-10000",
                 "drill-10000"};
    }
    try {
        fmt::print(
            "| program | model | closed | cutting, µs a hull | from text to surface, s | MB | "
            "volume "
            "- exact, mm³ | reported bound, mm³ | enclosed - exact, mm³ |\n"
            "|---|---|---|---|---|---|---|---|---|\n");
        std::fflush(stdout);
        for (const std::string& name : names) {
            const Program program = program_of(name);
            const Row exact{"cda", "cda", 0.0, RayDirections::Chosen};
            simulation::Plan plan = plan_for(program, exact);
            plan.keep_boundary = false;
            const double volume = simulation::simulate(plan).part_volume;
            const auto apart = [&](const std::string& title,
                                   const std::function<void()>& print_it) {
                bench::apart(program.name + " | " + title, 0, print_it);
            };
            const auto print = [&](const Row& row) {
                apart(row.title, [&] { print_row(program, row, volume); });
            };
            print(exact);
            const std::size_t length = program.text.text.size();
            if (length <= kMostForFlat) print({"cda-flat", "cda-flat", 0.0, RayDirections::Chosen});
            if (length <= kMostForNef) apart("nef", [&] { print_nef_row(program, volume); });
            for (const Row& row : rows)
                print(row);
            constexpr double kCoarse = 0.4;
            apart("meshers", [&] { print_mesher_rows(program, kCoarse, volume); });
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "model_table: %s\n", e.what());
        return 2;
    }
    return 0;
}
