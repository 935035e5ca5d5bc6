// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of commands from text.
#include "ncsim/report/plain_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ncsim::report {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_graphic(char c) {
    return c > ' ' && c < '\x7f';
}

// The first character of a text and its number of bytes; U+FFFD and 1 if the text does not begin
// with UTF-8.
struct Character {
    std::uint32_t code = 0xfffd;
    std::size_t bytes = 1;
};

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0xffU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) return {};
        code = code << 6 | (byte(i) & 0x3fU);
    }
    return {code, bytes};
}

// True for control characters of ASCII and Latin-1, line separators, and characters that change the
// writing direction.
bool is_control_code(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e ||
           code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

// True for "##[error]", "##vso[…" and similar markers, which GitHub's runner and Azure's agent
// recognise anywhere in a line. "##[100]", which occurs in programs, is no marker.
bool is_mark(std::string_view text) {
    if (!text.starts_with("##")) return false;
    std::size_t at = 2;
    while (at < text.size() && is_letter(text[at]))
        ++at;
    if (at + 1 >= text.size() || text[at] != '[') return false;
    return at > 2 || is_letter(text[at + 1]);
}

// Returns the position of the first graphic character of ASCII. Services skip blanks of all
// alphabets before a command, so all characters beyond ASCII count as blanks.
std::size_t first_graphic(std::string_view line) {
    const auto* const found = std::ranges::find_if(line, is_graphic);
    return static_cast<std::size_t>(found - line.begin());
}

bool begins_like_a_command(std::string_view line) {
    const std::string_view rest = line.substr(first_graphic(line));
    return rest.starts_with("::") || rest.starts_with("##");
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result(text);
    for (std::size_t at = 0; at < result.size();) {
        const Character c = first_character(std::string_view(result).substr(at));
        const auto byte = static_cast<std::uint8_t>(result[at]);
        // A byte that is not UTF-8 is a control character in a Latin-1 terminal.
        const bool is_stray = c.bytes == 1 && byte >= 0x80 && byte < 0xa0;
        if ((is_control_code(c.code) || is_stray) && byte != '\n') {
            const char instead = byte == '\t' ? ' ' : '?';
            result.replace(at, c.bytes, c.bytes, instead);
        }
        at += c.bytes;
    }
    for (std::size_t at = result.find("##"); at != std::string::npos;
         at = result.find("##", at + 1)) {
        if (is_mark(std::string_view(result).substr(at))) result[at + 1] = '?';
    }
    for (std::size_t begin = 0; begin < result.size();) {
        const std::size_t end = std::min(result.find('\n', begin), result.size());
        const auto line = std::string_view(result).substr(begin, end - begin);
        if (begins_like_a_command(line)) result[begin + first_graphic(line)] = '?';
        begin = end + 1;
    }
    return result;
}

std::string one_line(std::string_view text) {
    std::string line = printable(text);
    std::ranges::replace(line, '\n', '?');
    return line;
}

std::string printable_path(std::string_view path) {
    // Spreadsheets evaluate a cell that begins with any of these characters.
    constexpr std::string_view kFormula = "=+-@\t\r";
    const bool is_safe = path.empty() || (kFormula.find(path.front()) == std::string_view::npos &&
                                          !begins_like_a_command(path));
    std::string shown = is_safe ? "" : "./";
    return one_line(shown.append(path));
}

std::string printable_json(std::string text) {
    for (std::size_t at = text.find("##"); at != std::string::npos; at = text.find("##", at + 1)) {
        if (!is_mark(std::string_view(text).substr(at))) continue;
        constexpr std::string_view kEscaped = "\\u0023";
        text.replace(at, 1, kEscaped);
        at += kEscaped.size() - 1;
    }
    return text;
}

}  // namespace ncsim::report
