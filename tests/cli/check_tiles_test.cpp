// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdict of a part in tiles: byte-identical to the verdict of a single check, or an error. Only
// the reported place of a contact may differ, because a contact has many points; the tables compare
// all values except the place.
#include "cli/run_program.h"
#include "cli/verdict_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kSource = NCSIM_SOURCE_DIR;

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string tile_name(int i, int n) {
    return fmt::format("tiles/tile-{:04}-of-{:04}.nctile", i, n);
}

Ran check_tile(const Folder& folder, const Words& program, int i, int n, const Words& more = {}) {
    return folder.run(Words{"check"} + program + Words{"--tile", fmt::format("{}/{}", i, n)} +
                      Words{"--tile-out", "tiles", "--threads", "1"} + more);
}

struct Specified {
    int exit_code = -1;
    std::string out, err;
    json all, sarif;
};

Specified specified_by(const Folder& folder, const Words& command) {
    const Ran ran = folder.run(command + Words{"--json", "a.json", "--sarif", "a.sarif"});
    Specified specified{ran.exit_code, ran.out, ran.err, {}, {}};
    if (!folder.has("a.json")) {
        ADD_FAILURE() << ran.err;
        return specified;
    }
    specified.all = json::parse(folder.read("a.json"));
    for (json& finding : specified.all["programs"][0]["findings"]) {
        if (!finding["point"].is_null()) finding["point"] = "somewhere";
    }
    specified.sarif = json::parse(folder.read("a.sarif"));
    fs::remove(folder.path() / "a.json");
    fs::remove(folder.path() / "a.sarif");
    return specified;
}

void expect_one_verdict(const Folder& folder, const Words& program, const std::vector<int>& ns) {
    const Specified once = specified_by(folder, Words{"check"} + program);
    for (const int n : ns) {
        SCOPED_TRACE(n);
        for (int k = 0; k < n; ++k) {
            const Ran ran = check_tile(folder, program, (k * 5 + 3) % n, n);
            ASSERT_EQ(ran.exit_code, 0) << ran.err;
            EXPECT_FALSE(contains(ran.out + ran.err, "error")) << "a tile judges nothing";
        }
        const Specified merged = specified_by(folder, {"merge", "tiles"});
        EXPECT_EQ(merged.exit_code, once.exit_code);
        EXPECT_EQ(merged.out, once.out);
        EXPECT_EQ(merged.err, once.err);
        EXPECT_EQ(merged.all, once.all) << json::diff(once.all, merged.all).dump(1);
        EXPECT_EQ(merged.sarif, once.sarif);
        fs::remove_all(folder.path() / "tiles");
    }
}

const json& table() {
    return verdict_rows();
}

class VerdictsOfTiles : public testing::TestWithParam<std::size_t> {};

TEST_P(VerdictsOfTiles, AreThoseOfOneCheck) {
    const json& row = table()[GetParam()];
    const Folder folder;
    for (const auto& file : fs::directory_iterator(kSource / "tests" / "verdicts"))
        fs::copy(file.path(), folder.path());
    Words program{row["program"]};
    for (const json& option : row["options"])
        program.push_back(option);
    // A tile holds a single program.
    const Ran several = check_tile(folder, program, 0, 2);
    fs::remove_all(folder.path() / "tiles");
    if (contains(several.err, "the file has several programs")) {
        EXPECT_EQ(several.exit_code, 2);
        return;
    }
    // By day, rows take turns.
    std::vector<int> tiles{GetParam() % 2 == 0 ? 2 : 7};
    if (std::getenv("NCSIM_ALL_TILES")) tiles = {2, 7};
    expect_one_verdict(folder, program, tiles);
}

INSTANTIATE_TEST_SUITE_P(Programs, VerdictsOfTiles, testing::Range(std::size_t{0}, table().size()),
                         name_of_row);

