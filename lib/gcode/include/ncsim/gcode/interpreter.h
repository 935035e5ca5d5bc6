// SPDX-License-Identifier: GPL-3.0-or-later
//
// From text to motions: the front door of lib/gcode for every other stage.
#pragma once

#include "ncsim/gcode/interpretation.h"

namespace ncsim::gcode {

/// Runs `program`. Total: any byte sequence gives a result; a block with an error in
/// it is reported and left out, and reading goes on. Streams: memory does not grow with the
/// number of motions. Bounded: loops and calls end with a diagnostic at a stated limit.
Interpretation interpret(const SourceFile& program, const InterpreterOptions& options,
                         const MotionSink& sink);

}  // namespace ncsim::gcode
