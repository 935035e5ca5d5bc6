// SPDX-License-Identifier: GPL-3.0-or-later
//
// Packs arrays for pages. Differences of neighbours are small, so most high bytes are zero.
#include "page_arrays.h"

#include <zlib.h>

#include <cmath>
#include <stdexcept>

namespace ncsim::report {

namespace {

constexpr double kUnitVector = 32767.0;
// Level of zlib. Level 6 takes three times the time, and saves a tenth of the bytes.
constexpr int kLevel = 3;

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string result(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()),
                                 static_cast<uLong>(bytes.size()), kLevel);
    if (status != Z_OK) throw std::runtime_error("the page cannot be compressed: zlib failed");
    result.resize(size);
    return result;
}

std::uint32_t integer(double value) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::llround(value)));
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
        }
    }
    return out;
}

std::string packed(std::span<const std::uint32_t> numbers, std::size_t stride) {
    const std::size_t count = numbers.size();
    std::string bytes(4 * count, '\0');
    std::size_t at = 0;
    for (std::size_t column = 0; column < stride; ++column) {
        std::uint32_t last = 0;
        for (std::size_t i = column; i < count; i += stride, ++at) {
            const std::uint32_t difference = numbers[i] - last;
            last = numbers[i];
            // The sign in the lowest bit, so that small differences have zeros in the high bytes.
            const std::uint32_t sign = difference >> 31U;
            const std::uint32_t word = (difference << 1U) ^ (0U - sign);
            for (std::size_t byte = 0; byte < 4; ++byte)
                bytes[byte * count + at] = static_cast<char>(word >> (8 * byte) & 0xffU);
        }
    }
    return base64(compressed(bytes));
}

std::string packed_text(const std::string& text) {
    return base64(compressed(text));
}

void append_position(std::vector<std::uint32_t>& numbers, const cda::Vec3& position) {
    for (const double c : {position.x, position.y, position.z})
        numbers.push_back(integer(c / kPageUnit));
}

void append_direction(std::vector<std::uint32_t>& numbers, const cda::Vec3& direction) {
    for (const double c : {direction.x, direction.y, direction.z})
        numbers.push_back(integer(kUnitVector * c));
}

}  // namespace ncsim::report
