// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim.toml: options for a folder of programs.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

// The rapid moves pass through a vice that only the machine file describes.
constexpr const char* kVice =
    "[[fixture]]\nname = \"vice\"\nbox = [[-29, -30, 0], [-24, 30, 20]]\n";

// Repository with programs in two folders and a machine for one folder.
struct Repository : Folder {
    explicit Repository(const std::string& project) {
        for (const char* name : {"plain/deep", "clamped", "machines"})
            std::filesystem::create_directories(path() / name);
        write("plain/deep/a.nc", kSlot);
        write("clamped/b.nc", kSlot);
        write("machines/vice.toml", kVice);
        write("ncsim.toml", "version = 1\n" + project);
    }
};

TEST(Project, TellsProgramsBelowItTheirMachine) {
    const Repository folder(
        "[[program]]\nfiles = [\"clamped/**\"]\nmachine = \"machines/vice.toml\"\n");
    const Ran all = folder.run({"check", "."});
    EXPECT_EQ(all.exit_code, 1) << all.err;
    EXPECT_TRUE(contains(all.out, "./clamped/b.nc:6:1: error: ")) << all.out;
    EXPECT_FALSE(contains(all.out, "a.nc:")) << all.out;
    EXPECT_TRUE(contains(all.out, "  settings ncsim.toml\n")) << all.out;
    // The same verdict from a subfolder, from elsewhere and by the absolute path.
    const Ran below = folder.shell("cd clamped && \"$0\" check b.nc");
    EXPECT_EQ(below.exit_code, 1) << below.err;
    EXPECT_TRUE(contains(below.out, "  settings ../ncsim.toml\n")) << below.out;
    EXPECT_EQ(folder.shell("cd plain/deep && \"$0\" check ../../clamped/b.nc").exit_code, 1);
    EXPECT_EQ(folder.shell("cd / && \"$0\" check \"$OLDPWD/clamped/b.nc\"").exit_code, 1);
    EXPECT_EQ(folder.shell("cd clamped && \"$0\" check - < b.nc").exit_code, 1);
    EXPECT_EQ(folder.run({"check", "plain"}).exit_code, 0);
    // --no-project ignores the file.
    EXPECT_EQ(folder.run({"check", "clamped", "--no-project"}).exit_code, 0);
}

TEST(Project, IsReadByEveryCommandThatReadsAProgram) {
    const Repository folder("stock = \"80x60x20\"\naccept = [\"all\"]\n");
    const auto stock_of = [&](const std::vector<std::string>& words) {
        const Ran ran = folder.run(words);
        EXPECT_NE(ran.exit_code, 2) << ran.err;
        return ran.out + ran.err;
    };
    const std::string stock = "80 x 60 x 20 mm";
    const std::string program = "plain/deep/a.nc";
    for (const char* command : {"run", "check", "tools", "measure"}) {
        SCOPED_TRACE(command);
        EXPECT_TRUE(contains(stock_of({command, program}), stock));
        EXPECT_FALSE(contains(stock_of({command, program, "--no-project"}), stock));
        EXPECT_FALSE(contains(stock_of({command, program, "--stock=90x60x20"}), stock));
    }
    EXPECT_TRUE(contains(stock_of({"run", program}), "settings  ncsim.toml\n"));
    // The volumes of both programs are those of the stock in the file.
    EXPECT_NE(stock_of({"diff", program, "clamped/b.nc"}),
              stock_of({"diff", program, "clamped/b.nc", "--no-project"}));
    folder.write("ncsim.toml", "version = 1\nstrict = true\n");
    folder.write("plain/q.nc", "G21 G90\nG1 X1 Q5 F100\nM2\n");
    EXPECT_EQ(folder.run({"parse", "plain/q.nc", "--canonical"}).exit_code, 1);
    EXPECT_EQ(folder.run({"parse", "plain/q.nc", "--canonical", "--no-project"}).exit_code, 0);
    // A fault is an error of every command, with its place.
    folder.write("ncsim.toml", "version = 1\ntolerance = \"wide\"\n");
    for (const char* command : {"run", "tools", "measure", "parse"}) {
        const Ran ran = folder.run({command, program});
        EXPECT_EQ(ran.exit_code, 2) << command;
        EXPECT_TRUE(contains(ran.err, "ncsim.toml:2:1")) << ran.err;
    }
}

TEST(Project, GivesWayToTheCommandLine) {
    const Repository folder("ignore = [\"collision\"]\nmachine = \"machines/vice.toml\"\n");
    EXPECT_EQ(folder.run({"check", "clamped"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "clamped", "--ignore", "air-cut"}).exit_code, 1);
    EXPECT_EQ(folder.run({"check", "--ignore", "air-cut", "--", "clamped/b.nc"}).exit_code, 1);
}

