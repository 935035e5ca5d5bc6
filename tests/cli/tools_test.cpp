// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim tools: tool tables, job files and kinematics.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

constexpr const char* kTwoTools =
    "(T1 D=10. CR=0. - ZMIN=-2. - flat end mill)\n"
    "(T3 D=4. CR=2. - ZMIN=-2. - ball end mill)\n"
    "G21 G90 G17\n"
    "T1 M6\n"
    "G0 X-30. Y0. Z5.\n"
    "G0 Z-2.\n"
    "G1 X30. F500.\n"
    "G0 Z5.\n"
    "T2 M6\n"
    "G0 X0 Y0 Z5.\n"
    "G1 Z-3. F100\n"
    "G0 Z5\n"
    "M30\n";

TEST(Tools, AreListedWithTheirSourceAndUse) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    const Ran ran = folder.run({"tools", "slot.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out,
              "T1        flat end mill D10 L30\n"
              "  source  line 1: (T1 D=10. CR=0. - ZMIN=-2. - flat end mill)\n"
              "  assumed length 30 mm\n"
              "  used    from line 6, 60.0 mm cutting, 113.6 mm rapid\n"
              "stock     40 x 30 x 10 mm, X -20 to 20, Y -15 to 15, Z -10 to 0\n"
              "  source  line 2: (STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n");
}

TEST(Tools, NamesOfSinumerikContainTheSize) {
    Folder folder;
    folder.write("a.mpf",
                 "G710 G90 G17\nT=\"CUTTER 16\"\nM6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\n"
                 "G0 Z5\nT=\"FACEMILL_63\"\nM6\nG0 X9\nG1 Z0 F100\nG0 Z5\nM30\n");
    const Ran ran = folder.run({"tools", "a.mpf"});
    EXPECT_TRUE(contains(ran.out, "T9001     flat end mill D16 ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "line 2: (T9001 CUTTER 16)")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "T9002     face mill D63 ")) << ran.out;
}

TEST(Tools, ThatAreNotDescribedOrNotUsedAreToldAndExitWithOne) {
    Folder folder;
    folder.write("two.nc", kTwoTools);
    const Ran ran = folder.run({"tools", "two.nc"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "T2        not described\n  used    from line 10, ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "T3        ball end mill D4\n")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "  used    no\n")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "--tool T2=drill:D6")) << ran.err;

    const json sheet = json::parse(folder.run({"tools", "two.nc", "--json"}).out);
    ASSERT_EQ(sheet["tools"].size(), 3U);
    EXPECT_EQ(sheet["tools"][0]["diameter_mm"], 10.0);
    EXPECT_EQ(sheet["tools"][0]["source"]["line"], 1);
    EXPECT_EQ(sheet["tools"][1]["described"], false);
    EXPECT_EQ(sheet["tools"][2]["used"], false);
    EXPECT_EQ(sheet["findings"][0]["code"], "tool-unknown");
    // A tool that is called and never moves is not used; T0 is not a tool.
    folder.write("called.nc",
                 "(T1 D=10. - flat end mill)\nG21 G90 T1 M6 S1 M3\nG0 X0 Y0 Z5\nG1 Z-1 "
                 "F100\nG0 Z5\nT7 M6\nT0 M6\nM30\n");
    const json called = json::parse(folder.run({"tools", "called.nc", "--json"}).out);
    ASSERT_EQ(called["tools"].size(), 1U) << called.dump(1);
    EXPECT_EQ(called["tools"][0]["number"], 1);
}

TEST(Tools, ComeFromTablesAndContradictionsAreReported) {
    Folder folder;
    folder.write("two.nc", kTwoTools);
    folder.write("tool.tbl", "T1 P1 D8 ;8 mm end mill\nT2 P2 D3 ;3 mm drill\n");
    const Ran ran = folder.run({"tools", "two.nc", "--tool-table", "tool.tbl"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "T1        flat end mill D8 ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "  source  from tool.tbl, line 2: T2 P2 D3 ;3 mm drill\n"));
    EXPECT_TRUE(contains(ran.err, "two.nc:1:")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "tool 1 has a diameter of 10 mm, but tool.tbl says 8 mm"));
}

TEST(Tools, OfTheCommandLineBeatTheTableInSilence) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("tool.tbl", "T1 P1 D10 ;end mill\n");
    const Ran ran =
        folder.run({"tools", "slot.nc", "--tool-table", "tool.tbl", "--tool", "T1=ball:D6"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(contains(ran.out, "T1        ball end mill D6")) << ran.out;
}

TEST(Tools, TableThatIsNoneIsAnErrorWithItsPlace) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("tool.tbl", "T1 P1 D10 ;end mill\nhello\n");
    const Ran ran = folder.run({"tools", "slot.nc", "--tool-table", "tool.tbl"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "tool.tbl:2:1: ")) << ran.err;
    EXPECT_EQ(folder.run({"tools", "slot.nc", "--tool-table", "none.tbl"}).exit_code, 2);
}

TEST(Tools, CamoticsProjectBringsItsWorkpieceAndUnits) {
    Folder folder;
    folder.write("inch.nc", "T1 M6\nG0 X0 Y0 Z1\nG1 Z-.1 F5\nG1 X1\nG0 Z1\nM2\n");
    folder.write("inch.camotics",
                 R"({"units":"imperial","tools":{"1":{"units":"imperial","shape":"cylindrical",
                     "length":1,"diameter":0.25}},
                     "workpiece":{"automatic":false,"bounds":{"min":[-10,-10,-10],
                     "max":[50,10,0]}}})");
    const Ran ran = folder.run({"run", "inch.nc", "--tool-table", "inch.camotics"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "60 x 20 x 10 mm")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "flat end mill D6.35 L25.4")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "inches")) << ran.err;
}

