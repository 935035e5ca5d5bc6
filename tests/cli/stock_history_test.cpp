// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces that earlier runs left on a stock keep surface, tool and line.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* kHead =
    "(T1 D=8. CR=0. - flat end mill)\n"
    "(T2 D=6. CR=0. TAPER=118deg - drill)\n"
    "(T3 D=6. CR=3. - ball end mill)\n"
    "(T4 D=8. CR=0. TAPER=45deg - chamfer mill)\n"
    "(STOCK/BLOCK,90.,70.,20.,45.,35.,20.)\n"
    "G21 G90 G17 G40 G49 G80 G94 (FROM/0.,0.,100.)\n";

// Cuts that leave each kind of surface: planes, cylinders, cones, spheres, tori, extrusions.
const std::vector<std::string> kCuts{
    "T1 M6\nS1000 M3\nG0 X-30 Y-20 Z5\nG1 Z-4 F200\nG1 X20\nG1 Y0\nG0 Z30\n",
    "T1 M6\nS1000 M3\nG0 X10 Y10 Z5\nG1 Z-3 F200\nG3 X10 Y10 I-9 J0\nG0 Z30\n",
    "T2 M6\nS1000 M3\nG0 X30 Y20 Z5\nG1 Z-9 F200\nG0 Z5\nG0 X-30 Y20\nG1 Z-25\nG0 Z30\n",
    "T3 M6\nS1000 M3\nG0 X-20 Y25 Z5\nG1 Z-2 F200\nG1 X10\nG2 X20 Y15 I0 J-10\nG0 Z30\n",
    "T4 M6\nS1000 M3\nG0 X-40 Y-28 Z5\nG1 Z-2 F200\nG1 X30\nG0 Z30\n",
    "T1 M6\nS1000 M3\nG0 X30 Y-25 Z5\nG1 Z-1 F200\nG1 X35 Y5 Z-6\nG0 Z30\n",
};

std::string program_of(std::size_t first, std::size_t last) {
    std::string text = kHead;
    for (std::size_t i = first; i < last; ++i)
        text += kCuts[i];
    return text + "M30\n";
}

