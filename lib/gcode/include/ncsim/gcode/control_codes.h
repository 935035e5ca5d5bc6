// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables of the codes of each control, and the codes of a program that a control lacks.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Parts of the language that a control may lack, as bits.
enum ControlFeature : std::uint32_t {
    kVariables = 1,      ///< #1, #<name>, R1 in expressions.
    kExpressions = 2,    ///< [1 + 2]
    kOWords = 4,         ///< sub, call, if, while of RS274/NGC.
    kMacroB = 8,         ///< IF, WHILE, GOTO of Fanuc.
    kArcsByRadius = 16,  ///< R of G2 and G3.
    kCornerWords = 32,   ///< ,R and ,C
    kBlockDelete = 64,   ///< A slash at the start of a line.
    kSkippedRest = 128,  ///< A slash within a line: block delete skips the rest.
};

/// The codes of one control: a row of control_codes.def.
struct ControlCodes {
    std::string_view name;   ///< "grbl"
    std::string_view title;  ///< "grbl 1.1"
    std::string_view g;      ///< Numbers and ranges of whole numbers: "0 1 38.2 54-59".
    /// Codes that need a build option, a device or an option of the manufacturer.
    std::string_view optional_g;
    std::string_view m, optional_m;
    std::string_view axes;       ///< Letters of the axes, from XYZABCUVW.
    std::uint32_t features = 0;  ///< Bits of ControlFeature.
    bool is_complete = false;    ///< False if the list is second-hand and may have gaps.
    std::string_view otherwise;  ///< Reaction of the control to a code that is not in the table.
    std::string_view source;
};

/// Returns all rows of the table, in the order of control_codes.def.
std::span<const ControlCodes> all_control_codes();

/// Returns the row with the name `name`, or nullptr.
const ControlCodes* find_control_codes(std::string_view name);

/// Support of a code. Option: an option of the control. Unknown: the number of the code is an
/// expression.
enum class CodeSupport : std::uint8_t { No, Option, Unknown, Yes };

/// Returns the support of `control` for the G code (`letter` 'G') or M code `number`.
/// Requires: `control` is a row of the table.
CodeSupport support_of(const ControlCodes& control, char letter, double number);

/// A code, an axis or a part of the language that a program uses.
struct CodeUse {
    std::string what;  ///< "G81", "variables"
    SourceSpan first;
    std::uint64_t count = 0;  ///< Number of blocks or words that use the code.
    CodeSupport support = CodeSupport::No;
};

/// Returns the codes, axes and language parts that `program` uses and `control` lacks, has only as
/// an option, or may lack (unknown), in the order of the first use. Unreadable lines count as
/// unknown. A program in another language (Klartext, SINUMERIK …) counts as a single use of the
/// language. Called files are not read. Lengths of lines and ranges of values are not checked.
/// Cost: O(length of the program).
std::vector<CodeUse> missing_codes(const SourceFile& program, const ControlCodes& control);

}  // namespace ncsim::gcode
