// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrays of pages, read back as page/arrays.js reads them.
#include "page_arrays.h"

#include "../support/random.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ncsim::report {
namespace {

std::string from_base64(const std::string& text) {
    static const std::string kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<unsigned>(kDigits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xffU);
    }
    return bytes;
}

std::string inflated(const std::string& text, std::size_t size) {
    const std::string bytes = from_base64(text);
    std::string result(size + 1, '\0');
    uLongf length = result.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                         reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
              Z_OK);
    EXPECT_EQ(length, size);
    result.resize(size);
    return result;
}

std::vector<std::uint32_t> unpacked(const std::string& text, std::size_t count,
                                    std::size_t stride) {
    const std::string bytes = inflated(text, 4 * count);
    std::vector<std::uint32_t> numbers(count);
    std::size_t at = 0;
    for (std::size_t column = 0; column < stride; ++column) {
        std::uint32_t last = 0;
        for (std::size_t i = column; i < count; i += stride, ++at) {
            std::uint32_t word = 0;
            for (std::size_t byte = 0; byte < 4; ++byte)
                word |= std::uint32_t{static_cast<unsigned char>(bytes[byte * count + at])}
                        << 8 * byte;
            last += (word >> 1U) ^ (0U - (word & 1U));
            numbers[i] = last;
        }
    }
    return numbers;
}

TEST(PageArrays, Base64HasItsPadding) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(PageArrays, NumbersComeBackForAnyStride) {
    test::Random random(11);
    for (const std::size_t stride : {1U, 3U, 6U}) {
        std::vector<std::uint32_t> numbers;
        numbers.reserve(6 * 50);
        for (std::size_t i = 0; i < 6 * 50; ++i) {
            const auto step = static_cast<std::uint32_t>(random.between(-20, 20));
            numbers.push_back(i < stride || random.one_in(20)
                                  ? static_cast<std::uint32_t>(random.next())
                                  : numbers[i - stride] + step);
        }
        EXPECT_EQ(unpacked(packed(numbers, stride), numbers.size(), stride), numbers);
    }
    EXPECT_TRUE(unpacked(packed({}), 0, 1).empty());
    const std::vector<std::uint32_t> extremes{0, 0xffffffff, 0x80000000, 0x7fffffff, 0};
    EXPECT_EQ(unpacked(packed(extremes), extremes.size(), 1), extremes);
}

TEST(PageArrays, SmallStepsNeedFewBytes) {
    std::vector<std::uint32_t> line;
    line.reserve(30'000);
    for (std::uint32_t i = 0; i < 30'000; ++i)
        line.push_back(1'000'000 + 7 * i);
    EXPECT_LT(packed(line).size(), 1000U) << "of 120,000 bytes";
}

TEST(PageArrays, TextComesBack) {
    const std::string text = "G1 X10\nG1 X20\n\xff\x01";
    EXPECT_EQ(inflated(packed_text(text), text.size()), text);
    EXPECT_EQ(inflated(packed_text(""), 0), "");
}

TEST(PageArrays, PositionsAreTenthsOfAMicrometre) {
    std::vector<std::uint32_t> numbers;
    append_position(numbers, {1.00004, -2.0, 0.00006});
    append_direction(numbers, {1.0, -0.5, 0.0});
    const auto minus = [](std::uint32_t n) { return static_cast<std::uint32_t>(-n); };
    EXPECT_EQ(numbers,
              (std::vector<std::uint32_t>{10'000, minus(20'000), 1, 32'767, minus(16'384), 0}));
}

}  // namespace
}  // namespace ncsim::report
