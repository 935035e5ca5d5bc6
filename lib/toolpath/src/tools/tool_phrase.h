// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools as people and most CAM systems describe them: a number, a size, a kind, and what else
// belongs to a tool, in any order.
#pragma once

#include "tools/tool_remark.h"

#include <optional>
#include <string_view>

namespace ncsim::toolpath {

/// Reads a comment that is shaped like the description of a tool. Nothing for prose, for names of
/// operations, for comments about stock, holes or offsets, and for those where it is not certain
/// which number is the size: no description is better than a wrong one.
///
///     description = { part }          in any order
///     part   = number | size | kind | key value | value key | attribute | name
///     number = (T | TOOL [NO]) integer | integer "=" ...
///     size   = value [unit] | fraction | # integer | LETTER letter | M value [X pitch]
///
/// A size stands before or behind a kind, or beside a key such as DIA. Words that are in no
/// description of a tool, such as HOLES or DEPTH, and several unknown ones, make it something
/// else. Behind FOR comes what a tool is for.
std::optional<ToolRemark> read_tool_phrase(std::string_view comment);

}  // namespace ncsim::toolpath
