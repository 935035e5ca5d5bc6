// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of a program that a control with block delete executes.
#pragma once

#include "ncsim/gcode/interpretation.h"
#include "ncsim/gcode/language.h"
#include "ncsim/gcode/source.h"

#include <optional>

namespace ncsim::gcode {

/// Replaces all blocks of `file` that begin with '/' by blanks, so the other blocks keep their
/// lines and columns. Numbers and labels of blocks stay, as targets of jumps. `strict`: by the
/// rules of LinuxCNC.
/// Cost: O(length of `file`).
void remove_deleted_blocks(SourceFile& file, Language language, bool strict);

/// The text that interpret() executes.
class ExecutedText {
public:
    /// Copies `program` without deleted blocks if `options` has block delete and there are such
    /// blocks.
    /// Requires: `program` outlives this object.
    ExecutedText(const SourceFile& program, const InterpreterOptions& options);

    const SourceFile& file() const { return without_deleted_ ? *without_deleted_ : *program_; }
    /// Language by whose rules deleted blocks were found.
    Language language() const { return language_; }

private:
    const SourceFile* program_;
    Language language_ = Language::GCode;
    std::optional<SourceFile> without_deleted_;
};

}  // namespace ncsim::gcode
