// SPDX-License-Identifier: GPL-3.0-or-later
//
// What we have to say about a program: a severity, a stable code for searching and for
// tests, a message for people and a place. Messages stand in src/diagnostics.def.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::gcode {

enum class Severity : std::uint8_t { Note, Warning, Error };

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;     ///< Stable, kebab-case: "arc-without-centre".
    std::string message;  ///< Lower case, no full stop, in the machinist's words.
    SourceSpan span;
    std::string file;          ///< Set where the place is not in the main program (O-files).
    std::uint32_t count = 1;   ///< How often it was met; the span is the first place.
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

bool has_errors(const Diagnostics& diagnostics);

/// The diagnostic as people read it, with the line and a caret, ending in a newline:
///
///     pocket.nc:3:5: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
///     N30 G2 X10 Y0
///         ^~
std::string render(const Diagnostic& diagnostic, const SourceFile& file);

}  // namespace ncsim::gcode
