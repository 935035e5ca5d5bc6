// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operators, functions and names of expressions.
#include "sinumerik/formula.h"

#include "ncsim/base/angles.h"
#include "ncsim/gcode/print.h"

#include "text/message.h"
#include "text/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace ncsim::gcode::sinumerik {
namespace {

/// Larger than any machine, and small enough that sums and squares are finite.
constexpr double kLargest = 1e12;
constexpr int kDeepest = 100;
constexpr std::size_t kLongest = 1000;

/// Operators of a level, weakest level first. Source: table of priorities in the manual.
constexpr std::array<std::string_view, 6> kLogic{"OR", "XOR", "AND", "B_OR", "B_XOR", "B_AND"};

std::string taken_name(CodeScanner& scan) {
    const std::string_view name = name_at(scan.remaining());
    scan.move_to(scan.at() + name.size());
    return upper_of(name);
}

/// Skips blanks and the operator `name`, unless a longer name follows.
bool take_operator(CodeScanner& scan, std::string_view name) {
    scan.skip_blanks();
    const std::string_view here = name_at(scan.remaining());
    if (upper_of(here) != name) return false;
    scan.move_to(scan.at() + here.size());
    return true;
}

std::int64_t bits_of(double value) {
    return static_cast<std::int64_t>(std::round(value));
}

}  // namespace

bool is_r_parameter(std::string_view name) {
    return name.size() > 1 && name.size() < 8 && upper(name[0]) == 'R' &&
           std::ranges::all_of(name.substr(1), is_digit);
}

std::string text_of(double value) {
    std::string text;
    print_number(text, value);
    return text;
}

std::optional<Value> Expressions::fail(const MessageText& message, SourceSpan span,
                                       std::initializer_list<std::string_view> arguments) {
    log_.add(message, span, arguments);
    return std::nullopt;
}

std::optional<Value> Expressions::checked(double value, SourceSpan span) {
    if (!(std::abs(value) <= kLargest)) return fail(Message::NotANumber, span);
    return Value::of(value);
}

std::optional<Value> Expressions::value(CodeScanner& scan, const Line& line) {
    depth_ = 0;
    return comparison(scan, line);
}

std::optional<double> Expressions::number(CodeScanner& scan, const Line& line) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::optional<Value> found = value(scan, line);
    if (!found) return std::nullopt;
    if (!found->is_text) return found->number;
    log_.add(Message::ValueType, line.span(begin, scan.at() - begin), {"a number"});
    return std::nullopt;
}

std::optional<double> Expressions::literal(CodeScanner& scan, const Line& line) {
    const std::string_view text = scan.remaining();
    const PlainNumber number = read_plain_number(text.data(), text.data() + text.size());
    if (!number.end) {
        log_.add(Message::ValueMissing, line.span(scan.at(), 1));
        return std::nullopt;
    }
    auto length = static_cast<std::size_t>(number.end - text.data());
    double value = number.value;
    // "1.5EX3"
    const bool has_exponent =
        length + 1 < text.size() && upper(text[length]) == 'E' && upper(text[length + 1]) == 'X';
    if (has_exponent) {
        const std::string_view rest = text.substr(length + 2);
        const PlainNumber power = read_plain_number(rest.data(), rest.data() + rest.size());
        if (power.end && std::abs(power.value) <= 300.0) {
            value *= std::pow(10.0, power.value);
            length += 2 + static_cast<std::size_t>(power.end - rest.data());
        }
    }
    const std::size_t begin = scan.at();
    scan.move_to(begin + length);
    if (std::abs(value) <= kLargest) return value;
    log_.add(Message::NotANumber, line.span(begin, length));
    return std::nullopt;
}

// --- Operators ---

std::optional<Value> Expressions::comparison(CodeScanner& scan, const Line& line) {
    std::optional<Value> left = concatenation(scan, line);
    bool has_compared = false;
    while (left) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        constexpr std::array<std::string_view, 6> kSigns{"==", "<>", "<=", ">=", "<", ">"};
        const auto* const sign = std::ranges::find_if(
            kSigns, [&](std::string_view s) { return scan.remaining().starts_with(s); });
        if (sign == kSigns.end() || scan.remaining().starts_with("<<")) break;
        if (has_compared) return fail(Message::ComparisonBrackets, line.span(at, sign->size()));
        has_compared = true;
        scan.move_to(at + sign->size());
        const std::optional<Value> right = concatenation(scan, line);
        if (!right) return std::nullopt;
        if (left->is_text != right->is_text)
            return fail(Message::ValueType, line.span(at, sign->size()), {"values of one type"});
        const int order = left->is_text
                              ? left->text.compare(right->text)
                              : (left->number > right->number) - (left->number < right->number);
        const std::string_view s = *sign;
        const bool is_true = s == "=="   ? order == 0
                             : s == "<>" ? order != 0
                             : s == "<=" ? order <= 0
                             : s == ">=" ? order >= 0
                             : s == "<"  ? order < 0
                                         : order > 0;
        left = Value::of(is_true ? 1.0 : 0.0);
    }
    return left;
}

