// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim explain: modes and the lines that set them, positions, moves and volume of a block.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

constexpr const char* kPart =
    "G21 G90 G17\n"
    "(T1 D=10. CR=0. - flat end mill)\n"
    "(STOCK/BLOCK,60,40,20,0,0,20)\n"
    "T1 M6\n"
    "S5000 M3\n"
    "G54 G0 X-10 Y10 Z5\n"
    "G1 Z-1 F500\n"
    "X70\n"
    "G91 G1 Y1 F250 M8\n"
    "G0 Z5\n"
    "M30\n";

json explained(const Folder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), "explain");
    words.emplace_back("--json");
    const Ran ran = folder.run(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
    return json::parse(ran.out);
}

const json& mode(const json& block, const std::string& name) {
    for (const json& m : block["modes"]) {
        if (m["name"] == name) return m;
    }
    throw std::runtime_error("there is no mode " + name);
}

TEST(Explain, HasModesWithTheirLines) {
    Folder folder;
    folder.write("part.nc", kPart);
    const json block = explained(folder, {"part.nc:9"});
    EXPECT_EQ(block["text"], "G91 G1 Y1 F250 M8");
    EXPECT_EQ(block["executions"], 1);
    const auto expect = [&](const char* name, const char* value, int line, bool is_changed) {
        const json& m = mode(block, name);
        EXPECT_EQ(m["value"], value) << name;
        EXPECT_EQ(m["changed"], is_changed) << name;
        EXPECT_EQ(m["set_by"].is_null() ? 0 : m["set_by"]["line"].get<int>(), line) << name;
    };
    expect("motion", "feed (G1)", 7, false);
    expect("plane", "XY (G17)", 0, false);
    expect("distances", "incremental (G91)", 9, true);
    expect("feed", "250 mm/min (G94)", 9, true);
    expect("spindle", "clockwise, 5000/min", 5, false);
    expect("coolant", "flood", 9, true);
    expect("tool", "T1", 4, false);
    expect("system", "G54, place in the machine not specified", 0, false);
    expect("length", "none", 0, false);
    EXPECT_EQ(block["position"]["before"], json::parse(R"({"x": 70, "y": 10, "z": -1})"));
    EXPECT_EQ(block["position"]["after"], json::parse(R"({"x": 70, "y": 11, "z": -1})"));
    EXPECT_TRUE(block["machine_position"].is_null());
    EXPECT_EQ(block["tool"]["description"], "flat end mill D10 L30");
    EXPECT_TRUE(contains(block["tool"]["source"].get<std::string>(), "line 2")) << block["tool"];
}

TEST(Explain, HasMovesVolumeAndPlaceInTheMachine) {
    Folder folder;
    folder.write("part.nc", kPart);
    folder.write("job.toml", "version = 1\n[offsets]\nG54 = [100, 50, -200]\n");
    const json block = explained(folder, {"part.nc:8", "--job", "job.toml"});
    ASSERT_EQ(block["motions"].size(), 1U);
    EXPECT_EQ(block["motions"][0]["to"]["x"], 70);
    EXPECT_EQ(block["feed_mm"], 80);
    EXPECT_EQ(block["seconds"], 9.6);
    EXPECT_EQ(block["removed_mm3"], 600);
    EXPECT_EQ(block["machine_position"], json::parse(R"({"x": 170, "y": 60, "z": -201})"));
    const Ran text = folder.run({"explain", "part.nc", "--line", "8"});
    EXPECT_TRUE(contains(text.out, "part.nc:8: X70\n")) << text.out;
    EXPECT_TRUE(contains(text.out, "removes        600 mm3\n")) << text.out;
    EXPECT_TRUE(contains(text.out, "motion         feed (G1)  [line 7]\n")) << text.out;
    EXPECT_TRUE(contains(text.out, "in the machine not known\n")) << text.out;
}

// Volumes of blocks are those of --block-volumes; a redundant word changes no mode.
TEST(Explain, AgreesWithTheReportOnEachLine) {
    Folder folder;
    const std::string program = std::string(NCSIM_SOURCE_DIR) + "/samples/simple.nc";
    folder.run({"run", program, "-q", "--block-volumes", "--report", "a.json"});
    const json report = json::parse(folder.read("a.json"));
    int blocks = 0;
    for (const json& block : report["blocks"]) {
        const std::string line = std::to_string(block["line"].get<int>());
        const json one = explained(folder, {program, "--line", line});
        EXPECT_NEAR(one["removed_mm3"].get<double>(), block["removed_mm3"].get<double>(), 1e-6)
            << line;
        ++blocks;
    }
    EXPECT_GT(blocks, 5);
}

