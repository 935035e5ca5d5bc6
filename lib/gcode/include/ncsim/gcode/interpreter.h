// SPDX-License-Identifier: GPL-3.0-or-later
//
// From text to motions: the front door of lib/gcode for every other stage.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/motion.h"
#include "ncsim/gcode/source.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace ncsim::gcode {

enum class DefaultUnits : std::uint8_t { Millimetres, Inches };

struct InterpreterOptions {
    /// For programs that say neither G20 nor G21.
    DefaultUnits default_units = DefaultUnits::Millimetres;
    /// Origins of G54, G55 … G59.3 in machine coordinates at the start. Motions are relative to the
    /// first.
    std::array<Position, 9> work_offsets{};
    bool block_delete = false;  ///< Skip blocks that start with '/'.
};

/// What was concluded on the way, for the assumption sheet and for reports.
struct Interpretation {
    Diagnostics diagnostics;
    bool units_stated = false;  ///< G20 or G21 came before the first length.
    bool uses_inches = false;   ///< At the first length.
    std::uint64_t lines = 0;
    std::uint64_t motions = 0;
    std::vector<std::string> files;  ///< [0] is the program; O-files that were called follow.
};

/// Called for each motion in the order of execution. The reference is valid during the call.
using MotionSink = std::function<void(const Motion&)>;

/// Runs `program`. Total: any byte sequence gives a result; a block with an error in
/// it is reported and left out, and reading goes on. Streams: memory does not grow with the
/// number of motions. Bounded: loops and calls end with a diagnostic at a stated limit.
Interpretation interpret(const SourceFile& program, const InterpreterOptions& options,
                         const MotionSink& sink);

}  // namespace ncsim::gcode
