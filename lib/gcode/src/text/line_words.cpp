// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses words, assignments and checksums.
#include "text/characters.h"
#include "text/line_parser.h"
#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <vector>

namespace ncsim::gcode {

namespace {

/// True for M66 to M68 and G65, G66, whose blocks may have E words.
bool takes_e(char letter, double number) {
    return (letter == 'M' && number >= 66.0 && number <= 68.0) ||
           (letter == 'G' && (number == 65.0 || number == 66.0));
}

/// True if `words` end in a code that calls a program.
bool calls_program(const std::vector<Word>& words) {
    if (words.empty() || !words.back().literal) return false;
    const double number = words.back().number;
    return (words.back().letter == 'M' && (number == 98.0 || number == 198.0)) ||
           (words.back().letter == 'G' && (number == 65.0 || number == 66.0));
}

}  // namespace

bool LineParser::read_words() {
    if (at_ < text_.size() && (text_[at_] == 'o' || text_[at_] == ':') && !read_o_word())
        return false;
    while (at_ < text_.size()) {
        const std::size_t start = at_;
        const char c = text_[at_];
        if (c == '#') {
            if (!read_assignment()) return false;
        } else if (c == '<' && calls_program(block_.words) && !options_.strict) {
            if (!read_program_name()) return false;
        } else if (c == '*') {
            if (!read_checksum()) return false;
        } else if (c == ',' && at_ + 1 < text_.size() && is_letter(text_[at_ + 1])) {
            ++at_;
            if (!read_word(start, true)) return false;
        } else if (c == '/' && !options_.strict) {
            read_slash();
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

bool LineParser::read_word(std::size_t start, bool comma) {
    const char letter = upper(text_[at_]);
    const std::size_t value = ++at_;
    const PlainNumber number = read_plain_number(text_.data() + at_, text_.data() + text_.size());
    if (number.end) {
        at_ = static_cast<std::size_t>(number.end - text_.data());
        // "M67E2Q3", "G65P1F600E41" have no exponents.
        const bool has_e = takes_e(letter, number.value) ||
                           std::ranges::any_of(block_.words, [](const Word& word) {
                               return takes_e(word.letter, word.number);
                           });
        if (!has_e && has_exponent(start)) return false;
        block_.words.push_back({letter, comma, true, number.value, span(start, at_), {}});
        return true;
    }
    if (!skip_value()) {
        if (!reported_) {
            report(Message::NumberExpected, span(start, start + 1), {std::string_view(&letter, 1)});
        }
        return false;
    }
    // "X#1-#2", "X#1/2": some controls calculate without brackets. "X#1 /2 M8" has a block delete;
    // Fanuc and Haas read "X#1/2M8" in the same way.
    const bool may_skip = !options_.strict && is_block_delete_at(at_);
    const bool is_skipped = may_skip && columns_[at_] > columns_[at_ - 1] + 1;
    if (may_skip && !is_skipped) report(Message::SlashAfterValue, span(start, at_ + 2));
    const bool goes_on = !is_skipped && at_ + 1 < text_.size() &&
                         std::string_view("+-*/").find(text_[at_]) != std::string_view::npos &&
                         starts_value(text_[at_ + 1]);
    if (goes_on && !options_.strict && !skip_operations()) return false;
    block_.words.push_back(
        {letter, comma, false, 0.0, span(start, at_), text_.substr(value, at_ - value)});
    return true;
}

/// True for "/2" in front of a letter or at the end: a block delete with the number of its switch.
bool LineParser::is_block_delete_at(std::size_t at) const {
    if (at + 1 >= text_.size() || text_[at] != '/' || !is_digit(text_[at + 1])) return false;
    return at + 2 == text_.size() || is_letter(text_[at + 2]) || text_[at + 2] == '/';
}

bool LineParser::read_assignment() {
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
    if (at_ == text_.size() && start == 0 && is_number && !options_.strict) {
        report(Message::ParameterShown, span(start, at_), {name});
        return true;
    }
    if (at_ >= text_.size() || text_[at_] != '=') {
        report(Message::AssignmentExpected, span(start, at_));
        return false;
    }
    const std::size_t value = ++at_;
    if (!skip_value() || (!options_.strict && !skip_operations())) {
        if (!reported_) report(Message::NumberExpected, span(start, at_), {"="});
        return false;
    }
    if (has_exponent(start)) return false;
    block_.assignments.push_back({name, text_.substr(value, at_ - value), span(start, at_)});
    return true;
}

bool LineParser::read_program_name() {
    const std::size_t open = at_;
    if (!skip_name()) return false;
    const std::size_t first = columns_[open];  // Behind the '<', counted from 0.
    block_.program_name = line_.substr(first, columns_[at_ - 1] - 1 - first);
    return true;
}

bool LineParser::read_checksum() {
    const std::size_t start = at_++;
    while (at_ < text_.size() && is_digit(text_[at_]))
        ++at_;
    return tolerate(Message::Checksum, span(start, at_));
}

}  // namespace ncsim::gcode
