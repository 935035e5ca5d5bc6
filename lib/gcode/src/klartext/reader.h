// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits a Klartext program into blocks: numbers, verbs, words, comments, continued lines.
// Source: HEIDENHAIN TNC 640, User's Manual for Klartext Programming, 34059x.
#pragma once

#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"

#include "klartext/block.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ncsim::gcode::klartext {

/// Reads a program block by block.
/// Guarantees: any byte sequence gives blocks. Memory does not grow with the program.
class Reader {
public:
    /// Requires: `file` outlives the reader.
    explicit Reader(const SourceFile& file);

    /// Reads the next block into `block`. Reports an unreadable block to `log`, unless null.
    /// Returns: false at the end of the program.
    bool next(Block& block, DiagnosticLog* log);
    /// Same as `next`, but reads no words.
    bool next_verb(Block& block);

    /// True if the next block with code is RND or CHF.
    bool is_corner_next() const;

    /// Start of the next line; valid for `seek` on the same file.
    struct Place {
        std::size_t offset = 0;
        std::uint32_t line = 0;
        bool operator==(const Place&) const = default;
    };
    Place place() const { return place_; }
    void seek(Place place) { place_ = place; }

private:
    bool take_block(Block& block);
    std::string_view take_line();
    void continue_block(Block& block, bool is_in_comment);
    void take_parameters(Block& block);

    const SourceFile* file_;
    Place place_;
};

}  // namespace ncsim::gcode::klartext
