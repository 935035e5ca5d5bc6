// SPDX-License-Identifier: GPL-3.0-or-later
//
// A recursive-descent evaluator of expressions.
#include "text/expression.h"

#include "ncsim/base/angles.h"

#include "text/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ncsim::gcode {
namespace {

enum class Operator : std::uint8_t {
    Power,
    Times,
    Divide,
    Modulo,
    Plus,
    Minus,
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    And,
    Or,
    Xor,
};

struct OperatorText {
    std::string_view text;
    Operator op;
    int precedence;
};
// "**" is before "*" because the first match counts.
constexpr auto kOperators = std::to_array<OperatorText>({
    {"**", Operator::Power, 6},
    {"^", Operator::Power, 6},  // Carvera and Mach3.
    {"*", Operator::Times, 5},
    {"/", Operator::Divide, 5},
    {"mod", Operator::Modulo, 5},
    {"+", Operator::Plus, 4},
    {"-", Operator::Minus, 4},
    {"eq", Operator::Equal, 3},
    {"ne", Operator::NotEqual, 3},
    {"gt", Operator::Greater, 3},
    {"ge", Operator::GreaterEqual, 3},
    {"lt", Operator::Less, 3},
    {"le", Operator::LessEqual, 3},
    {"and", Operator::And, 2},
    {"or", Operator::Or, 2},
    {"xor", Operator::Xor, 2},
});

/// Limit of the nesting depth; protects the stack.
constexpr int kMaxDepth = 100;

class Evaluator {
public:
    Evaluator(std::string_view text, const ParameterSource& parameters,
              const Arithmetic& arithmetic, ExpressionFault& fault)
        : text_(text), parameters_(parameters), arithmetic_(arithmetic), fault_(fault) {}

    bool at_end() const { return at_ == text_.size(); }
    std::size_t at() const { return at_; }

    std::optional<double> expression(int min_precedence) {
        std::optional<double> left = value();
        while (left && at_ < text_.size()) {
            const OperatorText* op = next_operator();
            if (!op || op->precedence < min_precedence) return left;
            at_ += op->text.size();
            const std::optional<double> right = expression(op->precedence + 1);
            if (!right) return std::nullopt;
            left = apply(op->op, *left, *right);
        }
        return left;
    }

    std::optional<double> value() {
        if (++depth_ > kMaxDepth) return fail(Message::ExpressionTooDeep);
        const std::optional<double> result = unguarded_value();
        --depth_;
        return result;
    }

    std::optional<double> fail(const MessageText& message, std::string_view argument = {}) {
        fault_ = {message, std::string(argument)};
        return std::nullopt;
    }

private:
    std::optional<double> finite(double value) {
        if (!std::isfinite(value)) return fail(Message::NotANumber);
        return value;
    }

