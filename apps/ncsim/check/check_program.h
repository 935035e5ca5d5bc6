// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification of one program: from a path to a verdict, whatever the faults of the program.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/simulation/program_check.h"

#include "options/check_options.h"

#include <cstddef>
#include <stop_token>
#include <string>

namespace ncsim::app {

/// Returns the plan of the program at `path`; `threads` is the number of threads. `number`: index
/// of the program in a file with several.
simulation::Plan plan_to_check(const std::string& path, const CheckOptions& options,
                               unsigned threads, setup::InputSet& inputs, std::size_t number = 0,
                               const std::stop_token& stop = {});

/// Reads and verifies the program at `path` with `threads` threads; returns its exit code. Faults
/// are recorded in the result. Stops early at a request of `stop`. `number`: index of the program
/// in the file; `programs` becomes the number of programs in the file, if known.
/// Guarantees: never throws. The result depends on the file and the options only.
int check_program(report::Checked& checked, const std::string& path, const CheckOptions& options,
                  const simulation::VerificationOptions& verification_options, unsigned threads,
                  setup::InputSet& inputs, std::stop_token stop, std::size_t number,
                  std::size_t& programs);

}  // namespace ncsim::app
