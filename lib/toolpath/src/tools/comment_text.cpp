// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with units, words and quotes in comments and options.
#include "tools/comment_text.h"

#include "ncsim/base/number_text.h"

#include <charconv>
#include <cmath>

namespace ncsim::toolpath::text {

bool is_letter(char c) {
    return ncsim::is_letter(c) || static_cast<unsigned char>(c) >= 0x80;
}

std::vector<std::string_view> split(std::string_view s, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = s.find(separator);
        parts.push_back(s.substr(0, at));
        if (at == std::string_view::npos) return parts;
        s.remove_prefix(at + 1);
    }
}

std::size_t find_word(std::string_view s, std::string_view needle, std::size_t from) {
    for (std::size_t at = s.find(needle, from); at != std::string_view::npos;
         at = s.find(needle, at + 1)) {
        const std::size_t end = at + needle.size();
        const bool free_left = at == 0 || !is_letter(s[at - 1]);
        const bool free_right = end == s.size() || !is_letter(s[end]);
        if (free_left && free_right) return at;
    }
    return std::string_view::npos;
}

namespace {

struct Plain {
    double value = 0.0;
    std::size_t end = 0;
};

// Reads at least one digit, with at most one point.
std::optional<Plain> plain_at(std::string_view s, std::size_t at) {
    std::size_t end = at;
    bool point = false;
    bool digit = false;
    while (end < s.size() && (is_digit(s[end]) || (s[end] == '.' && !point))) {
        point = point || s[end] == '.';
        digit = digit || is_digit(s[end]);
        ++end;
    }
    if (!digit) return std::nullopt;
    Plain plain;
    const char* first = s.data() + at;
    const auto read = std::from_chars(first, s.data() + end, plain.value, std::chars_format::fixed);
    if (read.ec != std::errc{}) return std::nullopt;
    plain.end = end;
    return plain;
}

std::size_t skip_blanks(std::string_view s, std::size_t at) {
    while (at < s.size() && (s[at] == ' ' || s[at] == '\t'))
        ++at;
    return at;
}

}  // namespace

std::optional<Quantity> quantity_at(std::string_view s, std::size_t at) {
    Quantity q;
    q.begin = at;
    double sign = 1.0;
    if (at < s.size() && (s[at] == '-' || s[at] == '+')) sign = s[at++] == '-' ? -1.0 : 1.0;
    const auto whole = plain_at(s, at);
    if (!whole) return std::nullopt;
    q.value = whole->value;
    std::size_t end = whole->end;
    const auto fraction_at = [&](std::size_t slash, double numerator) {
        if (slash >= s.size() || s[slash] != '/') return false;
        const auto denominator = plain_at(s, slash + 1);
        if (!denominator || denominator->value == 0.0) return false;
        q.value += numerator / denominator->value;
        q.is_fraction = true;
        end = denominator->end;
        return true;
    };
    if (end < s.size() && s[end] == '/') {
        q.value = 0.0;
        if (!fraction_at(end, whole->value)) q.value = whole->value;
    } else if (end < s.size() && (s[end] == '-' || s[end] == ' ')) {  // 1-1/2, 1 1/2
        if (const auto numerator = plain_at(s, end + 1)) {
            fraction_at(numerator->end, numerator->value);
        }
    }
    q.value *= sign;
    const std::size_t unit = skip_blanks(s, end);
    const auto follows = [&](std::string_view name) {
        if (s.substr(unit, name.size()) != name) return false;
        const std::size_t behind = unit + name.size();
        if (is_letter(name.back()) && behind < s.size() && is_letter(s[behind])) return false;
        end = behind;
        return true;
    };
    if (follows("MM")) {
        q.unit = Unit::Millimetre;
    } else if (follows("INCHES") || follows("INCH") || follows("IN") || follows("\"") ||
               follows("''")) {
        q.unit = Unit::Inch;
    } else if (follows("DEGREES") || follows("DEGREE") || follows("DEG") || follows("\xC2\xB0") ||
               follows("\xB0") || follows("'")) {
        q.unit = Unit::Degree;
    }
    q.end = end;
    return q;
}

bool is_sane_length(double mm) {
    return std::isfinite(mm) && mm > 1e-6 && mm < 1e6;
}

std::string quoted(std::string_view s) {
    std::string result;
    result.reserve(s.size() + 2);
    result.push_back('\'');
    result.append(s);
    result.push_back('\'');
    return result;
}

std::string number(double value) {
    // Rounded to 1e-6, a nanometre in mm; this removes -0 and rounding errors.
    return shortest(std::round(value * 1e6) / 1e6 + 0.0);
}

}  // namespace ncsim::toolpath::text
