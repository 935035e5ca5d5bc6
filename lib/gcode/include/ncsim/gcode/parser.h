// SPDX-License-Identifier: GPL-3.0-or-later
//
// From text to blocks, one line at a time: the grammar of RS274/NGC (Kramer, Proctor, Messina,
// "The NIST RS274NGC Interpreter, Version 3", 2000) with what other controls write besides.
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

/// Reads a program line by line. Total: any byte sequence gives blocks; a line that cannot be
/// read is reported and comes as BlockKind::Unreadable. Memory does not grow with the program.
///
///     BlockReader reader(file);
///     Block block;
///     while (reader.next(block, log)) { … }
class BlockReader {
public:
    /// `file` must outlive the reader.
    explicit BlockReader(const SourceFile& file, ParserOptions options = {});

    /// Reads the next line into `block`; false at the end of the program.
    bool next(Block& block, DiagnosticLog& log) { return next(block, &log); }
    /// The same for those who want comments and words but no opinion about them.
    bool next(Block& block) { return next(block, nullptr); }

    /// Where the next line starts. Good for `seek` on the same file.
    struct Place {
        std::size_t offset = 0;
        std::uint32_t line = 0;  ///< Lines before it.
        bool operator==(const Place&) const = default;
    };
    Place place() const { return place_; }
    void seek(Place place) { place_ = place; }

    /// From here on keeps what it reads of lines that are more than plain words, up to kMostKept
    /// lines, so that those of a loop are read once. Lines of which something was said are read
    /// anew, and it is said again.
    void keep_lines();
    static constexpr std::size_t kMostKept = 2000;

private:
    std::string_view take_line();
    bool next(Block& block, DiagnosticLog* log);

    const SourceFile* file_;
    ParserOptions options_;
    Place place_;
    // The line under way, lower case and without blanks and comments, and the column each
    // byte came from. Only lines that are more than plain words need them.
    std::string clean_;
    std::vector<std::uint32_t> columns_;

    struct Kept;  // lines, by where they begin
    std::shared_ptr<Kept> kept_;
};

/// Reads the tool change that a comment holds and nothing else: the 3 of "( M6 T3 )". -1: none.
/// FreeCAD's post for grbl writes tool changes so, and an operator makes them.
int tool_called_in(const Comment& comment);

}  // namespace ncsim::gcode