TEST(Explain, CountsLoopsAndReadsCalledFiles) {
    Folder folder;
    folder.write("main.nc",
                 "%\nO1\nG21 G90 G17 G54\n(T1 D=10. CR=0. - flat end mill)\nT1 M6\nS900 M3\n"
                 "G0 X0 Y0 Z5\nM98 P22 L3\nM30\n%\n");
    folder.write("O0022.nc", "%\nO22\nG91 G1 Z-1 F100\nG90 M99\n%\n");
    const json block =
        explained(folder, {"main.nc", "--line", "3", "--in", "O0022.nc", "--dialect", "fanuc"});
    EXPECT_EQ(block["executions"], 3);
    EXPECT_EQ(block["motion_count"], 3);
    EXPECT_EQ(block["file"], "O0022.nc");
    EXPECT_EQ(block["position"]["after"]["z"], 4);
    EXPECT_EQ(mode(block, "tool")["set_by"]["file"], "main.nc");
    const Ran ran = folder.run({"explain", "main.nc:3", "--in", "O9.nc"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "the program does not call a file 'O9.nc'")) << ran.err;
}

TEST(Explain, IsOfInchesAndUnknownPlacesAsTheProgramHasThem) {
    Folder folder;
    folder.write("inch.nc",
                 "G20 G90 G17\nG10 L2 P1 X1\nT1 M6\nG43 H1\nG0 X0 Y0\nG1 Z-.1 F20\nX2\nM30\n");
    const Ran ran = folder.run({"explain", "inch.nc:7", "--tool", "T1=flat:D1/2in"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "position       X2 Y0 Z-0.1 in\n")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "path           2 in at feed")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "length         H1, length not specified  [line 4]")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "feed           20 inch/min (G94)  [line 6]")) << ran.out;

    EXPECT_TRUE(contains(ran.out, "units          inch (G20)  [line 1]")) << ran.out;
    const Ran first = folder.run({"explain", "inch.nc:5", "--tool", "T1=flat:D1/2in"});
    EXPECT_TRUE(contains(first.out, "  before       X? Y? Z? in\n")) << first.out;
}

// Rotations and scales are not in the position of the program; those of a system, G68 and G51 are
// in the position in the machine.
TEST(Explain, HasPositionsAsTheProgramWritesThem) {
    Folder folder;
    folder.write("part.nc",
                 "G21 G90 G17\nT1 M6\nS900 M3\nG0 X0 Y0 Z5\nG68 X0 Y0 R90\nX10 Y0\nG69\n"
                 "G51 X0 Y0 Z0 I2 J2 K1\nX10 Y5\nG50\nG1 Z-1 F100\nX12\nM30\n");
    folder.write("job.toml", "version = 1\n[offsets]\nG54 = [100, 50, -200]\n");
    const auto at = [&](const char* line) {
        return explained(folder, {"part.nc", "--line", line, "--dialect", "fanuc", "--tool",
                                  "T1=flat:D6", "--stock", "100x60x20", "--job", "job.toml"});
    };
    EXPECT_EQ(at("6")["position"]["after"], json::parse(R"({"x": 10, "y": 0, "z": 5})"));
    EXPECT_EQ(at("6")["machine_position"], json::parse(R"({"x": 100, "y": 60, "z": -195})"));
    EXPECT_EQ(at("9")["position"]["after"], json::parse(R"({"x": 10, "y": 5, "z": 5})"));
    EXPECT_EQ(at("9")["machine_position"], json::parse(R"({"x": 120, "y": 60, "z": -195})"));
}

// A change of units or a code that resets what is off changes no mode; an increment from an unknown
// place leads to an unknown place.
TEST(Explain, NamesNoBlockThatChangedNothing) {
    Folder folder;
    folder.write("part.nc",
                 "G21 G90 G17\nT1 M6\nS900 M3\nG52 X25.4\nG68 X1 Y1 R30\nG69\nG0 X0 Y0\n"
                 "G91 G1 Z-2 F100\nG20\nM30\n");
    const auto at = [&](int line) {
        return explained(folder, {"part.nc", "--line", std::to_string(line), "--dialect", "fanuc",
                                  "--tool", "T1=flat:D6", "--stock", "100x60x20"});
    };
    EXPECT_TRUE(at(8)["position"]["after"]["z"].is_null());
    const json inch = at(9);
    EXPECT_EQ(mode(inch, "shift")["set_by"]["line"], 4);
    EXPECT_EQ(mode(inch, "shift")["value"], "X1");
    EXPECT_EQ(mode(inch, "units")["set_by"]["line"], 9);
    EXPECT_FALSE(mode(inch, "system")["changed"]);
    EXPECT_EQ(mode(at(10), "transformation")["set_by"]["line"], 6);
}

