// SPDX-License-Identifier: GPL-3.0-or-later
//
// That the files are valid is for the Khronos validator to say (gltf/validate.mjs).
#include "ncsim/export/gltf.h"

#include "box_part.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

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
