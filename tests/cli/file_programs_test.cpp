// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files with several programs: each program has a separate verdict in each report.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// The second program cuts the slot at rapid, in line 19.
std::string two_programs() {
    return "O0100\n" + std::string(kSlot) + "O0101\n" + replaced(kSlot, "G1 X30. F500.", "G0 X30.");
}

TEST(FileOfPrograms, HasAVerdictForEach) {
    Folder folder;
    folder.write("two.nc", two_programs());
    const Ran ran = folder.run({"check", "two.nc", "--json", "a.json"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out,
                         "two.nc:20:1: error: O0101: rapid move through material: removed "
                         "800 mm3 [rapid-in-material]\n  | G0 X30."))
        << ran.out;
    EXPECT_TRUE(contains(ran.out, "two.nc (O0100): clean: ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "two.nc (O0101): failed: ")) << ran.out;
    const Json programs = Json::parse(folder.read("a.json"))["programs"];
    ASSERT_EQ(programs.size(), 2U);
    EXPECT_EQ(programs[0]["program"], "O0100");
    EXPECT_EQ(programs[0]["verdict"], "clean");
    EXPECT_EQ(programs[1]["file"], "two.nc");
    EXPECT_EQ(programs[1]["verdict"], "failed");
    for (const Json& finding : programs[1]["findings"]) {
        EXPECT_EQ(finding["program"], "O0101");
        if (finding["rule"] == "rapid-in-material") {
            EXPECT_EQ(finding["line"], 20);
        }
    }
    folder.write("one.nc", kSlot);
    const Ran many = folder.run({"check", "two.nc", "one.nc"});
    EXPECT_TRUE(contains(many.out, "failed:\n  two.nc (O0101): 1 error")) << many.out;
    EXPECT_TRUE(contains(many.out, "3 programs: 2 clean, 0 not proven, 1 failed")) << many.out;
}

TEST(FileOfPrograms, IsTheSameFromShardsCachesAndPipes) {
    Folder folder;
    folder.write("all/two.nc", two_programs());
    folder.write("all/one.nc", kSlot);
    const Words reports{"--json",  "a.json",  "--junit",          "a.xml",
                        "--sarif", "a.sarif", "--write-baseline", "known.json"};
    const auto ran = [&](Words words) {
        words.insert(words.end(), reports.begin(), reports.end());
        const Ran result = folder.run(words);
        return result.out + folder.read("a.json") + folder.read("a.xml") + folder.read("a.sarif") +
               folder.read("known.json");
    };
    const std::string once = ran({"check", "all"});
    EXPECT_TRUE(contains(once, "3 programs: ")) << once;
    EXPECT_TRUE(once == ran({"check", "all", "--isolate", "-j", "3"}));
    EXPECT_TRUE(once == ran({"check", "all", "--cache", "known"}));
    EXPECT_TRUE(once == ran({"check", "all", "--cache", "known"}));
    for (const char* number : {"0/2", "1/2"})
        ASSERT_EQ(folder.run({"check", "all", "--shard", number, "--out", "shards"}).exit_code, 0);
    EXPECT_TRUE(once == ran({"merge", "shards"}));
    const Ran pipe = folder.shell(R"(mkfifo p; cat all/two.nc >p & "$0" check p)");
    EXPECT_EQ(pipe.exit_code, 1);
    EXPECT_TRUE(contains(pipe.out, "p (O0101): failed: ")) << pipe.out << pipe.err;
    EXPECT_EQ(folder.shell(R"("$0" check - <all/two.nc)").exit_code, 1);
}

TEST(FileOfPrograms, HasKnownFindingsOfEach) {
    Folder folder;
    const std::string bad = replaced(kSlot, "G1 X30. F500.", "G0 X30.");
    folder.write("two.nc", "O0100\n" + bad + "O0101\n" + bad);
    ASSERT_EQ(folder.run({"check", "two.nc", "--write-baseline", "known.json"}).exit_code, 1);
    const Ran ran = folder.run({"check", "two.nc", "--baseline", "known.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_FALSE(contains(ran.out, "no longer there")) << ran.out;
    EXPECT_EQ(
        folder
            .run({"check", "two.nc", "--baseline", "known.json", "--write-baseline", "known.json"})
            .exit_code,
        0);
    EXPECT_EQ(folder.run({"check", "two.nc", "--baseline", "known.json"}).exit_code, 0);
    // A fault of the first program does not count for the second.
    folder.write("two.nc", "O0100\n" + bad + "O0102\n" + bad);
    EXPECT_EQ(folder.run({"check", "two.nc", "--baseline", "known.json"}).exit_code, 1);
}

TEST(FileOfPrograms, TakesToolsAndStockOfEach) {
    Folder folder;
    // The second block is as low as the slot, so no material is left there.
    folder.write("two.nc",
                 "O0100\n" + std::string(kSlot) + "O0101\n" +
                     replaced(kSlot, "40.,30.,10.,20.,15.,10.", "40.,30.,10.,20.,15.,20."));
    const Ran ran = folder.run({"check", "two.nc"});
    EXPECT_TRUE(contains(ran.out, "two.nc (O0100): clean: ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "O0101: ")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "Z -10 to 0")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "Z -20 to -10")) << ran.out;
}

TEST(Pages, AreOneForEachProgramAndAnIndex) {
    Folder folder;
    folder.write("all/two.nc", two_programs());
    folder.write("all/sub/a b.nc", kSlot);
    folder.write("all/sub_a b.nc", kSlot);
    folder.write("all/notes.txt", "words\n");
    ASSERT_EQ(folder.run({"check", "all", "--html", "pages/", "-j", "3"}).exit_code, 1);
    const std::string index = folder.read("pages/index.html");
    for (const char* row :
         {"<a href=\"all_two.nc~O0100.html\">all/two.nc (O0100)</a>",
          "<a href=\"all_two.nc~O0101.html\">all/two.nc (O0101)</a>",
          "src=\"all_two.nc~O0101.png\"", "<a href=\"all_sub_a_b.nc~1.html\">all/sub/a b.nc</a>",
          "<a href=\"all_sub_a_b.nc~2.html\">all/sub_a b.nc</a>",
          "all/notes.txt: text without G-code"})
        EXPECT_TRUE(contains(index, row)) << row << '\n' << index.substr(index.find("<header"));
    EXPECT_LT(index.find("<tr role=\"row\" class=\"failed\">"),
              index.find("<tr role=\"row\" class=\"clean\">"));
    EXPECT_EQ(folder.read("pages/all_two.nc~O0101.png").substr(1, 3), "PNG");
    EXPECT_TRUE(contains(folder.read("pages/all_two.nc~O0101.html"), "O0101: rapid move through"));
    EXPECT_FALSE(contains(folder.read("pages/all_two.nc~O0100.html"), "O0101: rapid move through"));
    EXPECT_TRUE(contains(folder.read("pages/all_sub_a_b.nc~1.html"), "all/sub/a b.nc: clean"));
    // The index is a file in the checked folder; the next run writes the same bytes.
    ASSERT_EQ(folder.run({"check", "all", "--html", "all/all.html"}).exit_code, 1);
    const std::string beside = folder.read("all/all.html");
    EXPECT_TRUE(contains(beside, "<a href=\"all-pages/all_two.nc~O0101.html\">")) << beside;
    EXPECT_TRUE(folder.has("all/all-pages/all_two.nc~O0101.html"));
    ASSERT_EQ(folder.run({"check", "all", "--html", "all/all.html"}).exit_code, 1);
    EXPECT_TRUE(folder.read("all/all.html") == beside);
    // A file with two programs, and a program with a page that cannot be read.
    ASSERT_EQ(folder.run({"check", "all/two.nc", "--html", "two.html"}).exit_code, 1);
    EXPECT_TRUE(contains(folder.read("two.html"), "<a href=\"two-pages/all_two.nc~O0100.html\">"));
    ASSERT_EQ(folder.run({"check", "none.nc", "all/two.nc", "--html", "p/"}).exit_code, 2);
    EXPECT_TRUE(
        contains(folder.read("p/index.html"), "<a href=\"none.nc.html\">none.nc</a><small>cannot"));
    EXPECT_EQ(folder.run({"check", "all", "--html", "all/two.nc"}).exit_code, 2);
}

TEST(FileOfPrograms, IsReadUpToItsSecondProgramByOtherCommands) {
    Folder folder;
    folder.write("one.nc", kSlot);
    folder.write("two.nc", std::string(kSlot) + "O0101\nT5 M6\nG0 X9.\nM30\n");
    ASSERT_EQ(folder.run({"run", "one.nc", "--stl", "one.stl", "-q"}).exit_code, 0);
    const Ran ran = folder.run({"run", "two.nc", "--stl", "two.stl", "-q"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.err, "more programs from here on (O0101); only program 1")) << ran.err;
    // The header of the second file says that a program was not read.
    constexpr std::size_t kHeader = 80;
    EXPECT_EQ(folder.read("one.stl").substr(kHeader), folder.read("two.stl").substr(kHeader));
    EXPECT_TRUE(contains(folder.run({"tools", "two.nc"}).err, "more programs from here on"));
    const Ran tile = folder.run({"check", "two.nc", "--tile", "0/2", "--tile-out", "t"});
    EXPECT_EQ(tile.exit_code, 2);
    EXPECT_TRUE(contains(tile.err, "several programs")) << tile.err;
}

}  // namespace
}  // namespace ncsim::cli_test
