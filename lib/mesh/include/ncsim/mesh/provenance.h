// SPDX-License-Identifier: GPL-3.0-or-later
//
// Program line and tool for each origin number of a boundary, for formats that can store them.
#pragma once

#include "ncsim/cda/origin.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ncsim::mesh {

/// Program line and tool of each origin. Entry i belongs to Origin{i}; entry 0 is the stock (line
/// 0, tool 0).
struct Provenance {
    /// Line and tool of one origin.
    struct Entry {
        /// Line of the program, from 1; 0: uncut stock, or cut by an earlier program.
        std::uint32_t nc_line = 0;
        std::uint32_t tool = 0;  ///< Tool number; 0: no tool was called, or uncut stock.
        /// Earlier program that left the face, from 1 in Provenance::earlier_programs, and its
        /// line; 0: none.
        std::uint32_t earlier_program = 0, earlier_line = 0;

        bool is_stock() const { return nc_line == 0 && tool == 0 && earlier_program == 0; }
        /// Returns a number that is equal for faces of one line of one program.
        std::uint64_t place() const {
            return std::uint64_t{earlier_program} << 32 |
                   (earlier_program == 0 ? nc_line : earlier_line);
        }
    };
    std::vector<Entry> entries;
    std::string program;  ///< File name without folders, as formats may quote.
    std::vector<std::string> earlier_programs{};  ///< The same for programs that left the stock.
    /// Text of the lines that entries name, if known.
    std::map<std::uint32_t, std::string> text{};
    /// Reasons for doubt about the run, "stock-guess, tool-guess", which files record behind
    /// cda::kAssumedMark; empty: none.
    std::string assumed{};

    /// Returns the entry of `origin`; the entry of the stock if `origin` is beyond the list.
    Entry of(cda::Origin origin) const;
};

}  // namespace ncsim::mesh
