// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

namespace ncsim::report {

/// Adds to `text` what fmt::format() would make. fmt::format_to() with an iterator is compiled anew
/// in every file that names it, 3 seconds each; this calls the library.
template <class... Args>
void append(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
    text += fmt::vformat(format, fmt::make_format_args(args...));
}

}  // namespace ncsim::report
