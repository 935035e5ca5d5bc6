// SPDX-License-Identifier: GPL-3.0-or-later
#include "sources.h"

#include "join_moves.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ncsim::simulation {

namespace {

// Straight moves at feed in a row, one as the other. What these take together is one hull of the
// last of them (toolpath::Walk), and so is what they leave where the first one starts.
class Row {
public:
    // The motion from where its row starts; nothing if that is its own start.
    std::optional<gcode::Motion> take(const gcode::Motion& motion) {
        const auto* line = std::get_if<gcode::Linear>(&motion.what);
        const bool is_of_row = line && motion.kind == gcode::MoveKind::Feed;
        if (!is_of_row || !last_ || motion.tool != last_->tool || !goes_on(*line)) {
            start_.reset();
            last_.reset();
            if (is_of_row) {
                start_ = line->from;
                last_ = motion;
            }
            return std::nullopt;
        }
        last_ = motion;
        gcode::Motion together = motion;
        std::get<gcode::Linear>(together.what).from = *start_;
        return together;
    }

private:
    static cda::Vec3 place(const gcode::Position& p) { return {p.x.mm(), p.y.mm(), p.z.mm()}; }

    // As far as the lattice tells.
    bool goes_on(const gcode::Linear& line) const {
        constexpr double kLattice = 2e-5;  // mm
        const gcode::Linear& before = std::get<gcode::Linear>(last_->what);
        if (!(before.to == line.from)) return false;
        const cda::Vec3 way = place(line.from) - place(*start_),
                        on = place(line.to) - place(line.from);
        const double length = cda::norm(way) + cda::norm(on);
        return cda::dot(way, on) > 0.0 && cda::norm(cda::cross(way, on)) <= kLattice * length;
    }

    std::optional<gcode::Position> start_;
    std::optional<gcode::Motion> last_;
};

}  // namespace

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
    Row row;
    MoveJoiner joiner(plan.join_tolerance, [&](const gcode::Motion& motion) {
        ++motions;
        const std::optional<gcode::Motion> together = row.take(motion);
        if (next >= simulation.cuts.size() || simulation.cuts[next].motion != motions) return;
        const std::size_t origin = next++;
        const auto tool = survey.tools.find(motion.tool);
        if (!is_there[origin] || tool == survey.tools.end()) return;
        const auto cutter = simulation.cutters.find(motion.tool);
        const double polygon =
            cutter == simulation.cutters.end() ? plan.tool_tolerance : cutter->second.error_mm;
        brep::Source source = brep::surfaces_of(motion, tool->second.tool, plan.placed.get());
        if (together) {
            brep::Source of_row =
                brep::surfaces_of(*together, tool->second.tool, plan.placed.get());
            std::ranges::move(of_row.candidates, std::back_inserter(source.candidates));
        }
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