std::optional<Value> Expressions::concatenation(CodeScanner& scan, const Line& line) {
    std::optional<Value> left = logic(scan, line, 0);
    while (left) {
        scan.skip_blanks();
        if (!scan.remaining().starts_with("<<")) break;
        const std::size_t at = scan.at();
        scan.move_to(at + 2);
        const std::optional<Value> right = logic(scan, line, 0);
        if (!right) return std::nullopt;
        std::string text = left->is_text ? left->text : text_of(left->number);
        text += right->is_text ? right->text : text_of(right->number);
        if (text.size() > kLongest)
            return fail(Message::ValueType, line.span(at, 2), {"a shorter text"});
        left = Value::of(std::move(text));
    }
    return left;
}

std::optional<Value> Expressions::logic(CodeScanner& scan, const Line& line, std::size_t level) {
    if (level == kLogic.size()) return sum(scan, line);
    std::optional<Value> left = logic(scan, line, level + 1);
    while (left && take_operator(scan, kLogic[level])) {
        const SourceSpan span = line.span(scan.at(), 1);
        const std::optional<Value> right = logic(scan, line, level + 1);
        if (!right) return std::nullopt;
        if (left->is_text || right->is_text) return fail(Message::ValueType, span, {"numbers"});
        const double a = left->number;
        const double b = right->number;
        const auto truth = [](bool is_true) { return is_true ? 1.0 : 0.0; };
        switch (level) {
            case 0: left = Value::of(truth(a != 0.0 || b != 0.0)); break;
            case 1: left = Value::of(truth((a != 0.0) != (b != 0.0))); break;
            case 2: left = Value::of(truth(a != 0.0 && b != 0.0)); break;
            case 3: left = Value::of(static_cast<double>(bits_of(a) | bits_of(b))); break;
            case 4: left = Value::of(static_cast<double>(bits_of(a) ^ bits_of(b))); break;
            default: left = Value::of(static_cast<double>(bits_of(a) & bits_of(b))); break;
        }
    }
    return left;
}

std::optional<Value> Expressions::sum(CodeScanner& scan, const Line& line) {
    std::optional<Value> left = product(scan, line);
    while (left) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        const char sign = scan.peek();
        if (sign != '+' && sign != '-') break;
        scan.move_to(at + 1);
        const std::optional<Value> right = product(scan, line);
        if (!right) return std::nullopt;
        if (left->is_text || right->is_text)
            return fail(Message::ValueType, line.span(at, 1), {"numbers"});
        left = checked(sign == '+' ? left->number + right->number : left->number - right->number,
                       line.span(at, 1));
    }
    return left;
}

std::optional<Value> Expressions::product(CodeScanner& scan, const Line& line) {
    std::optional<Value> left = factor(scan, line);
    while (left) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        const SourceSpan span = line.span(at, 1);
        char sign = scan.peek();
        if (sign == '*' || sign == '/') {
            scan.move_to(at + 1);
        } else if (take_operator(scan, "DIV")) {
            sign = 'D';
        } else if (take_operator(scan, "MOD")) {
            sign = 'M';
        } else {
            break;
        }
        const std::optional<Value> right = factor(scan, line);
        if (!right) return std::nullopt;
        if (left->is_text || right->is_text) return fail(Message::ValueType, span, {"numbers"});
        const double a = left->number;
        const double b = right->number;
        if (sign != '*' && b == 0.0) return fail(Message::DivisionByZero, span);
        left = checked(sign == '*'   ? a * b
                       : sign == '/' ? a / b
                       : sign == 'D' ? std::trunc(a / b)
                                     : std::fmod(a, b),
                       span);
    }
    return left;
}

