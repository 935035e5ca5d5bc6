// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of ncsim run is shaded by the surfaces that tools leave (tests/simulation checks which
// surfaces).
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

// A slot with two walls along X.
const std::string kSlot =
    "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,0.)\n"
    "G21 G90 T1 M6 S5000 M3\nG0 X20 Y30 Z25\nG1 Z10 F300\nX60\nG0 Z25\nM30\n";

// Returns the normals of all faces that tool 1 cut.
std::vector<std::array<float, 3>> normals_of(const std::string& glb) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, &glb[at], sizeof value);
        return value;
    };
    static_assert(std::endian::native == std::endian::little);
    const std::size_t length = word(12), bytes = 20 + length + 8;
    const json model = json::parse(glb.substr(20, length));
    std::vector<std::array<float, 3>> normals;
    for (const json& primitive : model["meshes"][0]["primitives"]) {
        if (model["materials"][primitive["material"].get<std::size_t>()]["name"] != "T1") continue;
        const json& accessor =
            model["accessors"][primitive["attributes"]["NORMAL"].get<std::size_t>()];
        const json& view = model["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        normals.resize(accessor["count"]);
        std::memcpy(normals.data(), &glb[bytes + view.value("byteOffset", std::size_t{0})],
                    12 * normals.size());
    }
    return normals;
}

TEST(Shading, WallsOfASlotStayFlatAndItsEndsBeginAsTheyEnd) {
    for (const char* tolerance : {"0.05", "0.5"}) {
        SCOPED_TRACE(tolerance);
        Folder folder;
        folder.write("slot.nc", kSlot);
        const Ran ran =
            folder.run({"run", "slot.nc", "-q", "--gltf", "a.glb", "--tool-tolerance", tolerance});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        int flat = 0, touching = 0;
        for (const auto& [x, y, z] : normals_of(folder.read("a.glb"))) {
            EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), 1.0F, 1e-6F);
            if (z == 0.0F && x == 0.0F && std::abs(y) == 1.0F) {
                ++flat;
            } else if (std::abs(z) < 1e-6F && std::abs(x) < 1e-3F) {
                ++touching;
            }
        }
        // Each wall, and the adjacent faces at both ends of the wall.
        EXPECT_EQ(flat, 8);
        EXPECT_EQ(touching, 8);
    }
}

// Curves are often chains of short lines: where two planar walls meet at 10°, the shading treats
// both as one surface.
TEST(Shading, WallsOfShortLinesAreOneSurface) {
    Folder folder;
    folder.write("bend.nc",
                 "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,80.,60.,20.,0.,0.,0.)\n"
                 "G21 G90 T1 M6 S5000 M3\nG0 X-10 Y30 Z25\nG1 Z10 F300\nX40\n"
                 "X90 Y38.816\nG0 Z25\nM30\n");
    const Ran ran = folder.run({"run", "bend.nc", "-q", "--gltf", "a.glb"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    int between = 0;
    for (const auto& [x, y, z] : normals_of(folder.read("a.glb"))) {
        // The sine of 5°, because both walls have about equal areas.
        if (std::abs(z) < 1e-6F && y < 0.0F && std::abs(std::abs(x) - 0.0872F) < 0.003F) ++between;
    }
    EXPECT_EQ(between, 4);
}

}  // namespace
}  // namespace ncsim::cli_test
