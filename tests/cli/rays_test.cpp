// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rays: directions, stated error, and drafts that use rays.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

const std::string kBlock = "(STOCK/BLOCK,20.,20.,10.,0.,0.,10.)\nG21 G90 G17\nT1 M6\nS9000 M3\n";
const std::string kFlat = "(T1 D=6. CR=0. - flat end mill)\n" + kBlock;
const std::string kBall = "(T1 D=6. CR=3. - ball end mill)\n" + kBlock;
// Two slots with a rib of 0.2 mm between the slots.
const std::string kRib =
    "G0 X-5. Y5. Z5.\nG1 Z-3. F300.\nX25.\nG0 Z5.\nX-5. Y11.2\nG1 Z-3.\nX25.\n"
    "G0 Z20.\nM30\n";

TEST(Rays, GoAlongZAloneWhereNoToolHasAFlatEnd) {
    Folder folder;
    folder.write("ball.nc", kBall + kRib);
    folder.write("flat.nc", kFlat + kRib);
    folder.write("turn.nc", kBall + "G0 X-5. Y5. Z5.\nG1 Z-3. A10. F300.\nX25.\nM30\n");
    const auto rays_of = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"run", "--model",  "dexel", "--resolution",
                                     "0.5", "--report", "r.json"};
        all.insert(all.end(), words.begin(), words.end());
        const Ran ran = folder.run(all);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        const std::string rays = json::parse(folder.read("r.json"))["model"]["rays"];
        EXPECT_EQ(contains(ran.err, "along Z alone:"), rays == "z") << ran.err;
        return rays;
    };
    EXPECT_EQ(rays_of({"ball.nc"}), "z");
    EXPECT_EQ(rays_of({"ball.nc", "--rays", "xyz"}), "xyz");
    EXPECT_EQ(rays_of({"flat.nc"}), "xyz");
    EXPECT_EQ(rays_of({"flat.nc", "--rays", "z"}), "z");
    EXPECT_EQ(rays_of({"turn.nc"}), "xyz");
    const Ran ran = folder.run({"run", "turn.nc", "--model", "dexel", "--rays", "z"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "--rays z")) << ran.err;
    EXPECT_EQ(folder.run({"run", "flat.nc", "--rays", "z"}).exit_code, 2);
    EXPECT_EQ(folder.run({"run", "flat.nc", "--model", "dexel", "--rays", "y"}).exit_code, 2);
}

TEST(Rays, TellOfARibThatIsThinnerThanTheyAreApart) {
    Folder folder;
    folder.write("rib.nc", kFlat + kRib);
    const Ran ran = folder.run({"run", "rib.nc", "--model", "dexel", "--resolution", "0.5",
                                "--report", "r.json", "--stl", "r.stl"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "material thinner than 0.5 mm on")) << ran.out;
    const json report = json::parse(folder.read("r.json"));
    const json& thin = report["thinner_than_resolution"]["material"];
    EXPECT_EQ(thin["rays"].get<int>(), 40 * 6);
    EXPECT_NEAR(thin["thinnest"]["mm"].get<double>(), 0.2, 1e-4);
    EXPECT_NEAR(thin["thinnest"]["at"][1].get<double>(), 8.1, 1e-4);
    EXPECT_EQ(thin["thinnest"]["line"].get<int>(), 12);
    // Half a resolution times the area of the walls.
    EXPECT_GT(report["volume_mm3"]["error"].get<double>(), 1.0);
    const Ran fine = folder.run({"run", "rib.nc", "--model", "dexel", "--resolution", "0.1"});
    EXPECT_FALSE(contains(fine.out, "thinner")) << fine.out;
}

// Returns a program long enough that rays are faster, but quick to cut.
std::string long_program() {
    std::ostringstream text;
    text << kBall << "G0 X0 Y0 Z5.\nG1 F3000.\n";
    for (int i = 0; i < 200000; ++i)
        text << "X" << 0.001 * (i % 20000) << "Y" << 0.1 * (i / 1000) << "Z-" << 1 + i % 2 << "\n";
    text << "M30\n";
    return text.str();
}

TEST(Rays, AreChosenByALongDraftAndByNothingElse) {
    Folder folder;
    folder.write("long.nc", long_program());
    // Options as for drafts; the run stops early, so the exact model is fast, too.
    const auto model_of = [&](std::vector<std::string> words, std::string& said) {
        words.insert(words.begin(), {"run", "long.nc", "--at-line", "20", "--report", "r.json"});
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        said = ran.err;
        return json::parse(folder.read("r.json"))["model"]["name"].get<std::string>();
    };
    std::string said;
    EXPECT_EQ(model_of({}, said), "cda");
    EXPECT_TRUE(contains(said, "--model dexel shows them in a fraction of the time")) << said;
    EXPECT_EQ(model_of({"--draft"}, said), "dexel");
    EXPECT_TRUE(contains(said, "a draft of 200001 moves")) << said;
    EXPECT_EQ(model_of({"--draft", "--save-stock", "a.ncstock"}, said), "cda");
    EXPECT_EQ(model_of({"--model", "cda"}, said), "cda");
    EXPECT_FALSE(contains(said, "hint")) << said;
}

}  // namespace
}  // namespace ncsim::cli_test
