// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verdict on one program as a self-contained page: pictures, findings, source, ledger, and the
// part in three dimensions with faces linked to lines.
#pragma once

#include "ncsim/report/checked.h"

#include <iosfwd>
#include <string>

namespace ncsim::report {

/// Writes HTML 5, UTF-8, without external resources.
/// Requires: `checked.page_data`, unless the program was not verified.
void write_page(std::ostream& out, const Checked& checked);

/// Writes the page of a run, without a verdict, as write_page(). `path`: the program as specified;
/// `summary`: volumes, tools and times as text.
void write_run_page(std::ostream& out, const std::string& path, const std::string& summary,
                    const PageData& page_data);

}  // namespace ncsim::report
