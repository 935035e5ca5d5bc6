// SPDX-License-Identifier: GPL-3.0-or-later
//
// Index of the pages of several programs: a table with the verdicts, which a reader can search and
// sort.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/entry.h"
#include "ncsim/report/length_unit.h"
#include "ncsim/report/scope.h"

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace ncsim::report {

/// Facts of a program for its row of the index.
struct IndexFacts {
    std::string page;     ///< Relative address of the page.
    std::string picture;  ///< Relative address of the small picture; empty: none.
    std::string failure;  ///< Reason why there is no verdict; empty: there is a verdict.
    std::uint64_t errors = 0, warnings = 0, doubts = 0;
    std::optional<double> seconds;      ///< Machining time; empty: not known.
    std::optional<double> removed_mm3;  ///< Removed volume; empty: not simulated.
};

/// Returns the facts of `checked`, without addresses.
IndexFacts index_facts(const Checked& checked);

/// Writes the index as HTML 5, UTF-8: a row for each program, the worst verdicts first, then the
/// rest of `scope`. Without JavaScript the index is a plain table. It loads only the small
/// pictures. `facts` returns the facts of an entry; null: the program has no page.
void write_page_index(std::ostream& out, const Entries& all,
                      const std::function<const IndexFacts*(const Entry&)>& facts,
                      const Scope& scope, LengthUnit unit = LengthUnit::Millimetre);

}  // namespace ncsim::report
