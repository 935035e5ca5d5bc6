// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls, for readers of comments and listings. interpret() runs the
// programs.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"
#include "ncsim/gcode/units.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ncsim::gcode {

/// True if `program` has signs of Klartext (detect_dialect).
/// Cost: a search for words, and for a program with such a word a call of detect_dialect.
bool is_klartext(const SourceFile& program);

/// Reads the comments, tool calls and positions of a Klartext program as blocks: G20 or G21 for the
/// unit of BEGIN PGM, T for a tool, X, Y and Z for a move. Headings, names of tools and BLK FORM
/// are comments. The values do not show the effect of the program; use interpret().
class KlartextNotes {
public:
    /// Requires: `program` outlives this object.
    explicit KlartextNotes(const SourceFile& program);
    ~KlartextNotes();
    KlartextNotes(const KlartextNotes&) = delete;
    KlartextNotes& operator=(const KlartextNotes&) = delete;

    /// Reads the next block into `block`, valid until the next call.
    /// Returns: false at the end of the program.
    bool next(Block& block);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A round blank: BLK FORM CYLINDER.
struct KlartextCylinder {
    int axis = 2;  ///< Axis of the cylinder: 0, 1, 2 for X, Y, Z.
    Length radius, length;
    Length top;  ///< Position of the upper end along the axis.
    SourceSpan span;
    std::string text;
};

/// Returns the first BLK FORM CYLINDER of `program` with numbers as values.
std::optional<KlartextCylinder> klartext_cylinder(const SourceFile& program);

/// A block as written, with single blanks and without comments.
struct KlartextLine {
    std::uint32_t line = 0;
    std::string text;
    bool is_readable = true;
};

/// Reads a program for a listing, and reports unreadable blocks to `log`.
class KlartextListing {
public:
    /// Requires: `program` outlives this object.
    explicit KlartextListing(const SourceFile& program);
    ~KlartextListing();
    KlartextListing(const KlartextListing&) = delete;
    KlartextListing& operator=(const KlartextListing&) = delete;

    /// Returns: false at the end of the program.
    bool next(KlartextLine& line, DiagnosticLog& log);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ncsim::gcode
