// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses a line in place, or from a clean copy.
#include "text/line_parser.h"

#include "ncsim/base/ascii.h"

#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <array>

namespace ncsim::gcode {

namespace {

constexpr std::uint32_t column_of(std::size_t index) {
    return static_cast<std::uint32_t>(index + 1);
}

/// End of the comment that opens at `open`: index of the matching ')'; of the first ')' if the
/// parentheses do not balance; npos if there is none.
struct CommentEnd {
    std::size_t close;
    bool nested;
};
CommentEnd find_comment_end(std::string_view line, std::size_t open) {
    const std::size_t first = line.find(')', open);
    if (first == std::string_view::npos) return {first, false};
    if (line.substr(open + 1, first - open - 1).find('(') == std::string_view::npos) {
        return {first, false};
    }
    int depth = 0;
    for (std::size_t i = open; i < line.size(); ++i) {
        if (line[i] == '(') ++depth;
        if (line[i] == ')' && --depth == 0) return {i, true};
    }
    return {first, true};
}

}  // namespace

bool LineParser::read_plain() {
    const char* p = line_.data();
    const char* const end = p + line_.size();
    bool first = true;
    while (true) {
        while (p != end && is_blank(*p))
            ++p;
        if (p == end) return true;
        const char letter = upper(*p);
        if (letter < 'A' || letter > 'Z' || letter == 'O') {
            const auto at = static_cast<std::size_t>(p - line_.data());
            if (*p == ';') return add_semicolon_comment(at), true;
            if (*p != '(') return false;
            const CommentEnd comment = find_comment_end(line_, at);
            if (comment.close == std::string_view::npos || comment.nested) return false;
            add_comment(at, comment.close);
            p = line_.data() + comment.close + 1;
            continue;
        }
        const char* start = p++;
        while (p != end && is_blank(*p))
            ++p;
        const PlainNumber number = read_plain_number(p, end);
        if (!number.end) return false;
        // A blank inside a number ("X1 2.5") is legal and rare; read_general() handles the line.
        const char* next = number.end;
        while (next != end && is_blank(*next))
            ++next;
        if (next != end && (is_digit(*next) || *next == '.')) return false;
        if (number.end != end && upper(*number.end) == 'E') return false;  // Possibly an exponent.
        if (letter == 'N') {
            if (!first || number.value < 0.0) return false;
            set_number(number.value);
        } else {
            block_.words.push_back(
                {letter,
                 false,
                 true,
                 number.value,
                 {block_.line, column_of(static_cast<std::size_t>(start - line_.data())),
                  static_cast<std::uint32_t>(number.end - start)},
                 {}});
        }
        first = false;
        p = number.end;
    }
}

void LineParser::read_general(std::string& clean) {
    clean.clear();
    block_.words.clear();
    block_.comments.clear();
    block_.has_number = false;
    const bool is_good = make_clean_copy(clean);
    text_ = clean;
    if (!is_good) {
        read_prefix();
        return refuse();
    }
    if (text_.empty()) return;
    if (is_percent()) return;
    if (is_console_command()) return;
    read_prefix();
    if (!read_words()) refuse();
}

void LineParser::report(const MessageText& message, SourceSpan span,
                        std::initializer_list<std::string_view> arguments) {
    has_fault_ = true;
    if (log_) log_->add(message, span, arguments);
}

bool LineParser::tolerate(const MessageText& message, SourceSpan span,
                          std::initializer_list<std::string_view> arguments) {
    if (!options_.strict) return report(message, span, arguments), true;
    has_fault_ = true;
    if (log_) log_->add(Severity::Error, message, span, arguments);
    return false;
}

void LineParser::add_comment(std::size_t open, std::size_t close) {
    block_.comments.push_back(
        {line_.substr(open + 1, close - open - 1),
         {block_.line, column_of(open), static_cast<std::uint32_t>(close - open + 1)},
         false});
}

void LineParser::add_semicolon_comment(std::size_t at) {
    block_.comments.push_back(
        {line_.substr(at + 1),
         {block_.line, column_of(at), static_cast<std::uint32_t>(line_.size() - at)},
         true});
}

bool LineParser::is_bracket_comment(std::size_t at, std::string_view before) const {
    if (line_[at] != '[' || !before.empty() || options_.strict) return false;
    const std::size_t first = line_.find_first_not_of(" \t", at + 1);
    const bool is_text = first != std::string_view::npos && line_[first] != '#';
    return is_text && line_.find(']', at) != std::string_view::npos;
}

bool LineParser::make_clean_copy(std::string& clean) {
    auto& columns = columns_;
    columns.clear();
    bool good = true;
    for (std::size_t i = 0; i < line_.size(); ++i) {
        const char c = line_[i];
        if (c == '(') {
            const CommentEnd comment = find_comment_end(line_, i);
            const SourceSpan span{block_.line, column_of(i), 1};
            if (comment.close == std::string_view::npos) {
                good = tolerate(Message::CommentUnclosed, span) && good;
                block_.comments.push_back(
                    {line_.substr(i + 1),
                     {block_.line, column_of(i), static_cast<std::uint32_t>(line_.size() - i)},
                     false});
                break;
            }
            if (comment.nested) good = tolerate(Message::CommentNested, span) && good;
            add_comment(i, comment.close);
            i = comment.close;
        } else if (c == ';') {
            add_semicolon_comment(i);
            break;
        } else if (is_bracket_comment(i, clean)) {
            const std::size_t close = line_.find(']', i);
            add_comment(i, close);
            i = close;
        } else if (c == ')') {
            good = tolerate(Message::CommentUnopened, {block_.line, column_of(i), 1}) && good;
        } else if (!is_blank(c) && c != '\0') {
            clean.push_back(lower(c));
            columns.push_back(column_of(i));
        }
    }
    return good;
}

SourceSpan LineParser::span(std::size_t first, std::size_t last) const {
    const auto& columns = columns_;
    if (columns.empty()) return {block_.line, 1, 0};
    first = std::min(first, columns.size() - 1);
    last = std::clamp(last, first + 1, columns.size());
    return {block_.line, columns[first], columns[last - 1] - columns[first] + 1};
}

bool LineParser::is_percent() {
    if (text_[0] != '%') return false;
    block_.kind = BlockKind::Percent;
    return true;
}

bool LineParser::is_console_command() {
    static constexpr std::array<std::string_view, 5> kFanucOutput = {"dprnt", "bprnt", "popen",
                                                                     "pclos", "setvn"};
    // Lines for grbl that unlock the control, or show its state, settings and offsets.
    static constexpr std::array<std::string_view, 7> kViews = {"$x", "$g", "$#", "$$",
                                                               "$i", "$n", "?"};
    const char c = text_[0];
    if (std::ranges::find(kViews, text_) != kViews.end() && !options_.strict) {
        report(Message::ConsoleState, span(0, text_.size()), {trimmed(line_)});
        block_.kind = BlockKind::Command;
        return true;
    }
    // "<PART>" alone is the name of a program of newer Fanuc controls.
    if (c == '<' && text_.find('>') == text_.size() - 1 && !options_.strict) {
        block_.control = {};
        block_.control.word = ControlWord::ProgramNumber;
        block_.control.label = text_;
        block_.control.span = span(0, text_.size());
        return true;
    }
    // M117 and M118 show the rest of the line on a display.
    const bool shows = (text_.starts_with("m117") || text_.starts_with("m118")) &&
                       text_.size() > 4 && is_letter(text_[4]);
    const bool fanuc = std::ranges::any_of(
        kFanucOutput, [&](std::string_view name) { return text_.starts_with(name); });
    if (c != '$' && c != '?' && c != '!' && c != '~' && c != '<' && c != '&' && !fanuc && !shows)
        return false;
    // Displayed or printed text does not affect the program.
    const bool is_text = (fanuc || shows) && !options_.strict;
    const std::string_view shown = line_.substr(0, std::min<std::size_t>(line_.size(), 20));
    if (is_text) report(Message::ConsoleText, span(0, text_.size()), {shown});
    block_.kind = is_text || tolerate(Message::ConsoleCommand, span(0, text_.size()), {shown})
                      ? BlockKind::Command
                      : BlockKind::Unreadable;
    return true;
}

void LineParser::read_prefix() {
    while (at_ < text_.size()) {
        if (text_[at_] == '/' && (!options_.strict || !block_.block_delete)) {
            block_.block_delete = true;
            read_slash();
        } else if (text_[at_] == 'n' && !block_.has_number && at_ + 1 < text_.size() &&
                   is_digit(text_[at_ + 1])) {
            const PlainNumber number =
                read_plain_number(text_.data() + at_ + 1, text_.data() + text_.size());
            if (!number.end) return;
            set_number(number.value);
            at_ = static_cast<std::size_t>(number.end - text_.data());
        } else {
            return;
        }
    }
}

void LineParser::read_slash() {
    if (block_.deletable.length == 0) {
        const auto end = static_cast<std::uint32_t>(line_.size() + 1);
        const std::uint32_t column = columns_[at_];
        block_.deletable = {block_.line, column, end - column};
    }
    ++at_;
    const bool has_number = at_ < text_.size() && is_digit(text_[at_]);
    const bool is_alone =
        at_ + 1 >= text_.size() || (!is_digit(text_[at_ + 1]) && text_[at_ + 1] != '.');
    if (has_number && is_alone) ++at_;
}

}  // namespace ncsim::gcode
