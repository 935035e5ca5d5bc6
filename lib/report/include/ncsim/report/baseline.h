// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings that somebody looked at and accepts, in a file beside the programs: what is new is told
// apart from what was known. A finding is the same where it says the same about the same block, in
// the same place of the part, and is no worse; where in the file the block stands does not matter.
// A finding of several motions is the same if all of them are: else one could hide another.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/verify/selection.h"

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {

/// What a baseline keeps of a finding.
struct KnownFinding {
    std::string rule, code, severity, message;
    std::string file;        ///< The subprogram it is in, as it was called; empty: the program.
    std::uint32_t line = 0;  ///< For people; where `file` is told, it has to be the same.
    std::string block;       ///< The line, without its number and blanks, in capitals.
    int tool = 0;
    bool certain = true;
    std::uint64_t count = 1;  ///< As in verify::Finding.
    bool goes_on = false;
    std::string row;  ///< Of several motions: verify::Finding::row, in hexadecimal.
    std::optional<verify::Quantity> quantity;
    cda::Box box;     ///< Where it happens, in W, mm; may be empty.
    std::string why;  ///< What people wrote there.
    bool operator==(const KnownFinding&) const = default;
};

class Baseline {
public:
    /// That knows nothing.
    explicit Baseline(std::string file) : file_(std::move(file)) {}
    /// `text` is that of `file`. Throws std::runtime_error, naming it, if it is no baseline.
    Baseline(std::string file, const std::string& text);

    const std::string& file() const { return file_; }
    /// Marks the findings of `checked` that are known, and notes which known ones are not found any
    /// more: those of rules that were asked. Of several that cannot be told apart none is taken for
    /// known if there are more of them than were known. O(n²) in those that say the same.
    void accept(Checked& checked, const verify::Selection& selection) const;

    /// All it says about a program, in one line; equal lines make equal verdicts.
    std::string about(const std::string& program) const;
    /// Programs it tells of, as they are seen from here, with how many findings.
    std::map<std::string, std::size_t> programs() const;

private:
    friend void write_baseline(std::ostream&, const std::string&, const Entries&, const Baseline*);

    const std::vector<KnownFinding>* known_of(const std::string& program) const;

    std::string file_;
    std::map<std::string, std::vector<KnownFinding>> known_;  // by program, seen from its folder
};

/// Errors and warnings of all programs that were verified, as the baseline that will be in `file`.
/// If there is one `before`, it keeps what that says about other programs, and why findings are
/// accepted that are still there.
void write_baseline(std::ostream& out, const std::string& file, const Entries& all,
                    const Baseline* before);

}  // namespace ncsim::report
