// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two readers for one grammar. Nearly every line of a real program is a row of letters with plain
// numbers; those are read in place, in one pass. The first thing that is anything else sends
// the line to the general reader, which works on a clean copy (lower case, no blanks, no comments)
// with a column for each byte, so that blanks may stand anywhere, as RS274/NGC allows.
#include "ncsim/gcode/parser.h"

#include "text/line_end.h"
#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace ncsim::gcode {
namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t';
}
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}
constexpr char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}
constexpr bool is_letter(char c) {
    return lower(c) >= 'a' && lower(c) <= 'z';
}
constexpr bool starts_value(char c) {
    return is_digit(c) || c == '.' || c == '-' || c == '+' || c == '[' || c == '#';
}

constexpr std::uint32_t column_of(std::size_t index) {
    return static_cast<std::uint32_t>(index + 1);
}

/// Where the comment that opens at `open` ends: the index of the matching ')', of the first one if
/// the parentheses do not balance, or npos.
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

/// Reads one line. Lives as long as the line.
class LineParser {
public:
    LineParser(BlockReader& reader, std::string_view line, Block& block, DiagnosticLog* log)
        : reader_(reader), line_(line), block_(block), log_(log) {}

    /// Something was to be said of the line.
    bool said_something() const { return said_; }

