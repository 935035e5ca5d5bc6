// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers and names in comments and options. Bytes outside ASCII count as letters without
// meaning.
#pragma once

#include "ncsim/base/ascii.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::toolpath::text {

bool is_letter(char c);
std::vector<std::string_view> split(std::string_view s, char separator);
/// Returns the first position from `from` on at which `needle` is a word of its own, without
/// adjacent letters; npos if there is none.
std::size_t find_word(std::string_view s, std::string_view needle, std::size_t from = 0);

/// A number with its unit, if given.
enum class Unit : unsigned char { None, Millimetre, Inch, Degree };
struct Quantity {
    double value = 0.0;
    Unit unit = Unit::None;
    bool is_fraction = false;  // 1/4, 1-1/2: inches, whatever the program's unit
    std::size_t begin = 0;     // start of the number
    std::size_t end = 0;       // end of the unit
};
/// Reads `12`, `.5`, `5.`, `-3`, `1/4`, `1-1/2` at `at`, then blanks and a unit.
std::optional<Quantity> quantity_at(std::string_view upper_text, std::size_t at);
/// True if the length is finite and possible for a tool or a stock in mm.
bool is_sane_length(double mm);

/// Returns 'text' in quotes, as in messages.
std::string quoted(std::string_view s);

/// Returns the shortest text of the number, rounded to 1e-6: "10", "3.175".
std::string number(double value);

}  // namespace ncsim::toolpath::text