TEST(Project, IsLookedForUpToTheRepository) {
    const Repository folder("machine = \"machines/vice.toml\"\n");
    std::filesystem::create_directories(folder.path() / "clamped/.git");
    EXPECT_EQ(folder.run({"check", "clamped"}).exit_code, 0);
    // Only the nearest ncsim.toml applies.
    std::filesystem::remove(folder.path() / "clamped/.git");
    EXPECT_EQ(folder.run({"check", "clamped"}).exit_code, 1);
    folder.write("clamped/ncsim.toml", "version = 1\n");
    EXPECT_EQ(folder.run({"check", "clamped"}).exit_code, 0);
}

TEST(Project, TellsWhereItIsWrong) {
    const std::vector<std::pair<std::string, std::string>> kWrong{
        {"jobs = 3", "ncsim.toml:2:8: 'jobs': no option of ncsim check that decides verdicts"},
        {"json = \"x\"", "ncsim.toml:2:8: 'json': no option of"},
        {"save-job = \"x\"", "ncsim.toml:2:12: 'save-job': no option of"},
        {"acept = \"x\"", "ncsim.toml:2:9: 'acept': no option of"},
        {"accept = \"nope\"", "ncsim.toml:2:10: --accept 'nope': no reason for doubt"},
        {"strict = 1", "ncsim.toml:2:10: 'strict': expected true or false"},
        {"stock = true", "ncsim.toml:2:9: 'stock': expected a value"},
        {"stock = \"1x\"", "ncsim.toml:2:9: --stock '1x': expected"},
        {"tolerance = 99", "ncsim.toml:2:13: --tolerance: expected 0.0001 to 10 mm"},
        {"tool = [1.5, [2]]", "ncsim.toml:2:14: 'tool': expected a text, a number, true, false"},
        {"[[program]]\nmachine = \"m\"", "ncsim.toml:2:1: expected files"},
        {"[[program]]\nfiles = [\"a/**\", \"/a/**\"]",
         "ncsim.toml:3:18: '/a/**': expected a path below"},
        {"[[program]]\nfiles = [\"../a.nc\"]", "ncsim.toml:3:10: '../a.nc': expected a path below"},
        {"[[program]]\nfiles = [\"./a.nc\"]", "ncsim.toml:3:10: './a.nc': expected a path below"},
        {"program = 3", "ncsim.toml:2:11: write [[program]]"},
        {"strict = ", "ncsim.toml:2:"},
        {"machine = \"none.toml\"", "cannot read 'none.toml'"},
        {"accept = \"all\\u001b]0;x\"", "ncsim.toml:2:10: --accept"}};
    for (const auto& [text, message] : kWrong) {
        const Repository folder(text + "\n");
        const Ran ran = folder.run({"check", "plain"});
        EXPECT_EQ(ran.exit_code, 2) << text;
        EXPECT_TRUE(ran.err.starts_with("ncsim: " + message)) << text << '\n' << ran.err;
        EXPECT_EQ(ran.out, "") << text;
    }
    const Folder folder;
    folder.write("a.nc", kSlot);
    folder.write("ncsim.toml", "strict = true\n");
    EXPECT_TRUE(folder.run({"check", "a.nc"})
                    .err.starts_with("ncsim: ncsim.toml:1:1: expected version = 1"));
}

// A specified file that cannot be read is an error; ncsim does not continue without the file.
TEST(Project, ThatCannotBeReadIsNotPassedOver) {
    const Repository folder("");
    const auto file = folder.path() / "ncsim.toml";
    std::filesystem::remove(file);
    std::filesystem::create_symlink("nowhere.toml", file);
    EXPECT_EQ(folder.run({"check", "plain"}).exit_code, 2);
    EXPECT_EQ(folder.run({"check", "plain", "--no-project"}).exit_code, 0);
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    EXPECT_EQ(folder.run({"check", "plain"}).exit_code, 2);
    std::filesystem::remove(file);
    std::filesystem::create_symlink("/dev/zero", file);
    EXPECT_EQ(folder.run({"check", "plain"}).exit_code, 2);
}

