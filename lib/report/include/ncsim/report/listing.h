// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks, motions and codes of a program, as text for comparison or as JSON.
#pragma once

#include "ncsim/gcode/control_codes.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/interpreter.h"
#include "ncsim/gcode/parser.h"
#include "ncsim/gcode/source.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace ncsim::report {

/// Receives text in chunks, so memory does not grow with the program.
using TextSink = std::function<void(std::string_view)>;

/// Lists the blocks of `program`.
/// Returns: the diagnostics, which are part of the JSON, too.
gcode::Diagnostics list_blocks(const gcode::SourceFile& program,
                               const gcode::ParserOptions& options, bool as_json,
                               const TextSink& sink);
/// Lists the motions of `program`, in mm and degrees.
/// Returns: the diagnostics, which are part of the JSON, too.
gcode::Diagnostics list_motions(const gcode::SourceFile& program,
                                const gcode::InterpreterOptions& options, bool as_json,
                                const TextSink& sink);

/// Numbers of codes (gcode::CodeUse) that a control lacks, and of codes that cannot be judged.
struct MissingCodes {
    std::size_t lacking = 0, unknown = 0;
};

/// Lists the codes in `program` that `control` lacks, may lack, or has as an option, one a line.
MissingCodes list_missing_codes(const gcode::SourceFile& program,
                                const gcode::ControlCodes& control, bool as_json,
                                const TextSink& sink);

}  // namespace ncsim::report
