// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known at the end of a run.
#pragma once

#include "ncsim/brep/measure.h"
#include "ncsim/brep/recognise.h"
#include "ncsim/brep/shading.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/drawing.h"
#include "ncsim/export/simplify.h"
#include "ncsim/report/facts.h"
#include "ncsim/report/run_report.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/sections.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"

#include "options/run_options.h"

#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

/// `simulation` is null if the program could not be simulated, `boundary` if nobody asked for it.
struct Outcome {
    const Options& options;
    const simulation::Plan& plan;
    const simulation::Survey& survey;
    const simulation::Simulation* simulation = nullptr;
    const cda::Boundary* boundary = nullptr;
    /// How `boundary` is shaded; null: as it is.
    const brep::Shading* shading = nullptr;
    /// What meshes are made of, if it is not `boundary` itself.
    const exporter::Simplified* simplified = nullptr;
    /// What --step writes, if anybody asked for it.
    const simulation::Solid* solid = nullptr;
    std::optional<brep::Mass> solid_mass{};  ///< Of it.
    /// The part as the tools left it, if anything that is asked for is made of that.
    const simulation::Solid* true_solid = nullptr;
    /// Where it was cut open, in the order of the options.
    std::vector<simulation::CutOpen> sections{};
    /// What --machine told, if anything.
    const setup::MachineFile* machine = nullptr;
    /// Times of the whole program on it.
    std::optional<verify::Ledger> on_machine{};
    /// Assumptions of the run, for files that ncsim reads again; a text each.
    std::vector<std::string> assumed{};
};

/// The sections with their origins; points into it.
std::vector<exporter::DrawnSection> drawn_sections(const Outcome& outcome);

/// What is reported of it; points into it.
report::RunFacts run_facts(const Outcome& outcome);

}  // namespace ncsim::app
