// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts lengths in texts.
#include "ncsim/report/length_unit.h"

#include "ncsim/base/ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ncsim::report {

namespace {

constexpr double kInch = 25.4;

// Returns four decimals without trailing zeros; three digits for small values.
std::string inch_text(double inches) {
    constexpr double kSmall = 0.01;
    if (inches != 0.0 && std::abs(inches) < kSmall) return fmt::format("{:.3g}", inches);
    std::string text = fmt::format("{:.4f}", inches);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct Number {
    std::size_t begin = 0, end = 0;
    double value = 0.0;
};

// Reads a number that begins at `at`.
std::optional<Number> number_at(std::string_view text, std::size_t at) {
    if (at >= text.size() || !(is_digit(text[at]) || text[at] == '-')) return std::nullopt;
    Number number{at, 0, 0.0};
    const char* const last = text.data() + text.size();
    const auto read = std::from_chars(text.data() + at, last, number.value);
    if (read.ec != std::errc()) return std::nullopt;
    number.end = static_cast<std::size_t>(read.ptr - text.data());
    return number;
}

// Unit of a text, and the replacement in inches.
struct Unit {
    std::string_view text;
    double factor;  ///< Factor from a value in `text` to a value in `inches`.
    std::string_view inches;
};

constexpr double kSquare = kInch * kInch, kCube = kSquare * kInch;
// A unit before the units that it begins with.
constexpr std::array<Unit, 12> kUnits{{{"mm3/min", 1 / kCube, "in3/min"},
                                       {"mm3/mm", 1 / kSquare, "in3/in"},
                                       {"mm3", 1 / kCube, "in3"},
                                       {"mm2", 1 / kSquare, "in2"},
                                       {"mm/min", 1 / kInch, "in/min"},
                                       {"mm/rev", 1 / kInch, "in/rev"},
                                       {"mm³", 1 / kCube, "in³"},
                                       {"mm²", 1 / kSquare, "in²"},
                                       {"mm", 1 / kInch, "in"},
                                       {"m/min", 1000 / kInch, "in/min"},
                                       {"cm3", 1000 / kCube, "in3"},
                                       {"cm³", 1000 / kCube, "in³"}}};

const Unit* unit_at(std::string_view text, std::size_t at) {
    for (const Unit& unit : kUnits) {
        if (!text.substr(std::min(at, text.size())).starts_with(unit.text)) continue;
        const std::size_t end = at + unit.text.size();
        if (end == text.size() || !is_letter(text[end])) return &unit;
    }
    return nullptr;
}

// Returns the first of `words` at `at`; empty if there is none.
template <std::size_t N>
std::string_view word_at(std::string_view text, std::size_t at,
                         const std::array<std::string_view, N>& words) {
    for (const std::string_view word : words) {
        if (text.substr(std::min(at, text.size())).starts_with(word)) return word;
    }
    return {};
}

// Text that is converted from its start to its end.
class Converter {
public:
    explicit Converter(std::string_view text) : text_(text) {}

    std::string operator()() {
        bool is_quoted = false;
        while (at_ < text_.size()) {
            // An apostrophe within a word, as in "tool's", is no quotation mark.
            if (text_[at_] == '\'' && (is_quoted || at_ == 0 || !is_letter(text_[at_ - 1])))
                is_quoted = !is_quoted;
            const bool begins = at_ == 0 || (!is_letter(text_[at_ - 1]) && text_[at_ - 1] != '.');
            if (is_quoted || !begins || !(put_turn() || put_lengths() || put_axis())) put(1);
        }
        return std::move(out_);
    }

private:
    void put(std::size_t count) {
        out_ += text_.substr(at_, count);
        at_ += count;
    }

    // Copies the angles of "turned X180,Z30".
    bool put_turn() {
        constexpr std::string_view kTurned = "turned ";
        if (!text_.substr(at_).starts_with(kTurned)) return false;
        put(std::min(text_.find(' ', at_ + kTurned.size()), text_.size()) - at_);
        return true;
    }

    // Converts numbers and the unit after them.
    bool put_lengths() {
        static constexpr std::array<std::string_view, 3> kBetween{" x ", " to ", " and "};
        std::vector<Number> numbers;
        for (std::size_t at = at_;;) {
            const auto number = number_at(text_, at);
            if (!number) return false;
            numbers.push_back(*number);
            const std::string_view between = word_at(text_, number->end, kBetween);
            if (between.empty()) break;
            at = number->end + between.size();
        }
        const std::size_t end = numbers.back().end;
        const Unit* const unit =
            end < text_.size() && text_[end] == ' ' ? unit_at(text_, end + 1) : nullptr;
        if (!unit) return false;
        put_numbers(numbers, unit->factor);
        out_ += ' ';
        out_ += unit->inches;
        at_ = end + 1 + unit->text.size();
        has_size_ = numbers.size() == 3;
        return true;
    }

    // Converts "X3", "X 3 to 5" after a size or in a place.
    bool put_axis() {
        if (std::string_view("XYZ").find(text_[at_]) == std::string_view::npos) return false;
        const bool is_range = has_size_ && at_ + 1 < text_.size() && text_[at_ + 1] == ' ';
        const auto first = number_at(text_, at_ + (is_range ? 2 : 1));
        if (!first) return false;
        std::vector<Number> numbers{*first};
        if (is_range) {
            constexpr std::string_view kTo = " to ";
            if (text_.substr(first->end, kTo.size()) != kTo) return false;
            const auto last = number_at(text_, first->end + kTo.size());
            if (!last) return false;
            numbers.push_back(*last);
        }
        put(first->begin - at_);
        put_numbers(numbers, 1 / kInch);
        at_ = numbers.back().end;
        return true;
    }

    void put_numbers(const std::vector<Number>& numbers, double factor) {
        std::size_t end = numbers.front().begin;
        for (const Number& number : numbers) {
            out_ += text_.substr(end, number.begin - end);
            out_ += inch_text(number.value * factor);
            end = number.end;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::string out_;
    bool has_size_ = false;
};

}  // namespace

std::string_view name_of(LengthUnit unit) {
    return unit == LengthUnit::Inch ? "in" : "mm";
}

double in_unit(double mm, LengthUnit unit) {
    return unit == LengthUnit::Inch ? mm / kInch : mm;
}

std::string in_unit(std::string_view text, LengthUnit unit) {
    return unit == LengthUnit::Inch ? Converter(text)() : std::string(text);
}

std::string tool_in_unit(std::string_view description, LengthUnit unit) {
    if (unit != LengthUnit::Inch) return std::string(description);
    std::string out;
    for (std::size_t at = 0; at < description.size();) {
        const bool begins = at == 0 || description[at - 1] == ' ';
        constexpr std::string_view kTo = "to ";
        const std::string_view rest = description.substr(at);
        const std::size_t skipped =
            !begins                                                            ? 0
            : rest.starts_with(kTo)                                            ? 3
            : std::string_view("DLRPK").find(rest[0]) < std::string_view::npos ? 1
                                                                               : 0;
        auto number = skipped > 0 ? number_at(description, at + skipped) : std::nullopt;
        if (!number) {
            out += description[at++];
            continue;
        }
        out += description.substr(at, skipped);
        // The upper diameter of a cone follows after a hyphen.
        for (;;) {
            out += inch_text(number->value / kInch);
            at = number->end;
            if (at >= description.size() || description[at] != '-') break;
            number = number_at(description, at + 1);
            if (!number) break;
            out += "in-";
        }
        out += skipped == 3 ? " in" : "in";
    }
    return out;
}

}  // namespace ncsim::report
