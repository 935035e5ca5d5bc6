// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values and formulas. Angles are in degrees.
// Source: HEIDENHAIN TNC 640, User's Manual for Klartext Programming, "Programming Q parameters".
#include "klartext/q_parameters.h"

#include "ncsim/base/angles.h"

#include "text/message.h"

#include <cmath>
#include <numbers>

namespace ncsim::gcode::klartext {
namespace {

/// Larger than any machine, and small enough that sums and squares are finite.
constexpr double kLargest = 1e12;
constexpr int kDeepest = 100;

}  // namespace

std::optional<double> Parameters::fail(const MessageText& message, SourceSpan span,
                                       std::string_view argument) {
    log_.add(message, span, {argument});
    return std::nullopt;
}

std::optional<double> Parameters::checked(double value, SourceSpan span) {
    if (!(std::abs(value) <= kLargest)) return fail(Message::NotANumber, span);
    return value;
}

std::optional<double> Parameters::value_of(const Value& value, SourceSpan span) {
    if (value.kind == Value::Kind::Number) return checked(value.number, span);
    const Locals* list = value.set == 'L' ? &locals_ : value.set == 'R' ? &kept_ : nullptr;
    bool is_set = false;
    double number = 0.0;
    if (list) {
        const auto found = list->find(value.index);
        is_set = found != list->end();
        if (is_set) number = found->second;
    } else if (value.index < kMost) {
        is_set = is_set_[value.index];
        number = values_[value.index];
    }
    if (!is_set && reported_.size() < 50 && reported_.insert({value.set, value.index}).second) {
        std::string name = value.set == 'Q' ? "Q" : std::string("Q") + value.set;
        name += std::to_string(value.index);
        log_.add(Message::ParameterWithoutValue, span, {name});
    }
    return value.number * number;
}

std::optional<double> Parameters::read_value(Scanner& scan, const Block& block) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    const Value value = scan.value();
    if (value.kind == Value::Kind::None) return fail(Message::ValueMissing, block.span(begin, 1));
    return value_of(value, block.span(begin, scan.at() - begin));
}

void Parameters::copy_values(const Parameters& other) {
    values_ = other.values_;
    is_set_ = other.is_set_;
    locals_ = other.locals_;
    kept_ = other.kept_;
    texts_ = other.texts_;
    reported_ = other.reported_;
}

bool Parameters::set(const Value& parameter, double value) {
    constexpr std::uint32_t kMostOthers = 500;
    if (parameter.set != 'Q') {
        if (parameter.index >= kMostOthers) return false;
        (parameter.set == 'L' ? locals_ : kept_)[parameter.index] = value;
        return true;
    }
    if (parameter.index >= kMost) return false;
    values_[parameter.index] = value;
    is_set_[parameter.index] = true;
    return true;
}

void Parameters::set_unknown(const Value& parameter) {
    (void)set(parameter, 0.0);
}

std::optional<std::string> Parameters::text(std::uint32_t index) const {
    const auto found = texts_.find(index);
    if (found == texts_.end()) return std::nullopt;
    return found->second;
}

std::optional<double> Parameters::read_formula(Scanner& scan, const Block& block) {
    const std::size_t begin = scan.at();
    const std::optional<double> value = sum(scan, block, 0);
    if (!value) return std::nullopt;
    if (!scan.is_at_end()) {
        const std::string_view rest = scan.remaining();
        return fail(Message::UnreadableText, block.span(scan.at(), rest.size()), rest);
    }
    return checked(*value, block.span(begin, scan.at() - begin));
}

std::optional<double> Parameters::sum(Scanner& scan, const Block& block, int depth) {
    std::optional<double> left = product(scan, block, depth);
    while (left) {
        const bool adds = scan.take('+');
        if (!adds && !scan.take('-')) break;
        const std::optional<double> right = product(scan, block, depth);
        if (!right) return std::nullopt;
        left = adds ? *left + *right : *left - *right;
    }
    return left;
}

