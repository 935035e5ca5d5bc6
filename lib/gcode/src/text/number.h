// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of NC programs: a sign, digits, an optional point; "5.", ".5"; no exponent.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

namespace ncsim::gcode {

/// A number and its end in the text.
struct PlainNumber {
    double value = 0.0;
    const char* end = nullptr;  ///< End of the number; nullptr if there is no number.
};

/// Reads the number at `p`, correctly rounded; infinity if the number exceeds the range of double.
inline PlainNumber read_plain_number(const char* p, const char* end) {
    bool negative = false;
    if (p != end && (*p == '-' || *p == '+')) negative = *p++ == '-';
    const char* const first = p;
    std::uint64_t digits = 0;
    while (p != end && static_cast<unsigned char>(*p - '0') < 10) {
        digits = digits * 10 + static_cast<std::uint64_t>(*p++ - '0');
    }
    int count = static_cast<int>(p - first);
    int fraction = 0;
    if (p != end && *p == '.') {
        const char* const point = p++;
        while (p != end && static_cast<unsigned char>(*p - '0') < 10) {
            digits = digits * 10 + static_cast<std::uint64_t>(*p++ - '0');
        }
        fraction = static_cast<int>(p - point) - 1;
        count += fraction;
    }
    if (count == 0) return {};
    double value = 0.0;
    // Integers up to 15 digits and powers of ten up to 10^22 are exact in double, so a single
    // division rounds once.
    // Source: Clinger, "How to read floating point numbers accurately", 1990.
    if (count <= 15) {
        constexpr double kPowers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
        value = static_cast<double>(digits) / kPowers[fraction];
    } else {
        const std::from_chars_result read =
            std::from_chars(first, p, value, std::chars_format::fixed);
        // Out of range: a number below 1 underflows to 0; any other number exceeds the range of
        // double.
        if (read.ec == std::errc::result_out_of_range) {
            const char* digit = first;
            while (*digit == '0')
                ++digit;
            value = *digit == '.' ? 0.0 : std::numeric_limits<double>::infinity();
        }
    }
    return {negative ? -value : value, p};
}

}  // namespace ncsim::gcode
