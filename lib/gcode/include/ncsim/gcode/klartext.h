// SPDX-License-Identifier: GPL-3.0-or-later
//
// Klartext of Heidenhain controls, for readers of comments and listings. interpret() runs the
// programs.
#pragma once

#include "ncsim/gcode/language.h"

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
class KlartextNotes final : public ProgramNotes {
public:
    /// Requires: `program` outlives this object.
    explicit KlartextNotes(const SourceFile& program);
    ~KlartextNotes() override;
    KlartextNotes(const KlartextNotes&) = delete;
    KlartextNotes& operator=(const KlartextNotes&) = delete;

    /// Reads the next block into `block`, valid until the next call.
    /// Returns: false at the end of the program.
    bool next(Block& block) override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Returns the first BLK FORM CYLINDER of `program` with numbers as values.
std::optional<RoundBlank> klartext_cylinder(const SourceFile& program);

/// Reads a program for a listing, and reports unreadable blocks to `log`.
class KlartextListing final : public ProgramListing {
public:
    /// Requires: `program` outlives this object.
    explicit KlartextListing(const SourceFile& program);
    ~KlartextListing() override;
    KlartextListing(const KlartextListing&) = delete;
    KlartextListing& operator=(const KlartextListing&) = delete;

    /// Returns: false at the end of the program.
    bool next(ListedBlock& block, DiagnosticLog& log) override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ncsim::gcode
