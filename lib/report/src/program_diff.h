// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two program texts side by side as HTML, with links between lines and regions of the part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::report {

/// Lines of one program that made a region.
struct LineMark {
    std::uint32_t first = 0, last = 0;  ///< From 1.
    std::size_t region = 0;             ///< From 1.
};

/// Program, with marked lines, and lines that must not be folded.
struct MarkedProgram {
    std::string source;
    std::vector<LineMark> marks;
    std::vector<std::uint32_t> open_lines;
};

/// HTML of two programs. Line i of the old program has the id PREFIXo-i, of the new PREFIXn-i.
struct ProgramDiff {
    std::string html;
    std::size_t removed = 0, added = 0;      ///< Number of lines that only one program has.
    std::vector<bool> shown_old, shown_new;  ///< By line, from 1: the line is in `html`.
};

/// Compares two programs. Equal stretches are folded; long equal stretches have no text, and very
/// many different lines are cut off, both with a remark. Marks link to PREFIXr-REGION.
ProgramDiff program_diff(const MarkedProgram& old_program, const MarkedProgram& new_program,
                         const std::string& prefix);

}  // namespace ncsim::report