TEST(CheckTiles, AreOneCheckOfSamples) {
    const Folder folder;
    fs::copy(kSource / "samples", folder.path(), fs::copy_options::recursive);
    expect_one_verdict(folder, {"simple.nc"}, {1, 2, 7, 64});
    expect_one_verdict(folder, {"complex.nc", "--cut-free", "--air-cuts"}, {1, 7, 64});
    expect_one_verdict(folder, {"wave.nc", "--tool-tolerance", "0.3"}, {1, 2, 7});
    expect_one_verdict(
        folder, {"--job", "five-axis.toml", "five-axis.nc", "--machine", "machines/trunnion.toml"},
        {1, 7});
}

// Limits of tools, a low holder, a plunging face mill, rapids in material, a design: sums and
// lengths over several tiles.
TEST(CheckTiles, AddUpWhatToolsTakeAndMeet) {
    const Folder folder;
    std::string limits =
        "[offsets]\nG54 = [-250, -200, -300]\n[[fixture]]\nname = \"jaw\"\n"
        "clearance = 2\nbox = [[-60, 10, -40], [20, 45, -3]]\n";
    folder.write("plain.toml", limits);
    folder.write("deep.toml",
                 limits + "[[tool]]\nnumber = 1\nmax_depth = 1.5\nblind_diameter = 6\n");
    folder.write("limits.toml", limits +
                                    "[[tool]]\nnumber = 1\nmax_engagement = 4\n"
                                    "max_removal_rate = 2000\n");
    std::string program =
        "(STOCK/BLOCK,80.,60.,25.,40.,30.,25.)\nG21 G90 G17 G54\nT1 M6\nG43 H1\nG0 X-60. Y0. Z30.\n"
        "G0 Z-1.\nG0 X-20.\nM3 S5000\nF600.\n";
    for (int i = 0; i < 12; ++i) {
        program += fmt::format("G1 X{} Z{}\nG1 Y{}\nG3 X{} Y{} R9.\n", i % 2 == 0 ? 25 : -25,
                               -2 - 1.5 * i, i - 5, i % 2 == 0 ? 34 : -34, i + 2);
    }
    program += "M5\nG1 X0. Y0.\nG0 X55.\nG0 Z50.\nM30\n";
    folder.write("many.nc", program);
    fs::copy(kSource / "tests" / "verdicts" / "boss.stl", folder.path());
    const Words flat{"--tool", "T1=flat:D10:L8:S6x20:H30x30", "--tool-tolerance", "0.4"};
    const Words many{"many.nc"};
    for (const Words& more : {Words{"--machine", "plain.toml", "--air-cuts", "--cut-free"},
                              Words{"--machine", "deep.toml", "--design", "boss.stl"},
                              Words{"--machine", "limits.toml", "--rapid", "dog-leg"}}) {
        SCOPED_TRACE(more[1]);
        expect_one_verdict(folder, many + flat + more, {1, 2, 7});
    }
}

TEST(CheckTiles, KnowTheProjectAndTheBaseline) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("ncsim.toml", "version = 1\nrequire = [\"holder\"]\n");
    expect_one_verdict(folder, {"slot.nc"}, {2});
    ASSERT_EQ(folder.run({"check", "slot.nc", "--write-baseline", "known.json", "-q"}).exit_code,
              4);
    expect_one_verdict(folder, {"slot.nc", "--baseline", "known.json"}, {2});
    expect_one_verdict(folder, {"slot.nc", "--no-project", "--warnings-as-errors"}, {2});
}

