// SPDX-License-Identifier: GPL-3.0-or-later
//
// Data at the end of a run.
#pragma once

#include "ncsim/brep/measure.h"
#include "ncsim/brep/part_shading.h"
#include "ncsim/brep/recognise.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/export/drawing.h"
#include "ncsim/mesh/simplify.h"
#include "ncsim/report/checked.h"
#include "ncsim/report/run_report.h"
#include "ncsim/setup/machine_file.h"
#include "ncsim/simulation/design_view.h"
#include "ncsim/simulation/facts.h"
#include "ncsim/simulation/plan.h"
#include "ncsim/simulation/sections.h"
#include "ncsim/simulation/simulate.h"
#include "ncsim/simulation/solid.h"
#include "ncsim/simulation/survey.h"
#include "ncsim/verify/finding.h"

#include "options/run_options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::app {

/// Result of a run. `simulation` is null if the program could not be simulated, `boundary` if no
/// output needs the surface.
struct Outcome {
    const Options& options;
    const simulation::Plan& plan;
    const simulation::Survey& survey;
    const simulation::Simulation* simulation = nullptr;
    const cda::Boundary* boundary = nullptr;
    /// Shading of `boundary`; null: default.
    const brep::Shading* shading = nullptr;
    /// Simplified surface for meshes; null: `boundary`.
    const mesh::Simplified* simplified = nullptr;
    /// Solid for --step; null: no output.
    const simulation::Solid* solid = nullptr;
    std::optional<brep::Mass> solid_mass{};  ///< Mass of `solid`.
    /// Part with true surfaces, as the tools left them; null if no output needs the solid.
    const simulation::Solid* true_solid = nullptr;
    /// Sections in the order of the options.
    std::vector<simulation::SectionView> sections{};
    /// Data of --html; null: no output.
    const simulation::PageData* page_data = nullptr;
    /// Machine file of --machine; null: none.
    const setup::MachineFile* machine = nullptr;
    /// Fixtures to be drawn, in W.
    std::vector<verify::Fixture> fixtures{};
    /// Comparison with the design for Colouring::Design; null: other colours.
    const simulation::DesignView* design = nullptr;
    /// Finding whose bodies a picture marks; null: none.
    const verify::Finding* finding = nullptr;
    /// Times of the whole program on the machine.
    std::optional<verify::Ledger> on_machine{};
    /// Assumptions of the run, for files that ncsim reads again; one text each.
    std::vector<std::string> assumed{};
    /// Rest of the stock for --save-stock; null: no output.
    const cda::Shape* left = nullptr;
};

/// Number of deviations from the design that pictures and texts list.
inline constexpr std::size_t kMostDesignPlaces = 5;

/// Returns the sections with their origins; points into `outcome`.
std::vector<exporter::DrawnSection> drawn_sections(const Outcome& outcome);

/// Returns the facts for the report; points into `outcome`.
report::RunFacts run_facts(const Outcome& outcome);

}  // namespace ncsim::app