// Otherwise a requirement for missing files would vanish without a message.
TEST(Project, WhosePatternMatchesNoProgramIsAnError) {
    Folder folder;
    folder.write("a/one.nc", kSlot);
    folder.write("a/two.nc", kSlot);
    folder.write("b/three", kSlot);
    folder.write("b/notes.md", "# Words\n");
    folder.write("own/four.nc", kSlot);
    folder.write("own/ncsim.toml", "version = 1\n");
    const auto checked = [&](const std::string& patterns, const std::string& program) {
        folder.write("ncsim.toml", "version = 1\n[[program]]\nfiles = [" + patterns +
                                       "]\naccept = [\"stock-guess\"]\n");
        return folder.run({"check", program});
    };
    for (const char* program : {".", "a/one.nc", "b/three"}) {
        for (const char* good :
             {"\"a/*.nc\"", "\"**/three\", \"a/**\"", "\"a/two.nc\"", "\"b/**\""})
            EXPECT_EQ(checked(good, program).exit_code, 0) << good << ' ' << program;
        for (const char* bad : {"c/**", "a/*.tap", "a/tow.nc", "own/**", "b/*.md", "one.nc"}) {
            const Ran ran = checked("\"a/**\", \"" + std::string(bad) + '"', program);
            EXPECT_EQ(ran.exit_code, 2) << bad << ' ' << program;
            EXPECT_TRUE(contains(
                ran.err, "ncsim.toml:3:18: '" + std::string(bad) + "' matches no NC program"))
                << ran.err;
        }
    }
    EXPECT_EQ(folder.run({"check", "own/four.nc"}).exit_code, 0);
    EXPECT_EQ(folder.run({"check", "a/one.nc", "--no-project"}).exit_code, 0);
}

// Reading a FIFO without a writer never ends.
TEST(Project, OrAFileThatNamesAPipeDoesNotHang) {
    for (const char* option : {"machine", "tool-table", "job", "design", "holders", "baseline"}) {
        Folder folder;
        folder.write("a.nc", kSlot);
        folder.write("ncsim.toml", "version = 1\n" + std::string(option) + " = \"pipe\"\n");
        const Ran ran = folder.shell(R"(mkfifo pipe; timeout 20 "$0" check a.nc)");
        EXPECT_EQ(ran.exit_code, 2) << option << ran.out;
        EXPECT_TRUE(contains(ran.err, "ncsim.toml:2:")) << ran.err;
        EXPECT_TRUE(contains(ran.err, "no regular file")) << ran.err;
    }
    Folder folder;
    folder.write("a.nc", kSlot);
    EXPECT_EQ(folder.shell(R"(mkfifo ncsim.toml; timeout 20 "$0" check a.nc)").exit_code, 2);
    folder.write("machine.toml", "[[fixture]]\nname = \"jaw\"\nmesh = \"pipe\"\n");
    folder.write("job.toml", "version = 1\nholders = \"pipe\"\n");
    for (const char* option : {"--machine machine.toml", "--job job.toml"}) {
        const Ran ran =
            folder.shell("rm -f ncsim.toml pipe; mkfifo pipe; timeout 20 \"$0\" check a.nc " +
                         std::string(option));
        EXPECT_EQ(ran.exit_code, 2) << option << ran.out;
        EXPECT_TRUE(contains(ran.err + ran.out, "no regular file")) << ran.err << ran.out;
    }
    // The command line may name a pipe: mkfifo, <(…) of a shell.
    const Ran named = folder.shell(
        R"(rm pipe; mkfifo pipe; echo 'T1 P1 D10' >pipe & "$0" check a.nc --tool-table pipe)");
    EXPECT_EQ(named.exit_code, 4) << named.err << named.out;  // the table was read
}

TEST(Project, IsNotWrittenOver) {
    const Repository folder("machine = \"machines/vice.toml\"\n");
    for (const char* name : {"ncsim.toml", "machines/vice.toml"}) {
        const std::string before = folder.read(name);
        EXPECT_EQ(folder.run({"check", "plain", "--json", name}).exit_code, 2) << name;
        EXPECT_EQ(folder.read(name), before);
    }
}

TEST(Project, IsPartOfWhatACacheAndAShardKnow) {
    const Repository folder("");
    const std::vector<std::string> cached{"check", "clamped", "--cache", "c"};
    EXPECT_EQ(folder.run(cached).exit_code, 0);
    folder.write("ncsim.toml", "version = 1\nmachine = \"machines/vice.toml\"\n");
    EXPECT_EQ(folder.run(cached).exit_code, 1);
    EXPECT_EQ(folder.run({"check", ".", "--shard", "0/2", "--out", "o"}).exit_code, 0);
    folder.write("ncsim.toml", "version = 1\n");
    EXPECT_EQ(folder.run({"check", ".", "--shard", "1/2", "--out", "o"}).exit_code, 0);
    EXPECT_EQ(folder.run({"merge", "o"}).exit_code, 2);
    folder.write("ncsim.toml", "version = 1\nmachine = \"machines/vice.toml\"\n");
    EXPECT_EQ(folder.run({"check", ".", "--shard", "1/2", "--out", "o"}).exit_code, 0);
    const Ran merged = folder.run({"merge", "o"});
    EXPECT_EQ(merged.exit_code, 1) << merged.err;
    // Without --out the results would become files of the folder that are skipped.
    folder.shell("rm -r o");
    EXPECT_EQ(merged.out, folder.run({"check", "."}).out);
}

}  // namespace
}  // namespace ncsim::cli_test
