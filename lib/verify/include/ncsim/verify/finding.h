// SPDX-License-Identifier: GPL-3.0-or-later
//
// What verification says about a program: findings, each with a rule, a place, a quantity and
// what it rests on.
//
//     motions ──► Verifier ──► Move (measured) ──► rules ──► FindingLog ──► Verdict
//                    │                                            ▲
//                    └──► part (cut on the way)      Setup (tools, machine, selection)
//
// A rule judges, it does not measure: the Verifier does, once for all rules, and only what a
// selected rule asks for.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

using gcode::Severity;

enum class Category : std::uint8_t { Program, Collision, Travel, Process, SetUp };

/// "program", "collision", "travel", "process", "set-up".
std::string_view name_of(Category category);
/// "note", "warning", "error".
std::string_view name_of(Severity severity);

/// What round tools allow to say about a contact: their polytopes contain the tool or are
/// contained in it. Certain: the inscribed polytope meets the material, and the material is never
/// less than what is modelled. Within: only the circumscribed one does, so that the tool may be
/// off by no more than its stated error.
enum class Certainty : std::uint8_t { Certain, Within };

/// A stretch of a file, for people.
struct Place {
    std::uint32_t file = 0;  ///< Index into Verdict::files; 0: the program.
    gcode::SourceSpan span;
    bool operator==(const Place&) const = default;
};

/// A measured number. `unit` is "mm", "mm3", "mm/min", "rpm", "mm3/min", "mm3/mm" or "" (a count).
struct Quantity {
    std::string name;  ///< What was measured: "removed".
    double value = 0.0;
    std::string unit;
    bool operator==(const Quantity&) const = default;
};

/// "removed 12.5 mm3", six significant digits.
std::string text_of(const Quantity& quantity);
/// Of distances that ought to be kept: "apart".
bool less_is_worse(const Quantity& quantity);

/// One fault, or a row of the same fault in successive motions.
struct Finding {
    std::string rule;
    std::string code;  ///< Of the diagnostic it comes from; empty for the other rules.
    Severity severity = Severity::Error;
    Category category = Category::Program;
    Certainty certainty = Certainty::Certain;
    Place place;                     ///< The first block.
    Place last;                      ///< The last one; equal to `place` for a single block.
    std::uint64_t first_motion = 0;  ///< Motions count from 1 in the order of execution; 0: none.
    std::uint64_t last_motion = 0;
    std::uint64_t count = 1;  ///< Motions (or repetitions of a diagnostic) in it.
    bool goes_on = false;     ///< Nobody looked how many more there are.
    /// Of a row of motions: places and quantities of all of them, to a thousandth of a millimetre
    /// and six digits, as a number that is another one where any of them is. 0: it is no such row.
    std::uint64_t row = 0;
    int tool = 0;
    std::optional<Quantity> quantity;      ///< Summed or the largest over the row, by its nature.
    std::optional<cda::Vec3> point;        ///< In W, mm: of the first motion.
    cda::Box box;                          ///< In W, mm: encloses where it happens; may be empty.
    std::string message;                   ///< Lower case, no full stop, without the quantity.
    std::string hint;                      ///< How to mend it.
    std::vector<std::string> assumptions;  ///< What was not told and the verdict rests on.
    bool suppressed = false;  ///< By a comment in the program; told, but does not count.
    bool demoted = false;     ///< The user lowered the severity of its rule.
    /// Somebody looked at it before and accepted it, outside of the program: why, if that was told.
    /// Does not count either, but a program with accepted errors is not clean.
    std::optional<std::string> accepted;

    bool counts() const { return !suppressed && !accepted; }
    bool operator==(const Finding&) const = default;
};

/// A rule that could not be asked, and why: never the same as "nothing found".
struct Skipped {
    std::string rule;
    std::string reason;
    bool deselected = false;  ///< By the user; `reason` says how.
    bool operator==(const Skipped&) const = default;
};

}  // namespace ncsim::verify
