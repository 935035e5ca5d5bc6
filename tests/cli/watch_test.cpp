// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim --watch: runs again when a file changes, and ends with Ctrl+C.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>

namespace ncsim::cli_test {
namespace {

// Program with the slot at rapid, which a check does not pass.
std::string at_rapid() {
    std::string text = kSlot;
    return text.replace(text.find("G1 X30. F500."), 13, "G0 X30.");
}

// Folder in which `command` is watched. Steps of the script end when the text on stderr has a given
// number of lines of --watch.
struct Watched : Folder {
    // Runs `command`, then `script`, in which `runs N` waits for the Nth run, and then Ctrl+C.
    Ran watch(const std::string& command, const std::string& script) const {
        return shell(
            "runs() {\n"
            "  n=0\n"
            "  until test $(grep -c '^watch ' log) -ge $1 || test $n -ge 400; do\n"
            "    sleep 0.05; n=$((n + 1))\n"
            "  done\n"
            "}\n"
            ": > log\n"
            // A background command of a shell ignores SIGINT.
            "env --default-signal=INT \"$0\" " +
            command + " --watch > out 2> log &\npid=$!\nruns 1\n" + script +
            "\nkill -INT $pid\nwait $pid\ncode=$?\ncat out; cat log >&2; rm out log\n"
            "exit $code");
    }
};

TEST(Watch, ChecksAgainWhenTheProgramChanges) {
    const Watched folder;
    folder.write("a.nc", kSlot);
    folder.write("b.nc", at_rapid());
    const Ran ran = folder.watch("check a.nc", "cp b.nc a.nc; runs 2");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.out, "a.nc: clean")) << ran.out << ran.err;
    EXPECT_TRUE(contains(ran.out, "[rapid-in-material]")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "watch     run 1: exit code 0; ")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "watch     run 2: a.nc changed, exit code 1; ")) << ran.err;
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"a.nc", "b.nc"}));
}

TEST(Watch, RunsAgainWhenASettingAppearsInAFile) {
    const Watched folder;
    folder.write("a.nc", kSlot);
    folder.write("ncsim.toml", "version = 1\n");
    const Ran ran = folder.watch("run a.nc --stl a.stl",
                                 "cp a.stl first.stl\n"
                                 "echo 'stock = \"40x30x12\"' >> ncsim.toml; runs 2\n"
                                 "cmp -s a.stl first.stl && echo same");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_TRUE(contains(ran.err, "run 2: ncsim.toml changed, exit code 0")) << ran.err;
    EXPECT_FALSE(contains(ran.out, "same")) << ran.out;
    EXPECT_EQ(folder.files(),
              (std::vector<std::string>{"a.nc", "a.stl", "first.stl", "ncsim.toml"}));
}

TEST(Watch, NoticesANewProjectFile) {
    const Watched folder;
    folder.write("parts/a.nc", at_rapid());
    folder.write("b.nc", kSlot);
    const std::string script =
        "printf 'version = 1\n' > ncsim.toml; runs 2\n"
        "printf 'version = 1\nstock = \"40x30x12\"\n' > parts/ncsim.toml; runs 3\n"
        "rm ncsim.toml parts/ncsim.toml";
    for (const std::string command : {"check parts/a.nc", "run parts/a.nc"}) {
        const Ran ran = folder.watch(command, script);
        EXPECT_TRUE(contains(ran.err, "run 2: ncsim.toml changed")) << command << ran.err;
        EXPECT_TRUE(contains(ran.err, "run 3: parts/ncsim.toml changed")) << command << ran.err;
    }
}

TEST(Watch, NoticesProgramsOfAFolderAndSubprogramsThatAppear) {
    const Watched folder;
    folder.write("parts/a.ngc",
                 std::string(kSlot).insert(std::string(kSlot).find("M30"), "o<lift> call\n"));
    folder.write("b.nc", at_rapid());
    const Ran ran = folder.watch("check parts --json parts/out.json",
                                 "printf 'o<lift> sub\\nG0 Z9.\\no<lift> endsub\\n' > "
                                 "parts/lift.ngc; runs 2\n"
                                 "cp b.nc parts/b.nc; runs 3\nsleep 0.5");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_TRUE(contains(ran.err, "run 1: exit code 1")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "run 2: parts")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "run 3: parts changed, exit code 1")) << ran.err;
    EXPECT_FALSE(contains(ran.err, "run 4")) << ran.err;
    EXPECT_TRUE(contains(ran.out, "1 program: 1 clean")) << ran.out;
}

TEST(Watch, GoesOnAfterAFileThatCannotBeRead) {
    const Watched folder;
    folder.write("a.nc", kSlot);
    const Ran ran = folder.watch("check a.nc", "mv a.nc c.nc; runs 2; mv c.nc a.nc; runs 3");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_TRUE(contains(ran.err, "run 2: a.nc changed, exit code 2")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "run 3: a.nc changed, exit code 0")) << ran.err;
}

TEST(Watch, ASignalThatIsNotCtrlCEndsTheProcess) {
    const Watched folder;
    folder.write("a.nc", kSlot);
    const Ran ran = folder.watch("check a.nc", "kill -TERM $pid; wait $pid; echo code $?");
    EXPECT_TRUE(contains(ran.out + ran.err, "code 143") || ran.exit_code == 143);
}

TEST(Watch, RefusesWhatCannotBeWatched) {
    const Folder folder;
    folder.write("a.nc", kSlot);
    const Ran stream = folder.shell("\"$0\" check - --watch < a.nc");
    EXPECT_EQ(stream.exit_code, 2);
    EXPECT_EQ(stream.err,
              "ncsim: --watch: the standard input cannot be watched; save it as a file\n");
    const Ran tile = folder.run({"run", "a.nc", "--tile", "0/2", "--tile-out", "t", "--watch"});
    EXPECT_EQ(tile.exit_code, 2);
    EXPECT_EQ(tile.err, "ncsim: --watch: shards and tiles are not watched\n");
    folder.write("ncsim.toml", "version = 1\nwatch = true\n");
    EXPECT_EQ(folder.run({"check", "a.nc"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
