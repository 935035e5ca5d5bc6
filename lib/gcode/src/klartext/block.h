// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block of a Klartext program as written: the verb, the words of path verbs, the text of the
// other verbs, and comments. Q parameters are not evaluated.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::klartext {

/// Beginning of a block.
enum class Verb : std::uint8_t {
    Empty,  ///< A block without code: a comment, a heading, a number.
    BeginPgm,
    EndPgm,
    BlkForm,
    ToolCall,
    ToolDef,
    CyclDef,
    CyclCall,
    CyclEnd,
    PatternDef,
    Lbl,
    CallLbl,
    CallPgm,
    Fn,
    Assignment,  ///< "Q1 = …", "QS1 = …".
    If,          ///< "IF +Q1 EQU +2 GOTO LBL 1": FN 9 … FN 12 without the number.
    Plane,
    Function,
    Stop,
    Error,     ///< "ERROR = …": a block that the control rejected at input.
    Straight,  ///< L, and blocks that begin with an axis, M, S or F.
    StraightPolar,
    Centre,
    Arc,
    ArcPolar,
    ArcByRadius,
    ArcTangent,
    ArcTangentPolar,
    Approach,  ///< APPR LT, LN, CT, LCT and their polar forms.
    Depart,    ///< DEP LT, LN, CT, LCT.
    Rounding,
    Chamfer,
    Other,       ///< A verb that is known and not read; `name` of the block.
    Unreadable,  ///< A text that is no block.
};

/// Name of a word of a path block.
enum class Address : std::uint8_t {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,
    PR,
    PA,
    Radius,   ///< R with a value
    R0,       ///< Path without cutter compensation.
    RL,       ///< Tool left of the path.
    RR,       ///< Tool right of the path.
    F,        ///< Feed
    FMax,     ///< Rapid, this block only.
    FAuto,    ///< Feed of TOOL CALL.
    FU,       ///< Feed per revolution.
    FZ,       ///< Feed per tooth.
    S,        ///< Spindle speed
    M,        ///< M code
    DrPlus,   ///< Counter-clockwise
    DrMinus,  ///< Clockwise
    MB,       ///< Distance of M140.
    MBMax,
    LA,   ///< Number of blocks of M120.
    Len,  ///< Length of APPR, DEP.
    Cca,  ///< Centre angle of APPR, DEP.
};

/// A number, or a Q parameter with a sign.
struct Value {
    enum class Kind : std::uint8_t { None, Number, Parameter };
    Kind kind = Kind::None;
    char set = 'Q';  ///< 'Q', 'L' (QL) or 'R' (QR).
    std::uint32_t index = 0;
    double number = 0.0;  ///< The number; the sign of a parameter, 1 or -1.
};

/// A word of a path block.
struct Word {
    Address address = Address::X;
    bool is_incremental = false;
    Value value;
    SourceSpan span;
};

/// Part of the code that is contiguous in the file. A block with "~" has several parts.
struct Part {
    std::size_t offset = 0;
    std::uint32_t line = 0, column = 1;
};

/// A block. The views are valid until the next block is read.
struct Block {
    Verb verb = Verb::Empty;
    std::uint32_t line = 0;     ///< Line of the file where the block begins, from 1.
    bool block_delete = false;  ///< The block begins with '/'.
    std::string_view name;      ///< Verb::Other: the verb, as in "TCH PROBE".
    std::string_view code;      ///< The block without comments and number.
    std::size_t rest = 0;       ///< Offset in `code` of the text after the verb.
    std::vector<Part> parts;
    std::vector<Word> words;  ///< Words of path verbs.
    std::vector<Comment> comments;
    std::string joined;  ///< Storage of `code` if the block has several lines.

    /// Returns the position in the file of `length` bytes of `code` from `offset` on.
    SourceSpan span(std::size_t offset, std::size_t length) const {
        std::size_t part = 0;
        while (part + 1 < parts.size() && parts[part + 1].offset <= offset)
            ++part;
        const Part& p = parts[part];
        return {p.line, p.column + static_cast<std::uint32_t>(offset - p.offset),
                static_cast<std::uint32_t>(length)};
    }
    /// Returns the position of the first line of the code.
    SourceSpan whole() const {
        const std::size_t end = parts.size() > 1 ? parts[1].offset : code.size();
        return span(0, end);
    }
};

}  // namespace ncsim::gcode::klartext
