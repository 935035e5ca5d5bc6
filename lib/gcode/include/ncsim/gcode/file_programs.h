// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the programs in a file that contains several: "O0100 … M30 O0101 … M30".
#pragma once

#include "ncsim/gcode/source.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ncsim::gcode {

/// A program that a control can start: a section that ends with M2 or M30 and that no program in
/// the file calls.
struct FileProgram {
    std::string label;  ///< "O0101" as written; "program 1" for a first program without a number.
    SourceSpan span;    ///< Span of the O number.
};

/// Part of a file that no program in the file reaches.
struct Unreached {
    SourceSpan span;  ///< First move of the part.
    /// Label of a subprogram: "O0200". Empty: moves after the end of a program.
    std::string label;
    std::uint32_t end_line = 0;  ///< Line of the M30, M2, M99 or '%' that precedes the moves.
};

/// The programs of a file, and the parts that no program reaches.
class FilePrograms {
public:
    /// Reads the O numbers, ends and calls of `file`.
    /// Cost: O(length of the file); a file with a single program and only comments after the end
    /// costs one search.
    explicit FilePrograms(const SourceFile& file);

    /// Returns the programs in the order of the file; at least one.
    const std::vector<FileProgram>& programs() const { return programs_; }
    const std::vector<Unreached>& unreached() const { return unreached_; }

    /// Returns `text`, the text of the file, with empty lines in place of all programs except
    /// `program`, so line numbers stay the same. Subprograms that the program calls are kept.
    std::string text_of(std::size_t program, std::string text) const;

private:
    friend class FileReaderPass;
    struct Section {
        std::string number;  ///< "101"; empty before the first O number.
        std::string label;   ///< "O0101"
        SourceSpan span;
        std::size_t begin = 0, end = 0;  ///< Bytes.
        bool ends = false, returns = false, has_words = false;
        bool runs_on = true;  ///< Execution continues in the next section.
        std::optional<SourceSpan> first_move;
        std::vector<std::string> calls;
        std::size_t program = kNone;  ///< Index of the program that contains the section.
    };
    static constexpr std::size_t kNone = ~std::size_t{0};

    void divide(bool calls_anything);

    std::vector<Section> sections_;
    std::vector<FileProgram> programs_;
    std::vector<Unreached> unreached_;
};

}  // namespace ncsim::gcode
