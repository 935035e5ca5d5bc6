// SPDX-License-Identifier: GPL-3.0-or-later
//
// The language of SINUMERIK controls, for readers of comments and listings. interpret() runs the
// programs.
#pragma once

#include "ncsim/gcode/language.h"

#include <memory>
#include <optional>

namespace ncsim::gcode {

/// True if the beginning of `program`, or its name, has signs of SINUMERIK (detect_dialect).
bool is_sinumerik(const SourceFile& program);

/// Reads the notes of a SINUMERIK program. WORKPIECE is a comment that describes the stock.
class SinumerikNotes final : public ProgramNotes {
public:
    /// Requires: `program` outlives this object.
    explicit SinumerikNotes(const SourceFile& program);
    ~SinumerikNotes() override;
    SinumerikNotes(const SinumerikNotes&) = delete;
    SinumerikNotes& operator=(const SinumerikNotes&) = delete;

    bool next(Block& block) override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Returns the first WORKPIECE(…, "CYLINDER", …) of `program` with numbers as values.
std::optional<RoundBlank> sinumerik_cylinder(const SourceFile& program);

/// Reads a SINUMERIK program for a listing.
class SinumerikListing final : public ProgramListing {
public:
    /// Requires: `program` outlives this object.
    explicit SinumerikListing(const SourceFile& program);
    ~SinumerikListing() override;
    SinumerikListing(const SinumerikListing&) = delete;
    SinumerikListing& operator=(const SinumerikListing&) = delete;

    bool next(ListedBlock& block, DiagnosticLog& log) override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ncsim::gcode