TEST(CheckTiles, ThatAreNotOfOneCheckAreRefused) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    const auto refused = [&](const std::string& why, const Words& more = {}) {
        const Ran ran = folder.run(Words{"merge", "tiles", "--json", "a.json"} + more);
        EXPECT_EQ(ran.exit_code, 2) << why;
        EXPECT_TRUE(contains(ran.err, why)) << ran.err;
        EXPECT_FALSE(folder.has("a.json"));
    };
    EXPECT_EQ(check_tile(folder, {"slot.nc"}, 0, 3).out,
              "tile 0 of 3 was verified: " + tile_name(0, 3) + "\n");
    EXPECT_EQ(check_tile(folder, {"slot.nc"}, 0, 3).out,
              "tile 0 of 3 was verified before: " + tile_name(0, 3) + "\n");
    ASSERT_EQ(check_tile(folder, {"slot.nc"}, 2, 3).exit_code, 0);
    refused("1 of 3 tiles are missing");
    ASSERT_EQ(check_tile(folder, {"slot.nc"}, 1, 3, {"--cut-free"}).exit_code, 0);
    refused("something else was asked for");
    ASSERT_EQ(folder.run({"run", "slot.nc", "--tile", "1/3", "--tile-out", "tiles"}).exit_code, 0);
    refused("something else was asked for");
    ASSERT_EQ(check_tile(folder, {"slot.nc"}, 1, 3).exit_code, 0);
    refused("--gltf: tiles of ncsim check are no part", {"--gltf", "a.glb"});
    const std::string whole = folder.read(tile_name(1, 3));
    folder.write(tile_name(1, 3), whole.substr(0, whole.size() / 2));
    refused("cut off");
    folder.write(tile_name(1, 3), whole);
    folder.write("slot.nc", std::string(kSlot) + "\n");
    refused("'slot.nc' is not what it was");
    for (const Words& wrong :
         {Words{"--tile", "0/2"}, Words{"--tile-out", "tiles"},
          Words{"--tile", "2/2", "--tile-out", "tiles"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--json", "a.json"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--csv", "a.csv"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--html", "a.html"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--cache", "c"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "other.nc"},
          Words{"--tile", "0/2", "--tile-out", "tiles", "--shard", "0/2", "--out", "o"}})
        EXPECT_EQ(folder.run(Words{"check", "slot.nc"} + wrong).exit_code, 2);
}

// Tile files may come from an untrusted source.
TEST(CheckTiles, SayNeitherWhatIsWrittenNorWhatDidNotHappen) {
    const Folder folder;
    folder.write("slot.nc", kSlot);
    ASSERT_EQ(check_tile(folder, {"slot.nc"}, 0, 1).exit_code, 0);
    const std::string whole = folder.read(tile_name(0, 1));
    const std::string body = whole.substr(0, whole.size() - 66);
    const auto merged = [&](const std::string& changed) {
        folder.write("body", changed);
        const std::string digest = folder.shell("sha256sum < body").out.substr(0, 64);
        folder.write(tile_name(0, 1), changed + '\n' + digest + '\n');
        fs::remove(folder.path() / "body");
        const Ran ran = folder.run({"merge", "tiles"});
        EXPECT_FALSE(contains(ran.err, "cut off")) << ran.err;
        EXPECT_EQ(folder.files(), (Words{"slot.nc", "tiles"}));
        return ran;
    };
    for (const char* word : {"--json=evil", "--cache=evil", "--html=evil", "--list=slot.nc",
                             "--tile=0/2", "--exit-zero", "--no-such-option", "slot.nc"}) {
        const std::string head = "\"words\":[\"check\"";
        std::string changed = body;
        changed.replace(changed.find(head), head.size(), head + ",\"" + word + "\"");
        EXPECT_EQ(merged(changed).exit_code, 2) << word;
    }
    // Observations begin after the first empty line.
    const std::size_t at = body.find("\n\n") + 2;
    for (const char* line : {"99 1 0 0 0 0 1\n", "7 1 3 9 0 0 1\n",
                             "7 18446744073709551615 7 0 0 0 1\n", "7 1 8 0 0 0 1\n", "what?\n"}) {
        const Ran ran = merged(body.substr(0, at) + line + body.substr(at));
        EXPECT_EQ(ran.exit_code, 2) << line << ran.out;
        EXPECT_TRUE(contains(ran.err + ran.out, "tiles do not agree") ||
                    contains(ran.err, "cannot be read"))
            << line << ran.err << ran.out;
    }
}

}  // namespace
}  // namespace ncsim::cli_test
