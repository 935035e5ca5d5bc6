// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of an NC program and places in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode {

/// A place for people: both count from 1; a column counts bytes.
struct LineColumn {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    bool operator==(const LineColumn&) const = default;
};

/// A stretch of one line of a program. `line` counts from 1 (0: no place), `column` from 1;
/// `length` is in bytes.
struct SourceSpan {
    std::uint32_t line = 0;
    std::uint32_t column = 1;
    std::uint32_t length = 0;
    bool operator==(const SourceSpan&) const = default;
};

/// A program as it was read: its name for messages, and its bytes, whatever they are.
/// Lines end in LF, CRLF or CR; a UTF-8 byte order mark is not part of the first line.
struct SourceFile {
    std::string name;
    std::string text;
};

/// Line `line` (from 1) of `file` without its line end; empty if there is no such line.
/// O(size of file).
std::string_view line_text(const SourceFile& file, std::uint32_t line);
/// All of them, from line 1, in one pass: line_text() reads from the beginning each time.
std::vector<std::string_view> lines_of(const SourceFile& file);

}  // namespace ncsim::gcode
