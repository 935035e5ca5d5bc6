// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a program is read, as text that can be compared or as JSON.
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

/// Takes text on its way out, a chunk at a time: memory does not grow with the program.
using TextSink = std::function<void(std::string_view)>;

/// Its blocks. Returns what there is to say about them, which is part of the JSON, too.
gcode::Diagnostics list_blocks(const gcode::SourceFile& program,
                               const gcode::ParserOptions& options, bool as_json,
                               const TextSink& sink);
/// The motions it makes, in mm and degrees.
gcode::Diagnostics list_motions(const gcode::SourceFile& program,
                                const gcode::InterpreterOptions& options, bool as_json,
                                const TextSink& sink);

/// Uses of codes (gcode::CodeUse) that a control lacks, and those that cannot be judged.
struct Lacking {
    std::size_t lacking = 0, unknown = 0;
};

/// Lists what the program uses and `control` does not surely have, a line each.
Lacking list_lacking(const gcode::SourceFile& program, const gcode::ControlCodes& control,
                     bool as_json, const TextSink& sink);

}  // namespace ncsim::report
