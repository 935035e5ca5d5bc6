// SPDX-License-Identifier: GPL-3.0-or-later
//
// For any invalid input: a clear message, the correct exit code, and no new file.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace ncsim::cli_test {
namespace {

struct Case {
    const char* name;
    std::string program;
    std::vector<std::string> more;
    int exit_code;
    const char* message;
};

std::vector<Case> cases() {
    const std::string called = "G21 G90\nT1 M6\n";
    const std::string tool = "(T1 D=10. - flat end mill)\n";
    return {
        {"empty", "", {}, 1, "there is no NC program in this file"},
        {"blank", " \r\n\n", {}, 1, "there is no NC program in this file"},
        {"binary",
         std::string("\x7f"
                     "ELF\2\1\1\0\0\0\0\0garbage",
                     19),
         {},
         2,
         "is not an NC program"},
        {"nothing moves", "G21\nM3\nM30\n", {}, 1, "the program makes no move"},
        {"only rapids",
         tool + called + "G0 X0 Y0 Z0\nG0 X10\nM30\n",
         {},
         1,
         "no cutting move, only rapid ones"},
        {"too little memory",
         tool + called + "G0 X0 Y0 Z5\nG1 Z-1 F10\nX20\nM30\n",
         {"--max-memory", "0.0001"},
         2,
         "more than --max-memory 0.0001: given up"},
        {"unknown tool",
         called + "G0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n",
         {},
         1,
         "tool 1 is not described; say what it is with --tool T1="},
        {"no tool",
         "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n",
         {},
         1,
         "no tool is called before this cut"},
        {"absurd path",
         tool + called + "G0 X0 Y0 Z5\nG1 Z-1 F10\nG1 X9999999\nM30\n",
         {},
         1,
         "is a unit wrong, or a number?"},
        {"unwritable",
         kSlot,
         {"--png", "no/such/folder/a.png"},
         2,
         "cannot write 'no/such/folder/a.png'"},
        {"output is a folder", kSlot, {"--stl", "."}, 2, "cannot write '.'"},
        {"picture too large",
         kSlot,
         {"--png", "a.png", "--size", "1000000x1000000"},
         2,
         "expected WxH"},
        {"stock too large", kSlot, {"--stock", "1e30x1x1"}, 2, "--stock"},
        {"disk full",
         kSlot,
         {"--png", "a.png", "--stl", "/dev/full"},
         2,
         "cannot write '/dev/full': No space left"},
        {"disk full for the report",
         kSlot,
         {"--gltf", "a.glb", "--report", "/dev/full"},
         2,
         "No space left"},
    };
}

TEST(BadInput, GetsAClearMessageTheRightExitCodeAndLeavesNoFile) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Folder folder;
        folder.write("part.nc", c.program);
        std::vector<std::string> arguments{"run", "part.nc"};
        if (c.more.empty())
            arguments.insert(arguments.end(), {"--png", "a.png", "--gltf", "a.glb"});
        arguments.insert(arguments.end(), c.more.begin(), c.more.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, c.exit_code) << ran.err;
        EXPECT_NE(ran.err.find(c.message), std::string::npos) << ran.err;
        EXPECT_EQ(folder.files(), std::vector<std::string>{"part.nc"});
    }
}

TEST(BadInput, ThatIsNotThereOrAFolderIsNamed) {
    Folder folder;
    const Ran missing = folder.run({"run", "missing.nc"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_EQ(missing.err, "ncsim: cannot read 'missing.nc': No such file or directory\n");
    const Ran directory = folder.run({"run", "."});
    EXPECT_EQ(directory.exit_code, 2);
    EXPECT_EQ(directory.err, "ncsim: cannot read '.': Is a directory\n");
}

TEST(BadInput, OfAnUnknownToolNamesTheBlock) {
    Folder folder;
    folder.write("part.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n");
    const Ran ran = folder.run({"run", "part.nc", "-q"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.err.find("part.nc:"), std::string::npos);
    EXPECT_NE(ran.err.find("error: tool 7 is not described"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("[tool-unknown]"), std::string::npos);
}

TEST(BadInput, AssumeToolLiftsThatAndIsShown) {
    Folder folder;
    folder.write("part.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nX20\nM30\n");
    const Ran ran = folder.run({"run", "part.nc", "--assume-tool", "ball:D6"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.err.find("ball end mill D6"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("assumed: ball:D6"), std::string::npos) << ran.err;
}

TEST(BadInput, IsReportedInTheReportToo) {
    Folder folder;
    folder.write("part.nc", "G21 G90\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\nM30\n");
    const Ran ran = folder.run({"run", "part.nc", "-q", "--report", "a.json", "--png", "a.png"});
    EXPECT_EQ(ran.exit_code, 1);
    const auto report = nlohmann::json::parse(folder.read("a.json"));
    EXPECT_EQ(report["simulated"], false);
    EXPECT_EQ(report["findings"][0]["code"], "tool-unknown");
    EXPECT_FALSE(folder.has("a.png"));
}

TEST(BadInput, InOneBlockDoesNotHideTheOthers) {
    Folder folder;
    std::string text(kSlot);
    text.insert(text.find("G0 Z5.\nM30"), "G1 X (\n");
    folder.write("part.nc", text);
    const Ran ran = folder.run({"run", "part.nc"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.out.find("0.800 cm3 removed"), std::string::npos) << ran.out << ran.err;
    EXPECT_NE(ran.err.find("part.nc:9:"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("the part is not what the blocks with errors"), std::string::npos);
}

TEST(BadInput, CannotSpeakToTheTerminal) {
    Folder folder;
    folder.write("part.nc",
                 std::string("(T1 D=10. \x1b[2J - flat end mill)\n") + kSlot + "G1 X\x1b[31m\n");
    const Ran ran = folder.run({"run", "part.nc"});
    EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(ran.out.find('\x1b'), std::string::npos);
}

TEST(BadInput, WithBytesThatAreNoTextStillMakesAReport) {
    Folder folder;
    folder.write("part.nc", std::string("(T1 D=10. \xff\xfe - flat end mill)\n") + kSlot);
    const Ran ran = folder.run({"run", "part.nc", "-q", "--report", "a.json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(nlohmann::json::accept(folder.read("a.json")));
}

}  // namespace
}  // namespace ncsim::cli_test
