// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads names, numbers and Q parameters from the code of a block.
#pragma once

#include "klartext/block.h"
#include "text/characters.h"
#include "text/number.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode::klartext {

/// A position in the code of a block.
class Scanner {
public:
    explicit Scanner(std::string_view code, std::size_t at = 0) : code_(code), at_(at) {}

    std::size_t at() const { return at_; }
    void move_to(std::size_t at) { at_ = at; }
    std::string_view remaining() const { return code_.substr(at_); }
    std::string_view text(std::size_t from) const { return code_.substr(from, at_ - from); }
    char peek() const { return at_ < code_.size() ? code_[at_] : '\0'; }
    char peek(std::size_t n) const { return at_ + n < code_.size() ? code_[at_ + n] : '\0'; }

    void skip_blanks() {
        while (at_ < code_.size() && is_blank(code_[at_]))
            ++at_;
    }
    /// Skips blanks.
    /// Returns: true at the end of the code.
    bool is_at_end() {
        skip_blanks();
        return at_ >= code_.size();
    }
    /// Skips blanks, and `c` if `c` follows.
    bool take(char c) {
        skip_blanks();
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    /// Skips blanks, and the letters of `word` (upper case) unless a letter follows.
    bool take_word(std::string_view word) {
        skip_blanks();
        for (std::size_t i = 0; i < word.size(); ++i) {
            if (upper(peek(i)) != word[i]) return false;
        }
        if (is_letter(peek(word.size()))) return false;
        at_ += word.size();
        return true;
    }
    /// Returns the next letters, which may be none.
    std::string_view letters() {
        const std::size_t begin = at_;
        while (at_ < code_.size() && is_letter(code_[at_]))
            ++at_;
        return code_.substr(begin, at_ - begin);
    }
    /// Returns the text in quotes; nullopt if there is none.
    std::optional<std::string_view> quoted() {
        skip_blanks();
        if (peek() != '"') return std::nullopt;
        const std::size_t end = code_.find('"', at_ + 1);
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view text = code_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return text;
    }
    /// Reads digits with a decimal point or comma, without a sign.
    std::optional<double> unsigned_number() {
        const std::size_t begin = at_;
        std::size_t end = at_;
        bool has_comma = false;
        bool has_point = false;
        std::size_t digits = 0;
        for (; end < code_.size(); ++end) {
            const char c = code_[end];
            if (is_digit(c)) {
                ++digits;
            } else if ((c == '.' || c == ',') && !has_point) {
                has_point = true;
                has_comma = c == ',';
            } else {
                break;
            }
        }
        if (digits == 0) return std::nullopt;
        at_ = end;
        if (!has_comma) return read_plain_number(code_.data() + begin, code_.data() + end).value;
        std::string number(code_.substr(begin, end - begin));
        number[number.find(',')] = '.';
        return read_plain_number(number.data(), number.data() + number.size()).value;
    }
    /// Reads a whole number below 10^9.
    std::optional<std::uint32_t> whole() {
        std::uint32_t value = 0;
        std::size_t digits = 0;
        while (at_ < code_.size() && is_digit(code_[at_]) && digits < 9)
            value = value * 10 + static_cast<std::uint32_t>(code_[at_++] - '0'), ++digits;
        if (digits == 0 || is_digit(peek())) return std::nullopt;
        return value;
    }
    /// Reads "Q5", "QL5" or "QR5".
    std::optional<Value> parameter() {
        if (upper(peek()) != 'Q') return std::nullopt;
        Value value{Value::Kind::Parameter, 'Q', 0, 1.0};
        const std::size_t begin = at_++;
        if (const char set = upper(peek()); set == 'L' || set == 'R') value.set = set, ++at_;
        const std::optional<std::uint32_t> index = whole();
        if (!index) {
            at_ = begin;
            return std::nullopt;
        }
        value.index = *index;
        return value;
    }
    /// Reads "-10.5", "+Q5", "- 1.7"; Kind::None without a value.
    Value value() {
        const std::size_t begin = at_;
        skip_blanks();
        double sign = 1.0;
        if (peek() == '+' || peek() == '-') {
            sign = peek() == '-' ? -1.0 : 1.0;
            ++at_;
            skip_blanks();
        }
        if (const std::optional<double> number = unsigned_number())
            return {Value::Kind::Number, 'Q', 0, sign * *number};
        if (std::optional<Value> parameter = this->parameter()) {
            parameter->number = sign;
            return *parameter;
        }
        at_ = begin;
        return {};
    }

private:
    std::string_view code_;
    std::size_t at_ = 0;
};

/// Returns `text` in upper case.
inline std::string upper_of(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        c = upper(c);
    return out;
}

}  // namespace ncsim::gcode::klartext