// --- Job files ---

TEST(JobFile, RunsTheProgramAgainToTheSameBytes) {
    Folder folder;
    folder.write("two.nc", kTwoTools);
    const Ran first = folder.run({"run", "two.nc", "--tool", "T2=v:D4:A60:P0.2", "--units", "inch",
                                  "--stl", "a.stl", "--save-job", "two.toml", "--allow", "G187"});
    ASSERT_EQ(first.exit_code, 0) << first.err;
    const Ran second = folder.run({"run", "--job", "two.toml", "--stl", "b.stl"});
    ASSERT_EQ(second.exit_code, 0) << second.err;
    EXPECT_EQ(folder.read("a.stl"), folder.read("b.stl"));
    EXPECT_EQ(first.out, second.out);
    EXPECT_TRUE(contains(second.err, "from two.toml, line ")) << second.err;
    // A job saved from a job has the same content.
    const Ran third = folder.run({"tools", "--job", "two.toml", "--save-job", "three.toml"});
    ASSERT_EQ(third.exit_code, 0) << third.err;
    const Ran fourth = folder.run({"run", "--job", "three.toml", "--stl", "c.stl", "-q"});
    EXPECT_EQ(folder.read("a.stl"), folder.read("c.stl"));
}

TEST(JobFile, OfAnUndescribedToolAsksForIt) {
    Folder folder;
    folder.write("two.nc", kTwoTools);
    EXPECT_EQ(folder.run({"tools", "two.nc", "--save-job", "two.toml"}).exit_code, 1);
    const std::string text = folder.read("two.toml");
    EXPECT_TRUE(contains(text, "# tool 2 moves from line 10 on and is not described")) << text;
    EXPECT_TRUE(contains(text, "#[[tool]]\n#number = 2\n")) << text;
}

