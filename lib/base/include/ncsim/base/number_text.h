// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text, independent of the locale.
#pragma once

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace ncsim {

/// Appends the shortest text that reads back as the same number.
template <class Number>
void append_shortest(std::string& text, Number number) {
    std::array<char, 32> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), written.ptr);
}

/// Returns the shortest text that reads back as the same number.
template <class Number>
std::string shortest(Number number) {
    std::string text;
    append_shortest(text, number);
    return text;
}

/// Returns the number that is the whole `text`, without a plus sign; empty if `text` is no number
/// or the number is out of range.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace ncsim
