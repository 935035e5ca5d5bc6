// SPDX-License-Identifier: GPL-3.0-or-later
//
// Folders and lists of programs: each file is checked, checked with the program that calls the
// file, or named in the report.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// Returns the values of `key` in a list of objects, in order.
Words values_of(const Json& list, const char* key) {
    Words values;
    for (const Json& one : list)
        values.push_back(one.at(key));
    return values;
}

Json checked(const Folder& folder, const Words& arguments, int exit_code) {
    Words words{"check", "--json", "report.json", "-q"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Ran ran = folder.run(words);
    EXPECT_EQ(ran.exit_code, exit_code) << ran.out << ran.err;
    return folder.has("report.json") ? Json::parse(folder.read("report.json")) : Json();
}

TEST(ProgramFolder, JudgesProgramsOfAnyName) {
    Folder folder;
    const Words names{"O0001", "a.EIA", "b.MPF", "c.spf", "d.gcode", "e.NCC", "f.min",
                      "g.pim", "h.iso", "i.ptp", "j.Cnc", "k.TAP",   "l.h",   "m.txt",
                      "n.TXT", "o",     "p.q.r", ".s",    "t.dat"};
    for (const std::string& name : names)
        folder.write("all/" + name, kSlot);
    const Json report = checked(folder, {"all"}, 0);
    EXPECT_EQ(report["programs"].size(), names.size()) << report["left_out"];
    EXPECT_TRUE(report["left_out"].empty());
}

TEST(ProgramFolder, NamesWhatItLeavesOut) {
    Folder folder;
    folder.write("all/part.nc", kSlot);
    folder.write("all/pins.h", "#define X1 5\nint G0(void);\n");
    folder.write("all/README.md", "# Parts\n");
    folder.write("all/tools.tbl", "T1 P1 D6 Z0.5 ;end mill\n");
    folder.write("all/list.csv", "a,b,c\n1,2,3\n");
    folder.write("all/run.sh", "#!/bin/sh\n");
    folder.write("all/notes.txt", "clamped in the vice\n");
    folder.write("all/picture", std::string("\x89PNG\0\0\0I", 8));
    folder.write("all/empty", "");
    folder.write("all/.git/config", "G0 X1\n");
    const Ran ran = folder.run({"check", "all", "--json", "all/report.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_TRUE(contains(ran.err, "9 left out")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "  binary file: 1: all/picture")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "  text without G-code: 1: all/notes.txt")) << ran.err;
    const Words excluded{"all/.git",     "all/README.md", "all/empty",
                         "all/list.csv", "all/notes.txt", "all/picture",
                         "all/pins.h",   "all/run.sh",    "all/tools.tbl"};
    const Json report = Json::parse(folder.read("all/report.json"));
    EXPECT_EQ(values_of(report["left_out"], "file"), excluded);
    // The report of an earlier run is not an entry of the folder.
    ASSERT_EQ(folder.run({"check", "all", "--json", "all/report.json"}).exit_code, 0);
    EXPECT_EQ(Json::parse(folder.read("all/report.json")), report);
    for (int i = 0; i < 9; ++i)
        folder.write("all/more" + std::to_string(i), "words\n");
    EXPECT_TRUE(contains(folder.run({"check", "all"}).err, " and 7 more")) << "of ten texts";
}

TEST(ProgramFolder, JudgesADamagedProgramThatIsCalledOne) {
    Folder folder;
    folder.write("all/part.nc", kSlot);
    folder.write("all/cut-off.nc", "");
    const Json report = checked(folder, {"all"}, 1);
    EXPECT_EQ(values_of(report["programs"], "file"), (Words{"all/cut-off.nc", "all/part.nc"}));
    folder.write("all/cut-off.nc", std::string("G0 X1\0\0\0Y", 9));
    (void)checked(folder, {"all"}, 2);
}

TEST(ProgramFolder, OpensRegularFilesOfTheFolderOnly) {
    Folder folder;
    folder.write("all/part.nc", kSlot);
    folder.write("other/secret.nc", kSlot);
    folder.write("outside.nc", kSlot);
    const fs::path all = folder.path() / "all";
    fs::create_symlink("../outside.nc", all / "out.nc");
    fs::create_symlink("../other", all / "folder");
    fs::create_symlink(".", all / "circle");
    fs::create_symlink("nowhere", all / "dead.nc");
    fs::create_symlink("/dev/zero", all / "zero.nc");
    fs::create_symlink("part.nc", all / "same.nc");
    folder.shell("mkfifo all/pipe.nc");
    const Json report = checked(folder, {"all"}, 0);
    EXPECT_EQ(values_of(report["programs"], "file"), (Words{"all/part.nc", "all/same.nc"}));
    EXPECT_EQ(values_of(report["left_out"], "file"),
              (Words{"all/circle", "all/dead.nc", "all/folder", "all/out.nc", "all/pipe.nc",
                     "all/zero.nc"}));
    EXPECT_EQ(values_of(report["left_out"], "why"),
              (Words{"link to a folder", "link that leads nowhere", "link to a folder",
                     "link out of the folder", "FIFO", "device"}));
}

TEST(ProgramFolder, WithoutProgramsIsAnError) {
    Folder folder;
    folder.write("all/notes.txt", "words\n");
    const Ran ran = folder.run({"check", "all"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "there are no NC programs in 'all'")) << ran.err;
}

TEST(ProgramList, NamesEntriesThatAreNoPrograms) {
    Folder folder;
    folder.write("part.nc", kSlot);
    folder.write("README.md", "# Parts\n");
    fs::create_directory(folder.path() / "nothing");
    folder.shell("mkfifo pipe");
    folder.write("list", "part.nc\nREADME.md\npipe\nnothing\n");
    const Json report = checked(folder, {"--list", "list"}, 0);
    EXPECT_EQ(values_of(report["left_out"], "file"), (Words{"README.md", "pipe", "nothing"}));
    folder.write("list", "part.nc\nmissing.nc\n");
    (void)checked(folder, {"--list", "list"}, 2);
    folder.write("list", "README.md\n");
    (void)checked(folder, {"--list", "list"}, 2);
}

// Writes a slot whose cut is in O100, which only slot.nc calls.
void write_caller(const Folder& folder) {
    folder.write("all/slot.nc", replaced(kSlot, "G1 X30. F500.", "M98 P100"));
    folder.write("all/O100.nc", "O100\nM98 P101\nM99\n");
    folder.write("all/O101", "O101\nG1 X30. F500.\nM99\n");
}

TEST(SubprogramFile, IsJudgedWithItsCaller) {
    Folder folder;
    write_caller(folder);
    const Ran ran = folder.run({"check", "all"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out,
                         "1 program: 1 clean, 0 not proven, 0 failed, 0 not verified; "
                         "2 subprograms, judged with their callers\n"))
        << ran.out;
    const Json report = checked(folder, {"all"}, 0);
    EXPECT_EQ(values_of(report["programs"], "file"), Words{"all/slot.nc"});
    EXPECT_EQ(values_of(report["subprograms"], "file"), (Words{"all/O100.nc", "all/O101"}));
    EXPECT_EQ(values_of(report["subprograms"], "judged_with"), Words(2, "all/slot.nc"));
    // A named file is checked alone.
    EXPECT_EQ(checked(folder, {"all/slot.nc", "all/O101"}, 1)["programs"].size(), 2U);
}

TEST(SubprogramFile, ThatNoProgramCallsIsJudgedAlone) {
    Folder folder;
    write_caller(folder);
    folder.write("all/O100.nc", "O100\nG1 X30. F500.\nM99\n");
    const Json uncalled = checked(folder, {"all"}, 1);
    EXPECT_EQ(values_of(uncalled["programs"], "file"), (Words{"all/slot.nc", "all/O101"}));
    // A called but complete program is checked, too, because the control can start the program
    // alone.
    folder.write("all/O100.nc", "O100\nG1 X30. F500.\nM30\n");
    EXPECT_EQ(checked(folder, {"all"}, 1)["programs"].size(), 3U);
    // The calling program was not checked.
    write_caller(folder);
    folder.write("all/slot.nc", folder.read("all/slot.nc") + std::string("\0", 1) + "X");
    EXPECT_EQ(checked(folder, {"all"}, 2)["programs"].size(), 2U);
}

TEST(SubprogramFile, IsTheSameFromShardsAndCaches) {
    Folder folder;
    write_caller(folder);
    folder.write("all/notes.txt", "words\n");
    folder.write("all/O9", "O9\nG1 X30. F500.\nM99\n");
    const Words reports{"--json", "a.json", "--junit", "a.xml", "--sarif", "a.sarif"};
    const auto ran = [&](Words words) {
        words.insert(words.end(), reports.begin(), reports.end());
        const Ran result = folder.run(words);
        return result.out + folder.read("a.json") + folder.read("a.xml") + folder.read("a.sarif");
    };
    const std::string once = ran({"check", "all"});
    EXPECT_TRUE(contains(once, "; 2 subprograms, judged with their callers; 1 left out")) << once;
    EXPECT_TRUE(once == ran({"check", "all", "--isolate", "-j", "3"}));
    EXPECT_TRUE(once == ran({"check", "all", "--cache", "known"}));
    EXPECT_TRUE(once == ran({"check", "all", "--cache", "known"}));
    for (const char* number : {"0/3", "1/3", "2/3"})
        ASSERT_EQ(folder.run({"check", "all", "--shard", number, "--out", "shards"}).exit_code, 0);
    EXPECT_TRUE(once == ran({"merge", "shards"}));
    // Results of shards and cached verdicts are not files of the folder.
    for (const char* option : {"--cache=all/known", "--cache=all/known"})
        EXPECT_TRUE(once == ran({"check", "all", option}));
    folder.shell("rm -r all/known");
    for (const char* number : {"0/2", "1/2"})
        ASSERT_EQ(folder.run({"check", "all", "--shard", number, "--out=all/out"}).exit_code, 0);
    EXPECT_TRUE(once == ran({"merge", "all/out"}));
}

}  // namespace
}  // namespace ncsim::cli_test
