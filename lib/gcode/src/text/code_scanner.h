// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads names, texts and whole numbers from the code of a block.
#pragma once

#include "ncsim/base/ascii.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode {

/// A position in the code of a block.
class CodeScanner {
public:
    explicit CodeScanner(std::string_view code, std::size_t at = 0) : code_(code), at_(at) {}

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
    /// Reads a whole number below 10^9.
    std::optional<std::uint32_t> whole() {
        std::uint32_t value = 0;
        std::size_t digits = 0;
        while (at_ < code_.size() && is_digit(code_[at_]) && digits < 9)
            value = value * 10 + static_cast<std::uint32_t>(code_[at_++] - '0'), ++digits;
        if (digits == 0 || is_digit(peek())) return std::nullopt;
        return value;
    }

protected:
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

}  // namespace ncsim::gcode