std::optional<Value> Expressions::factor(CodeScanner& scan, const Line& line) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    if (++depth_ > kDeepest) return fail(Message::ExpressionTooDeep, line.span(begin, 1));
    std::optional<Value> found;
    if (scan.take('(')) {
        found = comparison(scan, line);
        if (found && !scan.take(')')) return fail(Message::BracketUnclosed, line.span(begin, 1));
    } else if (const char sign = scan.peek(); sign == '-' || sign == '+') {
        scan.move_to(begin + 1);
        found = factor(scan, line);
        if (found && found->is_text)
            return fail(Message::ValueType, line.span(begin, 1), {"a number"});
        if (found && sign == '-') found->number = -found->number;
    } else if (take_operator(scan, "NOT")) {
        found = factor(scan, line);
        if (found) found = Value::of(found->number == 0.0 ? 1.0 : 0.0);
    } else if (take_operator(scan, "B_NOT")) {
        found = factor(scan, line);
        if (found) found = Value::of(static_cast<double>(~bits_of(found->number)));
    } else if (const auto text = scan.quoted()) {
        found = Value::of(std::string(*text));
    } else if (scan.peek() == '\'') {
        found = coded(scan, line);
    } else if (is_digit(scan.peek()) || scan.peek() == '.') {
        const std::optional<double> number = literal(scan, line);
        if (number) found = Value::of(*number);
    } else {
        found = named(scan, line);
    }
    --depth_;
    return found;
}

/// Reads 'H1F' (hexadecimal), 'B101' (binary), or a character.
std::optional<Value> Expressions::coded(CodeScanner& scan, const Line& line) {
    const std::size_t begin = scan.at();
    const std::string_view rest = scan.remaining();
    const std::size_t end = rest.find('\'', 1);
    if (end == std::string_view::npos || end < 2)
        return fail(Message::UnreadableText, line.span(begin, rest.size()), {rest});
    const std::string_view body = rest.substr(1, end - 1);
    scan.move_to(begin + end + 1);
    if (body.size() == 1) return Value::of(std::string(body));
    const unsigned base = upper(body[0]) == 'H' ? 16 : upper(body[0]) == 'B' ? 2 : 0;
    double value = 0.0;
    for (const char c : body.substr(1)) {
        const char digit = upper(c);
        const unsigned d = is_digit(digit)                ? static_cast<unsigned>(digit - '0')
                           : digit >= 'A' && digit <= 'F' ? static_cast<unsigned>(digit - 'A') + 10
                                                          : 99;
        if (d >= base)
            return fail(Message::UnreadableText, line.span(begin, end + 1),
                        {rest.substr(0, end + 1)});
        value = value * base + d;
    }
    return checked(value, line.span(begin, end + 1));
}

// --- Names ---

std::optional<std::vector<std::uint32_t>> Expressions::indices(CodeScanner& scan,
                                                               const Line& line) {
    std::vector<std::uint32_t> found;
    const std::size_t begin = scan.at();
    if (!scan.take('[')) return found;
    do {
        const std::optional<Value> index = comparison(scan, line);
        if (!index) return std::nullopt;
        const double whole = std::round(index->number);
        if (index->is_text || !(whole >= 0.0 && whole < 1e9) || found.size() >= 3) {
            fail(Message::IndexRange, line.span(begin, scan.at() - begin));
            return std::nullopt;
        }
        found.push_back(static_cast<std::uint32_t>(whole));
    } while (scan.take(','));
    if (!scan.take(']')) {
        fail(Message::BracketUnclosed, line.span(begin, 1));
        return std::nullopt;
    }
    return found;
}

std::optional<Target> Expressions::target(CodeScanner& scan, const Line& line) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const std::string name = taken_name(scan);
    const auto span = [&] { return line.span(begin, std::max<std::size_t>(scan.at() - begin, 1)); };
    Target target;
    if (is_r_parameter(name)) {
        target.index = static_cast<std::uint32_t>(std::stoul(name.substr(1)));
    } else if (name == "R" && scan.peek() == '[') {
        const auto index = indices(scan, line);
        if (!index) return std::nullopt;
        target.index = index->front();
    } else {
        target.variable = variables_.find(name);
        if (!target.variable) {
            fail(Message::VariableMissing, span(),
                 {name.empty() ? scan.remaining().substr(0, 1) : name});
            return std::nullopt;
        }
        const auto index = indices(scan, line);
        if (!index) return std::nullopt;
        const Variable& variable = *target.variable;
        std::size_t element = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t at = i < index->size() ? (*index)[i] : 0;
            if (variable.size[i] == 0 ? i < index->size() : at >= variable.size[i]) {
                fail(Message::IndexRange, span());
                return std::nullopt;
            }
            element = element * std::max(variable.size[i], 1U) + at;
        }
        target.index = static_cast<std::uint32_t>(element);
        return target;
    }
    if (target.index >= Variables::kMostR) {
        fail(Message::IndexRange, span());
        return std::nullopt;
    }
    return target;
}

