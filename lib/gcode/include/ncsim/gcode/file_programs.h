// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the programs of a file that holds more than one: "O0100 … M30 O0101 … M30".
#pragma once

#include "ncsim/gcode/source.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::gcode {

/// A program that a control can start: it ends with M2 or M30, and no program of the file calls it.
struct FileProgram {
    std::string label;  ///< "O0101" as written; "program 1" for a first program without a number.
    SourceSpan span;    ///< Of its O number.
};

/// Part of a file that no program of the file reaches.
struct Unreached {
    SourceSpan span;    ///< Its first move.
    std::string label;  ///< Of a subprogram: "O0200"; empty: moves after the end of a program.
    std::uint32_t end_line = 0;  ///< Of M30, M2, M99 or '%' before such moves.
};

class FilePrograms {
public:
    /// Reads the O numbers, ends and calls of `file`. A file with one program and nothing behind
    /// its end costs one look at its lines. `block_delete`: blocks with '/' are skipped.
    FilePrograms(const SourceFile& file, bool block_delete);

    /// In the order of the file; at least one.
    const std::vector<FileProgram>& programs() const { return programs_; }
    const std::vector<Unreached>& unreached() const { return unreached_; }

    /// Returns `text`, the text of the file, with empty lines instead of all other programs, so
    /// that lines keep their numbers. What the program calls stays.
    std::string text_of(std::size_t program, std::string text) const;

private:
    friend class FileReaderPass;
    struct Section {
        std::string number;  ///< "101"; empty: before the first O number.
        std::string label;   ///< "O0101"
        SourceSpan span;
        std::size_t begin = 0, end = 0;  ///< Bytes.
        bool ends = false, returns = false, has_words = false;
        bool runs_on = true;  ///< Into the section behind it.
        std::optional<SourceSpan> first_move;
        std::vector<std::string> calls;
        std::size_t program = kNone;  ///< Of which it is a part.
    };
    static constexpr std::size_t kNone = ~std::size_t{0};

    void divide(bool calls_anything);

    std::vector<Section> sections_;
    std::vector<FileProgram> programs_;
    std::vector<Unreached> unreached_;
};

}  // namespace ncsim::gcode
