// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests PLY files byte by byte.
#include "ncsim/export/ply.h"

#include "ncsim/cda/triangulate.h"

#include "support/box_part.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    std::ostringstream out;
    write_ply(out, boundary, cda::triangulate(boundary), provenance);
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
    ASSERT_EQ(bytes.size(), body + 3 * 24 + 1 + 3 * 4 + 4 + 4 + 3);
    EXPECT_EQ(at<double>(bytes, body), 0.1);
    EXPECT_EQ(at<std::uint64_t>(bytes, body + 16), 0U);  // no -0
    EXPECT_EQ(at<double>(bytes, body + 56), 1.0 / 3.0);
    EXPECT_EQ(at<std::uint8_t>(bytes, body + 72), 3U);
    EXPECT_EQ((std::array{at<std::int32_t>(bytes, body + 73), at<std::int32_t>(bytes, body + 77),
                          at<std::int32_t>(bytes, body + 81)}),
              (std::array{2, 0, 1}));
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 85), 1234567U);
    EXPECT_EQ(at<std::uint32_t>(bytes, body + 89), 8U);
}

// FreeCAD drops all faces of a file with a quadrilateral; openctm keeps a triangle of each.
TEST(WritePly, HasTrianglesOnly) {
    const std::string bytes = written(test::plate_with_hole(), {});
    EXPECT_NE(bytes.find("element vertex 16\n"), std::string::npos);
    EXPECT_NE(bytes.find("element face 32\nproperty list uchar int vertex_indices\n"),
              std::string::npos);
    constexpr std::size_t kRecord = 1 + 3 * 4 + 4 + 4 + 3;
    const std::size_t body = bytes.find("end_header\n") + 11 + std::size_t{16} * 24;
    ASSERT_EQ(bytes.size(), body + 32 * kRecord);
    for (std::size_t at = body; at < bytes.size(); at += kRecord)
        EXPECT_EQ(bytes[at], '\x03');
}

TEST(WritePly, AnEmptyPartIsAHeader) {
    const std::string bytes = written({}, {});
    EXPECT_NE(bytes.find("element vertex 0\n"), std::string::npos);
    EXPECT_EQ(bytes.substr(bytes.size() - 11), "end_header\n");
}

TEST(WritePly, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_ply(out, {}, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
