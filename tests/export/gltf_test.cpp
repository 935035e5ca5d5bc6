// SPDX-License-Identifier: GPL-3.0-or-later
//
// That the files are valid is for the Khronos validator to say (gltf/validate.mjs).
#include "ncsim/export/gltf.h"

#include "box_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const Provenance& provenance) {
    std::ostringstream out;
    write_gltf(out, boundary, provenance);
    return out.str();
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(WriteGltf, HasAPrimitiveForEachToolAndTheNameOfTheProgram) {
    const auto part = test::grooved_part();
    const std::string glb = written(test::boundary_of(part), test::provenance_of(part));
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_TRUE(has(glb, R"("name":"stock")"));
    EXPECT_TRUE(has(glb, R"("name":"T1")"));
    EXPECT_TRUE(has(glb, R"("name":"T7")"));
    EXPECT_TRUE(has(glb, R"("program":"boxes.nc")"));
    EXPECT_TRUE(has(glb, R"("unit":"mm")"));
    EXPECT_TRUE(has(glb, "_NC_LINE"));
    EXPECT_TRUE(has(glb, "_TOOL"));
}

TEST(WriteGltf, TheNodeMovesTheCentreBackAndTurnsItUpright) {
    auto part = test::grooved_part();  // 60 × 40 × 20, so its centre is at 30 20 10
    part.shift = {100, 0, 0};
    const std::string glb = written(test::boundary_of(part), test::provenance_of(part));
    EXPECT_TRUE(has(glb, R"("scale":[0.001,0.001,0.001])"));
    EXPECT_TRUE(has(glb, R"("translation":[0.13,0.01,-0.02])"));
    EXPECT_TRUE(has(glb, R"("max":[30.0,20.0,10.0])"));
}

// A roof of two slopes that meet at `rise` over 1, cut by `tool`; the normals written for it.
std::vector<std::array<float, 3>> roof_normals(double rise, std::uint32_t tool) {
    cda::Boundary b;
    b.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {1, 0, rise}, {1, 3, rise}};
    const double s = 1.0 / std::sqrt(1.0 + rise * rise);
    const cda::Origin cut{1};
    b.faces = {{{0, 0, -1}, 0, cda::kStockOrigin, 0, {{3, 2, 1, 0}}},
               {{0, -1, 0}, 0, cda::kStockOrigin, 0, {{0, 1, 4}}},
               {{0, 1, 0}, 3, cda::kStockOrigin, 0, {{2, 3, 5}}},
               {{-rise * s, 0, s}, 0, cut, 0, {{0, 4, 5, 3}}},
               {{rise * s, 0, s}, 2 * rise * s, cut, 0, {{1, 2, 5, 4}}}};
    b.shells = 1;
    const std::string glb = written(b, {{{}, {5, tool}}, ""});
    // The last primitive is the tool's: 12 indices, then positions and normals of 8 vertices, 8
    // lines, 8 tools, and nothing after them.
    std::vector<std::array<float, 3>> normals(8);
    const std::size_t tail = 8 * (4 + 4) + 8 * 12;
    std::memcpy(normals.data(), &glb[glb.size() - tail], 8 * 12);
    return normals;
}

TEST(WriteGltf, ShadesGentleBendsOfOneToolAsRound) {
    // At the ridge the two normals of 2 × 10° average to straight up; at the eaves they stay.
    const auto normals = roof_normals(0.176, 3);
    EXPECT_EQ(std::count(normals.begin(), normals.end(), std::array{0.0F, 0.0F, 1.0F}), 4);
}

TEST(WriteGltf, ShadesWhatAToolWithoutANumberCutAsAnyOther) {
    EXPECT_EQ(roof_normals(0.176, 0), roof_normals(0.176, 3));
}

TEST(WriteGltf, HasAMaterialForAToolWithoutANumber) {
    auto part = test::grooved_part();
    Provenance lines = test::provenance_of(part);
    for (std::size_t i = 1; i < lines.entries.size(); ++i) {
        if (lines.entries[i].tool == 7) lines.entries[i].tool = 0;
    }
    const std::string glb = written(test::boundary_of(part), lines);
    EXPECT_TRUE(has(glb, R"("name":"stock")"));
    EXPECT_TRUE(has(glb, R"("name":"T0")"));
    EXPECT_TRUE(has(glb, R"("name":"T1")"));
}

TEST(WriteGltf, KeepsSharpEdges) {
    const auto normals = roof_normals(0.3, 3);  // 2 × 17°
    EXPECT_EQ(std::count(normals.begin(), normals.end(), std::array{0.0F, 0.0F, 1.0F}), 0);
}

TEST(WriteGltf, AnEmptyPartIsAnEmptyScene) {
    const std::string glb = written({}, {});
    EXPECT_TRUE(has(glb, "scenes"));
    EXPECT_FALSE(has(glb, "meshes"));
    EXPECT_FALSE(has(glb, "buffers"));
}

TEST(WriteGltf, SaysTheSameTwice) {
    const auto part = test::grooved_part().tilted();
    const auto boundary = test::boundary_of(part);
    EXPECT_EQ(written(boundary, test::provenance_of(part)),
              written(boundary, test::provenance_of(part)));
}

TEST(WriteGltf, TellsThatTheStreamFailed) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(write_gltf(out, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace ncsim::exporter
