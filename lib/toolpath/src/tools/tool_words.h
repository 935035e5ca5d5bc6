// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of the trade: what is said of tools in comments, in the languages of those who write
// them, cut into numbers, known words and the rest.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "tools/text.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath::words {

/// What a word says about a tool, or about what else the comment is.
enum class Role : std::uint8_t {
    Unknown,    ///< A name, a part number, or prose that this table does not have.
    Noun,       ///< A tool: END MILL, DRILL, FRAISE.
    Shape,      ///< Of which form: BALL, FLAT, CHAMFER. Also of what a tool cuts.
    Attribute,  ///< Says nothing of the geometry: CARBIDE, LONG, UPCUT.
    Tool,       ///< TOOL, WERKZEUG; a number behind it is the tool's.
    // Keys: the number beside them is what they say.
    Diameter,
    CornerRadius,
    ToolRadius,
    Tip,
    Angle,
    FluteLength,
    Shank,
    StickOut,
    Flutes,
    Gauge,    ///< NO. 7, LETTER F
    Other,    ///< Offset registers, speeds, depths: the number is no size.
    Purpose,  ///< FOR: what follows is something else than this tool.
    Prose     ///< Words that descriptions of tools do not have.
};

struct Token {
    enum class Form : std::uint8_t { Word, Number, Mark } form = Form::Mark;
    std::string text{};         ///< Upper case, in ASCII letters; several words joined by a blank.
    text::Quantity quantity{};  ///< Of a number.
    Role role = Role::Unknown;  ///< Of a word.
    std::optional<ToolKind> kind{};
    int rank = 0;              ///< Of `kind`: the highest in a comment counts.
    bool glued_left = false;   ///< No blank before it …
    bool glued_right = false;  ///< … or behind it.
    bool is(char mark) const { return form == Form::Mark && text.size() == 1 && text[0] == mark; }
    bool is_word() const { return form == Form::Word; }
    bool is_number() const { return form == Form::Number; }
    bool is_word(Role r) const { return is_word() && role == r; }
};

/// Letters with marks become plain ones, in UTF-8 and Latin-1: ä AE, é E, Ø DIA, × X.
std::string plain_upper(std::string_view s);

/// The tokens of `plain_upper(comment)`; words of several words are one token. O(length).
std::vector<Token> tokens_of(std::string_view plain_upper_text);

/// No description of a tool is longer, in bytes.
constexpr std::size_t kLongest = 200;

/// The kind of tool that the first kLongest bytes of a text name, whatever else they say.
std::optional<ToolKind> kind_named(std::string_view s);

/// Diameters in inches of number drills (1 to 80), letter drills, and the bodies of centre drills
/// (1 to 8), and of screws by number (0 to 14): 0 where there is none.
double number_drill(int number);
double letter_drill(char letter);
double centre_drill(int number);
double number_screw(int number);

/// Pitch of the coarse metric thread M`diameter`, mm; 0 where there is none. Source: ISO 261.
double coarse_pitch(double diameter);

}  // namespace ncsim::toolpath::words
