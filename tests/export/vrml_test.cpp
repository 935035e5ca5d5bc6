// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests VRML text: groups, polygons and quoted names.
#include "ncsim/export/vrml.h"

#include "support/box_part.h"
#include "support/count.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
    std::ostringstream out;
    write_vrml(out, boundary, provenance);
    return out.str();
}

// Returns a square pyramid: a polygon of stock, and four triangles cut by the lines 7 and 9.
cda::Boundary pyramid() {
    cda::Boundary b;
    b.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1.5}};
    b.faces = {{{0, 0, -1}, 0, cda::kStockOrigin, 0, {{3, 2, 1, 0}}},
               {{0, -0.83, 0.55}, 0, cda::Origin{1}, 0, {{0, 1, 4}}},
               {{0.83, 0, 0.55}, 1.6, cda::Origin{2}, 0, {{1, 2, 4}}},
               {{0, 0.83, 0.55}, 1.6, cda::Origin{1}, 0, {{2, 3, 4}}},
               {{-0.83, 0, 0.55}, 0, cda::Origin{2}, 0, {{3, 0, 4}}}};
    b.shells = 1;
    return b;
}

mesh::Provenance pyramid_lines() {
    return {{{}, {9, 4}, {7, 4}}, "pyramid.nc"};
}

TEST(WriteVrml, GroupsFacesByLineAndKeepsPolygons) {
    EXPECT_EQ(written(pyramid(), pyramid_lines()), R"(#VRML V2.0 utf8
WorldInfo { title "pyramid.nc" info [ "made by ncsim" "unit: mm, z up" ] }
DEF STOCK Group { children [
Shape {
appearance DEF STOCK_LOOK Appearance { material Material { diffuseColor 0.588 0.611 0.643 specularColor 0.2 0.2 0.2 } }
geometry IndexedFaceSet { coord Coordinate { point [
0 2 0
2 2 0
2 0 0
0 0 0
] }
coordIndex [
0 1 2 3 -1
] } }
] }
DEF LINE_7 Group { children [
Shape {
appearance DEF TOOL_4 Appearance { material Material { diffuseColor 0.494 0.713 0.886 specularColor 0.2 0.2 0.2 } }
geometry IndexedFaceSet { coord Coordinate { point [
2 0 0
2 2 0
1 1 1.5
0 2 0
0 0 0
] }
coordIndex [
0 1 2 -1
3 4 2 -1
] } }
] }
DEF LINE_9 Group { children [
Shape {
appearance USE TOOL_4
geometry IndexedFaceSet { coord Coordinate { point [
0 0 0
2 0 0
1 1 1.5
2 2 0
0 2 0
] }
coordIndex [
0 1 2 -1
3 4 2 -1
] } }
] }
)");
}

TEST(WriteVrml, AToolWithoutANumberDoesNotLookLikeTheStock) {
    const std::string text = written(pyramid(), {{{}, {9, 0}, {7, 4}}, "pyramid.nc"});
    EXPECT_NE(text.find("DEF STOCK_LOOK Appearance { material Material { diffuseColor 0.588 0.611 "
                        "0.643"),
              std::string::npos);
    EXPECT_NE(text.find("DEF TOOL_0 Appearance"), std::string::npos);
    EXPECT_NE(text.find("DEF TOOL_4 Appearance { material Material { diffuseColor 0.494 0.713 "
                        "0.886"),
              std::string::npos);
}

TEST(WriteVrml, AnEmptyPartIsAWorldWithoutShapes) {
    EXPECT_EQ(written({}, {}),
              "#VRML V2.0 utf8\n"
              "WorldInfo { title \"\" info [ \"made by ncsim\" \"unit: mm, z up\" ] }\n");
}

std::size_t polygons(const std::string& text) {
    return ncsim::test::count(text, "-1\n");
}

TEST(WriteVrml, CutsFacesWithHolesIntoTriangles) {
    const std::string text = written(test::plate_with_hole(), {{{}, {20, 3}}, "plate.nc"});
    // Each of the 2 faces with 8 corners and 1 hole becomes 8 triangles; 8 squares stay.
    EXPECT_EQ(polygons(text), 16U + 8U);
}

// Returns a prism of height 1: the bottom, the top, and a side for each corner.
cda::Boundary prism(const std::vector<std::array<double, 2>>& outline) {
    cda::Boundary b;
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : outline)
            b.vertices.push_back({x, y, z});
    }
    b.faces.push_back({{0, 0, -1}, 0.0, cda::kStockOrigin, 0, {{}}});
    b.faces.push_back({{0, 0, 1}, 1.0, cda::kStockOrigin, 0, {{}}});
    for (std::uint32_t i = 0; i < n; ++i) {
        b.faces[0].loops[0].push_back(n - 1 - i);
        b.faces[1].loops[0].push_back(n + i);
        const std::uint32_t j = (i + 1) % n;
        const Vec3 along = b.vertices[j] - b.vertices[i];
        b.faces.push_back({normalized({along.y, -along.x, 0}),
                           0.0,
                           cda::kStockOrigin,
                           0,
                           {{i, j, j + n, i + n}}});
    }
    return b;
}

// three.js draws a polygon as a fan from its first corner.
TEST(WriteVrml, CutsConcaveFacesIntoTriangles) {
    const auto ell = prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});
    EXPECT_EQ(polygons(written(ell, {})), 2U * 4U + 6U);
}

TEST(WriteVrml, CutsFacesThatTouchThemselvesIntoTriangles) {
    // The notch reaches the lower edge.
    const auto notched = prism({{0, 0}, {4, 0}, {4, 3}, {2, 1e-9}, {0, 3}});
    EXPECT_EQ(polygons(written(notched, {})), 3U + 3U + 5U);
}

TEST(WriteVrml, QuotesTheNameOfTheProgram) {
    mesh::Provenance provenance;
    provenance.program = "a\"b\\c\nd\xFF.nc";
    EXPECT_NE(written({}, provenance)
                  .find("title \"a\\\"b\\\\c\xEF\xBF\xBD"
                        "d\xEF\xBF\xBD.nc\""),
              std::string::npos);
}

TEST(WriteVrml, SaysTheSameTwice) {
    const auto part = test::grooved_part().tilted();
    const auto boundary = test::boundary_of(part);
    EXPECT_EQ(written(boundary, test::provenance_of(part)),
              written(boundary, test::provenance_of(part)));
}

TEST(WriteVrml, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_vrml(out, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
