// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of the parser.
#pragma once

namespace ncsim::gcode {

/// Options of BlockReader.
struct ParserOptions {
    /// Reports extensions that RS274/NGC lacks as errors: nested comments, checksums, expressions
    /// without brackets, console commands.
    bool strict = false;
};

}  // namespace ncsim::gcode
