// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim diff`: do two programs make the same part? The gate for a change of a
// post-processor.
#pragma once

#include "options/program_options.h"

#include <string>

namespace ncsim::app {

/// `program` is the old one.
struct DiffOptions : ProgramOptions, SimulationOptions {
    std::string new_program;
    std::string machine;         ///< Offsets and how the machine turns, of both.
    double tolerance_mm3 = 0.0;  ///< Differences up to this volume do not count.
    bool process = false;        ///< Exit code 1 for feeds and speeds that differ, too.
    std::string json;            ///< A file to write; empty: not asked for.
    bool quiet = false;
};

cli::App* add_diff(cli::App& app, DiffOptions& options);
void complete(const DiffOptions& options);

/// 0: the same part (and process, where asked for); 1: not, or a program has faults. Throws
/// std::runtime_error if the world fails.
int run(const DiffOptions& options);

}  // namespace ncsim::app
