// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::report {

/// Files by name, with their digests; nothing: there was none.
using FileDigests = std::map<std::string, std::optional<std::string>>;

/// One line of JSON, and back; nothing if it is no such line.
std::string line_of(const FileDigests& files);
std::optional<FileDigests> file_digests_from(std::string_view line);

}  // namespace ncsim::report
