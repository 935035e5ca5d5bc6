// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options of the parser.
#pragma once

namespace ncsim::gcode {

struct ParserOptions {
    /// Report as errors what RS274/NGC does not know, even if other controls do: nested comments,
    /// checksums, expressions without brackets, console commands.
    bool strict = false;
};

}  // namespace ncsim::gcode
