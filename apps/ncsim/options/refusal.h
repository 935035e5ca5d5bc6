// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exit codes, and errors of the command line.
#pragma once

#include <string>

namespace ncsim::app {

/// Exit codes of the program; also listed in --help.
enum ExitCode : int {
    kClean = 0,
    kFindings = 1,     ///< The NC program has faults.
    kEnvironment = 2,  ///< Wrong usage, unreadable input, or an environment failure.
    kInternalError = 3,
    kNotProven = 4,  ///< No fault was found, but an unspecified value prevents "clean".
};

/// Value that the parser of the command line cannot judge. Thrown and caught during parsing, inside
/// parse_options() only.
struct Refusal {
    std::string text;  ///< "--stock '1x2': expected …"
};

}  // namespace ncsim::app
