// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the origin numbers of a boundary stand for, for formats that can say it.
#pragma once

#include "ncsim/cda/origin.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ncsim::exporter {

/// Who cut what. Entry i belongs to Origin{i}; entry 0 is the stock (line 0, tool 0).
struct Provenance {
    struct Entry {
        std::uint32_t nc_line = 0;  ///< Line of the program, from 1; 0: uncut stock.
        std::uint32_t tool = 0;     ///< Tool number; 0: none was called, or uncut stock.

        bool is_stock() const { return nc_line == 0 && tool == 0; }
    };
    std::vector<Entry> entries;
    std::string program;  ///< File name without folders, as formats may quote it.
    /// Text of the lines that entries name, as far as it is known.
    std::map<std::uint32_t, std::string> text{};
    /// Reasons for doubt about the run, "stock-guess, tool-guess", as files record them behind
    /// cda::kAssumedMark; empty: none.
    std::string assumed{};

    /// The entry of `origin`; that of the stock for numbers beyond the list.
    Entry of(cda::Origin origin) const;
};

}  // namespace ncsim::exporter