// Returns the facts of the solid.
json solid_of(const Folder& folder, Words words) {
    words.insert(words.begin(), "run");
    for (const char* word : {"-q", "--step", "a.step", "--report", "a.json"})
        words.emplace_back(word);
    const Ran ran = folder.run(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(folder.read("a.json"))["step"];
}

void expect_same(const json& a, const json& b) {
    EXPECT_EQ(a["surfaces"], b["surfaces"]);
    EXPECT_EQ(a["facets_kept"], 0) << a.dump(1);
    EXPECT_EQ(b["facets_kept"], 0) << b.dump(1);
    EXPECT_NEAR(a["volume_mm3"].get<double>(), b["volume_mm3"].get<double>(), 1e-3);
}

TEST(StockHistory, TwoRunsLeaveTheSolidOfOneRun) {
    Folder folder;
    folder.write("all.nc", program_of(0, kCuts.size()));
    const json whole = solid_of(folder, {"all.nc"});
    for (std::size_t at = 1; at < kCuts.size(); ++at) {
        SCOPED_TRACE(at);
        folder.write("first.nc", program_of(0, at));
        folder.write("then.nc", program_of(at, kCuts.size()));
        ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--save-stock", "a.ncstock"}).exit_code, 0);
        expect_same(solid_of(folder, {"then.nc", "--stock", "a.ncstock"}), whole);
    }
}

TEST(StockHistory, TurnsWithTheStock) {
    Folder folder;
    folder.write("all.nc", program_of(0, kCuts.size()));
    folder.write("none.nc",
                 std::string(kHead) + "T1 M6\nS1000 M3\nG0 X0 Y0 Z90\nG1 X1 F100\nM30\n");
    json whole = solid_of(folder, {"all.nc", "--save-stock", "0.ncstock"});
    std::string stock = "0.ncstock";
    for (const char* turn : {"X180", "Y90", "Z-90,X90", "Z180"}) {
        SCOPED_TRACE(turn);
        const std::string next = std::string(turn) + ".ncstock";
        expect_same(solid_of(folder, {"none.nc", "--stock", stock, "--stock-turn", turn,
                                      "--stock-move", "3,-1.5,0.25", "--save-stock", next}),
                    whole);
        stock = next;
    }
}

TEST(StockHistory, ABoreFromBothSidesIsOneBore) {
    Folder folder;
    folder.write("first.nc", std::string(kHead) +
                                 "T2 M6\nS1000 M3\nG0 X20 Y10 Z5\nG1 Z-12 F100\n"
                                 "G0 Z5\nM30\n");
    folder.write("back.nc", std::string(kHead) +
                                "T2 M6\nS1000 M3\nG0 X20 Y-10 Z5\nG1 Z-12 F100\n"
                                "G0 Z5\nM30\n");
    ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--save-stock", "a.ncstock"}).exit_code, 0);
    const Words turned{"back.nc", "--stock",      "a.ncstock", "--stock-turn",
                       "X180",    "--stock-move", "0,0,-20"};
    Words measure{"measure"};
    measure.insert(measure.end(), turned.begin(), turned.end());
    measure.insert(measure.end(), {"-q", "--json", "a.json"});
    ASSERT_EQ(folder.run(measure).exit_code, 0);
    const json bores = json::parse(folder.read("a.json"))["bores"];
    ASSERT_EQ(bores.size(), 1U) << bores.dump(1);
    EXPECT_EQ(bores[0]["diameter_mm"], 6.0);
    EXPECT_EQ(bores[0]["depth_mm"], 20.0);
    EXPECT_EQ(bores[0]["through"], true);
    EXPECT_EQ(bores[0]["lines"], json::parse("[10]"));
    EXPECT_EQ(bores[0]["earlier"], json::parse(R"([{"program": "first.nc", "line": 10}])"));
    const json solid = solid_of(folder, turned);
    EXPECT_EQ(solid["surfaces"]["cylinder"], 1);
    EXPECT_EQ(solid["surfaces"]["plane"], 6);
}

TEST(StockHistory, PicturesHaveTheColoursOfEarlierTools) {
    Folder folder;
    folder.write("first.nc", program_of(0, 1));
    folder.write("then.nc", program_of(2, 3));
    folder.write("all.nc", program_of(0, 1).substr(0, program_of(0, 1).size() - 4) +
                               program_of(2, 3).substr(std::string(kHead).size()));
    ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--save-stock", "a.ncstock"}).exit_code, 0);
    const Words picture{"-q", "--marks", "none", "--size", "320x240", "--png"};
    Words two{"run", "then.nc", "--stock", "a.ncstock"}, one{"run", "all.nc"};
    two.insert(two.end(), picture.begin(), picture.end());
    two.emplace_back("two.png");
    one.insert(one.end(), picture.begin(), picture.end());
    one.emplace_back("one.png");
    const Ran ran = folder.run(two);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    ASSERT_EQ(folder.run(one).exit_code, 0);
    EXPECT_TRUE(folder.read("two.png") == folder.read("one.png"));
}

TEST(StockHistory, TilesKeepEarlierTools) {
    Folder folder;
    folder.write("first.nc", program_of(0, 3));
    folder.write("then.nc", program_of(3, 6));
    ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--save-stock", "a.ncstock"}).exit_code, 0);
    const Ran ran = folder.shell(
        "common='then.nc -q --stock a.ncstock' && \"$0\" run $common --ply one.ply && "
        "for tile in 0/2 1/2; do \"$0\" run $common --tile $tile --tile-out t || exit; done && "
        "\"$0\" merge t --ply two.ply -q");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(folder.read("two.ply") == folder.read("one.ply"));
}

TEST(StockHistory, AFileThatLiesIsRefused) {
    Folder folder;
    folder.write("first.nc", program_of(0, 4));
    folder.write("then.nc", program_of(4, 5));
    ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--save-stock", "a.ncstock"}).exit_code, 0);
    const std::string good = folder.read("a.ncstock");
    const auto place_of = [&](std::size_t at) {
        return "b.ncstock:" +
               std::to_string(1 + std::count(good.begin(),
                                             good.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    };
    const std::size_t cylinder = good.find("surface cylinder"), source = good.find("source 10 ");
    ASSERT_NE(cylinder, std::string::npos);
    ASSERT_NE(source, std::string::npos);
    const auto with = [&](std::size_t at, const std::string& line) {
        std::string changed = good;
        changed.replace(at, good.find('\n', at) - at, line);
        folder.write("b.ncstock", changed);
        const Ran ran = folder.run({"run", "then.nc", "--stock", "b.ncstock", "--step", "b.step"});
        EXPECT_EQ(ran.exit_code, 2) << line;
        EXPECT_TRUE(contains(ran.err, place_of(at))) << line << '\n' << ran.err;
        EXPECT_FALSE(folder.has("b.step"));
    };
    with(cylinder, "surface cylinder 0 0 0 0 0 1 44 hollow");
    with(cylinder, "surface sphere 0 0 0 4");
    with(cylinder, "surface cylinder 0 0 0 0 0 2 4");
    with(cylinder, "surface teapot 0 0 0");
    with(source, "source 10 1 1e9 closed first.nc");
    with(source, "source 10 1 -1 closed first.nc");
    with(source, "source 10 one 0.05 closed first.nc");
    with(source, "source 10 1 0.05 first.nc");
    // Files of version 2 have no sources; their faces count as facets of a mesh.
    std::istringstream lines(good);
    std::string old;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("source") && !line.starts_with("surface") &&
            !line.starts_with("origin"))
            old += (line == "ncsim stock 3" ? "ncsim stock 2" : line) + "\n";
    }
    folder.write("old.ncstock", old);
    EXPECT_GT(solid_of(folder, {"then.nc", "--stock", "old.ncstock"})["facets_of_stock"], 0);
}

TEST(StockHistory, FacetsOfAMeshAreCounted) {
    Folder folder;
    folder.write("first.nc", program_of(1, 2));
    folder.write("then.nc", program_of(4, 5));
    ASSERT_EQ(folder.run({"run", "first.nc", "-q", "--stl", "a.stl"}).exit_code, 0);
    const Words words{"then.nc", "--stock", "a.stl"};
    const json solid = solid_of(folder, words);
    EXPECT_GT(solid["facets_of_stock"], 20) << solid.dump(1);
    EXPECT_GE(solid["facets_kept"], solid["facets_of_stock"]);
    const Ran strict =
        folder.run({"run", "then.nc", "--stock", "a.stl", "--step", "b.step", "--step-strict"});
    EXPECT_EQ(strict.exit_code, 2) << strict.err;
    EXPECT_TRUE(contains(strict.out, "are facets of the mesh of the stock")) << strict.out;
    // A block in a mesh has no facets.
    folder.write("none.nc",
                 std::string(kHead) + "T1 M6\nS1000 M3\nG0 X0 Y0 Z90\nG1 X1 F100\nM30\n");
    ASSERT_EQ(folder.run({"run", "none.nc", "-q", "--stl", "block.stl"}).exit_code, 0);
    EXPECT_EQ(solid_of(folder, {"then.nc", "--stock", "block.stl"})["facets_of_stock"], 0);
}

}  // namespace
}  // namespace ncsim::cli_test
