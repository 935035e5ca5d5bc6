// SPDX-License-Identifier: GPL-3.0-or-later
//
// Failures that become exceptions of the Python package: ncsim.UsageError, ncsim.ProgramError,
// ncsim.Error.
#pragma once

#include "ncsim/gcode/diagnostic.h"

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace ncsim::python {

/// Unusable argument, or a file that cannot be read: ncsim.UsageError.
struct UsageFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Program with errors: ncsim.ProgramError.
struct ProgramFailure : std::runtime_error {
    ProgramFailure(const std::string& message, std::string program_name, gcode::Diagnostics found)
        : std::runtime_error(message),
          program(std::move(program_name)),
          diagnostics(std::move(found)) {}

    std::string program;             ///< Name of the program file.
    gcode::Diagnostics diagnostics;  ///< All messages about the program.
};

/// Returns `diagnostics` as a list of tuples (severity, code, message, file, line, column, count);
/// `program` is the file of diagnostics without a file.
pybind11::list diagnostic_list(const gcode::Diagnostics& diagnostics, const std::string& program);

/// Translates the failures, and further std::runtime_error, to the exceptions of the package.
void register_failures();

}  // namespace ncsim::python
