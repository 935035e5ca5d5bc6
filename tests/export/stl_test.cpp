// SPDX-License-Identifier: GPL-3.0-or-later
#include "ncsim/export/stl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

std::string written(const cda::TriangleMesh& mesh) {
    std::ostringstream out;
    write_stl(out, mesh);
    return out.str();
}

float float_at(const std::string& bytes, std::size_t at) {
    float value = 0;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
}

constexpr std::size_t kHeader = 84;
constexpr std::size_t kTriangle = 50;

TEST(WriteStl, WritesTheTriangleAndItsNormal) {
    const std::string bytes = written({{{0, 0, 2}, {3, 0, 2}, {0, 4.5, 2}}, {{0, 1, 2}}, {0}});
    ASSERT_EQ(bytes.size(), kHeader + kTriangle);
    EXPECT_EQ(bytes[80], 1);
    const std::array<float, 12> expected{0, 0, 1, 0, 0, 2, 3, 0, 2, 0, 4.5, 2};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(float_at(bytes, kHeader + 4 * i), expected[i]) << i;
    }
}

TEST(WriteStl, DoesNotBeginLikeTheTextForm) {
    EXPECT_NE(written({}).substr(0, 5), "solid");
}

TEST(WriteStl, AMeshWithoutTrianglesIsAHeader) {
    EXPECT_EQ(written({}).size(), kHeader);
    EXPECT_EQ(written({}).substr(80), std::string(4, '\0'));
}

TEST(WriteStl, KeepsTrianglesThatVanishInFloats) {
    const std::string bytes =
        written({{{1e6, 0, 0}, {1e6, 1, 0}, {1e6 + 1e-9, 1, 0}}, {{0, 1, 2}}, {0}});
    ASSERT_EQ(bytes.size(), kHeader + kTriangle);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(float_at(bytes, kHeader + 4 * i), 0.0F);
}

TEST(WriteStl, KnowsOnlyOneZero) {
    const std::string bytes =
        written({{{-0.0, 0, -0.0}, {1, 0, 0}, {0, 1, -1e-300}}, {{0, 1, 2}}, {0}});
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_FALSE(std::signbit(float_at(bytes, kHeader + 4 * i))) << i;
    }
}

TEST(WriteStl, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_stl(out, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
