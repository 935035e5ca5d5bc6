// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of an NC program as written: letters, numbers, comments and positions in the text. Blocks
// carry no modal state; for example, the effect of G91 on an X word is not known here.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A letter and a value: X12.5, G2, M6, X[#1 * 2]. Letters are upper case; '@' and '^' are the
/// polar words of RS274/NGC.
struct Word {
    char letter = 0;
    bool comma = false;     ///< A comma precedes the letter: ",R2" (corner rounding).
    bool literal = true;    ///< True if `number` is the value; false if `text` is to be evaluated.
    double number = 0.0;    ///< Value in the active units of the program; valid if `literal`.
    SourceSpan span;        ///< Letter and value.
    std::string_view text;  ///< The expression, lower case, without blanks; valid unless `literal`.
};

/// A comment in the program, "( … )" or "; …". `text` excludes the delimiters.
struct Comment {
    std::string_view text;
    SourceSpan span;         ///< Includes the parentheses or the semicolon.
    bool semicolon = false;  ///< "; …", to the end of the line.
};

/// An assignment: "#1 = 2", "#<depth> = [#3 - 1]". Texts are lower case, without blanks.
struct Assignment {
    std::string_view target;  ///< Text after the '#': "1", "<depth>", "[#3+1]", "#2".
    std::string_view value;
    SourceSpan span;
};

/// Control words of RS274/NGC and of Fanuc Macro B: subprograms, branches, loops and jumps.
enum class ControlWord : std::uint8_t {
    None,
    ProgramNumber,  ///< "O1234", ":1234", "<NAME>": start of a Fanuc program or subprogram.
    Sub,
    EndSub,
    Call,
    Return,  // Last of the O-words of RS274/NGC.
    OIf,
    OElseIf,
    OElse,
    OEndIf,
    OWhile,
    OEndWhile,
    ODo,
    ORepeat,
    OEndRepeat,
    OBreak,
    OContinue,
    If,
    Goto,
    While,
    End,  // Last of the words of Fanuc Macro B.
};

/// The control word of a block. Texts are lower case, without blanks.
struct Control {
    ControlWord word = ControlWord::None;
    /// O-words: "100", "<name>", "[#1]". WHILE and END: the digits of DO n. IF, GOTO: number of the
    /// target line; empty for IF … THEN.
    std::string_view label;
    /// Condition, or arguments of a call, as in "[1][2]"; empty if absent.
    std::string_view expression;
    SourceSpan span;
    SourceSpan rest;  ///< Text after the control word that the language ignores; length 0: none.
};

/// Kind of a line.
enum class BlockKind : std::uint8_t {
    Words,    ///< Words, assignments, a control word, or only comments.
    Percent,  ///< A line that starts with '%'.
    /// A line for the sender or the console of the control: "$H", "?", "DPRNT[…]".
    Command,
    Unreadable,  ///< Reported as an error; must not be executed.
};

/// One line of a program. The views point into the program text (comments) or into the reader, and
/// are valid until the next block is read.
struct Block {
    BlockKind kind = BlockKind::Words;
    std::uint32_t line = 0;     ///< Counted from 1.
    bool block_delete = false;  ///< The line starts with '/'.
    /// Part that block delete removes: from the first '/' to the end of the line; length 0: none.
    SourceSpan deletable;
    bool has_number = false;   ///< The line starts with N.
    std::uint32_t number = 0;  ///< Value of N, truncated to a whole number.
    Control control;
    std::vector<Word> words;  ///< Words except N and O, in the order of the text.
    std::vector<Assignment> assignments;
    std::vector<Comment> comments;
    std::string_view program_name;  ///< NAME of "M98 <NAME>", "G65 <NAME>"; empty: none.
    std::string_view text;          ///< The whole line without the line end.

    SourceSpan line_span() const { return {line, 1, static_cast<std::uint32_t>(text.size())}; }
};

/// Returns the first word of `block` with the upper-case letter `letter` and without a comma, or
/// nullptr.
inline const Word* find_word(const Block& block, char letter) {
    for (const Word& word : block.words) {
        if (word.letter == letter && !word.comma) return &word;
    }
    return nullptr;
}

}  // namespace ncsim::gcode
