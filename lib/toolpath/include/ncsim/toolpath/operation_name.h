// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of operations, which CAM systems write as comments in front of the blocks of an operation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::toolpath {

/// Name of an operation, and the line of the comment.
struct OperationName {
    std::uint32_t line = 0;
    std::string name;
};

/// Returns the name in a comment that stands alone in its block: at most six words and 60 bytes,
/// without dashes and stars around it and without "BEGIN OPERATION:" in front. Empty for sentences,
/// values (`Z = 5`), messages to the operator and ends of operations.
std::optional<std::string> operation_name_of(std::string_view comment);

}  // namespace ncsim::toolpath
