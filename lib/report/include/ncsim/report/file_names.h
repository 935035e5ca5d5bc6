// SPDX-License-Identifier: GPL-3.0-or-later
//
// How reports name files.
#pragma once

#include <string>

namespace ncsim::report {

/// Without folders.
std::string base_name(const std::string& path);

/// `path` as seen from the working directory, with '/' and without "./"; as it is if it is not
/// below it.
std::string relative_path(const std::string& path);

}  // namespace ncsim::report
