// SPDX-License-Identifier: GPL-3.0-or-later
//
// Line ends: LF, CRLF or CR. A UTF-8 byte order mark is not part of the first line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace ncsim::gcode {

/// End of the first line of a text.
struct LineEnd {
    std::size_t length;  ///< Length of the line without the line end.
    std::size_t next;    ///< Start of the next line.
};

/// Returns the end of the first line of `text`.
inline LineEnd find_line_end(std::string_view text) {
    const void* lf = std::memchr(text.data(), '\n', text.size());
    const std::size_t length =
        lf ? static_cast<std::size_t>(static_cast<const char*>(lf) - text.data()) : text.size();
    if (const void* cr = std::memchr(text.data(), '\r', length)) {
        const auto at = static_cast<std::size_t>(static_cast<const char*>(cr) - text.data());
        return {at, at + 1 == length && lf ? length + 1 : at + 1};
    }
    return {length, lf ? length + 1 : length};
}

/// Returns the number of lines of `text`, for limits: lines that end in CR alone are not counted.
inline std::uint64_t line_count(std::string_view text) {
    return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

/// Returns `text` without a leading byte order mark.
inline std::string_view after_byte_order_mark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

}  // namespace ncsim::gcode
