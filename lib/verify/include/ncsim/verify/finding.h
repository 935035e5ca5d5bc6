// SPDX-License-Identifier: GPL-3.0-or-later
//
// Result of verification: findings, each with a rule, a place, a quantity and assumptions.
//
//     motions ──► Verifier ──► Move (measured) ──► rules ──► FindingLog ──► Verdict
//                    │                                            ▲
//                    └──► part (cut on the way)      Setup (tools, machine, selection)
//
// A rule judges and does not measure. The Verifier measures once for all rules, and only quantities
// that a selected rule needs.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/machine/chain.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::verify {

using gcode::Severity;

/// Category of a rule.
enum class Category : std::uint8_t { Program, Collision, Travel, Process, SetUp };

/// Returns "program", "collision", "travel", "process" or "set-up".
std::string_view name_of(Category category);
/// Returns "note", "warning" or "error".
std::string_view name_of(Severity severity);

/// Certainty of a contact of a round tool, whose circumscribed polytope contains the tool and whose
/// inscribed polytope is contained in the tool. Certain: the inscribed polytope meets the material,
/// and the true material is never less than the model. Within: only the circumscribed polytope
/// meets the material, so the true tool may miss the material by at most the stated error.
enum class Certainty : std::uint8_t { Certain, Within };

/// Stretch of a file, for display.
struct Place {
    std::uint32_t file = 0;  ///< Index into Verdict::files; 0: the program.
    gcode::SourceSpan span;
    bool operator==(const Place&) const = default;
};

/// Measured number. `unit` is "mm", "mm3", "mm/min", "rpm", "mm3/min", "mm3/mm" or "" (a count).
struct Quantity {
    std::string name;  ///< Measured property: "removed".
    double value = 0.0;
    std::string unit;
    bool operator==(const Quantity&) const = default;
};

/// Formats `quantity` with six significant digits: "removed 12.5 mm3".
std::string text_of(const Quantity& quantity);
/// True if smaller values are worse, as for the distance "apart".
bool less_is_worse(const Quantity& quantity);

/// A fault, or a row of the same fault in successive motions.
struct Finding {
    std::string rule;
    std::string code;  ///< Code of the diagnostic; empty for findings of rules.
    Severity severity = Severity::Error;
    Category category = Category::Program;
    Certainty certainty = Certainty::Certain;
    Place place;  ///< First block.
    Place last;   ///< Last block; equal to `place` for a single block.
    /// Number of the motion, from 1 in the order of execution; 0: none.
    std::uint64_t first_motion = 0;
    std::uint64_t last_motion = 0;
    std::uint64_t count = 1;  ///< Number of motions, or of repetitions of a diagnostic.
    bool goes_on = false;     ///< There may be more motions; further ones are not searched.
    /// Hash of the places and quantities of all motions of a row, rounded to 0.001 mm and six
    /// digits. A change of any place or quantity changes the hash. 0: a single motion.
    std::uint64_t row = 0;
    int tool = 0;
    /// Sum or maximum over the row, as the quantity requires.
    std::optional<Quantity> quantity;
    std::optional<Vec3> point;  ///< Point of the first motion; mm, W.
    Box box;                    ///< Box that encloses all contacts; mm, W; may be empty.
    Box first_box;              ///< The same for the first motion.
    /// Bodies that meet, other than the tool and the part: "the fixture 'jaw'", "the link 'head'".
    std::vector<std::string> bodies;
    /// Positions of the joints at the first contact of links, machine coordinates.
    std::optional<machine::Values> joints;
    std::string message;                   ///< Lower case, no full stop, without the quantity.
    std::string hint;                      ///< Remedy.
    std::vector<std::string> assumptions;  ///< Assumptions on which the finding rests.
    /// Suppressed by a comment in the program; reported, but does not count.
    bool suppressed = false;
    bool demoted = false;  ///< The user lowered the severity of the rule.
    /// Reason for which the user accepted the finding outside the program; may be an empty text.
    /// Accepted findings do not count, but a program with accepted errors is not clean.
    std::optional<std::string> accepted;

    bool counts() const { return !suppressed && !accepted; }
    bool operator==(const Finding&) const = default;
};

/// Returns the point of a finding, or the centre of its first contacts; mm, W. Empty: no place.
std::optional<Vec3> point_of(const Finding& finding);

/// Rule that could not be checked, with the reason. Differs from a rule without findings.
struct Skipped {
    std::string rule;
    std::string reason;
    bool deselected = false;  ///< Deselected by the user; `reason` says how.
    bool operator==(const Skipped&) const = default;
};

}  // namespace ncsim::verify
