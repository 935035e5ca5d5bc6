// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known at the end of a run.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/simplify.h"
#include "ncsim/report/facts.h"
#include "ncsim/report/run_report.h"

#include "pipeline.h"
#include "plan.h"
#include "run_options.h"
#include "survey.h"

namespace ncsim::app {

/// `simulation` is null if the program could not be simulated, `boundary` if nobody asked for it.
struct Outcome {
    const Options& options;
    const Plan& plan;
    const Survey& survey;
    const Simulation* simulation = nullptr;
    const cda::Boundary* boundary = nullptr;
    /// What meshes are made of, if it is not `boundary` itself.
    const exporter::Simplified* simplified = nullptr;
};

/// What is reported of it; points into it.
report::RunFacts run_facts(const Outcome& outcome);

}  // namespace ncsim::app
