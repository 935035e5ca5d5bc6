// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim measure`: what a calliper would find on the part.
#pragma once

#include "options/program_options.h"

#include <string>

namespace ncsim::app {

struct MeasureOptions : ProgramOptions, SimulationOptions {
    std::string machine;  ///< A file of one.
    std::string json;     ///< Where to write it; empty: nowhere.
    bool quiet = false;
};

/// The command `measure` of `app`. It reads into `options`, which must outlive it.
cli::App* add_measure(cli::App& app, MeasureOptions& options);
/// What can be judged only when all options were read; throws Refusal.
void complete(const MeasureOptions& options);

/// The sheet to the standard output, findings to stderr: kFindings, and no sheet, where the program
/// cannot be simulated. Throws std::runtime_error if the world fails.
int run(const MeasureOptions& options);

}  // namespace ncsim::app
