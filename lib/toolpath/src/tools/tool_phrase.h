// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools in free form, as users and most CAM systems describe them: a number, a size, a kind, and
// further properties, in any order.
#pragma once

#include "tools/tool_remark.h"

#include <optional>
#include <string_view>

namespace ncsim::toolpath {

/// Reads a comment with the form of a tool description. Empty for prose, names of operations,
/// comments about stock, holes or offsets, and comments in which the size is ambiguous: a missing
/// description is better than a wrong description.
///
///     description = { part }          in any order
///     part   = number | size | kind | key value | value key | attribute | name
///     number = (T | TOOL [NO]) integer | integer "=" ...
///     size   = value [unit] | fraction | # integer | LETTER letter | M value [X pitch]
///
/// A size is before or after a kind, or next to a key such as DIA. A comment with words that occur
/// in no tool description, such as HOLES or DEPTH, or with several unknown words, is not a
/// description. The purpose of the tool follows FOR.
std::optional<ToolRemark> read_tool_phrase(std::string_view comment);

}  // namespace ncsim::toolpath
