// SPDX-License-Identifier: GPL-3.0-or-later
//
// A simulated program. Surface, solid and motions are made on request and kept.
#pragma once

#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

#include "mesh_data.h"
#include "motion_records.h"
#include "prepared_plan.h"
#include "request.h"
#include "solid_data.h"

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::python {

/// The part of a program. All members may be called from several threads, which wait for each
/// other.
class Simulated {
public:
    /// Simulates the program of `request`.
    /// Throws: UsageFailure; ProgramFailure if the program cannot be simulated, or if a block has
    /// an error and `request` does not allow errors.
    Simulated(const SimulateRequest& request, const std::stop_token& stop);

    const simulation::Plan& plan() const { return prepared_.plan; }
    const simulation::Survey& survey() const { return survey_; }
    const simulation::Simulation& result() const { return result_; }
    /// Returns the values of the machine that cannot be used, in words.
    const std::vector<std::string>& not_used() const { return not_used_; }

    std::shared_ptr<MeshData> mesh();
    std::shared_ptr<const std::vector<MotionRecord>> motions();
    /// Returns the solid, improved by up to `refinements` further cuts.
    std::shared_ptr<SolidData> solid(int refinements, const std::stop_token& stop);
    /// Returns the measures of the part as JSON.
    std::string measures(const std::stop_token& stop);
    /// Returns the assumptions of the run, a text each.
    std::vector<std::string> assumptions();

private:
    const std::vector<std::string>& assumed();
    std::shared_ptr<SolidData> solid_with(const simulation::Refinement& limit,
                                          const std::stop_token& stop);

    simulation::SimulationOptions accuracy_;
    PreparedPlan prepared_;
    std::vector<std::string> not_used_;
    simulation::Survey survey_;
    simulation::Simulation result_;
    std::mutex mutex_;  // for all that follows, and for the provenance of result_
    std::optional<std::vector<std::string>> assumed_;
    std::shared_ptr<MeshData> mesh_;
    std::shared_ptr<const std::vector<MotionRecord>> motions_;
    std::map<std::pair<int, bool>, std::shared_ptr<SolidData>> solids_;  // by Refinement
};

/// Adds the class Simulation and the function simulate() to `module`.
void define_simulation(pybind11::module_& module);

}  // namespace ncsim::python
