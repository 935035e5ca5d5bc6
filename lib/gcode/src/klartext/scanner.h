// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads names, numbers and Q parameters from the code of a block.
#pragma once

#include "klartext/block.h"
#include "text/code_scanner.h"
#include "text/number.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ncsim::gcode::klartext {

using gcode::upper_of;

/// A position in the code of a block.
class Scanner : public CodeScanner {
public:
    using CodeScanner::CodeScanner;

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
};

}  // namespace ncsim::gcode::klartext