TEST(JobFile, YieldsToTheCommandLine) {
    Folder folder;
    folder.write("slot.nc", kSlot);
    folder.write("slot.toml",
                 "version = 2\nprogram = \"slot.nc\"\n[stock]\nmin = [-20, -15, -10]\n"
                 "max = [20, 15, 0]\n[[tool]]\nnumber = 1\nkind = \"ball\"\ndiameter = 6\n");
    const Ran ran = folder.run({"tools", "--job", "slot.toml", "--tool", "T1=flat:D4"});
    EXPECT_TRUE(contains(ran.out, "T1        flat end mill D4 ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "from slot.toml")) << ran.out;
    EXPECT_TRUE(
        contains(folder.run({"tools", "--job", "slot.toml"}).out, "T1        ball end mill D6 "));
}

TEST(JobFile, ThatMakesNoSenseIsRefusedWithItsPlace) {
    const std::pair<const char*, const char*> table[] = {
        {"version = ", "a.toml:1:"},
        {"version = 3\n", "a.toml:1:11: "},
        {"program = 3\n", "a.toml:1:11: 'program': expected a text in quotes"},
        {"colour = \"red\"\n",
         "a.toml:1:10: 'colour' is not known; expected accept, air_cuts, allow"},
        {"units = \"furlong\"\n", "a.toml:1:9: "},
        {"dialect = \"klingon\"\n", "a.toml:1:11: "},
        {"[stock]\nmin = [0,0,0]\n", "a.toml:1:1: a stock has two corners"},
        {"[stock]\nmin = [0,0,0]\nmax = [1,1,0]\n", "a.toml:3:7: "},
        {"[stock]\nmin = [0,0,inf]\nmax = [1,1,0]\n", "a.toml:2:12: "},
        {"[[tool]]\nnumber = 1\n", "a.toml:1:1: a tool needs a diameter"},
        {"[[tool]]\ndiameter = 1\n", "a.toml:1:1: a tool has a number"},
        {"[[tool]]\nnumber = 1\ndiameter = \"1\"\n",
         "a.toml:3:12: 'tool.diameter': expected a number"},
        {"[[tool]]\nnumber = 1\ndiameter = -1\n", "a.toml:3:12: "},
        {"[[tool]]\nnumber = 1\nkind = \"spoon\"\ndiameter = 1\n", "a.toml:3:8: "},
        {"[[tool]]\nnumber = 1\ndiameter = 1\n[[tool]]\nnumber = 1\ndiameter = 1\n",
         "a.toml:4:1: tool 1 is described twice"},
    };
    for (const auto& [text, expected] : table) {
        SCOPED_TRACE(text);
        Folder folder;
        folder.write("slot.nc", kSlot);
        folder.write("a.toml", text);
        const Ran ran = folder.run({"tools", "slot.nc", "--job", "a.toml"});
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.err.rfind("ncsim: " + std::string(expected), 0), 0U) << ran.err;
    }
}

TEST(JobFile, WithoutAProgramIsRefused) {
    Folder folder;
    folder.write("a.toml", "version = 2\n");
    EXPECT_EQ(folder.run({"tools", "--job", "a.toml"}).exit_code, 2);
    EXPECT_EQ(folder.run({"tools", "--job", "none.toml"}).exit_code, 2);
    EXPECT_EQ(folder.run({"tools"}).exit_code, 2);
}

TEST(JobFile, TellsWhereAToolCameFromWhateverBytesStandThere) {
    Folder folder;
    folder.write("a.nc",
                 "(T1 D=6 CR=0 - Schaftfr\xe4ser \"x\" \\ # - flat end mill)\nG21\nT1 M6\n"
                 "G0 X0 Y0 Z1\nG1 Z-1 F9\nX9\nM2\n");
    ASSERT_EQ(folder.run({"tools", "a.nc", "--save-job", "a.toml"}).exit_code, 0);
    const Ran ran = folder.run({"tools", "--job", "a.toml"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "T1        flat end mill D6 ")) << ran.out;
}

// Two moves along the tool of a cradle A with C on top that turn the part by the right hand, from
// the impeller of LinuxCNC. A move of a millimetre gives no evidence; a move in a different
// direction is evidence against the kinematics.
TEST(Tools, SayWhatMovesAtTiltedAnglesTellOfXYZ) {
    Folder folder;
    const std::string begin = "(T1 D=3. CR=1.5 - ball end mill)\nG21 G90 T1 M6 S1 M3 F100\n";
    const std::string moves =
        "G0 X16.339 Y-25.409 Z33.353 A-71.841 C-35.93\n"
        "G0 X7.417 Y-13.098 Z28.366\nG1 X6.302 Y-11.56 Z27.743\nG1 X20 Y-13\n"
        "G0 X13.646 Y-21.89 Z36.873 A-43.236 C-43.723\n"
        "G0 X8.468 Y-16.476 Z28.905 A-43.236 C-43.723\n";
    folder.write("tip.nc", begin + "M428\n" + moves + "M429\nM30\n");
    const Ran ran = folder.run({"tools", "tip.nc"});
    EXPECT_TRUE(contains(ran.out,
                         "plunges   2 at tilted angles, along the tool of some machine or along Z\n"
                         "  tip     2 along the tool of xyzac-trt\n"
                         "  axes    0 along Z\n"))
        << ran.out;
    const json specified = json::parse(folder.run({"tools", "tip.nc", "--json"}).out)["plunges"];
    EXPECT_EQ(specified, json::parse(R"({"moves": 2, "along_z": 0,
                                    "tip": [{"machines": ["xyzac-trt"], "moves": 2}]})"));
    // With G43.4, for a table of opposite direction: the part turns by -A and -C.
    folder.write("iso.nc", begin +
                               "G43.4 H1\nG0 X0 Y0 Z0 A30 C0\nG1 Y-5 Z8.6602540378\n"
                               "G0 X0 Y0 Z0\nM30\n");
    EXPECT_TRUE(
        contains(folder.run({"tools", "iso.nc"}).out,
                 "  tip     2 along the tool of xyzac-trt with other signs, xyzab-table, 4axis-a"));
    // Positions of axes: down is Z for any position of the table.
    folder.write("axes.nc", begin + "G0 X0 Y0 Z9 B90\nG1 Z-5\nG0 Z9\nB180\nG1 Z-5\nM30\n");
    EXPECT_TRUE(contains(folder.run({"tools", "axes.nc"}).out, "  axes    3 along Z\n"));
    folder.write("none.nc", begin + "G0 X0 Y0 Z9 B90\nG1 X-5\nY3 Z-20\nM30\n");
    EXPECT_TRUE(contains(folder.run({"tools", "none.nc"}).out, "  tip     1 along the tool of "));
    folder.write("mute.nc", begin + "G0 X0 Y0 Z9 B30\nG1 X-5\nY3 Z-20\nM30\n");
    EXPECT_TRUE(
        contains(folder.run({"tools", "mute.nc"}).out,
                 "plunges   none at tilted angles: no move decides what X, Y and Z mean\n"));
    folder.write("upright.nc", begin + "G0 X0 Y0 Z9 C30\nG1 Z-5\nM30\n");
    EXPECT_FALSE(contains(folder.run({"tools", "upright.nc"}).out, "plunges"));
}

constexpr const char* kLibrary = R"({"data": [
 {"type": "flat end mill", "description": "6 mm", "unit": "millimeters", "post-process": {"number": 1},
  "geometry": {"DC": 6, "LCF": 13, "SFDM": 6, "LB": 30}},
 {"type": "ball end mill", "unit": "millimeters", "post-process": {"number": 2},
  "geometry": {"DC": 4, "LCF": 11}},
 {"type": "bull nose end mill", "unit": "millimeters", "post-process": {"number": 3},
  "geometry": {"DC": 10, "RE": 1.5, "LCF": 22}},
 {"type": "drill", "unit": "millimeters", "post-process": {"number": 4},
  "geometry": {"DC": 8, "SIG": 140, "LCF": 40}},
 {"type": "tap right hand", "unit": "millimeters", "post-process": {"number": 5},
  "geometry": {"DC": 8, "TP": 1.25, "LCF": 20}},
 {"type": "chamfer mill", "unit": "inches", "post-process": {"number": 6},
  "geometry": {"DC": 0.5, "TA": 45, "tip-diameter": 0.1, "LCF": 0.25}},
 {"type": "engrave", "unit": "millimeters", "post-process": {"number": 7},
  "geometry": {"DC": 6, "SIG": 60, "tip-diameter": 0.2, "LCF": 8}},
 {"type": "face mill", "unit": "millimeters", "post-process": {"number": 8},
  "geometry": {"DC": 50, "LCF": 8}}]})";

