// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the path of a program to a verdict, whatever is wrong with it.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/simulation/check.h"

#include "options/check_options.h"

#include <cstddef>
#include <stop_token>
#include <string>

namespace ncsim::app {

/// Returns the plan of the program at `path`; `threads` evaluate at a time. `number`: index of the
/// program in a file with several.
simulation::Plan plan_to_check(const std::string& path, const CheckOptions& options,
                               unsigned threads, setup::InputSet& inputs, std::size_t number = 0);

/// Reads and verifies `path`; returns the exit code that the program alone would have. Never
/// throws: what is wrong is in the result. The result depends on the file and the options only.
/// `threads` evaluate at a time. Gives up when it is asked to `stop`. `number`: which program of
/// the file; `programs` becomes how many there are, if that is known.
int check_program(report::Checked& checked, const std::string& path, const CheckOptions& options,
                  const simulation::Questions& questions, unsigned threads, setup::InputSet& inputs,
                  std::stop_token stop, std::size_t number, std::size_t& programs);

}  // namespace ncsim::app
