// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks the motions of a program and collects the hulls of its tools.
#include "hulls.h"

#include "ncsim/cda/intersect.h"
#include "ncsim/cda/tree.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/setup/job.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/toolpath/walk.h"

#include "programs.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace ncsim::bench {

cda::Cell Hulls::stock_cell() const {
    return cda::box_cell(lattice.round(stock.min), lattice.round(stock.max), lattice);
}

double Hulls::exact_volume() const {
    cda::TreeParameters parameters;
    parameters.threads = 1;
    cda::TreeCda part(stock_cell(), lattice, parameters);
    part.subtract_unmeasured(cells);
    return part.volume();
}

Hulls hulls_of(const std::string& name, std::size_t most) {
    std::ifstream file(name, std::ios::binary);
    gcode::SourceFile text{
        name, file ? std::string(std::istreambuf_iterator<char>(file), {}) : program_named(name)};
    simulation::Plan plan;
    plan.job = setup::job_of(std::move(text));
    const simulation::Survey survey = simulation::survey(plan);
    Hulls hulls;
    hulls.name = std::filesystem::path(name).stem().string();
    hulls.stock = survey.stock->box;
    hulls.lattice = cda::Lattice::for_stock(hulls.stock);
    toolpath::ToolAccuracy accuracy;
    accuracy.tolerance_mm = plan.tool_tolerance;
    toolpath::Walk walk(hulls.lattice, hulls.stock, {accuracy});
    for (const auto& [number, used] : survey.tools)
        walk.add_tool(number, used.tool);
    gcode::interpret(plan.job.program, plan.job.interpreter, [&](const gcode::Motion& motion) {
        if (hulls.cells.size() >= most) return;
        walk.take(motion, cda::Origin{1}, [&](const toolpath::Step& step) {
            for (const cda::Cell& cell : step.cells) {
                if (hulls.cells.size() < most) hulls.cells.push_back(cell);
            }
        });
    });
    return hulls;
}

std::vector<cda::ConvexPolytope> bodies_of(const Hulls& hulls, Within within) {
    constexpr std::int64_t kFar = (std::int64_t{1} << cda::kCoordinateBits) - 2;
    const cda::Cell room =
        within == Within::Stock
            ? hulls.stock_cell()
            : cda::box_cell({-kFar, -kFar, -kFar}, {kFar, kFar, kFar}, hulls.lattice);
    const auto box = cda::ConvexPolytope::of(room, hulls.lattice);
    std::vector<cda::ConvexPolytope> bodies;
    cda::IntersectionCosts costs;
    for (const cda::Cell& cell : hulls.cells) {
        if (auto body = cda::intersect(*box, cell, hulls.lattice, costs))
            bodies.push_back(std::move(*body));
    }
    return bodies;
}

}  // namespace ncsim::bench
