// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings beside the lines of a change, on GitHub.
#pragma once

#include "ncsim/report/checked.h"

#include <string>

namespace ncsim::report {

/// Workflow commands that GitHub Actions shows beside the lines of a change; a line each. Notes
/// only where `notes`.
std::string github_annotations(const Checked& checked, bool notes);

}  // namespace ncsim::report
