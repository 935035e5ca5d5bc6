// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON written piece by piece.
#include "json_stream.h"

#include "ncsim/base/plain_text.h"

#include <ostream>
#include <string>

namespace ncsim::report {

// Writes the comma, the indentation and the key before the next value.
void JsonStream::next(std::string_view key) {
    if (open_.empty()) return;
    if (!open_.back().is_empty) out_ << ',';
    open_.back().is_empty = false;
    out_ << '\n' << std::string(open_.size(), ' ');
    if (!key.empty()) out_ << to_line(Json(std::string(key))) << ": ";
}

void JsonStream::begin(std::string_view key, char bracket) {
    next(key);
    out_ << bracket;
    open_.push_back({bracket == '{' ? '}' : ']'});
}

void JsonStream::value(std::string_view key, const Json& value) {
    next(key);
    // Line ends in the text are between values, because line ends within strings are escaped.
    std::string text = to_text(value);
    text.pop_back();
    const std::string indent(open_.size(), ' ');
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        if (at > 0) out_ << indent;
        out_ << std::string_view(text).substr(at, end - at);
        at = end;
    }
}

void JsonStream::end() {
    const Open last = open_.back();
    open_.pop_back();
    if (!last.is_empty) out_ << '\n' << std::string(open_.size(), ' ');
    out_ << last.end;
    if (open_.empty()) out_ << '\n';
}

}  // namespace ncsim::report
