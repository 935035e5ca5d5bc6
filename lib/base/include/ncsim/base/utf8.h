// SPDX-License-Identifier: GPL-3.0-or-later
//
// Characters of UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ncsim {

/// A character of a text.
struct Character {
    std::uint32_t code = 0xfffd;
    std::size_t bytes = 1;  ///< Number of bytes in the text.

    /// False for a byte that is not part of UTF-8.
    constexpr bool is_valid() const { return bytes > 1 || code < 0x80; }
    /// True for control characters of ASCII and Latin-1, line separators, and characters that
    /// change the writing direction.
    constexpr bool is_control() const {
        return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e ||
               code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
               (code >= 0x2066 && code <= 0x2069);
    }
};

/// Returns the first character of `text`. If `text` does not begin with UTF-8, the character is its
/// first byte, with the code U+FFFD. Overlong forms, surrogates and codes beyond U+10FFFF are not
/// UTF-8.
/// Requires: `text` is not empty.
/// Source: RFC 3629; Unicode, table 3-7.
Character first_character(std::string_view text);

}  // namespace ncsim