    bool skip(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    const OperatorText* next_operator() const {
        const std::string_view rest = text_.substr(at_);
        const auto* found = std::ranges::find_if(kOperators, [&](const OperatorText& op) {
            return rest.starts_with(op.text) && !(arithmetic_.strict && op.text == "^");
        });
        return found == kOperators.end() ? nullptr : found;
    }

    std::optional<double> unguarded_value() {
        if (at_ >= text_.size()) return fail(Message::ValueMissing);
        const char c = text_[at_];
        const PlainNumber number =
            read_plain_number(text_.data() + at_, text_.data() + text_.size());
        if (number.end) {
            at_ = static_cast<std::size_t>(number.end - text_.data());
            return number.value;
        }
        if (c == '-' || c == '+') {
            ++at_;
            std::optional<double> inner = value();
            if (inner && c == '-') *inner = -*inner;
            return inner;
        }
        if (c == '[') return brackets();
        if (c == '#') return parameter();
        return function();
    }

    std::optional<double> brackets() {
        if (!skip('[')) return fail(Message::BracketExpected, rest());
        std::optional<double> inner = expression(0);
        if (!inner) return std::nullopt;
        if (!skip(']')) return fail(Message::BracketExpected, rest());
        return inner;
    }

    std::optional<double> parameter() {
        ++at_;
        if (at_ < text_.size() && text_[at_] == '<') {
            const std::size_t close = text_.find('>', at_);
            if (close == std::string_view::npos) return fail(Message::NameUnclosed);
            const std::string_view name = text_.substr(at_ + 1, close - at_ - 1);
            at_ = close + 1;
            if (const std::optional<double> found = parameters_.named(name)) return found;
            return fail(Message::ParameterUnset, name);
        }
        std::optional<double> number = value();
        if (!number) return std::nullopt;
        // A vacant #120 makes "#[#120]" #0, which is vacant.
        if (arithmetic_.vacant && std::isnan(*number)) number = 0.0;
        if (const std::optional<double> found = parameters_.numbered(*number)) return found;
        const double shown = std::isnan(*number) ? 0.0 : std::clamp(*number, -1e15, 1e15);
        return fail(
            parameters_.is_hidden(shown) ? Message::PositionHidden : Message::ParameterRange,
            std::to_string(static_cast<long long>(shown)));
    }

    std::optional<double> function() {
        std::size_t end = at_;
        while (end < text_.size() && text_[end] >= 'a' && text_[end] <= 'z')
            ++end;
        const std::string_view name = text_.substr(at_, end - at_);
        if (name.empty() || end == text_.size() || text_[end] != '[') {
            return fail(Message::UnreadableText, rest());
        }
        at_ = end;
        if (name == "exists") return exists();
        if (name == "atan" || (name == "pow" && !arithmetic_.strict)) return binary_function(name);
        const std::optional<double> x = brackets();
        if (!x) return std::nullopt;
        return unary_function(name, std::isnan(*x) ? 0.0 : *x);
    }

    /// EXISTS: 1 if the name was set or the numbered parameter exists, otherwise 0.
    std::optional<double> exists() {
        if (!skip('[') || at_ >= text_.size() || text_[at_] != '#')
            return fail(Message::ExistsArgument);
        ++at_;
        bool found = false;
        if (at_ < text_.size() && text_[at_] == '<') {
            const std::size_t close = text_.find('>', at_);
            if (close == std::string_view::npos) return fail(Message::NameUnclosed);
            found = parameters_.named(text_.substr(at_ + 1, close - at_ - 1)).has_value();
            at_ = close + 1;
        } else {
            const std::optional<double> number = value();
            if (!number) return std::nullopt;
            found = parameters_.numbered(*number).has_value();
        }
        if (!skip(']')) return fail(Message::ExistsArgument);
        return found ? 1.0 : 0.0;
    }

    /// ATAN[y]/[x] on all controls; ATAN[y,x], ATAN[y] and POW[x,y] if not strict.
    std::optional<double> binary_function(std::string_view name) {
        ++at_;
        const std::optional<double> a = expression(0);
        if (!a) return std::nullopt;
        std::optional<double> b = 1.0;
        if (!arithmetic_.strict && skip(',')) {
            b = expression(0);
            if (!b) return std::nullopt;
            if (!skip(']')) return fail(Message::BracketExpected, rest());
        } else {
            if (!skip(']')) return fail(Message::BracketExpected, rest());
            if (at_ + 1 < text_.size() && text_[at_] == '/' && text_[at_ + 1] == '[') {
                ++at_;
                b = brackets();
                if (!b) return std::nullopt;
            } else if (arithmetic_.strict || name == "pow") {
                return fail(Message::AtanForm);
            }
        }
        if (name == "pow") return finite(std::pow(*a, *b));
        return angle_of(*b, *a);
    }

    std::optional<double> unary_function(std::string_view name, double x) {
        if (name == "abs") return std::abs(x);
        if (name == "sin") return sin_cos(x).sin;
        if (name == "cos") return sin_cos(x).cos;
        if (name == "tan") {
            const SinCos s = sin_cos(x);
            return finite(s.sin / s.cos);
        }
        if (name == "asin" || name == "acos") {
            if (std::abs(x) > 1.0) return fail(Message::FunctionRange, name);
            const double other = std::sqrt((1.0 - x) * (1.0 + x));
            return name == "asin" ? angle_of(other, x) : angle_of(x, other);
        }
        if (name == "sqrt" || (name == "sqr" && !arithmetic_.strict)) {
            if (x < 0.0) return fail(Message::FunctionRange, name);
            return std::sqrt(x);
        }
        if (name == "exp") return finite(std::exp(x));
        if (name == "ln") {
            if (x <= 0.0) return fail(Message::FunctionRange, name);
            return std::log(x);
        }
        if (name == "fix") return arithmetic_.fix_truncates ? std::trunc(x) : std::floor(x);
        if (name == "fup") {
            return arithmetic_.fix_truncates ? std::copysign(std::ceil(std::abs(x)), x)
                                             : std::ceil(x);
        }
        if (name == "round" || (name == "rnd" && !arithmetic_.strict))
            return std::round(x * arithmetic_.round_scale) / arithmetic_.round_scale;
        if (!arithmetic_.strict && (name == "bin" || name == "bcd")) return convert_bcd(name, x);
        return fail(Message::FunctionUnknown, name);
    }

    /// BIN: converts four bits per decimal digit to a number; BCD: the inverse.
    static double convert_bcd(std::string_view name, double x) {
        const double base_in = name == "bin" ? 16.0 : 10.0;
        const double base_out = name == "bin" ? 10.0 : 16.0;
        double rest = std::trunc(std::abs(x));
        double result = 0.0;
        double place = 1.0;
        for (int i = 0; i < 12 && rest > 0.0; ++i) {
            result += place * std::fmod(rest, base_in);
            rest = std::trunc(rest / base_in);
            place *= base_out;
        }
        return result;
    }

    std::optional<double> apply(Operator op, double a, double b) {
        // A vacant variable is equal only to a vacant variable; in other operations it counts as 0.
        const bool vacant_a = std::isnan(a);
        const bool vacant_b = std::isnan(b);
        if (vacant_a || vacant_b) {
            if (op == Operator::Equal) return vacant_a && vacant_b ? 1.0 : 0.0;
            if (op == Operator::NotEqual) return vacant_a && vacant_b ? 0.0 : 1.0;
            if (vacant_a) a = 0.0;
            if (vacant_b) b = 0.0;
        }
        // TOLERANCE_EQUAL of LinuxCNC applies to EQ and NE only.
        const double same = arithmetic_.compares_loosely ? 1e-4 : 1e-6;
        const bool is_near = !arithmetic_.compares_loosely && std::abs(a - b) < same;
        switch (op) {
            case Operator::Power:
                if (a < 0.0 && b != std::floor(b)) return fail(Message::FunctionRange, "**");
                return finite(std::pow(a, b));
            case Operator::Times: return finite(a * b);
            case Operator::Divide:
                if (b == 0.0) return fail(Message::DivisionByZero);
                return finite(a / b);
            case Operator::Modulo: {
                if (b == 0.0) return fail(Message::DivisionByZero);
                const double rest = std::fmod(a, b);
                return rest < 0.0 ? rest + std::abs(b) : rest;
            }
            case Operator::Plus: return finite(a + b);
            case Operator::Minus: return finite(a - b);
            case Operator::Equal: return std::abs(a - b) < same ? 1.0 : 0.0;
            case Operator::NotEqual: return std::abs(a - b) < same ? 0.0 : 1.0;
            case Operator::Greater: return a > b ? 1.0 : 0.0;
            case Operator::GreaterEqual: return a >= b || is_near ? 1.0 : 0.0;
            case Operator::Less: return a < b ? 1.0 : 0.0;
            case Operator::LessEqual: return a <= b || is_near ? 1.0 : 0.0;
            case Operator::And:
            case Operator::Or:
            case Operator::Xor: return logic(op, a, b);
        }
        return 0.0;
    }

    double logic(Operator op, double a, double b) const {
        if (!arithmetic_.bitwise) {
            const bool x = a != 0.0;
            const bool y = b != 0.0;
            const bool result = op == Operator::And ? x && y : op == Operator::Or ? x || y : x != y;
            return result ? 1.0 : 0.0;
        }
        const auto bits = [](double v) {
            return static_cast<std::int64_t>(std::clamp(v, -1e15, 1e15));
        };
        const std::int64_t x = bits(a);
        const std::int64_t y = bits(b);
        return static_cast<double>(op == Operator::And  ? x & y
                                   : op == Operator::Or ? x | y
                                                        : x ^ y);
    }

    std::string_view rest() const { return text_.substr(at_, 20); }

    std::string_view text_;
    const ParameterSource& parameters_;
    const Arithmetic& arithmetic_;
    ExpressionFault& fault_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

std::optional<double> evaluate(std::string_view text, const ParameterSource& parameters,
                               const Arithmetic& arithmetic, ExpressionFault& fault, bool open) {
    Evaluator evaluator(text, parameters, arithmetic, fault);
    const std::optional<double> value = open ? evaluator.expression(0) : evaluator.value();
    if (value && !evaluator.at_end()) {
        return evaluator.fail(Message::UnreadableText, text.substr(evaluator.at(), 20));
    }
    return value;
}

std::optional<double> evaluate_first(std::string_view& text, const ParameterSource& parameters,
                                     const Arithmetic& arithmetic, ExpressionFault& fault) {
    Evaluator evaluator(text, parameters, arithmetic, fault);
    const std::optional<double> value = evaluator.value();
    text.remove_prefix(evaluator.at());
    return value;
}

}  // namespace ncsim::gcode
