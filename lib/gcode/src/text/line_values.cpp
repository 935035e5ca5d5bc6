// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the ends of values. Values are evaluated by expression.h.
#include "ncsim/base/ascii.h"

#include "text/line_parser.h"
#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <array>

namespace ncsim::gcode {

bool LineParser::has_exponent(std::size_t start) {
    std::size_t end = at_;
    const bool follows = end > 0 && end < text_.size() && text_[end] == 'e' &&
                         (is_digit(text_[end - 1]) || text_[end - 1] == '.') &&
                         columns_[end] == columns_[end - 1] + 1;  // Otherwise a separate word E.
    if (!follows) return false;
    if (++end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
    if (end == text_.size() || !is_digit(text_[end])) return false;
    while (end < text_.size() && (is_digit(text_[end]) || text_[end] == '.'))
        ++end;
    const SourceSpan place = span(start, end);
    report(Message::Exponent, place, {line_.substr(place.column - 1, place.length)});
    return reported_ = true;
}

bool LineParser::skip_brackets() {
    const std::size_t open = at_;
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
        if (text_[at_] == '[') ++depth;
        if (text_[at_] == ']' && --depth == 0) return ++at_, true;
    }
    report(Message::BracketUnclosed, span(open, open + 1));
    return reported_ = true, false;
}

bool LineParser::skip_name() {
    const std::size_t close = text_.find('>', at_);
    if (close == std::string_view::npos) {
        report(Message::NameUnclosed, span(at_, at_ + 1));
        return reported_ = true, false;
    }
    at_ = close + 1;
    return true;
}

bool LineParser::skip_value() {
    while (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+'))
        ++at_;
    if (at_ >= text_.size()) return false;
    const char c = text_[at_];
    if (is_digit(c) || c == '.') {
        const PlainNumber number =
            read_plain_number(text_.data() + at_, text_.data() + text_.size());
        if (!number.end) return false;
        at_ = static_cast<std::size_t>(number.end - text_.data());
        return true;
    }
    if (c == '[') return skip_brackets();
    if (c == '#') {
        ++at_;
        while (at_ < text_.size() && text_[at_] == '#')
            ++at_;
        if (at_ < text_.size() && text_[at_] == '<') return skip_name();
        return skip_value();
    }
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end]))
        ++end;
    if (end - at_ < 2 || end >= text_.size() || text_[end] != '[') return false;
    at_ = end;
    if (!skip_brackets()) return false;
    if (text_.substr(0, end).ends_with("atan") && at_ + 1 < text_.size() && text_[at_] == '/' &&
        text_[at_ + 1] == '[') {
        ++at_;
        return skip_brackets();
    }
    return true;
}

bool LineParser::skip_operations() {
    static constexpr std::array<std::string_view, 15> kOperators = {
        "**", "+", "-", "*", "/", "mod", "and", "xor", "or", "eq", "ne", "ge", "gt", "le", "lt"};
    while (at_ < text_.size()) {
        const std::string_view rest = text_.substr(at_);
        const auto* found = std::ranges::find_if(
            kOperators, [&](std::string_view op) { return rest.starts_with(op); });
        if (found == kOperators.end()) return true;
        const std::size_t before = at_;
        at_ += found->size();
        if (skip_value()) continue;
        if (*found != "/" || reported_) return false;
        at_ = before;  // A block delete, as in "#1=#2 /M8".
        return true;
    }
    return true;
}

}  // namespace ncsim::gcode
