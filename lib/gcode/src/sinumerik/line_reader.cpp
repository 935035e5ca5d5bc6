// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads lines.
#include "sinumerik/line_reader.h"

#include "ncsim/base/ascii.h"

#include "text/code_scanner.h"
#include "text/line_end.h"

#include <algorithm>

namespace ncsim::gcode::sinumerik {
namespace {

bool is_padding(char c) {
    return is_blank(c) || c == '\f' || c == '\x1a' || c == '\0';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_padding(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Returns the position of the ';' that begins a comment; npos: none.
std::size_t find_comment(std::string_view text) {
    const std::size_t first = text.find(';');
    if (first == std::string_view::npos || text.find('"') > first) return first;
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') is_quoted = !is_quoted;
        if (text[i] == ';' && !is_quoted) return i;
    }
    return std::string_view::npos;
}

void skip_blanks(std::string_view text, std::size_t& at) {
    while (at < text.size() && is_padding(text[at]))
        ++at;
}

/// Skips "/" and "/3".
void skip_slash(std::string_view text, std::size_t& at, Line& line) {
    skip_blanks(text, at);
    if (at >= text.size() || text[at] != '/') return;
    line.block_delete = true;
    ++at;
    if (at < text.size() && is_digit(text[at])) ++at;
    skip_blanks(text, at);
}

/// Skips a label: "NAME:".
void split_label(std::string_view text, std::size_t& at, Line& line) {
    const std::string_view name = name_at(text.substr(at));
    std::size_t after = at + name.size();
    skip_blanks(text, after);
    const bool is_label = !name.empty() && name[0] != '$' && after < text.size() &&
                          text[after] == ':' && text.substr(after, 2) != ":=";
    if (!is_label) return;
    line.label = name;
    at = after + 1;
    skip_blanks(text, at);
}

/// Splits `text`, a line without comment, into number, label and code.
void split(std::string_view text, Line& line) {
    std::size_t at = 0;
    skip_slash(text, at, line);
    const bool has_letter = at < text.size() && (upper(text[at]) == 'N' || text[at] == ':');
    if (has_letter && at + 1 < text.size() && is_digit(text[at + 1])) {
        const std::size_t begin = at++;
        while (at < text.size() && is_digit(text[at]))
            ++at;
        line.number = text.substr(begin, at - begin);
        skip_slash(text, at, line);
    }
    skip_blanks(text, at);
    if (text.find(':', at) != std::string_view::npos) split_label(text, at, line);
    line.code = text.substr(at);
    line.column = static_cast<std::uint32_t>(at + 1);
}

}  // namespace

std::string_view name_at(std::string_view text) {
    if (text.empty() || !(is_letter(text[0]) || text[0] == '_' || text[0] == '$')) return {};
    std::size_t end = 1;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]) || text[end] == '_'))
        ++end;
    return text.substr(0, end);
}

Reader::Reader(const SourceFile& file, Place begin, std::size_t end)
    : text_(std::string_view(file.text).substr(0, end)), place_(begin) {
    if (place_.offset == 0 && text_.starts_with("\xEF\xBB\xBF")) place_.offset = 3;
}

bool Reader::next(Line& line) {
    if (place_.offset >= text_.size()) return false;
    const std::string_view rest = text_.substr(place_.offset);
    const LineEnd end = find_line_end(rest);
    line.offset = place_.offset;
    place_.offset += end.next;
    line.line = ++place_.line;
    line.block_delete = line.is_head = false;
    line.number = line.label = {};
    line.comments.clear();
    const std::string_view text = rest.substr(0, end.length);
    const std::size_t comment = find_comment(text);
    const std::string_view code = trimmed(text.substr(0, comment));
    if (comment != std::string_view::npos) {
        const std::string_view remark = trimmed(text.substr(comment + 1));
        line.comments.push_back({remark,
                                 {line.line, static_cast<std::uint32_t>(comment + 1),
                                  static_cast<std::uint32_t>(remark.size() + 1)},
                                 true});
    }
    if (code.starts_with('%')) {
        line.is_head = true;
        line.code = code;
        line.column = 1;
        return true;
    }
    split(code, line);
    return true;
}

std::vector<Section> sections_of(const SourceFile& file) {
    constexpr std::size_t kMost = 10'000;
    std::vector<Section> sections{{}};
    sections.back().end = file.text.size();
    if (file.text.find('%') == std::string::npos) return sections;
    Reader reader(file);
    Line line;
    bool has_code = false;
    while (reader.next(line) && sections.size() < kMost) {
        if (!line.is_head) {
            has_code = has_code || !line.code.empty();
            continue;
        }
        // "%_N_PART_MPF", "%MPF100", "%SPF100006"; "%" alone is no head.
        const std::string head = upper_of(line.code);
        std::string name = head.starts_with("%_N_") ? head.substr(4) : head.substr(1);
        if (name.empty() || name == "_N_") continue;
        const bool is_sub = name.ends_with("_SPF") || name.starts_with("SPF");
        if (name.ends_with("_SPF") || name.ends_with("_MPF")) name.resize(name.size() - 4);
        if (name.starts_with("SPF")) name = "L" + name.substr(3);
        if (has_code || !sections.back().name.empty()) {
            sections.back().end = line.offset;
            sections.push_back({});
        }
        Section& section = sections.back();
        section.name = std::move(name);
        section.is_main = !is_sub;
        section.begin = reader.place();
        section.end = file.text.size();
    }
    return sections;
}

}  // namespace ncsim::gcode::sinumerik
