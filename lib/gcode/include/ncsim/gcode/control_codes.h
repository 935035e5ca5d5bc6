// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which codes a control has, and what of a program a control does not have.
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
    std::uint32_t features = 0;  ///< Bits of ControlFeature.
    bool is_complete = false;    ///< False: the list is second-hand and may have gaps.
    std::string_view otherwise;  ///< What the control does with a code that it lacks.
    std::string_view source;
};

/// Returns all controls of the table, by name.
std::span<const ControlCodes> all_control_codes();

/// Returns the row of `name`, or nullptr.
const ControlCodes* find_control_codes(std::string_view name);

enum class CodeSupport : std::uint8_t { No, Option, Yes };

/// Returns whether the control has the G code (`letter` 'G') or M code `number`.
/// Requires: `control` is a row of the table.
CodeSupport support_of(const ControlCodes& control, char letter, double number);

/// A code or a part of the language that a program uses.
struct CodeUse {
    std::string what;  ///< "G81", "variables"
    SourceSpan first;
    std::uint64_t count = 0;  ///< Blocks with it, or words.
    bool is_option = false;   ///< The control has it as an option.
};

/// Returns what `program` uses and `control` does not have, or has as an option, in the order of
/// the first use. G and M words whose number is an expression are not judged. Cost: O(length of the
/// program).
std::vector<CodeUse> lacking_codes(const SourceFile& program, const ControlCodes& control);

}  // namespace ncsim::gcode
