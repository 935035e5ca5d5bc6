// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests glTF files. The Khronos validator checks that the files are valid (gltf/validate.mjs).
#include "ncsim/export/gltf.h"

#include "ncsim/cda/triangulate.h"

#include "support/box_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::exporter {
namespace {

std::string written(const cda::Boundary& boundary, const mesh::Provenance& provenance) {
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
    auto part = test::grooved_part();  // 60 × 40 × 20 mm, with the centre at 30 20 10
    part.shift = {100, 0, 0};
    const std::string glb = written(test::boundary_of(part), test::provenance_of(part));
    EXPECT_TRUE(has(glb, R"("scale":[0.001,0.001,0.001])"));
    EXPECT_TRUE(has(glb, R"("translation":[0.13,0.01,-0.02])"));
    EXPECT_TRUE(has(glb, R"("max":[30.0,20.0,10.0])"));
}

struct Corner {
    std::array<float, 3> position{}, normal{};
    float line = 0.0F;
    auto operator<=>(const Corner&) const = default;
};

struct ReadPrimitive {
    std::vector<Corner> vertices;
    std::vector<std::uint32_t> indices;
};

// Returns the primitives of the only mesh of a file.
std::vector<ReadPrimitive> primitives_of(const std::string& glb) {
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    std::uint32_t length = 0;
    std::memcpy(&length, &glb[kHeader], sizeof length);
    const auto json = nlohmann::json::parse(glb.substr(kHeader + kChunkHeader, length));
    const std::size_t buffer = kHeader + kChunkHeader + length + kChunkHeader;
    // Passes each element of an accessor, of `size` bytes, to `put`.
    const auto read = [&](int accessor, std::size_t size, const auto& put) {
        const auto& a = json["accessors"][accessor];
        const auto& view = json["bufferViews"][a["bufferView"].get<int>()];
        const std::size_t begin = buffer + view.value("byteOffset", std::size_t{0}) +
                                  a.value("byteOffset", std::size_t{0});
        for (std::size_t i = 0; i < a["count"].get<std::size_t>(); ++i)
            put(i, &glb[begin + i * size]);
    };
    std::vector<ReadPrimitive> all;
    for (const auto& from : json["meshes"][0]["primitives"]) {
        ReadPrimitive& to = all.emplace_back();
        const auto& attributes = from["attributes"];
        read(attributes["POSITION"], 12, [&](std::size_t, const char* bytes) {
            std::memcpy(to.vertices.emplace_back().position.data(), bytes, 12);
        });
        read(attributes["NORMAL"], 12, [&](std::size_t i, const char* bytes) {
            std::memcpy(to.vertices.at(i).normal.data(), bytes, 12);
        });
        read(attributes["_NC_LINE"], 4, [&](std::size_t i, const char* bytes) {
            std::memcpy(&to.vertices.at(i).line, bytes, 4);
        });
        // Indices are little-endian, in two bytes or four.
        constexpr int kUnsignedShort = 5123;
        const bool is_short =
            json["accessors"][from["indices"].get<int>()]["componentType"] == kUnsignedShort;
        read(from["indices"], is_short ? 2 : 4, [&](std::size_t, const char* bytes) {
            std::memcpy(&to.indices.emplace_back(), bytes, is_short ? 2 : 4);
        });
    }
    return all;
}

// Returns the normals that are written for a roof of two slopes with `rise` over 1, cut by `tool`.
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
    // The last primitive belongs to the tool.
    const ReadPrimitive of_tool = primitives_of(written(b, {{{}, {5, tool}}, ""})).back();
    std::vector<std::array<float, 3>> normals;
    for (const Corner& corner : of_tool.vertices)
        normals.push_back(corner.normal);
    return normals;
}

TEST(WriteGltf, ShadesGentleBendsOfOneToolAsRound) {
    // At the ridge the two normals, 2 × 10° apart, average to the vertical, so both slopes share
    // the ridge's two vertices. At the eaves the normals stay.
    const auto normals = roof_normals(0.176, 3);
    EXPECT_EQ(normals.size(), 6U);
    EXPECT_EQ(std::count(normals.begin(), normals.end(), std::array{0.0F, 0.0F, 1.0F}), 2);
}

TEST(WriteGltf, ShadesWhatAToolWithoutANumberCutAsAnyOther) {
    EXPECT_EQ(roof_normals(0.176, 0), roof_normals(0.176, 3));
}

TEST(WriteGltf, HasAMaterialForAToolWithoutANumber) {
    auto part = test::grooved_part();
    mesh::Provenance lines = test::provenance_of(part);
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
    EXPECT_EQ(normals.size(), 8U);
    EXPECT_EQ(std::count(normals.begin(), normals.end(), std::array{0.0F, 0.0F, 1.0F}), 0);
}

// Equal corners are a single vertex, and each triangle keeps its corners.
TEST(WriteGltf, CornersWithOneNormalAndOneLineAreOneVertex) {
    for (const auto& part : {test::grooved_part(), test::raster_part().tilted()}) {
        const cda::Boundary boundary = test::boundary_of(part);
        const mesh::Provenance provenance = test::provenance_of(part);
        std::size_t triangles = 0;
        std::set<float> lines;
        for (const ReadPrimitive& primitive : primitives_of(written(boundary, provenance))) {
            const std::set<Corner> different(primitive.vertices.begin(), primitive.vertices.end());
            EXPECT_EQ(different.size(), primitive.vertices.size());
            EXPECT_LT(primitive.vertices.size(), primitive.indices.size());
            triangles += primitive.indices.size() / 3;
            for (const Corner& corner : different)
                lines.insert(corner.line);
            // All corners of a triangle are of the same face.
            for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
                const Corner& first = primitive.vertices.at(primitive.indices[i]);
                for (std::size_t k = 1; k < 3; ++k) {
                    const Corner& other = primitive.vertices.at(primitive.indices[i + k]);
                    EXPECT_EQ(other.line, first.line);
                    EXPECT_EQ(other.normal, first.normal);  // boxes have no gentle bends
                }
            }
        }
        EXPECT_EQ(triangles, cda::triangulate(boundary).triangles.size());
        EXPECT_GT(lines.size(), 4U);
    }
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
