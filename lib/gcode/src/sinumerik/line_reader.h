// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits a SINUMERIK program into blocks: numbers, labels, comments; and a file into programs.
// Source: SINUMERIK 840D sl, Programming Manual Fundamentals, 06/2019.
#pragma once

#include "ncsim/gcode/block.h"
#include "ncsim/gcode/source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::gcode::sinumerik {

/// A block as written. The views are valid as long as the file.
struct Line {
    std::uint32_t line = 0;     ///< Line of the file, from 1.
    std::size_t offset = 0;     ///< Start of the line in the file.
    std::uint32_t column = 1;   ///< Column of `code`.
    bool block_delete = false;  ///< The block begins with '/'.
    bool is_head = false;       ///< The line begins with '%': the head of a program.
    std::string_view number;    ///< "N10" or ":10".
    std::string_view label;     ///< The name before a colon.
    std::string_view code;      ///< The block without number, label and comment.
    std::vector<Comment> comments;

    /// Returns the position in the file of `length` bytes of `code` from `at` on.
    SourceSpan span(std::size_t at, std::size_t length) const {
        return {line, column + static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(length)};
    }
    SourceSpan whole() const { return span(0, code.size()); }
};

/// Start of a line; valid for `Reader::seek` on the same file.
struct Place {
    std::size_t offset = 0;
    std::uint32_t line = 0;  ///< Number of lines before the place.
    bool operator==(const Place&) const = default;
};

/// Reads a program line by line.
/// Guarantees: any byte sequence gives lines. Memory does not grow with the program.
class Reader {
public:
    /// Reads `file` from `begin` up to the offset `end`.
    /// Requires: `file` outlives the reader.
    explicit Reader(const SourceFile& file, Place begin = {},
                    std::size_t end = std::string_view::npos);

    /// Returns: false at the end of the program.
    bool next(Line& line);
    Place place() const { return place_; }
    void seek(Place place) { place_ = place; }

private:
    std::string_view text_;
    Place place_;
};

/// A program of a file: an archive has several.
struct Section {
    std::string name;     ///< "PART", in upper case; empty: the file has no head.
    bool is_main = true;  ///< "_MPF", or no head.
    Place begin;
    std::size_t end = 0;
};

/// Returns the programs of `file`, in order; at least one.
std::vector<Section> sections_of(const SourceFile& file);

/// Returns the name at the start of `text`: letters, digits, '_', beginning with a letter, '_' or
/// '$'; empty if there is none.
std::string_view name_at(std::string_view text);

}  // namespace ncsim::gcode::sinumerik
