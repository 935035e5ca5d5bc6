// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of the codes that controls have, and the codes of a program that a control lacks.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Parts of the language that a control may lack; bits.
enum ControlFeature : std::uint32_t {
    kVariables = 1,      ///< #1, #<name>, R1 in expressions.
    kExpressions = 2,    ///< [1 + 2]
    kOWords = 4,         ///< sub, call, if, while of RS274/NGC.
    kMacroB = 8,         ///< IF, WHILE, GOTO of Fanuc.
    kArcsByRadius = 16,  ///< R of G2 and G3.
    kCornerWords = 32,   ///< ,R and ,C
    kBlockDelete = 64,   ///< A slash at the start of a line.
};

/// A row of control_codes.def.
struct ControlCodes {
    std::string_view name;        ///< "grbl"
    std::string_view title;       ///< "grbl 1.1"
    std::string_view g;           ///< Numbers and ranges of whole numbers: "0 1 38.2 54-59".
    std::string_view optional_g;  ///< With a build option, a device or an option of the maker.
    std::string_view m, optional_m;
    std::string_view axes;       ///< Letters of its axes, of XYZABCUVW.
    std::uint32_t features = 0;  ///< Bits of ControlFeature.
    bool is_complete = false;    ///< False: the list is second-hand and may have gaps.
    std::string_view otherwise;  ///< What the control does with a code that it lacks.
    std::string_view source;
};

/// Returns all controls of the table, by name.
std::span<const ControlCodes> all_control_codes();

/// Returns the row of `name`, or nullptr.
const ControlCodes* find_control_codes(std::string_view name);

/// Unknown: the number of the code is an expression.
enum class CodeSupport : std::uint8_t { No, Option, Unknown, Yes };

/// Returns whether the control has the G code (`letter` 'G') or M code `number`.
/// Requires: `control` is a row of the table.
CodeSupport support_of(const ControlCodes& control, char letter, double number);

/// A code, an axis or a part of the language that a program uses.
struct CodeUse {
    std::string what;  ///< "G81", "variables"
    SourceSpan first;
    std::uint64_t count = 0;  ///< Blocks with it, or words.
    CodeSupport support = CodeSupport::No;
};

/// Returns what `program` uses and `control` does not surely have, in the order of the first use:
/// what it lacks, has as an option, or what is unknown. Lines that cannot be read are among them. A
/// program in another language (Klartext, SINUMERIK …) is one use, of that language. Files that the
/// program calls are not read, and the lengths of lines and the ranges of values are not judged.
/// Cost: O(length of the program).
std::vector<CodeUse> lacking_codes(const SourceFile& program, const ControlCodes& control);

}  // namespace ncsim::gcode
