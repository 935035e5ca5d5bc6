// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `ncsim check` and `ncsim rules`.
#pragma once

#include "options/check_options.h"

namespace ncsim::app {

/// Verifies every program, several at a time. Prints findings and verdicts to the standard output,
/// in the order of the command line, each as soon as all earlier programs are finished. Returns the
/// worst exit code.
/// Throws: std::runtime_error if the machine description cannot be read or an output cannot be
///   written.
int run(CheckOptions options);

int run(const RulesOptions& options);

}  // namespace ncsim::app