std::optional<Value> Expressions::named(CodeScanner& scan, const Line& line) {
    const std::size_t begin = scan.at();
    const std::string_view raw = name_at(scan.remaining());
    if (raw.empty()) return fail(Message::ValueMissing, line.span(begin, 1));
    const std::string name = upper_of(raw);
    if (name[0] == '$') return system(scan, line);
    const std::shared_ptr<Variable> variable = variables_.find(name);
    if (!variable && !is_r_parameter(name) && name != "R") {
        scan.move_to(begin + raw.size());
        if (name == "TRUE") return Value::of(1.0);
        if (name == "FALSE") return Value::of(0.0);
        if (name == "PI") return Value::of(std::numbers::pi);
        if (scan.take('(')) return function(name, scan, line);
        return fail(Message::VariableMissing, line.span(begin, raw.size()), {raw});
    }
    const std::optional<Target> found = target(scan, line);
    if (!found) return std::nullopt;
    return variables_.get(*found, line.span(begin, scan.at() - begin), log_);
}

/// Reads "$P_TOOLR", "$AA_IW[X]".
std::optional<Value> Expressions::system(CodeScanner& scan, const Line& line) {
    const std::size_t begin = scan.at();
    const std::string name = taken_name(scan);
    std::string axis;
    if (scan.peek() == '[') {
        scan.move_to(scan.at() + 1);
        scan.skip_blanks();
        axis = taken_name(scan);
        if (!scan.take(']')) axis = "?";
    }
    if (const std::optional<double> value = system_.system_value(name, axis))
        return Value::of(*value);
    return fail(Message::SystemValueUnknown, line.span(begin, scan.at() - begin), {name});
}

std::optional<Value> Expressions::function(std::string_view name, CodeScanner& scan,
                                           const Line& line) {
    const std::size_t begin = scan.at() - 1 - name.size();
    std::vector<Value> arguments;
    do {
        const std::optional<Value> argument = comparison(scan, line);
        if (!argument) return std::nullopt;
        arguments.push_back(*argument);
    } while (scan.take(',') && arguments.size() < 10);
    if (!scan.take(')')) return fail(Message::BracketUnclosed, line.span(scan.at(), 1));
    const SourceSpan span = line.span(begin, scan.at() - begin);
    const auto refuse = [&] { return fail(Message::FunctionRange, span, {name}); };
    const std::size_t count = arguments.size();
    if (name == "STRLEN" && count == 1 && arguments[0].is_text)
        return Value::of(static_cast<double>(arguments[0].text.size()));
    if (std::ranges::any_of(arguments, [](const Value& v) { return v.is_text; }))
        return fail(Message::FunctionUnknown, span, {name});
    const double x = arguments[0].number;
    const double y = count > 1 ? arguments[1].number : 0.0;
    if (count == 1) {
        if (name == "SIN") return Value::of(sin_cos(x).sin);
        if (name == "COS") return Value::of(sin_cos(x).cos);
        if (name == "TAN") return sin_cos(x).cos == 0.0 ? refuse() : Value::of(tangent(x));
        if (name == "ASIN" || name == "ACOS") {
            if (std::abs(x) > 1.0) return refuse();
            const double other = std::sqrt((1.0 - x) * (1.0 + x));
            return Value::of(name == "ASIN" ? angle_of(other, x) : angle_of(x, other));
        }
        if (name == "SQRT") return x < 0.0 ? refuse() : Value::of(std::sqrt(x));
        if (name == "POT") return checked(x * x, span);
        if (name == "ABS") return Value::of(std::abs(x));
        if (name == "TRUNC") return Value::of(std::trunc(x));
        if (name == "ROUND") return Value::of(std::round(x));
        if (name == "LN") return x <= 0.0 ? refuse() : Value::of(std::log(x));
        if (name == "EXP") return checked(std::exp(x), span);
    }
    if (count == 2) {
        if (name == "ATAN2") return Value::of(angle_of(y, x));
        if (name == "MINVAL") return Value::of(std::min(x, y));
        if (name == "MAXVAL") return Value::of(std::max(x, y));
    }
    if (name == "BOUND" && count == 3)
        return Value::of(std::clamp(arguments[2].number, std::min(x, y), std::max(x, y)));
    return fail(Message::FunctionUnknown, span, {name});
}

}  // namespace ncsim::gcode::sinumerik
