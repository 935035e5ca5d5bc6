// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim parse: blocks and motions of a program.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

TEST(Parse, ListsWhatAControlDoesNotHave) {
    Folder folder;
    folder.write("a.nc", "G21 G90\nG0 X0 Y0\nG81 X1 Z-1 R1 F100\nX2\nG81 X3\nM7\nM2\n");
    Ran ran = folder.run({"parse", "a.nc", "--for", "grbl"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(
        ran.out,
        "a.nc:3:1: grbl 1.1 has no G81 (2 times)\n"
        "a.nc:6:1: M7 is an option of grbl 1.1\n"
        "a.nc: grbl 1.1 lacks 1 of what this program uses; it answers with error 20 and stops "
        "the stream\n"
        "source: gnea/grbl, grbl/gcode.c at v1.1h\n");
    ran = folder.run({"parse", "a.nc", "--for", "haas"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "M7 is not in the list of codes of Haas")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "the list may have gaps")) << ran.out;
    ran = folder.run({"parse", "a.nc", "--for", "linuxcnc"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_TRUE(contains(ran.out, "has all codes of this program")) << ran.out;
    const json lacks = json::parse(folder.run({"parse", "a.nc", "--for", "grbl", "--json"}).out);
    EXPECT_EQ(lacks.at("lacks").at(0).at("what"), "G81");
    EXPECT_EQ(lacks.at("lacks").at(0).at("line"), 3);
    EXPECT_EQ(lacks.at("options").size(), 1U);
    EXPECT_EQ(folder.run({"parse", "a.nc", "--for", "grbl", "--canonical"}).exit_code, 2);
    folder.write("b.nc", "G21 G90\nG#100 X0\nM2\n");
    ran = folder.run({"parse", "b.nc", "--for", "fanuc"});
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_TRUE(contains(ran.out, "b.nc:2:1: codes by expressions cannot be judged")) << ran.out;
    ran = folder.run({"parse", "a.nc", "--for", "siemens"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "--for 'siemens': expected grbl,")) << ran.err;
}

TEST(Parse, ReportsWhatCannotBeReadAndExitsWithOne) {
    Folder folder;
    folder.write("a.nc", "G21 G90\nG0 X Y2 Z3\nG0 Z1.5\nG1 X1 F100\nM2\n");
    const Ran blocks = folder.run({"parse", "a.nc"});
    EXPECT_EQ(blocks.exit_code, 1);
    EXPECT_NE(blocks.out.find("L2 unreadable"), std::string::npos) << blocks.out;
    EXPECT_NE(blocks.err.find("a.nc:2:"), std::string::npos) << blocks.err;
    const Ran motions = folder.run({"parse", "a.nc", "--canonical"});
    EXPECT_EQ(motions.exit_code, 1);
    EXPECT_NE(motions.out.find("L4 feed X1 "), std::string::npos) << motions.out;
}

TEST(Parse, WritesJsonWithFindings) {
    Folder folder;
    folder.write("a.nc", "G21 G0 X1 Y2 Z3 (\xff)\nG3 X3 I1 Z2 F50 E9\nM2\n");
    const Ran blocks = folder.run({"parse", "a.nc", "--json"});
    const json b = json::parse(blocks.out);
    EXPECT_EQ(b["program"], "a.nc");
    EXPECT_EQ(b["blocks"].size(), 3U);
    EXPECT_EQ(b["blocks"][1]["words"][1]["text"], "X3");
    EXPECT_EQ(b["blocks"][1]["words"][1]["column"], 4);

    const Ran motions = folder.run({"parse", "a.nc", "--canonical", "--json"});
    const json m = json::parse(motions.out);
    ASSERT_EQ(m["motions"].size(), 2U) << motions.err;
    EXPECT_EQ(m["motions"][0]["unknown_start"], "xyz");
    EXPECT_EQ(m["motions"][1]["what"], "arc");
    EXPECT_EQ(m["motions"][1]["centre"], json::array({2.0, 2.0}));
    EXPECT_EQ(m["motions"][1]["turns"], 1);
    EXPECT_EQ(m["motions"][1]["feed"], 50.0);
    bool has_unknown_word = false;
    for (const json& finding : m["findings"]) {
        if (finding["line"] == 2 && finding["column"] == 17) has_unknown_word = true;
    }
    EXPECT_TRUE(has_unknown_word) << m["findings"];
}

}  // namespace
}  // namespace ncsim::cli_test
