// SPDX-License-Identifier: GPL-3.0-or-later
//
// fmt::format() that appends.
#pragma once

#include <fmt/format.h>

#include <string>

namespace ncsim::report {

/// Appends the result of fmt::format() to `text`. fmt::format_to() with an iterator would be
/// compiled again in every file that uses it, 3 seconds each; this function calls the library.
template <class... Args>
void append(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
    text += fmt::vformat(format, fmt::make_format_args(args...));
}

}  // namespace ncsim::report