// Returns the tools that ncsim reads, as JSON without their sources; `without` are keys that a
// format has no place for.
json tools_read(const Folder& folder, const std::vector<std::string>& options,
                const std::vector<std::string>& without) {
    std::vector<std::string> words{"tools", "part.nc", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const Ran ran = folder.run(words);
    json tools = json::parse(ran.out)["tools"];
    for (json& tool : tools) {
        tool.erase("source");
        for (const std::string& key : without)
            tool.erase(key);
        tool["diameter_mm"] = std::round(1e6 * tool["diameter_mm"].get<double>()) / 1e6;
    }
    return tools;
}

TEST(Tools, OfALibraryAreConverted) {
    Folder folder;
    folder.write("part.nc", "G21 G90\nT99 M6\nG0 X0 Y0 Z5\nM30\n");
    folder.write("lib.json", kLibrary);
    const Ran job = folder.run({"tools", "--tool-table", "lib.json", "--convert", "tools.toml"});
    EXPECT_EQ(job.exit_code, 0) << job.err;
    EXPECT_EQ(job.out, "tools.toml: 8 tools\n");
    EXPECT_EQ(tools_read(folder, {"--tool-table", "lib.json"}, {}),
              tools_read(folder, {"--job", "tools.toml"}, {}));
    // A table of LinuxCNC has no lengths.
    EXPECT_EQ(folder.run({"tools", "--tool-table", "lib.json", "--convert", "tool.tbl"}).exit_code,
              0);
    const std::vector<std::string> lengths{"length_mm", "shank_diameter_mm"};
    EXPECT_EQ(tools_read(folder, {"--tool-table", "lib.json"}, lengths),
              tools_read(folder, {"--tool-table", "tool.tbl"}, lengths))
        << folder.read("tool.tbl");
    folder.run({"tools", "--tool-table", "lib.json", "--convert", "inch.tbl", "--units", "inch"});
    EXPECT_TRUE(contains(folder.read("inch.tbl"), "T6 P6 Z0 D0.5 ;chamfer mill"))
        << folder.read("inch.tbl");
    EXPECT_EQ(tools_read(folder, {"--tool-table", "lib.json"}, lengths),
              tools_read(folder, {"--tool-table", "inch.tbl", "--units", "inch"}, lengths));
}

TEST(Tools, AreConvertedOnlyFromTables) {
    Folder folder;
    folder.write("part.nc", kTwoTools);
    folder.write("lib.json", kLibrary);
    const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 2) << ran.out;
        EXPECT_TRUE(contains(ran.err, why)) << ran.err;
    };
    refused({"tools", "--convert", "a.tbl"}, "--convert: name the tools");
    refused({"tools", "part.nc", "--tool-table", "lib.json", "--convert", "a.tbl"}, "--save-job");
    refused({"tools", "--tool-table", "lib.json", "--convert", "a.csv"},
            "expected a file .toml or .tbl");
    refused({"tools", "--tool-table", "part.nc", "--convert", "a.tbl"}, "part.nc:1:1");
    folder.run({"tools", "--tool-table", "lib.json", "--convert", "tool.tbl"});
    refused({"tools", "--tool-table", "tool.tbl", "--convert", "tool.tbl"}, "tool.tbl");
    EXPECT_FALSE(folder.has("a.tbl"));
}

}  // namespace
}  // namespace ncsim::cli_test
