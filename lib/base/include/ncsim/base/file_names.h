// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of files in reports.
#pragma once

#include <string>

namespace ncsim {

/// Returns `path` without folders.
std::string base_name(const std::string& path);

/// Returns `path` normalised, with '/' and without "./". A path below the working directory is
/// returned relative to the working directory.
std::string relative_path(const std::string& path);

}  // namespace ncsim
