// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests PLY files byte by byte.
#include "ncsim/export/ply.h"

#include "box_part.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const Provenance& provenance) {
    std::ostringstream out;
    write_ply(out, boundary, provenance);
    return out.str();
}

template <typename T>
T at(const std::string& bytes, std::size_t position) {
    T value{};
    std::memcpy(&value, &bytes[position], sizeof value);
    return value;
}

TEST(WritePly, WritesPointsInDoublesAndFacesWithTheirLine) {
    cda::Boundary triangle;
    triangle.vertices = {{0.1, 0, -0.0}, {1, 0, 0}, {0, 1.0 / 3.0, 0}};
    triangle.faces = {{{0, 0, 1}, 0, cda::Origin{1}, 0, {{0, 1, 2}}}};
    const std::string bytes = written(triangle, {{{}, {1234567, 8}}, "a\nb.nc"});
    const std::size_t body = bytes.find("end_header\n") + 11;
    EXPECT_NE(bytes.find("comment made by ncsim from a\xEF\xBF\xBD"
                         "b.nc\n"),
              std::string::npos);
    ASSERT_EQ(bytes.size(), body + 3 * 24 + 4 + 3 * 4 + 4 + 4 + 3);
    EXPECT_EQ(at<double>(bytes, body), 0.1);
    EXPECT_EQ(at<std::uint64_t>(bytes, body + 16), 0U);  // no -0
    EXPECT_EQ(at<double>(bytes, body + 56), 1.0 / 3.0);
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 72), 3U);
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 84), 2U);
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 88), 1234567U);
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 92), 8U);
}

TEST(WritePly, CountsThePiecesOfFacesWithHoles) {
    const std::string bytes = written(test::plate_with_hole(), {});
    EXPECT_NE(bytes.find("element vertex 16\n"), std::string::npos);
    EXPECT_NE(bytes.find("element face 24\n"), std::string::npos);
}

TEST(WritePly, AnEmptyPartIsAHeader) {
    const std::string bytes = written({}, {});
    EXPECT_NE(bytes.find("element vertex 0\n"), std::string::npos);
    EXPECT_EQ(bytes.substr(bytes.size() - 11), "end_header\n");
}

TEST(WritePly, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_ply(out, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
