// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrays of numbers as text for pages; page/arrays.js is the reader.
#pragma once

#include "ncsim/base/vec3.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ncsim::report {

/// Returns `bytes` in Base64.
std::string base64(std::string_view bytes);

/// Returns the numbers as text: columns of a table with `stride` columns, differences in each
/// column, the four bytes of all differences apart, deflate, Base64.
/// Throws: std::runtime_error if zlib fails.
std::string packed(std::span<const std::uint32_t> numbers, std::size_t stride = 1);

/// Returns a text, deflated, in Base64.
/// Throws: std::runtime_error if zlib fails.
std::string packed_text(const std::string& text);

/// Lengths of pages are integers of this unit, mm.
inline constexpr double kPageUnit = 1e-4;
/// Appends a position in units of kPageUnit.
void append_position(std::vector<std::uint32_t>& numbers, const Vec3& position);
/// Components of unit vectors are integers of 1/32767; for a normal, a step is below 0.002°.
void append_direction(std::vector<std::uint32_t>& numbers, const Vec3& direction);

}  // namespace ncsim::report
