// SPDX-License-Identifier: GPL-3.0-or-later
//
// Baseline: a file of accepted findings next to the programs, which separates known findings from
// new findings. A finding is known if it has the same text for the same block, in the same place of
// the part, and is no worse; the position of the block in the file does not matter. A finding of
// several motions is known only if all motions are the same, because otherwise a new motion could
// hide behind a known motion.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/simulation/known_findings.h"
#include "ncsim/verify/selection.h"

#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::report {

/// The data of a finding in a baseline.
struct KnownFinding {
    std::string rule, code, severity, message;
    std::string file;  ///< Subprogram of the finding, as it was called; empty: the program itself.
    std::uint32_t line = 0;  ///< Informative; compared only if `file` is not empty.
    std::string block;       ///< The line in capitals, without number and blanks.
    int tool = 0;
    bool certain = true;
    std::uint64_t count = 1;  ///< As in verify::Finding.
    bool goes_on = false;
    std::string row;  ///< For several motions: verify::Finding::row, in hexadecimal.
    std::optional<verify::Quantity> quantity;
    Box box;          ///< Place of the finding in W, mm; may be empty.
    std::string why;  ///< Reason for acceptance, written by the user.
    bool operator==(const KnownFinding&) const = default;
};

/// Known findings of all programs of a baseline file.
class Baseline : public simulation::KnownFindings {
public:
    /// Makes an empty baseline.
    explicit Baseline(std::string file) : file_(std::move(file)) {}
    /// Reads `text`, the content of `file`.
    /// Throws: std::runtime_error with the name of the file if `text` is not a baseline.
    Baseline(std::string file, const std::string& text);

    const std::string& file() const { return file_; }
    /// Marks the known findings of `checked`. Lists the known findings that were not found again in
    /// `checked.resolved`, if their rules were checked. If there are more indistinguishable
    /// findings than known findings, all of these findings count as new.
    /// Cost: O(n²) for findings with the same text.
    void accept(Checked& checked, const verify::Selection& selection) const override;

    /// Returns the known findings of a program in one line. Equal lines give equal verdicts.
    std::string key_of_program(const std::string& program) const;
    /// Returns the number of known findings for each program, by the path from the working
    /// directory.
    std::map<std::string, std::size_t> programs() const;

private:
    friend void write_baseline(std::ostream&, const std::string&, const Entries&, const Baseline*);

    const std::vector<KnownFinding>* known_of(const std::string& program) const;

    std::string file_;
    // By path of the program, relative to the folder of the baseline.
    std::map<std::string, std::vector<KnownFinding>> known_;
};

/// Writes the errors and warnings of all verified programs as a baseline for `file`. If `before` is
/// provided, the new baseline keeps the findings of all remaining programs and the reasons of
/// findings that still exist.
void write_baseline(std::ostream& out, const std::string& file, const Entries& all,
                    const Baseline* before);

}  // namespace ncsim::report
