// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts options into a plan.
#include "options/plan_options.h"

#include "ncsim/simulation/plan_reader.h"

namespace ncsim::app {

simulation::Plan plan_for(const ProgramOptions& program, const SimulationOptions& simulation,
                          setup::InputSet& inputs, const std::stop_token& stop) {
    return simulation::read_plan(static_cast<const setup::JobOptions&>(program), simulation,
                                 program.machine, *program.left_stocks, inputs, stop);
}

simulation::Plan plan_for(const Options& options, setup::InputSet& inputs) {
    simulation::Plan plan = plan_for(options, options, inputs);
    plan.draft = options.draft;
    plan.is_model_specified = options.model_specified;
    plan.needs_exact = needs_exact_part(options);
    plan.resolution = options.resolution;
    plan.rays = options.rays;
    plan.at_line = options.at_line;
    plan.keep_boundary = needs_surface(options);
    plan.keep_paths = options.shows_path;
    plan.keep_removed_cells = !options.save_stock.empty();
    plan.tool_volumes = !options.quiet || !options.report.empty();
    plan.block_volumes = options.block_volumes;
    plan.hull_times = !options.stats.empty();
    return plan;
}

}  // namespace ncsim::app
