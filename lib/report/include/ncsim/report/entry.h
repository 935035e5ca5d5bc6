// SPDX-License-Identifier: GPL-3.0-or-later
//
// The share of one program in every report, made when the program was verified. Afterwards the
// verdict of the program can be dropped. Shares from any number of processes combine to the same
// bytes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {

/// Share of one program in every report.
struct Entry {
    std::string path;      ///< Path as specified.
    std::string program;   ///< "O0101" if the file has several programs; otherwise empty.
    std::string word;      ///< "clean", "accepted", "not-proven", "failed", "not-verified".
    int code = 0;          ///< Exit status if this were the only program.
    std::string text;      ///< Text for the terminal.
    std::string settings;  ///< Settings file (ncsim.toml) with options of the program; empty: none.
    std::string baseline;  ///< File of known findings; empty: none.
    std::string counts;    ///< Text: "1 error, 0 warnings, 0 notes, 2 doubts".
    /// Text: rules and doubts that the user switched off or accepted, "34 of 36 rules"; empty:
    /// none.
    std::string scope;
    std::string remedy_text;  ///< Text: remedies, a line for each reason for doubt.
    std::string skipped;      ///< Text: rules that were not checked, a line for each reason.
    std::string json;         ///< One line of JSON; so are the next two.
    std::string sarif;
    std::string junit;
    std::string github;  ///< Annotations, one a line.
    std::string csv;     ///< Lines of the ledger.
    std::string known;   ///< Findings for a baseline, as JSON.
    std::string reads;   ///< Files read for the verdict, one a line.
    /// True if the program is a subprogram, which only acts when called.
    bool is_subprogram = false;
    std::vector<Entry> more;  ///< The remaining programs of the file.
    bool operator==(const Entry&) const = default;
};

/// Converts between an entry and one line of JSON, byte by byte.
/// Returns: nullopt if `line` is not an entry.
std::string line_of(const Entry& entry);
std::optional<Entry> entry_from(std::string_view line);

/// Calls `take` for `entry` without the remaining programs of the file, then for each remaining
/// program.
void for_each_program(const Entry& entry, const std::function<void(const Entry&)>& take);

/// Calls its argument for every entry, in the order of the programs. Can be called repeatedly, so
/// the entries need not be kept in memory.
using Entries = std::function<void(const std::function<void(const Entry&)>&)>;

}  // namespace ncsim::report
