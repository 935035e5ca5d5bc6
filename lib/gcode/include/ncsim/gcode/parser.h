// SPDX-License-Identifier: GPL-3.0-or-later
//
// From text to blocks, one line at a time: the grammar of RS274/NGC (Kramer, Proctor, Messina,
// "The NIST RS274NGC Interpreter, Version 3", 2000) with what other controls write besides.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/diagnostic.h"
#include "ncsim/gcode/source.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

struct ParserOptions {
    /// Report as errors what RS274/NGC does not know, even if other controls do: nested comments,
    /// checksums, expressions without brackets, console commands.
    bool strict = false;
};

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
    bool next(Block& block, DiagnosticLog& log);
    /// The same for those who want comments and words but no opinion about them.
    bool next(Block& block);

    /// Where the next line starts. Good for `seek` on the same file.
    struct Place {
        std::size_t offset = 0;
        std::uint32_t line = 0;  ///< Lines before it.
        bool operator==(const Place&) const = default;
    };
    Place place() const { return place_; }
    void seek(Place place) { place_ = place; }

private:
    friend class LineParser;

    std::string_view take_line();

    const SourceFile* file_;
    ParserOptions options_;
    Place place_;
    // The line under way, lower case and without blanks and comments, and the column each
    // byte came from. Only lines that are more than plain words need them.
    std::string clean_;
    std::vector<std::uint32_t> columns_;
};

}  // namespace ncsim::gcode
