// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text for file formats: UTF-8 that all readers accept, and numbers with all digits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ncsim::exporter {

/// Size in bytes at which a writer flushes its buffer to the stream.
inline constexpr std::size_t kFlushSize = std::size_t{1} << 20;

/// Returns `text` with U+FFFD in place of bytes that are not UTF-8 and of control characters. File
/// names may contain both, but the formats do not allow them.
std::string printable_utf8(std::string_view text);

/// Returns printable_utf8(text) with the special characters of XML escaped.
std::string xml_text(std::string_view text);

/// Appends the shortest text that reads back as `number`, independent of the locale and never "-0".
void append_number(std::string& text, double number);

}  // namespace ncsim::exporter
