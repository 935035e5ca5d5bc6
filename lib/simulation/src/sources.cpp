// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources of the faces of a part, by a second pass over its motions.
#include "sources.h"

#include "ncsim/simulation/stock_history.h"
#include "ncsim/toolpath/kinematics.h"
#include "ncsim/toolpath/walk.h"

#include "join_moves.h"
#include "motions.h"
#include "upright_runs.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

// Successive straight feed moves of an upright tool along one line. The moves remove one hull,
// which has the origin of the last move (toolpath::Walk). So the surfaces at the start of the row
// have that origin, too.
class Row {
public:
    // Returns the start of the row of `motion`; empty if the motion starts a row or is in none.
    std::optional<gcode::Position> start_of(const gcode::Motion& motion) {
        if (!gcode::start_of(motion)) return std::nullopt;
        const gcode::Linear* line = toolpath::straight_upright(motion);
        if (!line || motion.kind != gcode::MoveKind::Feed) {
            start_.reset();
            return std::nullopt;
        }
        const bool goes_on =
            start_ && motion.tool == tool_ && end_ == line->from && is_ahead(*line);
        if (!goes_on) start_ = line->from;
        end_ = line->to;
        tool_ = motion.tool;
        return goes_on ? start_ : std::nullopt;
    }

private:
    // True if the line continues the row, to the accuracy of the lattice.
    bool is_ahead(const gcode::Linear& line) const {
        constexpr double kLattice = 2e-5;  // mm
        const Vec3 from = toolpath::linear_axes(line.from);
        const Vec3 way = from - toolpath::linear_axes(*start_);
        const Vec3 on = toolpath::linear_axes(line.to) - from;
        return dot(way, on) > 0.0 && norm(cross(way, on)) <= kLattice * (norm(way) + norm(on));
    }

    std::optional<gcode::Position> start_;  // start of the row
    gcode::Position end_;
    int tool_ = 0;
};

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
    std::uint64_t motions = 0;
    std::size_t next = 1 + std::size_t{earlier_origins(simulation.history.get())};
    Row row;
    UprightRuns runs([&](const gcode::Motion& motion, double moved_mm) {
        ++motions;
        const auto start_of_row = row.start_of(motion);
        if (next >= simulation.cuts.size() || simulation.cuts[next].motion != motions) return;
        const std::size_t origin = next++;
        const auto tool = survey.tools.find(motion.tool);
        if (!is_there[origin] || tool == survey.tools.end()) return;
        const auto cutter = simulation.cutters.find(motion.tool);
        const double polygon =
            cutter == simulation.cutters.end() ? plan.tool_tolerance : cutter->second.error_mm;
        brep::SweptSurfaces source =
            brep::surfaces_of(motion, tool->second.tool, plan.placed.get());
        // On specified machines no moves are combined.
        if (start_of_row && !plan.placed) {
            gcode::Motion together = motion;
            std::get<gcode::Linear>(together.action).from = *start_of_row;
            brep::SweptSurfaces of_row = brep::surfaces_of(together, tool->second.tool, nullptr);
            std::ranges::move(of_row.candidates, std::back_inserter(source.candidates));
        }
        source.error_mm =
            polygon + source.chords * plan.tolerance + source.deviation_mm + moved_mm + rounding;
        sink(cda::Origin{static_cast<std::uint32_t>(origin)}, std::move(source));
    });
    // On specified machines, any move may rotate the tool.
    MoveJoiner joiner(
        plan.join_tolerance,
        [&](const gcode::Motion& motion) {
            if (plan.placed) runs.flush();
            runs.take(motion);
        },
        plan.job.operations);
    for_each_motion(plan, [&](const gcode::Motion& motion) { joiner.take(motion); });
    joiner.flush();
    runs.flush();
}

}  // namespace ncsim::simulation
