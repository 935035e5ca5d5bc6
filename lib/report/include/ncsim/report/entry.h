// SPDX-License-Identifier: GPL-3.0-or-later
//
// What reports say of one program, made when it was verified: its share of each of them. The
// program itself may be forgotten then; many shares, from wherever they come, are put together to
// the same bytes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {

struct Entry {
    std::string path;      ///< As the file was named.
    std::string program;   ///< "O0101" of a file with several programs; else empty.
    std::string word;      ///< "clean", "accepted", "not-proven", "failed", "not-verified".
    int code = 0;          ///< What the command would end with if it were the only one.
    std::string text;      ///< For people.
    std::string settings;  ///< The ncsim.toml that told some options; empty: none.
    std::string baseline;  ///< The file of known findings; empty: none.
    std::string counts;    ///< For people: "1 error, 0 warnings, 0 notes, 2 doubts".
    /// For people: what the user switched off or accepted, "34 of 36 rules"; empty: nothing.
    std::string scope;
    std::string to_tell;  ///< For people: what would prove it, a line a reason for doubt.
    std::string skipped;  ///< For people: what was not asked, a line a reason.
    std::string json;     ///< In one line, as are the next two.
    std::string sarif;
    std::string junit;
    std::string github;  ///< Annotations, a line each.
    std::string csv;     ///< Lines of the ledger.
    std::string known;   ///< What a baseline keeps of it, JSON.
    std::string reads;   ///< Files that were read for the verdict, a line each.
    /// Only acts when another program calls it.
    bool is_subprogram = false;
    std::vector<Entry> more;  ///< The other programs of the file.
    bool operator==(const Entry&) const = default;
};

/// One line of JSON, and back, byte by byte. Nothing if it is no such line.
std::string line_of(const Entry& entry);
std::optional<Entry> entry_from(std::string_view line);

/// Calls `take` for `entry` without the other programs of its file, then for each of those.
void for_each_program(const Entry& entry, const std::function<void(const Entry&)>& take);

/// Calls its argument for every entry in the order of the programs; may be asked to more than once,
/// so that nobody has to keep them all.
using Entries = std::function<void(const std::function<void(const Entry&)>&)>;

}  // namespace ncsim::report
