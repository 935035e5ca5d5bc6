// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading numbers and names out of comments and options. Bytes outside ASCII are letters that
// mean nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath::text {

bool is_digit(char c);
bool is_letter(char c);
std::string upper(std::string_view s);
std::string_view trimmed(std::string_view s);
std::vector<std::string_view> split(std::string_view s, char separator);
/// `needle` as a word of its own: neither side touches a letter.
bool has_word(std::string_view s, std::string_view needle);
std::size_t find_word(std::string_view s, std::string_view needle, std::size_t from = 0);

/// A number and, where they stand behind it, its unit.
enum class Unit : unsigned char { None, Millimetre, Inch, Degree };
struct Quantity {
    double value = 0.0;
    Unit unit = Unit::None;
    bool is_fraction = false;  // 1/4, 1-1/2: inches, whatever the program's unit is
    std::size_t begin = 0;     // of the number
    std::size_t end = 0;       // behind the unit
};
/// Reads `12`, `.5`, `5.`, `-3`, `1/4`, `1-1/2` at `at`, then blanks and a unit.
std::optional<Quantity> quantity_at(std::string_view upper_text, std::size_t at);
/// Finite and of a size that a tool or a stock in mm can have.
bool is_sane_length(double mm);

/// 'text', as messages show what was written.
std::string quoted(std::string_view s);

/// Shortest text that reads back as the same number: "10", "3.175".
std::string number(double value);

}  // namespace ncsim::toolpath::text
