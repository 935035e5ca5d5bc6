// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of an NC program and positions in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A position for display; line and column count from 1, columns in bytes.
struct LineColumn {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    bool operator==(const LineColumn&) const = default;
};

/// A range within a line of a program. `line` counts from 1 (0: no position), `column` from 1;
/// `length` is in bytes.
struct SourceSpan {
    std::uint32_t line = 0;
    std::uint32_t column = 1;
    std::uint32_t length = 0;
    bool operator==(const SourceSpan&) const = default;
};

/// A program as read from a file: the name for messages, and the bytes, which may be any. Lines end
/// in LF, CRLF or CR; a UTF-8 byte order mark is not part of the first line.
struct SourceFile {
    std::string name;
    std::string text;
};

/// Returns line `line` (from 1) of `file` without the line end; empty if there is no such line.
/// Cost: O(size of `file`).
std::string_view line_text(const SourceFile& file, std::uint32_t line);
/// Returns all lines of `file` in one pass.
/// Cost: O(size of `file`).
std::vector<std::string_view> lines_of(const SourceFile& file);

}  // namespace ncsim::gcode
