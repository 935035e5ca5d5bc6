// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part in tiles as a folder of meshes: each mesh is open, the union of all meshes is closed.
#include "cli/run_program.h"
#include "support/written_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

void cut_tiles(const Folder& folder, const Words& program, int of) {
    std::filesystem::remove_all(folder.path() / "tiles");
    for (int i = 0; i < of; ++i) {
        Words words{"run", "--tile", fmt::format("{}/{}", i, of), "--tile-out", "tiles", "-q"};
        words.insert(words.end(), program.begin(), program.end());
        ASSERT_EQ(folder.run(words).exit_code, 0);
    }
}

// Joins all meshes and merges equal corners.
test::WrittenMesh joined(const std::vector<test::WrittenMesh>& meshes) {
    std::map<std::array<float, 3>, std::uint32_t> number;
    for (const test::WrittenMesh& mesh : meshes) {
        for (const auto& point : mesh.points)
            number.emplace(point, 0U);
    }
    test::WrittenMesh all;
    for (auto& [point, n] : number) {
        n = static_cast<std::uint32_t>(all.points.size());
        all.points.push_back(point);
    }
    for (const test::WrittenMesh& mesh : meshes) {
        for (auto triangle : mesh.triangles) {
            for (std::uint32_t& corner : triangle)
                corner = number.at(mesh.points[corner]);
            all.triangles.push_back(triangle);
        }
    }
    return all;
}

// Returns the number of directed edges without partner. Touching surfaces may use an edge more than
// once, equally often in both directions.
std::size_t open_edges(const test::WrittenMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> net;
    for (const auto& corners : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
            ++net[{from, to}];
            --net[{to, from}];
        }
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : net)
        open += count > 0 ? static_cast<std::size_t>(count) : 0;
    return open;
}

// Returns the meshes that mold.json names, after checking the data in mold.json.
std::vector<test::WrittenMesh> meshes_of(const Folder& folder) {
    std::vector<test::WrittenMesh> meshes;
    const json list = json::parse(folder.read("mold.json"));
    for (const json& file : list["files"]) {
        const std::string name = file["file"].get<std::string>();
        EXPECT_EQ(folder.shell("sha256sum < " + name).out.substr(0, 64), file["sha256"]);
        meshes.push_back(test::read_glb(folder.read(name)));
        const test::WrittenMesh& mesh = meshes.back();
        EXPECT_EQ(open_edges(mesh), file["open_edges"].get<std::size_t>()) << name;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::ranges::minmax(
                mesh.points, {}, [&](const auto& point) { return point[axis]; });
            const double centre = list["centre"][axis].get<double>();
            EXPECT_NEAR(centre + static_cast<double>(low[axis]),
                        file["box"]["min"][axis].get<double>(), 1e-4);
            EXPECT_NEAR(centre + static_cast<double>(high[axis]),
                        file["box"]["max"][axis].get<double>(), 1e-4);
        }
    }
    return meshes;
}

TEST(TileMeshes, AreClosedTogether) {
    const Folder folder;
    for (const char* name : {"complex.nc", "wave.nc"}) {
        std::ifstream in(std::filesystem::path(NCSIM_SOURCE_DIR) / "samples" / name);
        std::ostringstream text;
        text << in.rdbuf();
        folder.write(name, text.str());
    }
    for (const auto& [program, of] : {std::pair<Words, int>{{"complex.nc"}, 1},
                                      {{"complex.nc"}, 7},
                                      {{"wave.nc", "--tool-tolerance", "0.3"}, 16}}) {
        SCOPED_TRACE(program[0]);
        cut_tiles(folder, program, of);
        Words run{"run", "-q", "--gltf", "whole.glb"};
        run.insert(run.end(), program.begin(), program.end());
        ASSERT_EQ(folder.run(run).exit_code, 0);
        const test::Soundness whole = test::soundness(test::read_glb(folder.read("whole.glb")));
        const Ran ran =
            folder.run({"merge", "tiles", "-q", "--gltf", "mold/", "--report", "a.json"});
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        const std::vector<test::WrittenMesh> meshes = meshes_of(folder);
        EXPECT_EQ(meshes.size() > 1, of > 1);
        const test::WrittenMesh together = joined(meshes);
        EXPECT_EQ(open_edges(together), 0U);
        const test::Soundness all = test::soundness(together);
        EXPECT_EQ(all.repeated, 0U) << test::to_string(all);
        EXPECT_NEAR(all.area, whole.area, 1e-4 * whole.area);
        EXPECT_NEAR(all.volume, whole.volume, 1e-4 * whole.volume);
        // A second merge; the report equals the report of a single run.
        const std::string list = folder.read("mold.json");
        ASSERT_EQ(
            folder.run({"merge", "tiles", "-q", "--gltf", "mold", "--threads", "1"}).exit_code, 0);
        EXPECT_EQ(folder.read("mold.json"), list);
        run[3] = "again.glb";
        run.insert(run.end(), {"--report", "b.json"});
        ASSERT_EQ(folder.run(run).exit_code, 0);
        EXPECT_EQ(folder.read("a.json"), folder.read("b.json"));
        std::filesystem::remove_all(folder.path() / "mold");
    }
}

TEST(TileMeshes, AreListedOnlyWhereAllAreThere) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    cut_tiles(folder, {"slot.nc"}, 3);
    ASSERT_EQ(folder.run({"merge", "tiles", "-q", "--gltf", "mold/"}).exit_code, 0);
    ASSERT_TRUE(folder.has("mold.json"));
    // A folder has the name of the second mesh.
    std::filesystem::remove(folder.path() / "mold/0001.glb");
    std::filesystem::create_directories(folder.path() / "mold/0001.glb");
    EXPECT_EQ(folder.run({"merge", "tiles", "-q", "--gltf", "mold/"}).exit_code, 2);
    EXPECT_FALSE(folder.has("mold.json"));
    EXPECT_EQ(folder.files(), (Words{"mold", "slot.nc", "tiles"}));
    // Without tiles there is a single mesh.
    EXPECT_EQ(folder.run({"run", "slot.nc", "-q", "--gltf", "mold/"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
