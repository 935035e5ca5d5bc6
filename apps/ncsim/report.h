// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said at the end: for people as text, for programs as JSON.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/simplify.h"

#include "job.h"
#include "pipeline.h"
#include "survey.h"

#include <iosfwd>
#include <string>

namespace ncsim::app {

/// What is known at the end of a run. `simulation` is null if the program could not be simulated,
/// `boundary` if nobody asked for it.
struct Outcome {
    const Job& job;
    const Survey& survey;
    const Simulation* simulation = nullptr;
    const cda::Boundary* boundary = nullptr;
    /// What meshes are made of, if it is not `boundary` itself.
    const exporter::Simplified* simplified = nullptr;
};

/// "1.250 cm3".
std::string volume_text(double mm3);

/// A few lines for people.
std::string summary(const Outcome& outcome);

/// JSON, UTF-8. Depends on the input and the options only: no times, no dates. Lengths in mm,
/// volumes in mm³; lines count from 1. Keys are only ever added.
void write_report(std::ostream& out, const Outcome& outcome);

}  // namespace ncsim::app
