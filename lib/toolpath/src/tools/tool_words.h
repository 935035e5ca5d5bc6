// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lexicon of tool descriptions in several languages; divides comments into numbers, known words and
// further words.
#pragma once

#include "ncsim/toolpath/tool.h"

#include "tools/comment_text.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath::words {

/// Meaning of a word in a comment.
enum class Role : std::uint8_t {
    Unknown,    ///< A name, a part number, or prose that is not in the lexicon.
    Noun,       ///< A tool: END MILL, DRILL, FRAISE.
    Shape,      ///< A form: BALL, FLAT, CHAMFER. Also the form of a cut.
    Attribute,  ///< No geometry: CARBIDE, LONG, UPCUT.
    Tool,       ///< TOOL, WERKZEUG; a following number is the tool number.
    // Keys: the adjacent number is the value.
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
    Other,    ///< Offset registers, speeds, depths: the number is not a size.
    Purpose,  ///< FOR: the following words describe the purpose.
    Prose     ///< Words that do not occur in tool descriptions.
};

/// A word, a number or a mark of a comment.
struct Token {
    enum class Form : std::uint8_t { Word, Number, Mark } form = Form::Mark;
    std::string text{};         ///< Upper case, in ASCII letters; several words joined by a blank.
    text::Quantity quantity{};  ///< Value of a number.
    Role role = Role::Unknown;  ///< Role of a word.
    std::optional<ToolKind> kind{};
    int rank = 0;               ///< Precedence of `kind`: the highest in a comment counts.
    bool joined_left = false;   ///< No blank before the token …
    bool joined_right = false;  ///< … or after the token.
    bool is(char mark) const { return form == Form::Mark && text.size() == 1 && text[0] == mark; }
    bool is_word() const { return form == Form::Word; }
    bool is_number() const { return form == Form::Number; }
    bool is_word(Role r) const { return is_word() && role == r; }
};

/// Converts to upper case and replaces letters with marks, in UTF-8 and Latin-1: ä AE, é E, Ø DIA,
/// × X.
std::string plain_upper(std::string_view s);

/// Returns the tokens of `plain_upper(comment)`; an expression of several words is a single token.
/// Cost: O(length).
std::vector<Token> tokens_of(std::string_view plain_upper_text);

/// Largest length of a tool description, in bytes.
constexpr std::size_t kLongest = 200;

/// Returns the kind of tool named in the first kLongest bytes of a text; further words are ignored.
std::optional<ToolKind> kind_named(std::string_view s);

/// Return diameters in inches of number drills (1 to 80), letter drills, bodies of centre drills (1
/// to 8), and screws by number (0 to 14); 0 for other arguments.
double number_drill(int number);
double letter_drill(char letter);
double centre_drill(int number);
double number_screw(int number);

/// Returns the pitch of the coarse metric thread M`diameter`, mm; 0 if there is none. Source: ISO
/// 261.
double coarse_pitch(double diameter);

}  // namespace ncsim::toolpath::words
