// SPDX-License-Identifier: GPL-3.0-or-later
//
// Entry point of lib/gcode: converts a program to motions.
#pragma once

#include "ncsim/gcode/interpretation.h"

namespace ncsim::gcode {

/// Executes `program` and passes each motion to `sink`. A block with an error is reported and
/// skipped.
/// Guarantees: any byte sequence gives a result. Loops and calls end with a diagnostic at the
/// limits of `options`. Memory does not grow with the number of motions.
Interpretation interpret(const SourceFile& program, const InterpreterOptions& options,
                         const MotionSink& sink);

}  // namespace ncsim::gcode
