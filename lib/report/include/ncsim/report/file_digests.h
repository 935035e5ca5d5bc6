// SPDX-License-Identifier: GPL-3.0-or-later
//
// Digests of files by name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::report {

/// Digests of files by name; nullopt: the file did not exist.
using FileDigests = std::map<std::string, std::optional<std::string>>;

/// Converts between digests and a line of JSON.
/// Returns: nullopt if `line` has a different form.
std::string line_of(const FileDigests& files);
std::optional<FileDigests> file_digests_from(std::string_view line);

}  // namespace ncsim::report
