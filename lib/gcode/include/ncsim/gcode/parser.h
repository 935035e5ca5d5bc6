// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits a program into blocks, line by line: the grammar of RS274/NGC with the extensions of other
// controls.
// Source: Kramer, Proctor, Messina, "The NIST RS274NGC Interpreter, Version 3", 2000.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/parser_options.h"
#include "ncsim/gcode/source.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// Reads a program line by line.
/// Guarantees: any byte sequence gives blocks; an unreadable line is reported and returned as
/// BlockKind::Unreadable. Memory does not grow with the program.
///
///     BlockReader reader(file);
///     Block block;
///     while (reader.next(block, log)) { … }
class BlockReader {
public:
    /// Requires: `file` outlives the reader.
    explicit BlockReader(const SourceFile& file, ParserOptions options = {});

    /// Reads the next line into `block` and reports faults to `log`.
    /// Returns: false at the end of the program.
    bool next(Block& block, DiagnosticLog& log) { return next(block, &log); }
    /// Reads the next line into `block` without reporting faults.
    bool next(Block& block) { return next(block, nullptr); }

    /// Start of the next line; valid for `seek` on the same file.
    struct Place {
        std::size_t offset = 0;
        std::uint32_t line = 0;  ///< Number of lines before the position.
        bool operator==(const Place&) const = default;
    };
    Place place() const { return place_; }
    void seek(Place place) { place_ = place; }

    /// Keeps the parsed blocks of subsequent lines that are more than plain words, up to kMostKept
    /// lines, so lines in loops are parsed once. Lines with a report are parsed and reported again.
    void keep_lines();
    static constexpr std::size_t kMostKept = 2000;

private:
    std::string_view take_line();
    bool next(Block& block, DiagnosticLog* log);

    const SourceFile* file_;
    ParserOptions options_;
    Place place_;
    // Buffer for the current line in lower case without blanks and comments, and the column of each
    // byte. Used only for lines that are more than plain words.
    std::string clean_;
    std::vector<std::uint32_t> columns_;

    struct LineCache;  // Parsed lines by start offset.
    std::shared_ptr<LineCache> kept_;
};

/// Returns the tool number of a comment that consists of a tool change: 3 for "( M6 T3 )"; -1 for
/// other comments. FreeCAD's post processor for grbl writes tool changes as comments, which the
/// operator executes.
int tool_called_in(const Comment& comment);

}  // namespace ncsim::gcode
