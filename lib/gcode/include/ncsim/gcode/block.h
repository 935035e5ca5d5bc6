// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is written in one line of an NC program, and nothing that was concluded from it:
// letters, numbers, comments and their places. What G91 does to an X is not known here.
#pragma once

#include "ncsim/gcode/source.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A letter and its value: X12.5, G2, M6, X[#1 * 2]. Letters are upper case; '@' and '^' are
/// the polar words of RS274/NGC.
struct Word {
    char letter = 0;
    bool comma = false;     ///< Written with a comma before it: ",R2" (corner rounding).
    bool literal = true;    ///< `number` is the value; else `text` has to be evaluated.
    double number = 0.0;    ///< In the units of the moment; valid if `literal`.
    SourceSpan span;        ///< Letter and value.
    std::string_view text;  ///< If not `literal`: the expression, lower case, without blanks.
};

/// A remark of the programmer, "( … )" or "; …". `text` is what stands between, as written.
struct Comment {
    std::string_view text;
    SourceSpan span;         ///< With its parentheses or semicolon.
    bool semicolon = false;  ///< "; …", to the end of the line.
};

/// "#1 = 2", "#<depth> = [#3 - 1]". Texts are lower case and without blanks.
struct Assignment {
    std::string_view target;  ///< What follows the '#': "1", "<depth>", "[#3+1]", "#2".
    std::string_view value;
    SourceSpan span;
};

/// What steers the course of a program, in both languages that are used for it.
enum class ControlWord : std::uint8_t {
    None,
    ProgramNumber,  ///< "O1234", ":1234": a Fanuc program or subprogram starts here.
    Sub,
    EndSub,
    Call,
    Return,  // RS274/NGC O-words
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
    End,  // Fanuc Macro B
};

/// The control word of a block. Texts are lower case and without blanks.
struct Control {
    ControlWord word = ControlWord::None;
    /// O-words: "100", "<name>", "[#1]". WHILE and END: the digits of DO n. IF, GOTO: the
    /// line to go to; empty for IF … THEN.
    std::string_view label;
    /// The condition, or the arguments of a call: "[1][2]". Empty if there is none.
    std::string_view expression;
    SourceSpan span;
    SourceSpan rest;  ///< What is behind it, where the language does not read it; length 0: none.
};

enum class BlockKind : std::uint8_t {
    Words,    ///< Words, assignments, a control word, or nothing but comments.
    Percent,  ///< A line that starts with '%'.
    Command,  ///< A line for the sender or the control's console: "$H", "?", "<NAME>", "DPRNT[…]".
    Unreadable,  ///< Reported; nothing in it may be executed.
};

/// One line. Views point into the program text (comments) or into the reader, and are good until
/// the next block is read.
struct Block {
    BlockKind kind = BlockKind::Words;
    std::uint32_t line = 0;     ///< From 1.
    bool block_delete = false;  ///< Starts with '/'.
    bool has_number = false;    ///< Starts with N…
    std::uint32_t number = 0;   ///< The value of N, cut to whole numbers.
    Control control;
    std::vector<Word> words;  ///< Without N and O, in the order of writing.
    std::vector<Assignment> assignments;
    std::vector<Comment> comments;
    std::string_view text;  ///< The whole line without its line end.

    SourceSpan line_span() const { return {line, 1, static_cast<std::uint32_t>(text.size())}; }
};

/// The first word of `block` with this letter (upper case), or nullptr.
inline const Word* find_word(const Block& block, char letter) {
    for (const Word& word : block.words) {
        if (word.letter == letter && !word.comma) return &word;
    }
    return nullptr;
}

}  // namespace ncsim::gcode
