// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classes of characters in NC programs, independent of the locale.
#pragma once

namespace ncsim::gcode {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t';
}
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}
constexpr char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}
constexpr bool is_letter(char c) {
    return lower(c) >= 'a' && lower(c) <= 'z';
}
constexpr bool starts_value(char c) {
    return is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[' || c == '#';
}

}  // namespace ncsim::gcode
