// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verdict on one program as a self-contained page: pictures, findings, source, ledger, and the
// part in three dimensions with faces linked to lines.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/length_unit.h"

#include <iosfwd>
#include <string>

namespace ncsim::report {

/// Writes HTML 5, UTF-8, without external resources.
/// `unit`: of texts, and at first of the viewer.
/// Requires: `checked.page_data`, unless the program was not verified.
void write_page(std::ostream& out, const Checked& checked, LengthUnit unit);

/// Writes the page of a run, without a verdict, as write_page(). `path`: the program as specified;
/// `summary`: volumes, tools and times as text.
void write_run_page(std::ostream& out, const std::string& path, const std::string& summary,
                    const simulation::PageData& page_data, LengthUnit unit);

}  // namespace ncsim::report
