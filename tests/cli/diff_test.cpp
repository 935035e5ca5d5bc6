// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim diff: comparison of the parts of two programs.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string replaced(const std::string& from, const std::string& to) {
    std::string text(kSlot);
    return text.replace(text.find(from), from.size(), to);
}

TEST(Diff, OfAProgramWithItselfIsNothing) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", std::string("(another remark)\n") + kSlot);
    const Ran ran = folder.run({"diff", "a.nc", "b.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("the same motions"), std::string::npos) << ran.out;
}

TEST(Diff, SeesOnlyTheResult) {
    // The same slot from the opposite side and in two steps.
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", replaced("G1 X30. F500.", "G1 X-1. F500.\nG0 Z5.\nX30.\nZ-2.\nG1 X-1."));
    const Ran ran = folder.run({"diff", "a.nc", "b.nc"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_NE(ran.out.find("only in a.nc: 0 mm3"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("the same part"), std::string::npos);
}

TEST(Diff, OfPartsOnAMachineThatTurns) {
    Folder folder;
    folder.write("m.toml",
                 "preset = \"xyzac-trt\"\npivot = { A = [0, 0, 0], C = [0, 0, 0] }\n"
                 "control = { m_codes = { M428 = \"tip\", M429 = \"axes\" } }\n"
                 "[offsets]\nG54 = [0, 0, 0]\n");
    const std::string head =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,40.,10.,20.,20.,10.)\n"
        "(FROM/0.,0.,50.)\nG21 G90 G17 T1 M6\nS5000 M3\nG0 X0 Y0 Z20\n";
    folder.write("a.nc", head + "G0 C90\nX-30\nZ-2\nG1 X30 F500\nG0 Z20\nM30\n");
    folder.write("b.nc", head + "G0 Y30\nZ-2\nG1 Y-30 F500\nG0 Z20\nM30\n");
    folder.write("c.nc", head + "M428\nG0 C90\nX-30\nZ-2\nG1 X30 F500\nG0 Z20\nM429\nM30\n");
    const auto ends = [&](const char* a, const char* b) {
        return folder.run({"diff", a, b, "--machine", "m.toml"}).exit_code;
    };
    EXPECT_EQ(ends("a.nc", "b.nc"), 0);
    EXPECT_EQ(ends("a.nc", "c.nc"), 1);  // the tip moves along X of the part
    EXPECT_EQ(folder.run({"diff", "a.nc", "c.nc"}).exit_code, 2);  // M428 is unknown
}

TEST(Diff, TellsVolumesPlacesAndLines) {
    Folder folder;
    folder.write("a.nc", kSlot);
    // Half a millimetre deeper, but only along 30 of the 40 mm.
    folder.write("b.nc", replaced("G0 Z-2.\nG1 X30. F500.", "G0 Z-2.5\nG1 X5. F500."));
    const Ran ran = folder.run({"diff", "a.nc", "b.nc", "--json", "d.json"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const json d = json::parse(folder.read("d.json"));
    EXPECT_EQ(d["differs"], true);
    const double only_old = d["only_in_old"]["volume_mm3"];
    const double only_new = d["only_in_new"]["volume_mm3"];
    EXPECT_DOUBLE_EQ(d["old_mm3"], 11200.0);
    EXPECT_NEAR(only_old - only_new, 11200.0 - double(d["new_mm3"]), 1e-6);
    // Under the slot from X-20 to the round end at X5 to X10.
    EXPECT_GT(only_old, 25 * 10 * 0.5);
    EXPECT_LT(only_old, 30 * 10 * 0.5);
    ASSERT_EQ(d["only_in_old"]["regions"].size(), 1U);
    EXPECT_EQ(d["only_in_old"]["regions"][0]["lines"],
              json::parse(R"([{"file": "b.nc", "first": 8, "last": 8}])"));
    EXPECT_EQ(d["only_in_new"]["regions"][0]["lines"][0]["file"], "a.nc");
    EXPECT_EQ(d["only_in_new"]["regions"][0]["lines"][0]["first"], 8);
    EXPECT_NE(ran.out.find("cut by b.nc:8"), std::string::npos) << ran.out;
}

// An arc that removes material in a single quarter: the reported region is the quarter, not the
// circle.
TEST(Diff, TellsWhereOfALongBlock) {
    const std::string start =
        "(T1 D=6. CR=0. - flat end mill)\n(STOCK/BLOCK,60.,60.,10.,30.,30.,10.)\n"
        "G21 G90 G17 G94\nT1 M6\nS1000 M3\nG0 X-40. Y-25. Z5.\nG1 Z-2. F500.\n";
    std::string pocket;
    for (int y = -25; y <= 7; y += 4)
        pocket += "Y" + std::to_string(y) + ".\nX40.\nX-40.\n";
    Folder folder;
    folder.write("a.nc", start + pocket + "G0 Z5.\nM30\n");
    folder.write(
        "b.nc", start + pocket + "G0 Z5.\nX20. Y0.\nG1 Z-2.\nG2 X20. Y0. I-20. J0.\nG0 Z5.\nM30\n");
    const Ran ran = folder.run({"diff", "a.nc", "b.nc", "--json", "d.json"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const json d = json::parse(folder.read("d.json"));
    ASSERT_EQ(d["only_in_old"]["regions"].size(), 1U) << ran.out;
    const json box = d["only_in_old"]["regions"][0]["box"];
    EXPECT_GT(double(box["min"][1]), 0.0) << ran.out;
    EXPECT_NEAR(box["max"][1], 23.0, 0.1) << ran.out;
}

TEST(Diff, NamesFeedsSpeedsCoolantAndDwellsThatDiffer) {
    Folder folder;
    folder.write("a.nc", kSlot);
    const auto differs = [&](const std::string& from, const std::string& to) {
        folder.write("b.nc", replaced(from, to));
        EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc"}).exit_code, 0) << to;
        const Ran ran = folder.run({"diff", "a.nc", "b.nc", "--process", "--json", "d.json"});
        EXPECT_EQ(json::parse(folder.read("d.json"))["process"]["differs"], ran.exit_code == 1);
        return ran;
    };
    const Ran feed = differs("X30. F500.", "X30. F400.");
    EXPECT_EQ(feed.exit_code, 1);
    EXPECT_NE(feed.out.find("- a.nc:8: T1, feed 500 mm/min"), std::string::npos) << feed.out;
    EXPECT_NE(feed.out.find("+ b.nc:8: T1, feed 400 mm/min"), std::string::npos) << feed.out;
    EXPECT_EQ(differs("M3", "M4").exit_code, 1);
    EXPECT_EQ(differs("G0 Z-2.\n", "G0 Z-2. M8\n").exit_code, 1);
    EXPECT_EQ(differs("G0 Z-2.\n", "G0 Z-2. M7 M8\n").exit_code, 1);
    EXPECT_EQ(differs("G0 Z-2.\n", "G0 Z-2.\nG4 P1.\n").exit_code, 1);
    // Equal motions in different words.
    EXPECT_EQ(differs("G1 X30. F500.", "G1 X0. F500.\nX30.").exit_code, 0);
    EXPECT_EQ(differs("G0 Z-2.\n", "G0 Z-2. M8\nM9\n").exit_code, 0);
    EXPECT_EQ(
        differs("G1 X30. F500.", "G20 G1 X1.1811023622047243 F19.68503937007874\nG21").exit_code,
        0);
}

// The options of the command line hold for both jobs, also a switch that is off.
TEST(Diff, OfJobsHasTheOptionsOfTheCommandLine) {
    Folder folder;
    folder.write("a.nc", replaced("G1 X30. F500.", "/G1 X30. F500."));
    folder.write("a.toml", "version = 2\nprogram = \"a.nc\"\n");
    folder.write("b.toml", "version = 2\nprogram = \"a.nc\"\n");
    const auto volume_of = [&](const char* option) {
        const Ran ran = folder.run({"diff", "a.toml", "b.toml", option, "--json", "d.json"});
        EXPECT_EQ(ran.exit_code, 0) << option << ran.out << ran.err;
        const json d = json::parse(folder.read("d.json"));
        EXPECT_EQ(d["old_mm3"], d["new_mm3"]) << option;
        return d["new_mm3"].get<double>();
    };
    EXPECT_DOUBLE_EQ(volume_of("--block-delete=off"), 11200.0);
    EXPECT_DOUBLE_EQ(volume_of("--block-delete=on"), 12000.0);
}

TEST(Diff, LetsATolerancePass) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", replaced("G0 Z-2.\n", "G0 Z-2.001\n"));
    // The difference is 40 x 10 x 0.001 mm = 0.4 mm³.
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--tol", "0.39"}).exit_code, 1);
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--tol", "0.41"}).exit_code, 0);
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "-q"}).out, "");
}

TEST(Diff, OfDifferentBlocksIsADifference) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", replaced("40.,30.,10.,20.", "41.,30.,10.,20."));
    const Ran ran = folder.run({"diff", "a.nc", "b.nc"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.out.find("the stocks differ"), std::string::npos) << ran.out;
    EXPECT_EQ(folder.run({"diff", "a.nc", "b.nc", "--stock", "40x30x10"}).exit_code, 0);
}

// Code 1 is a difference, as for diff: scripts distinguish a difference from a failed comparison.
TEST(Diff, OfWhatCannotBeCutFails) {
    Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n");
    folder.write("fault.nc", replaced("G1 X30. F500.", "G1 X3O. F500."));
    EXPECT_EQ(folder.run({"diff", "a.nc", "fault.nc"}).exit_code, 2);
    EXPECT_EQ(folder.run({"diff", "fault.nc", "a.nc"}).exit_code, 2);
    const Ran ran = folder.run({"diff", "a.nc", "b.nc"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("tool 7 is not described"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.run({"diff", "a.nc", "missing.nc"}).exit_code, 2);
    EXPECT_EQ(folder.run({"diff", "a.nc"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
