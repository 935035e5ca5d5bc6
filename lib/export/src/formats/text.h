// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text as the formats want it: UTF-8 that no reader refuses, numbers with every digit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ncsim::exporter {

/// Who writes much hands on what there is when it has become as much, in bytes.
inline constexpr std::size_t kFlushSize = std::size_t{1} << 20;

/// `text` with U+FFFD in place of bytes that are not UTF-8 and of control characters: file names
/// may hold anything, the formats may not.
std::string printable_utf8(std::string_view text);

/// The same, with what XML has a meaning for spelled out.
std::string xml_text(std::string_view text);

/// Appends the shortest text that reads back as `number`; never an exponent's worth of surprise: no
/// locale, no "-0".
void append_number(std::string& text, double number);

}  // namespace ncsim::exporter