    /// Words with plain numbers, comments at the end, nothing else; false if there is more.
    bool read_plain() {
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
            // A blank inside a number ("X1 2.5") is legal and rare: the general reader's.
            const char* next = number.end;
            while (next != end && is_blank(*next))
                ++next;
            if (next != end && (is_digit(*next) || *next == '.')) return false;
            if (letter == 'N') {
                if (!first) return false;
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

    /// Everything else. The block points into `clean`, which is written into.
    void read_general(std::string& clean) {
        clean.clear();
        block_.words.clear();
        block_.comments.clear();
        block_.has_number = false;
        if (!make_clean(clean)) return refuse();
        text_ = clean;
        if (text_.empty()) return;
        if (is_percent()) return;
        if (is_console_command()) return;
        read_prefix();
        if (!read_words()) refuse();
    }

private:
    void refuse() {
        block_.kind = BlockKind::Unreadable;
        block_.words.clear();
        block_.assignments.clear();
        block_.control = {};
    }

    void report(const MessageText& message, SourceSpan span,
                std::initializer_list<std::string_view> arguments = {}) {
        said_ = true;
        if (log_) log_->add(message, span, arguments);
    }
    /// For what other controls accept: a warning, and under strict rules an error.
    bool tolerate(const MessageText& message, SourceSpan span,
                  std::initializer_list<std::string_view> arguments = {}) {
        if (!reader_.options_.strict) return report(message, span, arguments), true;
        said_ = true;
        if (log_) log_->add(Severity::Error, message, span, arguments);
        return false;
    }

    void set_number(double value) {
        block_.has_number = true;
        block_.number = value >= 0 && value < 4e9 ? static_cast<std::uint32_t>(value) : 0U;
    }

    void add_comment(std::size_t open, std::size_t close) {
        block_.comments.push_back(
            {line_.substr(open + 1, close - open - 1),
             {block_.line, column_of(open), static_cast<std::uint32_t>(close - open + 1)},
             false});
    }
    void add_semicolon_comment(std::size_t at) {
        block_.comments.push_back(
            {line_.substr(at + 1),
             {block_.line, column_of(at), static_cast<std::uint32_t>(line_.size() - at)},
             true});
    }

    /// "[VCarve: sign.crv]" at the beginning of a line: a comment for WinCNC, and no word anywhere.
    bool is_bracket_comment(std::size_t at, std::string_view before) const {
        if (line_[at] != '[' || !before.empty() || reader_.options_.strict) return false;
        const std::size_t first = line_.find_first_not_of(" \t", at + 1);
        const bool is_text = first != std::string_view::npos && line_[first] != '#';
        return is_text && line_.find(']', at) != std::string_view::npos;
    }

    /// Fills the clean copy. False if the line must not be executed.
    bool make_clean(std::string& clean) {
        auto& columns = reader_.columns_;
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

    SourceSpan span(std::size_t first, std::size_t last) const {
        const auto& columns = reader_.columns_;
        if (columns.empty()) return {block_.line, 1, 0};
        first = std::min(first, columns.size() - 1);
        last = std::clamp(last, first + 1, columns.size());
        return {block_.line, columns[first], columns[last - 1] - columns[first] + 1};
    }

    bool is_percent() {
        if (text_[0] != '%') return false;
        block_.kind = BlockKind::Percent;
        return true;
    }

    bool is_console_command() {
        static constexpr std::array<std::string_view, 5> kFanucOutput = {"dprnt", "bprnt", "popen",
                                                                         "pclos", "setvn"};
        const char c = text_[0];
        // M117 and M118 show the rest of their line on a display.
        const bool shows = (text_.starts_with("m117") || text_.starts_with("m118")) &&
                           text_.size() > 4 && is_letter(text_[4]);
        const bool fanuc = std::ranges::any_of(
            kFanucOutput, [&](std::string_view name) { return text_.starts_with(name); });
        if (c != '$' && c != '?' && c != '!' && c != '~' && c != '<' && c != '&' && !fanuc &&
            !shows)
            return false;
        block_.kind = tolerate(Message::ConsoleCommand, span(0, text_.size()),
                               {line_.substr(0, std::min<std::size_t>(line_.size(), 20))})
                          ? BlockKind::Command
                          : BlockKind::Unreadable;
        return true;
    }

    /// Block delete ('/', "/2") and the line number, in either order.
    void read_prefix() {
        for (int i = 0; i < 2 && at_ < text_.size(); ++i) {
            if (text_[at_] == '/' && !block_.block_delete) {
                block_.block_delete = true;
                ++at_;
                if (at_ + 1 < text_.size() && is_digit(text_[at_]) && is_letter(text_[at_ + 1]))
                    ++at_;
            } else if (text_[at_] == 'n' && !block_.has_number && at_ + 1 < text_.size() &&
                       is_digit(text_[at_ + 1])) {
                const PlainNumber number =
                    read_plain_number(text_.data() + at_ + 1, text_.data() + text_.size());
                if (!number.end) return;
                set_number(number.value);
                at_ = static_cast<std::size_t>(number.end - text_.data());
            }
        }
    }

    bool read_words() {
        if (at_ < text_.size() && (text_[at_] == 'o' || text_[at_] == ':') && !read_o_word())
            return false;
        while (at_ < text_.size()) {
            const std::size_t start = at_;
            const char c = text_[at_];
            if (c == '#') {
                if (!read_assignment()) return false;
            } else if (c == '*') {
                if (!read_checksum()) return false;
            } else if (c == ',' && at_ + 1 < text_.size() && is_letter(text_[at_ + 1])) {
                ++at_;
                if (!read_word(start, true)) return false;
            } else if (c == '/' && !reader_.options_.strict) {
                block_.block_delete = true;  // Fanuc: in mid-line, for what follows.
                ++at_;
            } else if (is_letter(c) || c == '@' || c == '^') {
                if (reads_macro_word()) {
                    if (!good_) return false;
                    continue;
                }
                if (c == 'n') {
                    report(Message::NumberNotFirst, span(start, start + 1));
                    return false;
                }
                if (!read_word(start, false)) return false;
            } else if (is_digit(c) || c == '.' || c == '-' || c == '+') {
                report(Message::LoneNumber, span(start, start + 1));
                return false;
            } else {
                report(Message::LetterExpected, span(start, start + 1), {text_.substr(start, 1)});
                return false;
            }
        }
        return true;
    }

    bool read_word(std::size_t start, bool comma) {
        const char letter = upper(text_[at_]);
        const std::size_t value = ++at_;
        const PlainNumber number =
            read_plain_number(text_.data() + at_, text_.data() + text_.size());
        if (number.end) {
            at_ = static_cast<std::size_t>(number.end - text_.data());
            block_.words.push_back({letter, comma, true, number.value, span(start, at_), {}});
            return true;
        }
        if (!skip_value()) {
            if (!reported_) {
                report(Message::NumberExpected, span(start, start + 1),
                       {std::string_view(&letter, 1)});
            }
            return false;
        }
        // "X#1-#2": some controls calculate without brackets, too.
        const bool goes_on = at_ + 1 < text_.size() &&
                             std::string_view("+-*/").find(text_[at_]) != std::string_view::npos &&
                             starts_value(text_[at_ + 1]);
        if (goes_on && !reader_.options_.strict && !skip_operations()) return false;
        block_.words.push_back(
            {letter, comma, false, 0.0, span(start, at_), text_.substr(value, at_ - value)});
        return true;
    }

    bool read_assignment() {
        const std::size_t start = at_++;
        const std::size_t target = at_;
        if (at_ < text_.size() && text_[at_] == '<') {
            if (!skip_name()) return false;
        } else if (!skip_value()) {
            if (!reported_) report(Message::NumberExpected, span(start, start + 1), {"#"});
            return false;
        }
        const std::string_view name = text_.substr(target, at_ - target);
        const bool is_number = name.find_first_not_of("0123456789") == std::string_view::npos;
        if (at_ == text_.size() && start == 0 && is_number && !reader_.options_.strict) {
            report(Message::ParameterShown, span(start, at_), {name});
            return true;
        }
        if (at_ >= text_.size() || text_[at_] != '=') {
            report(Message::AssignmentExpected, span(start, at_));
            return false;
        }
        const std::size_t value = ++at_;
        if (!skip_value() || (!reader_.options_.strict && !skip_operations())) {
            if (!reported_) report(Message::NumberExpected, span(start, at_), {"="});
            return false;
        }
        block_.assignments.push_back({name, text_.substr(value, at_ - value), span(start, at_)});
        return true;
    }

    bool read_checksum() {
        const std::size_t start = at_++;
        while (at_ < text_.size() && is_digit(text_[at_]))
            ++at_;
        return tolerate(Message::Checksum, span(start, at_));
    }

    /// "o100 sub", "o<name> call [1]", and the Fanuc program number "O1234".
    bool read_o_word() {
        const std::size_t start = at_++;
        const std::size_t label = at_;
        const bool is_name = at_ < text_.size() && is_letter(text_[at_]) && text_[start] == 'o';
        if (at_ < text_.size() && text_[at_] == '<') {
            if (!skip_name()) return false;
        } else if (is_name && !reader_.options_.strict) {
            while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_])))
                ++at_;
            block_.control = {
                ControlWord::ProgramNumber, text_.substr(label, at_ - label), {}, span(start, at_)};
            return true;  // "OCIRCLE": a program with a name
        } else if (text_[start] == ':' && !reader_.options_.strict &&
                   (at_ >= text_.size() || !is_digit(text_[at_]))) {
            at_ = text_.size();  // ": G90 …": a remark of other controls
            block_.kind = BlockKind::Command;
            report(Message::ConsoleCommand, span(start, at_),
                   {line_.substr(0, std::min<std::size_t>(line_.size(), 20))});
            return true;
        } else if (!skip_value()) {
            if (!reported_) {
                report(Message::NumberExpected, span(start, start + 1), {text_.substr(start, 1)});
            }
            return false;
        }
        block_.control.label = text_.substr(label, at_ - label);
        std::size_t end = at_;
        while (end < text_.size() && is_letter(text_[end]))
            ++end;
        const std::string_view command = text_.substr(at_, end - at_);
        block_.control.word = o_command(command);
        if (block_.control.word == ControlWord::None) {
            if (!reader_.options_.strict && end < text_.size() + 1 && !command.empty() &&
                text_[label] != '[' && text_[label] != '#') {
                at_ = end;  // "O7997A": a number with a letter
                while (at_ < text_.size() && is_digit(text_[at_]))
                    ++at_;
                if (command.size() > 2) at_ = end;
            }
            if (command.size() > 2 && (end == text_.size() || text_[end] == '[')) {
                report(Message::ControlWordUnknown, span(at_, end), {command});
                return false;
            }
            block_.control.word = ControlWord::ProgramNumber;
            block_.control.span = span(start, at_);
            return true;
        }
        at_ = end;
        const std::size_t arguments = at_;
        while (at_ < text_.size() && text_[at_] == '[') {
            if (!skip_brackets()) return false;
        }
        block_.control.expression = text_.substr(arguments, at_ - arguments);
        if (block_.control.expression.empty() && at_ < text_.size() && starts_value(text_[at_])) {
            // RS274/NGC allows "o100 repeat #1" and the like: one value without brackets.
            if (!skip_value()) return false;
            block_.control.expression = text_.substr(arguments, at_ - arguments);
        }
        block_.control.span = span(start, end);
        return true;
    }

    static ControlWord o_command(std::string_view name) {
        struct Entry {
            std::string_view name;
            ControlWord word;
        };
        static constexpr auto kCommands = std::to_array<Entry>({
            {"sub", ControlWord::Sub},
            {"endsub", ControlWord::EndSub},
            {"call", ControlWord::Call},
            {"return", ControlWord::Return},
            {"if", ControlWord::OIf},
            {"elseif", ControlWord::OElseIf},
            {"else", ControlWord::OElse},
            {"endif", ControlWord::OEndIf},
            {"while", ControlWord::OWhile},
            {"endwhile", ControlWord::OEndWhile},
            {"do", ControlWord::ODo},
            {"repeat", ControlWord::ORepeat},
            {"endrepeat", ControlWord::OEndRepeat},
            {"break", ControlWord::OBreak},
            {"continue", ControlWord::OContinue},
        });
        const auto* found = std::ranges::find(kCommands, name, &Entry::name);
        return found == kCommands.end() ? ControlWord::None : found->word;
    }

    /// IF, WHILE, GOTO, END n of Fanuc Macro B. True if there was one, read or refused (`good_`).
    bool reads_macro_word() {
        const std::string_view rest = text_.substr(at_);
        const std::size_t start = at_;
        const bool is_if = rest.starts_with("if");
        const bool is_do = rest.size() > 2 && rest.starts_with("do") && is_digit(rest[2]);
        const bool is_short = rest.starts_with("wh[");  // Fanuc reads the first two letters
        const bool is_while = rest.starts_with("while") || is_short || is_do;
        if (!is_if && !is_while && !rest.starts_with("goto") &&
            !(rest.starts_with("end") && rest.size() > 3 && is_digit(rest[3]))) {
            return false;
        }
        if (reader_.options_.strict || block_.control.word == ControlWord::If) {
            // Letters that mean nothing to RS274/NGC: the letter before is the culprit there.
            report(Message::NumberExpected, span(start, start + 1), {upper_letter(rest[0])});
            return good_ = false, true;
        }
        Control& control = block_.control;
        control.span = span(start, start + (is_while ? 5 : is_if ? 2 : rest[0] == 'g' ? 4 : 3));
        if (is_do) {
            at_ = start + 2;
        } else if (is_if || is_while) {
            const std::size_t condition = start + (is_if || is_short ? 2 : 5);
            const std::size_t jump = find_outside_brackets(condition, is_if ? "goto" : "do");
            const std::size_t then =
                is_if ? find_outside_brackets(condition, "then") : std::string_view::npos;
            at_ = condition;
            if (jump != std::string_view::npos) {
                control.expression = text_.substr(condition, jump - condition);
                at_ = jump + (is_if ? 4 : 2);
            } else if (then != std::string_view::npos) {
                control.expression = text_.substr(condition, then - condition);
                control.word = ControlWord::If;
                at_ = then + 4;
                return true;
            } else if (is_if && at_ < text_.size() && text_[at_] == '[' && skip_brackets()) {
                control.expression = text_.substr(condition, at_ - condition);  // IF[…] M99
                control.word = ControlWord::If;
                return true;
            } else {
                report(Message::UnreadableText, span(start, text_.size()), {rest.substr(0, 20)});
                return good_ = false, true;
            }
        } else {
            at_ = start + (rest[0] == 'g' ? 4 : 3);
            if (rest[0] == 'g' && at_ < text_.size() && text_[at_] == 'n') ++at_;
        }
        control.word = is_if            ? ControlWord::If
                       : is_while       ? ControlWord::While
                       : rest[0] == 'g' ? ControlWord::Goto
                                        : ControlWord::End;
        if (is_if && at_ < text_.size() && text_[at_] == 'n') ++at_;
        const std::size_t label = at_;
        if (!skip_value()) {
            if (!reported_) report(Message::NumberExpected, control.span, {upper_letter(rest[0])});
            return good_ = false, true;
        }
        control.label = text_.substr(label, at_ - label);
        return true;
    }

    static std::string_view upper_letter(char c) {
        static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
        return kLetters.substr(static_cast<std::size_t>(upper(c) - 'A'), 1);
    }

    std::size_t find_outside_brackets(std::size_t from, std::string_view what) const {
        int depth = 0;
        for (std::size_t i = from; i < text_.size(); ++i) {
            if (text_[i] == '[') ++depth;
            if (text_[i] == ']') --depth;
            if (depth == 0 && text_.substr(i).starts_with(what)) return i;
        }
        return std::string_view::npos;
    }

    // --- The extent of values; what they are worth is the evaluator's ---

    bool skip_brackets() {
        const std::size_t open = at_;
        int depth = 0;
        for (; at_ < text_.size(); ++at_) {
            if (text_[at_] == '[') ++depth;
            if (text_[at_] == ']' && --depth == 0) return ++at_, true;
        }
        report(Message::BracketUnclosed, span(open, open + 1));
        return reported_ = true, false;
    }

    bool skip_name() {
        const std::size_t close = text_.find('>', at_);
        if (close == std::string_view::npos) {
            report(Message::NameUnclosed, span(at_, at_ + 1));
            return reported_ = true, false;
        }
        at_ = close + 1;
        return true;
    }

    /// One value: sign, then a number, a parameter, brackets, or a function of brackets.
    bool skip_value() {
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

    /// Fanuc writes "#1=#2+3*#4" without brackets.
    bool skip_operations() {
        static constexpr std::array<std::string_view, 15> kOperators = {
            "**", "+",  "-",  "*",  "/",  "mod", "and", "xor",
            "or", "eq", "ne", "ge", "gt", "le",  "lt"};
        while (at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_);
            const auto* found = std::ranges::find_if(
                kOperators, [&](std::string_view op) { return rest.starts_with(op); });
            if (found == kOperators.end()) return true;
            at_ += found->size();
            if (!skip_value()) return false;
        }
        return true;
    }

    BlockReader& reader_;
    std::string_view line_;
    Block& block_;
    DiagnosticLog* log_;
    std::string_view text_;
    std::size_t at_ = 0;
    bool reported_ = false;
    bool said_ = false;
    bool good_ = true;
};