std::optional<double> Parameters::product(Scanner& scan, const Block& block, int depth) {
    std::optional<double> left = power(scan, block, depth);
    while (left) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        const char sign = scan.peek();
        if (sign != '*' && sign != '/' && sign != '%') break;
        scan.move_to(at + 1);
        const std::optional<double> right = power(scan, block, depth);
        if (!right) return std::nullopt;
        if (sign != '*' && *right == 0.0) return fail(Message::DivisionByZero, block.span(at, 1));
        left = sign == '*'   ? *left * *right
               : sign == '/' ? *left / *right
                             : std::fmod(*left, *right);
    }
    return left;
}

std::optional<double> Parameters::power(Scanner& scan, const Block& block, int depth) {
    std::optional<double> left = factor(scan, block, depth);
    while (left) {
        scan.skip_blanks();
        const std::size_t at = scan.at();
        if (!scan.take('^')) break;
        const std::optional<double> right = factor(scan, block, depth);
        if (!right) return std::nullopt;
        const bool is_whole = *right == std::floor(*right);
        if ((*left < 0.0 && !is_whole) || (*left == 0.0 && *right < 0.0))
            return fail(Message::FunctionRange, block.span(at, 1), "^");
        left = std::pow(*left, *right);
        if (!checked(*left, block.span(at, 1))) return std::nullopt;
    }
    return left;
}

std::optional<double> Parameters::factor(Scanner& scan, const Block& block, int depth) {
    scan.skip_blanks();
    const std::size_t begin = scan.at();
    if (depth > kDeepest) return fail(Message::ExpressionTooDeep, block.span(begin, 1));
    if (scan.take('(')) {
        const std::optional<double> value = sum(scan, block, depth + 1);
        if (!value) return std::nullopt;
        if (!scan.take(')')) return fail(Message::BracketUnclosed, block.span(begin, 1));
        return value;
    }
    if (scan.take('-')) {
        const std::optional<double> value = factor(scan, block, depth + 1);
        if (!value) return std::nullopt;
        return -*value;
    }
    if (scan.take('+')) return factor(scan, block, depth + 1);
    const Value value = scan.value();
    if (value.kind != Value::Kind::None)
        return value_of(value, block.span(begin, scan.at() - begin));
    const std::string name = upper_of(scan.letters());
    if (name.empty()) return fail(Message::ValueMissing, block.span(begin, 1));
    const SourceSpan span = block.span(begin, name.size());
    if (name == "PI") return std::numbers::pi;
    const std::optional<double> x = factor(scan, block, depth + 1);
    if (!x) return std::nullopt;
    return function(name, *x, span);
}

std::optional<double> Parameters::function(std::string_view name, double x, SourceSpan span) {
    const auto refuse = [&] { return fail(Message::FunctionRange, span, name); };
    if (name == "SIN") return sin_cos(x).sin;
    if (name == "COS") return sin_cos(x).cos;
    if (name == "TAN") return sin_cos(x).cos == 0.0 ? refuse() : tangent(x);
    if (name == "ATAN") return angle_of(1.0, x);
    if (name == "ASIN" || name == "ACOS") {
        if (std::abs(x) > 1.0) return refuse();
        const double other = std::sqrt((1.0 - x) * (1.0 + x));
        return name == "ASIN" ? angle_of(other, x) : angle_of(x, other);
    }
    if (name == "SQRT") return x < 0.0 ? refuse() : std::sqrt(x);
    if (name == "SQ") return checked(x * x, span);
    if (name == "ABS") return std::abs(x);
    if (name == "INT") return std::trunc(x);
    if (name == "FRAC") return x - std::trunc(x);
    if (name == "NEG") return -x;
    if (name == "SGN") return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
    if (name == "LN") return x <= 0.0 ? refuse() : std::log(x);
    if (name == "LOG") return x <= 0.0 ? refuse() : std::log10(x);
    if (name == "EXP") return checked(std::exp(x), span);
    return fail(Message::FunctionUnknown, span, name);
}

}  // namespace ncsim::gcode::klartext
