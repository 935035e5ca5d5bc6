// SPDX-License-Identifier: GPL-3.0-or-later
//
// Share of one program in each report, as JSON, made and read by the writers of the reports.
#pragma once

#include "ncsim/report/checked.h"
#include "ncsim/report/length_unit.h"

#include "json.h"

#include <string>

namespace ncsim::report {

Json check_json_share(const Checked& checked);
Json sarif_share(const Checked& checked, bool notes);
Json junit_share(const Checked& checked, bool warnings_as_errors);
Json baseline_share(const Checked& checked);
/// Lengths and volumes are in `unit`.
std::string ledger_csv_share(const Checked& checked, LengthUnit unit);

}  // namespace ncsim::report
