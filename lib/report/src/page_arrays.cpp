// SPDX-License-Identifier: GPL-3.0-or-later
//
// Packs arrays for pages. Differences of neighbours are small, so most high bytes are zero.
#include "page_arrays.h"

#include <nettle/base64.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace ncsim::report {

namespace {

constexpr double kUnitVector = 32767.0;
// Level of zlib for texts. Level 6 takes three times the time, and saves a tenth of the bytes.
constexpr int kTextLevel = 3;

// `strategy`: of zlib.
std::string compressed(const std::string& bytes, int level, int strategy) {
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, strategy) != Z_OK)
        throw std::runtime_error("the page cannot be compressed: zlib failed");
    std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    // Counts of zlib have 32 bits.
    constexpr std::size_t kMost = std::size_t{1} << 30U;
    std::size_t read = 0, written = 0;
    int status = Z_OK;
    while (status == Z_OK) {
        const std::size_t in = std::min(kMost, bytes.size() - read);
        const std::size_t out = std::min(kMost, result.size() - written);
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())) + read;
        stream.avail_in = static_cast<uInt>(in);
        stream.next_out = reinterpret_cast<Bytef*>(result.data()) + written;
        stream.avail_out = static_cast<uInt>(out);
        status = deflate(&stream, read + in == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
        read += in - stream.avail_in;
        written += out - stream.avail_out;
    }
    deflateEnd(&stream);
    if (status != Z_STREAM_END)
        throw std::runtime_error("the page cannot be compressed: zlib failed");
    result.resize(written);
    return result;
}

std::uint32_t integer(double value) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::llround(value)));
}

}  // namespace

std::string base64(std::string_view bytes) {
    std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(text.data(), bytes.size(),
                      reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return text;
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
    // Differences repeat as runs of zeros alone; a search for other repetitions takes twice the
    // time and saves no bytes.
    return base64(compressed(bytes, 1, Z_RLE));
}

std::string packed_text(const std::string& text) {
    return base64(compressed(text, kTextLevel, Z_DEFAULT_STRATEGY));
}

void append_position(std::vector<std::uint32_t>& numbers, const Vec3& position) {
    for (const double c : {position.x, position.y, position.z})
        numbers.push_back(integer(c / kPageUnit));
}

void append_direction(std::vector<std::uint32_t>& numbers, const Vec3& direction) {
    for (const double c : {direction.x, direction.y, direction.z})
        numbers.push_back(integer(kUnitVector * c));
}

}  // namespace ncsim::report