BlockReader::BlockReader(const SourceFile& file, ParserOptions options)
    : file_(&file), options_(options) {
    place_.offset = file.text.size() - after_byte_order_mark(file.text).size();
}

std::string_view BlockReader::take_line() {
    const std::string_view rest = std::string_view(file_->text).substr(place_.offset);
    const LineEnd end = find_line_end(rest);
    place_.offset += end.next;
    ++place_.line;
    return rest.substr(0, end.length);
}

namespace {
void reset(Block& block, std::uint32_t line, std::string_view text) {
    block.kind = BlockKind::Words;
    block.line = line;
    block.block_delete = false;
    block.has_number = false;
    block.number = 0;
    block.control = {};
    block.words.clear();
    block.assignments.clear();
    block.comments.clear();
    block.text = text;
}
}  // namespace

/// The text of a program does not change, so that what was read of it stays right.
struct BlockReader::Kept {
    /// More is written in no loop of a program that somebody wrote.
    static constexpr std::size_t kMostBytes = 128 * 1024;
    struct Line {
        std::string clean;
        bool is_kept = false;  ///< Else it is read again, into `clean`.
        Block block;
        Place after;
    };
    std::unordered_map<std::size_t, Line> lines;
    std::size_t bytes = 0;

    /// Where the line that begins at `start` is kept; nullptr, if there is no room for it.
    Line* at(std::size_t start, std::size_t size) {
        if (const auto known = lines.find(start); known != lines.end()) return &known->second;
        if (lines.size() >= kMostKept || bytes + size > kMostBytes) return nullptr;
        bytes += size;
        return &lines[start];
    }
};

void BlockReader::keep_lines() {
    if (!kept_) kept_ = std::make_shared<Kept>();
}

bool BlockReader::next(Block& block, DiagnosticLog* log) {
    if (place_.offset >= file_->text.size()) return false;
    const std::size_t start = place_.offset;
    if (kept_) {
        const auto known = kept_->lines.find(start);
        if (known != kept_->lines.end() && known->second.is_kept) {
            block = known->second.block;
            place_ = known->second.after;
            return true;
        }
    }
    const std::string_view line = take_line();
    reset(block, place_.line, line);
    LineParser parser(*this, line, block, log);
    if (parser.read_plain()) return true;
    Kept::Line* const kept = kept_ ? kept_->at(start, line.size()) : nullptr;
    parser.read_general(kept ? kept->clean : clean_);
    if (kept && !parser.said_something()) {
        kept->is_kept = true;
        kept->block = block;
        kept->after = place_;
    }
    return true;
}

}  // namespace ncsim::gcode
