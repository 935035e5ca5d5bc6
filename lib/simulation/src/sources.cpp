// SPDX-License-Identifier: GPL-3.0-or-later
#include "sources.h"

#include "join_moves.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace ncsim::simulation {

void for_each_source(const Plan& plan, const Survey& survey, const Simulation& simulation,
                     const cda::Boundary& boundary, double tolerance_mm, const SourceSink& sink) {
    // Of the lattice, and of what sums of these lack in accuracy.
    constexpr double kRounding = 1e-3;
    const double rounding = kRounding + tolerance_mm;
    std::vector<bool> is_there(simulation.cuts.size(), false);
    for (const cda::BoundaryFace& face : boundary.faces) {
        const auto origin = static_cast<std::size_t>(face.origin);
        if (origin < is_there.size()) is_there[origin] = true;
    }
    sink(cda::kStockOrigin,
         {brep::surfaces_of(*survey.stock), plan.tool_tolerance + rounding, false});
    std::uint64_t motions = 0;
    std::size_t next = 1;
    MoveJoiner joiner(plan.join_tolerance, [&](const gcode::Motion& motion) {
        ++motions;
        if (next >= simulation.cuts.size() || simulation.cuts[next].motion != motions) return;
        const std::size_t origin = next++;
        const auto tool = survey.tools.find(motion.tool);
        if (!is_there[origin] || tool == survey.tools.end()) return;
        const auto cutter = simulation.cutters.find(motion.tool);
        const double polygon =
            cutter == simulation.cutters.end() ? plan.tool_tolerance : cutter->second.error_mm;
        brep::Source source = brep::surfaces_of(motion, tool->second.tool, plan.placed.get());
        source.error_mm = polygon + source.chords * plan.tolerance + plan.join_tolerance + rounding;
        sink(cda::Origin{static_cast<std::uint32_t>(origin)}, std::move(source));
    });
    gcode::InterpreterOptions silent = plan.job.interpreter;
    silent.observe_frame = nullptr;
    gcode::interpret(plan.job.program, silent,
                     [&](const gcode::Motion& motion) { joiner.take(motion); });
    joiner.flush();
}

}  // namespace ncsim::simulation
