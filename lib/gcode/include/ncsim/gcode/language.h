// SPDX-License-Identifier: GPL-3.0-or-later
//
// Languages of programs, for readers of comments and listings. interpret() runs the programs.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/gcode/units.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode {

/// Language of a program.
enum class Language : std::uint8_t { GCode, Klartext, Sinumerik };

/// Returns the language of `program`, from signs in the text (detect_dialect).
/// Cost: a search for words, and for a program with such a word a call of detect_dialect.
Language language_of(const SourceFile& program);

/// Returns the name of `language` in listings: "klartext", "sinumerik".
std::string_view name_of(Language language);

/// Reads the comments, tools and positions of a program in a language other than G-code as blocks:
/// G20 or G21 for the unit, T for a tool, X, Y and Z for a move. Headings, names of tools and the
/// description of the stock are comments. The values do not show the effect of the program; use
/// interpret().
class ProgramNotes {
public:
    virtual ~ProgramNotes() = default;
    /// Reads the next block into `block`, valid until the next call.
    /// Returns: false at the end of the program.
    virtual bool next(Block& block) = 0;
};

/// Returns the reader of the notes of `program`; null for a program in G-code.
/// Requires: `program` outlives the reader.
std::unique_ptr<ProgramNotes> notes_of(const SourceFile& program);

/// A round blank that a program describes.
struct RoundBlank {
    int axis = 2;  ///< Axis of the cylinder: 0, 1, 2 for X, Y, Z.
    Length radius, length;
    Length top;  ///< Position of the upper end along the axis.
    SourceSpan span;
    std::string text;
};

/// Returns the first round blank with numbers as values that `program` describes.
std::optional<RoundBlank> round_blank_of(const SourceFile& program);

/// A block as written, with single blanks and without comments.
struct ListedBlock {
    std::uint32_t line = 0;
    std::string text;
    bool is_readable = true;
};

/// Reads a program for a listing, and reports unreadable blocks to a log.
class ProgramListing {
public:
    virtual ~ProgramListing() = default;
    /// Returns: false at the end of the program.
    virtual bool next(ListedBlock& block, DiagnosticLog& log) = 0;
};

/// Returns the listing of `program`; null for a program in G-code.
/// Requires: `program` outlives the listing.
std::unique_ptr<ProgramListing> listing_of(const SourceFile& program);

}  // namespace ncsim::gcode
