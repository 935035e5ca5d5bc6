// SPDX-License-Identifier: GPL-3.0-or-later
//
// NC text → motions → poses → hulls → part, as in the architecture's own sentence. Everything
// flows: no stage keeps more than one motion.
#include "pipeline.h"

#include "ncsim/cda/cell.h"
#include "ncsim/cda/flat.h"
#include "ncsim/cda/tree.h"
#include "ncsim/toolpath/trace.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace ncsim::app {

namespace {

double now_in_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Models by name; the one place that knows them.
std::unique_ptr<cda::WorkpieceModel> prototype(const Options& options) {
    if (options.model == "cda") {
        cda::TreeParameters parameters;
        parameters.threads = options.threads;
        return std::make_unique<cda::TreeCda>(parameters);
    }
    if (options.model == "cda-flat") {
        const bool timed = !options.stats.empty();
        return std::make_unique<cda::FlatCda>(timed ? &now_in_seconds : nullptr);
    }
    throw std::logic_error("no such model: " + options.model);
}

class Mill {
public:
    Mill(const Job& job, const Survey& survey, Simulation& result)
        : result_(result),
          stock_(survey.stock->box),
          measured_(job.options.model == "cda-flat" ||
                    (!job.options.report.empty() && job.options.block_volumes)),
          volume_(result.stock_volume) {
        accuracy_.tolerance_mm = job.options.tool_tolerance;
        sampling_.chord_tolerance_mm = job.options.tolerance;
        sampling_.rotation_miss_mm = job.options.tolerance;
        sampling_.rotation_gain_mm = 10 * job.options.tolerance;
        for (const auto& [number, used] : survey.tools) {
            const auto [cutter, is_new] = cutters_.try_emplace(
                number, toolpath::Cutter(used.tool, result.lattice, accuracy_));
            result.cutters[number] = {cutter->second.sides(), cutter->second.error_mm()};
        }
        result.provenance.program = base_name(job.program.name);
        result.provenance.entries.push_back({});  // the stock
    }

    void take(const gcode::Motion& motion) {
        if (motion.tool != tool_) change_tool(motion.tool);
        const auto found = cutters_.find(motion.tool);
        if (found == cutters_.end() || !toolpath::has_known_start(motion)) return;
        toolpath::Cutter& cutter = found->second;

        const toolpath::Samples samples = toolpath::sample(motion, cutter.extent(), sampling_);
        const cda::Origin origin{static_cast<std::uint32_t>(result_.provenance.entries.size())};
        bool met_stock = false;
        double removed = 0.0;
        for (std::size_t i = 1; i < samples.poses.size(); ++i) {
            const toolpath::Pose& X_WA = samples.poses[i - 1];
            const toolpath::Pose& X_WB = samples.poses[i];
            // A tool that does not move cuts nothing it has not cut on its way here.
            if (X_WA == X_WB || !stock_.overlaps(cutter.bounds(X_WA, X_WB))) continue;
            cells_.clear();
            cutter.trace(X_WA, X_WB, origin, cells_);
            for (const cda::Cell& cell : cells_) {
                if (!stock_.overlaps(cell.bounds)) continue;
                met_stock = true;
                ++result_.hulls;
                if (measured_) {
                    removed += result_.part->subtract(cell);
                } else {
                    result_.part->subtract_unmeasured(cell);
                }
            }
        }
        if (!met_stock) return;
        cut_since_change_ = true;
        result_.provenance.entries.push_back(
            {motion.span.line, static_cast<std::uint32_t>(std::max(0, motion.tool))});
        if (measured_) result_.removed_by_tool[motion.tool] += removed;
        if (removed > 0.0) result_.removed_by_block[{motion.file, motion.span.line}] += removed;
        result_.bounds.missed_mm = std::max(result_.bounds.missed_mm, samples.bounds.missed_mm);
        result_.bounds.gained_mm = std::max(result_.bounds.gained_mm, samples.bounds.gained_mm);
    }

    /// After the last motion.
    void finish() {
        change_tool(0);
        result_.part_volume = volume_;
    }

private:
    // Where cells are not measured one by one, what a tool removed is the difference of volumes.
    void change_tool(int next) {
        if (cut_since_change_) {
            const double volume = result_.part->volume();
            if (!measured_) result_.removed_by_tool[tool_] += volume_ - volume;
            volume_ = volume;
        }
        cut_since_change_ = false;
        tool_ = next;
    }

    Simulation& result_;
    cda::Box stock_;
    bool measured_;
    int tool_ = 0;
    double volume_;
    bool cut_since_change_ = false;
    toolpath::ToolAccuracy accuracy_;
    toolpath::SamplingOptions sampling_;
    std::map<int, toolpath::Cutter> cutters_;
    std::vector<cda::Cell> cells_;  // of one step, kept for its memory
};

}  // namespace

cda::Lattice lattice_for(const toolpath::StockEntry& stock) {
    return cda::Lattice::for_stock(stock.box);
}

Simulation simulate(const Job& job, const Survey& survey, const ProgressSink& progress) {
    Simulation result;
    result.lattice = lattice_for(*survey.stock);
    const cda::LatticePoint min = result.lattice.round(survey.stock->box.min);
    const cda::LatticePoint max = result.lattice.round(survey.stock->box.max);
    result.part =
        prototype(job.options)->create(cda::box_cell(min, max, result.lattice), result.lattice);
    result.stock_volume = result.part->volume();

    Mill mill(job, survey, result);
    std::uint64_t moves = 0;
    gcode::interpret(job.program, job.interpreter, [&](const gcode::Motion& motion) {
        mill.take(motion);
        if (start_of(motion)) progress(++moves);
    });
    mill.finish();
    return result;
}

}  // namespace ncsim::app
