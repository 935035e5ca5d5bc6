// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of commands from text.
#include "ncsim/base/plain_text.h"

#include "ncsim/base/ascii.h"
#include "ncsim/base/utf8.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ncsim {

namespace {

bool is_graphic(char c) {
    return c > ' ' && c < '\x7f';
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
        const bool is_stray = !c.is_valid() && byte < 0xa0;
        if ((c.is_control() || is_stray) && byte != '\n') {
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

}  // namespace ncsim
