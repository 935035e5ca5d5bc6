// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `ncsim parse`: how a program is read, as text that can be compared or as JSON.
#pragma once

#include "ncsim/gcode/control_codes.h"

#include "options/program_options.h"

namespace ncsim::app {

struct ParseOptions : ProgramOptions {
    bool canonical = false;  ///< The motions the program makes, not its blocks.
    bool json = false;
    const gcode::ControlCodes* control = nullptr;  ///< List what it does not have.
};

/// The command `parse` of `app`. It reads into `options`, which must outlive it.
cli::App* add_parse(cli::App& app, ParseOptions& options);

/// The blocks or motions to the standard output, what there is to say about them to stderr. Throws
/// std::runtime_error if the world fails.
int run(const ParseOptions& options);

}  // namespace ncsim::app
