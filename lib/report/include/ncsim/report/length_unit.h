// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unit of the lengths in texts and pictures. JSON is always in mm.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ncsim::report {

/// Unit of all lengths, areas, volumes and feeds of a text.
enum class LengthUnit : std::uint8_t { Millimetre, Inch };

/// Returns "mm" or "in".
std::string_view name_of(LengthUnit unit);

/// Returns a length in mm as a number of `unit`.
double in_unit(double mm, LengthUnit unit);

/// Returns `text`, a text of ncsim in mm, in `unit`. Converted are numbers, ranges ("3 to 5 mm")
/// and products ("3 x 4 x 5 mm") before a unit of mm, mm2, mm3, cm3 or m/min, quotients by min, rev
/// and mm, the ranges of X, Y and Z that follow a size, and places such as "X3 Y4". Inches have
/// four decimals, or three digits below 0.01 inch. Text in single quotes and the angles after
/// "turned" stay as they are.
std::string in_unit(std::string_view text, LengthUnit unit);

/// Returns a description of toolpath::describe(), such as "flat end mill D10 L22, D12 to 50", in
/// `unit`: "flat end mill D0.3937in L0.8661in, D0.4724in to 1.9685in".
std::string tool_in_unit(std::string_view description, LengthUnit unit);

}  // namespace ncsim::report