TEST(Explain, ReadsKlartextAndSinumerik) {
    Folder folder;
    folder.write("a.h",
                 "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+60 Y+40 Z+0\n"
                 "3 TOOL CALL 1 Z S2000\n4 L X-10 Y+10 Z+5 R0 FMAX M3\n5 L Z-1 F500\n6 L X+70\n"
                 "7 M30\n8 END PGM A MM\n");
    const json klartext = explained(folder, {"a.h:7", "--tool", "T1=flat:D10"});
    EXPECT_EQ(mode(klartext, "motion")["value"], "feed");
    EXPECT_EQ(mode(klartext, "feed")["set_by"]["line"], 6);
    EXPECT_EQ(klartext["removed_mm3"], 600);
    // Lines of a block of several lines stand for the block; frames are not in the position.
    folder.write("b.h",
                 "0 BEGIN PGM B MM\n1 TOOL CALL 1 Z S2000\n2 CYCL DEF 200 BOHREN ~\n Q200=2 ~\n"
                 " Q201=-10 ~\n Q206=150 ~\n Q202=5 ~\n Q210=0 ~\n Q203=+0 ~\n Q204=50 ~\n Q211=0\n"
                 "3 CYCL DEF 10.0 DREHUNG\n4 CYCL DEF 10.1 ROT+90\n5 L X+10 Y+0 Z+5 R0 FMAX\n"
                 "6 M30\n7 END PGM B MM\n");
    const auto of_block = [&](const char* line) {
        return explained(folder, {"b.h", "--line", line, "--tool", "T1=drill:D6"});
    };
    EXPECT_EQ(of_block("11"), of_block("3"));
    EXPECT_EQ(of_block("11")["line"], 3);
    EXPECT_EQ(of_block("2")["line"], 2);
    EXPECT_EQ(of_block("14")["position"]["after"]["x"], 10);
    EXPECT_EQ(mode(of_block("14"), "cycle")["value"], "CYCL DEF 200");
    EXPECT_EQ(mode(of_block("14"), "cycle")["set_by"]["line"], 3);
    EXPECT_EQ(mode(of_block("2"), "cycle")["value"], "none");
    folder.write("a.mpf",
                 "G17 G90 G71\nT1\nM6\nS2000 M3\nG0 X-10 Y10 Z5\nG1 Z-1 F500\n"
                 "TRANS X10\nX=AC(60)\nM30\n");
    const json sinumerik =
        explained(folder, {"a.mpf:8", "--tool", "T1=flat:D10", "--stock", "0,0,-20:60,40,0"});
    EXPECT_EQ(sinumerik["motions"][0]["to"]["x"], 70);
    EXPECT_EQ(sinumerik["removed_mm3"], 600);
    folder.write("b.mpf",
                 "G17 G90 G710\nT1\nM6\nS2000 M3\nG0 X0 Y0 Z5\nF100\n"
                 "MCALL CYCLE81(5,0,1,-2)\nX5\nMCALL\nMCALL L1\nX6\nMCALL\nX7\nM30\n"
                 "%_N_L1_SPF\nG91 G1 Z-1 F9\nG90\nM17\n");
    const auto cycle_of = [&](const char* line) {
        return mode(explained(folder, {"b.mpf", "--line", line, "--tool", "T1=drill:D6"}), "cycle");
    };
    EXPECT_EQ(cycle_of("8")["value"], "MCALL CYCLE81");
    EXPECT_EQ(cycle_of("8")["set_by"]["line"], 7);
    EXPECT_EQ(cycle_of("11")["value"], "MCALL of a subprogram");
    EXPECT_EQ(cycle_of("11")["set_by"]["line"], 10);
    EXPECT_EQ(cycle_of("13")["value"], "none");
}

TEST(Explain, SaysWhyThereIsNothing) {
    Folder folder;
    folder.write("part.nc", kPart);
    folder.write("skip.nc", "G21 G90\nGOTO 10\nG1 X5 F1\nN10 M30\n");
    const auto refusal = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "explain");
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 2) << ran.out;
        EXPECT_EQ(ran.out, "");
        return ran.err;
    };
    EXPECT_EQ(refusal({"part.nc"}),
              "ncsim: name a line: ncsim explain part.nc:120, or --line 120\n");
    EXPECT_EQ(refusal({"part.nc:12"}),
              "ncsim: part.nc: there is no line 12: the file has 11 lines\n");
    EXPECT_EQ(refusal({"part.nc:8", "--line", "9"}),
              "ncsim: 'part.nc:8' and --line 9 are two lines\n");
    EXPECT_TRUE(contains(refusal({"none.nc:1"}), "none.nc"));
    const Ran skipped = folder.run({"explain", "skip.nc:3", "--dialect", "fanuc"});
    EXPECT_EQ(skipped.exit_code, 1);
    EXPECT_EQ(skipped.out, "skip.nc:3: G1 X5 F1\n  not executed\n");
    // A comment is executed, and does nothing.
    const Ran comment = folder.run({"explain", "part.nc:2"});
    EXPECT_EQ(comment.exit_code, 0);
    EXPECT_TRUE(contains(comment.out, "moves          none\n")) << comment.out;
    folder.write("no-tool.nc", "G21 G90 G17\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX9\nM30\n");
    const Ran no_tool = folder.run({"explain", "no-tool.nc:5"});
    EXPECT_EQ(no_tool.exit_code, 0) << no_tool.err;
    EXPECT_TRUE(contains(no_tool.out, "removes        not known: the program cannot"))
        << no_tool.out;
    const Ran quick = folder.run({"explain", "part.nc:8", "--no-volume"});
    EXPECT_TRUE(contains(quick.out, "removes        not known: --no-volume\n")) << quick.out;
}

}  // namespace
}  // namespace ncsim::cli_test
