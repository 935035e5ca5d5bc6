// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of the faces of a part, from the records of its cuts.
#include "sources.h"

#include "ncsim/simulation/stock_history.h"
#include "ncsim/toolpath/kinematics.h"

#include "motions.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

void move_to(gcode::Position& position, const Vec3& to) {
    position.x = gcode::Length::from_mm(to.x);
    position.y = gcode::Length::from_mm(to.y);
    position.z = gcode::Length::from_mm(to.z);
}

// Returns the surfaces that the tool can have left in the recorded cut of `motion`.
brep::SweptSurfaces surfaces_of(const CutRecord& cut, gcode::Motion motion,
                                const toolpath::Tool& tool, const toolpath::Kinematics* specified) {
    if (!cut.path) return brep::surfaces_of(motion, tool, specified);
    auto& line = std::get<gcode::Linear>(motion.action);
    move_to(line.from, cut.path->from);
    move_to(line.to, cut.path->to);
    brep::SweptSurfaces surfaces = brep::surfaces_of(motion, tool, specified);
    surfaces.deviation_mm += cut.path->moved_mm;
    if (!cut.path->line_start) return surfaces;
    move_to(line.from, *cut.path->line_start);
    line.from.u = line.from.v = line.from.w = gcode::Length();
    brep::SweptSurfaces of_line = brep::surfaces_of(motion, tool, specified);
    std::ranges::move(of_line.candidates, std::back_inserter(surfaces.candidates));
    return surfaces;
}

}  // namespace

void for_each_source(const Plan& plan, const Survey& survey, const Simulation& simulation,
                     const cda::Boundary& boundary, double tolerance_mm, const SourceSink& sink) {
    // Rounding of the lattice, and of sums of lattice positions.
    constexpr double kRounding = 1e-3;
    const double rounding = kRounding + tolerance_mm;
    std::vector<bool> is_there(simulation.cuts.size(), false);
    for (const cda::BoundaryFace& face : boundary.faces) {
        const auto origin = static_cast<std::size_t>(face.origin);
        if (origin < is_there.size()) is_there[origin] = true;
    }
    if (const StockHistory* history = simulation.history.get()) {
        for (std::uint32_t i = 0; i < history->surfaces.size(); ++i) {
            if (i != 0 && !is_there[i]) continue;
            brep::SweptSurfaces source = history->surfaces[i];
            source.error_mm += tolerance_mm;
            sink(cda::Origin{i}, std::move(source));
        }
    } else {
        sink(cda::kStockOrigin,
             {brep::surfaces_of(*survey.stock), plan.tool_tolerance + rounding, false});
    }
    const auto& cuts = simulation.cuts;
    std::size_t next = 1 + std::size_t{earlier_origins(simulation.history.get())};
    std::uint64_t motions = 0;
    for_each_motion(plan, [&](const gcode::Motion& motion) {
        ++motions;
        if (next >= cuts.size() || cuts[next].motion != motions) return;
        const std::size_t origin = next++;
        const auto tool = survey.tools.find(motion.tool);
        if (!is_there[origin] || tool == survey.tools.end()) return;
        const auto cutter = simulation.cutters.find(motion.tool);
        const double polygon =
            cutter == simulation.cutters.end() ? plan.tool_tolerance : cutter->second.error_mm;
        brep::SweptSurfaces source =
            surfaces_of(cuts[origin], motion, tool->second.tool, plan.placed.get());
        source.error_mm = polygon + source.chords * plan.tolerance + source.deviation_mm + rounding;
        sink(cda::Origin{static_cast<std::uint32_t>(origin)}, std::move(source));
    });
}

}  // namespace ncsim::simulation
