// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verdict about one program as a page that needs nothing beside itself: pictures, findings,
// source, ledger, and the part in three dimensions with its faces linked to lines.
#pragma once

#include "ncsim/report/checked.h"

#include <iosfwd>

namespace ncsim::report {

/// HTML 5, UTF-8. Loads nothing from anywhere. Requires checked.look unless it was not verified.
void write_page(std::ostream& out, const Checked& checked);

}  // namespace ncsim::report
