// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that is known about one program in the end.
#pragma once

#include "ncsim/verify/finding.h"
#include "ncsim/verify/ledger.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ncsim::verify {

struct Verdict {
    std::vector<std::string> files;  ///< [0] the program; called files follow.
    std::vector<Finding> findings;   ///< In the order of the program's lines.
    std::vector<Skipped> skipped;    ///< In the order of rules().
    /// Beyond kMaxFindings of a rule they are only counted, here.
    std::map<std::string, std::uint64_t> unlisted;
    Ledger ledger;

    static constexpr std::size_t kMaxFindings = 1000;

    /// Findings that are not suppressed, those that are only counted included where they have the
    /// rule's default weight.
    std::uint64_t count(Severity severity) const;
    std::uint64_t suppressed() const;
};

}  // namespace ncsim::verify
