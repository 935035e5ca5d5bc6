// SPDX-License-Identifier: GPL-3.0-or-later
//
// UTF-8, XML text and numbers for all formats.
#include "formats/file_text.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>

namespace ncsim::exporter {

namespace {

// Returns the length of the well-formed UTF-8 sequence at the start of `text`; 0 if there is none.
// Overlong forms, surrogates and numbers beyond U+10FFFF are not well-formed.
// Source: Unicode, table 3-7.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    const std::uint8_t second = byte(1);
    const bool out_of_range = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
                              (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90);
    return out_of_range ? 0 : length;
}

// True for control characters of ASCII and Latin-1, line separators, and characters that change the
// writing direction.
bool is_control(std::string_view character) {
    std::uint32_t code = static_cast<std::uint8_t>(character[0]);
    if (code >= 0x80) {
        code &= 0xFFU >> (character.size() + 1);
        for (const char c : character.substr(1))
            code = code << 6 | (static_cast<std::uint8_t>(c) & 0x3FU);
    }
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x61C || code == 0x200E ||
           code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string printable_utf8(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        if (length == 0 || is_control(text.substr(0, length))) {
            result += "\xEF\xBF\xBD";
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

std::string xml_text(std::string_view text) {
    std::string result;
    for (const char c : printable_utf8(text)) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    }
    return result;
}

void append_number(std::string& text, double number) {
    std::array<char, 32> buffer{};
    const double positive_zero = number + 0.0;  // -0 + 0 is 0
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), positive_zero);
    text.append(buffer.data(), end.ptr);
}

}  // namespace ncsim::exporter
