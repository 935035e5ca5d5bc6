// SPDX-License-Identifier: GPL-3.0-or-later
//
// Program line and tool for each origin number of a boundary, for formats that can store them.
#pragma once

#include "ncsim/cda/origin.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Program line and tool of each origin. Entry i belongs to Origin{i}; entry 0 is the stock (line
/// 0, tool 0).
struct Provenance {
    /// Line and tool of one origin.
    struct Entry {
        std::uint32_t nc_line = 0;  ///< Line of the program, from 1; 0: uncut stock.
        std::uint32_t tool = 0;     ///< Tool number; 0: no tool was called, or uncut stock.

        bool is_stock() const { return nc_line == 0 && tool == 0; }
    };
    std::vector<Entry> entries;
    std::string program;  ///< File name without folders, as formats may quote.
    /// Text of the lines that entries name, if known.
    std::map<std::uint32_t, std::string> text{};
    /// Reasons for doubt about the run, "stock-guess, tool-guess", which files record behind
    /// cda::kAssumedMark; empty: none.
    std::string assumed{};

    /// Returns the entry of `origin`; the entry of the stock if `origin` is beyond the list.
    Entry of(cda::Origin origin) const;
};

}  // namespace ncsim::exporter
