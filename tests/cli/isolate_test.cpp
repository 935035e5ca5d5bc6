// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that end early: a program that crashes, a program that exceeds the time limit, a signal.
// Also the progress that a terminal shows.
#include "cli/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// Returns a program that cuts for hours.
std::string endless() {
    return replaced(kSlot, "G1 X30. F500.",
                    "#1 = 0\no1 while [#1 lt 300000]\nG1 X30. Z[-#1/100000] F500.\nG1 X-30.\n"
                    "#1 = [#1 + 1]\no1 endwhile");
}

// Programs of all kinds. The middle program, b.nc, is a pipe: the check starts when a script opens
// the pipe for writing, and lasts until the script closes the pipe.
struct Programs : Folder {
    Programs() {
        write("a.nc", replaced(kSlot, "G1 X30. F500.", "G0 X30."));
        write("c.nc", kSlot);
        write("d.nc", replaced(kSlot, "(FROM/0.,0.,100.)", ""));
        write("endless", endless());
        EXPECT_EQ(shell("mkfifo b.nc").exit_code, 0);
    }
    // Checks the programs one by one. Runs `meanwhile` while the process `child` of the process
    // `pid` reads b.nc. The last line of `out` is the exit code of the check.
    Ran check(const std::string& options, const std::string& meanwhile) const {
        return shell("\"$0\" check a.nc b.nc c.nc d.nc -j 1 --json out.json " + options +
                     " & pid=$!\n"
                     "exec 3> b.nc\n"
                     "for stat in /proc/[0-9]*/stat; do\n"
                     "  read -r id name state parent rest 2>&- < $stat &&\n"
                     "  test \"$parent\" = $pid && child=$id\n"
                     "done\n" +
                     meanwhile + "\nwait $pid; echo code $?");
    }
    std::vector<std::string> verdicts() const {
        std::vector<std::string> words;
        const json report = json::parse(read("out.json"));
        for (const json& program : report["programs"])
            words.push_back(program["verdict"]);
        return words;
    }
};

TEST(Isolate, SaysTheSame) {
    const Folder folder;
    folder.write("a.nc", replaced(kSlot, "G1 X30. F500.", "G0 X30. (\xff)"));
    folder.write("b.ngc", replaced(kSlot, "G1 X30. F500.", "o<cut> call"));
    folder.write("cut.ngc", "o<cut> sub\nG1 X30. F500.\no<cut> endsub\nM2\n");
    folder.write("c.nc", kSlot);
    const Words programs{"check", "a.nc", "b.ngc", "nowhere.nc", "c.nc"};
    const Words reports{"--json",  "out.json", "--sarif", "out.sarif",
                        "--junit", "out.xml",  "--csv",   "out.csv"};
    const Words files{"out.json", "out.sarif", "out.xml", "out.csv"};
    const Ran plain = folder.run(programs + reports);
    EXPECT_EQ(plain.exit_code, 2);
    std::vector<std::string> written;
    for (const std::string& file : files)
        written.push_back(folder.read(file));
    for (const Words& how : {Words{"-j", "1"}, Words{"-j", "3"}, Words{"--cache", "cache"},
                             Words{"--cache", "cache"}, Words{"--max-time", "1000"}}) {
        const Ran ran = folder.run(programs + reports + how + Words{"--isolate"});
        EXPECT_EQ(ran.exit_code, plain.exit_code);
        EXPECT_EQ(ran.out, plain.out);
        EXPECT_EQ(ran.err, plain.err);
        for (std::size_t i = 0; i < files.size(); ++i)
            EXPECT_EQ(folder.read(files[i]), written[i]) << files[i];
    }
    const std::string out = folder.run(programs).out;
    EXPECT_EQ(folder.run(programs + Words{"--cache", "cache", "--isolate"}).out, out);
    EXPECT_EQ(folder.run(programs + Words{"--cache", "cache"}).out, out);
    EXPECT_EQ(folder.run(programs + Words{"--shard", "0/1", "--out", "out", "--isolate"}).exit_code,
              0);
    EXPECT_EQ(folder.run({"merge", "out"}).out, out);
    // A file that a child process read is an input and cannot be an output.
    const std::string cut = folder.read("cut.ngc");
    for (const Words& how : {Words{}, Words{"--isolate"}, Words{"--isolate", "--cache", "cache"}}) {
        const Ran ran = folder.run(Words{"check", "b.ngc", "--json", "cut.ngc"} + how);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_TRUE(contains(ran.err, "'cut.ngc' is read, too")) << ran.err;
    }
    EXPECT_EQ(folder.read("cut.ngc"), cut);
    EXPECT_EQ(folder.shell("\"$0\" check - --isolate < a.nc").out,
              folder.shell("\"$0\" check - < a.nc").out);
    EXPECT_EQ(folder.run({"check", "c.nc", "--isolate", "--html", "c.html"}).exit_code, 2);
}

TEST(Isolate, ACrashIsToldAndTheOthersGoOn) {
    const Programs folder;
    const Ran crashed = folder.check("--isolate", "kill -SEGV $child");
    EXPECT_TRUE(contains(crashed.out,
                         "b.nc: not verified: a bug of ours, please report it: its process was "
                         "ended by signal 11 (Segmentation fault)\n"))
        << crashed.out;
    EXPECT_TRUE(crashed.out.ends_with("code 3\n")) << crashed.out;
    EXPECT_EQ(folder.verdicts(), (Words{"failed", "not-verified", "clean", "not-proven"}));
    const Ran killed = folder.check("--isolate", "kill -KILL $child");
    EXPECT_TRUE(contains(killed.out,
                         "b.nc: not verified: its process was ended by signal 9 (Killed): perhaps "
                         "memory ran out\n"))
        << killed.out;
    EXPECT_TRUE(killed.out.ends_with("code 2\n")) << killed.out;
    EXPECT_EQ(folder.verdicts(), (Words{"failed", "not-verified", "clean", "not-proven"}));
}

TEST(Isolate, WhoDoesNotWatchTheTimeIsKilled) {
    const Programs folder;
    const Ran ran = folder.check("--isolate --max-time 0.01", "");
    EXPECT_TRUE(contains(ran.out,
                         "b.nc: not verified: it takes longer than --max-time 0.01: "
                         "killed\n"))
        << ran.out;
    EXPECT_TRUE(ran.out.ends_with("code 2\n")) << ran.out;
}

TEST(Isolate, NoProcessOutlivesTheirParent) {
    const Programs folder;
    // If the child process survived, the script would loop forever.
    const Ran ran = folder.check(
        "--isolate",
        "kill -KILL $pid; while read -r id name state rest 2>&- < /proc/$child/stat && "
        "test $state != Z; do sleep 0.01; done");
    EXPECT_TRUE(ran.out.ends_with("code 137\n")) << ran.out;
    EXPECT_FALSE(folder.has("out.json"));
}

void expect_what_is_known(const Programs& folder, const Ran& ran, const std::string& name,
                          int code) {
    EXPECT_TRUE(contains(ran.out, "a.nc:8:1: error: rapid move")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "b.nc: not verified: stopped by " + name + "\n" +
                                      "c.nc: not verified: stopped by " + name +
                                      " before it was begun\n" + "d.nc: not verified: stopped by " +
                                      name + " before it was begun\n"))
        << ran.out;
    EXPECT_TRUE(
        contains(ran.out, "\n4 programs: 0 clean, 0 not proven, 1 failed, 3 not verified\n"))
        << ran.out;
    EXPECT_TRUE(ran.out.ends_with("\ncode " + std::to_string(code) + "\n")) << ran.out;
    EXPECT_TRUE(
        contains(ran.err, "ncsim: stopped by " + name + ": 2 of 4 programs were not begun\n"))
        << ran.err;
    EXPECT_EQ(folder.verdicts(), (Words{"failed", "not-verified", "not-verified", "not-verified"}));
}

TEST(Interrupted, ACheckWritesWhatIsKnown) {
    const Programs folder;
    const std::string go = "cat endless >&3; exec 3>&-; kill -TERM $pid";
    expect_what_is_known(folder, folder.check("", go), "SIGTERM", 143);
    expect_what_is_known(folder, folder.check("--isolate", "kill -TERM $pid"), "SIGTERM", 143);
    expect_what_is_known(folder, folder.check("--isolate", "kill -HUP $pid"), "SIGHUP", 129);
}

TEST(Interrupted, AShardIsNotDone) {
    const Programs folder;
    const Ran ran = folder.shell(
        "\"$0\" check a.nc b.nc -j 1 --shard 0/1 --out out & pid=$!\n"
        "exec 3> b.nc; kill -TERM $pid; wait $pid; echo code $?");
    EXPECT_EQ(ran.out, "code 143\n");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "out"));
}

// Returns the text that a terminal receives as standard error of a check.
std::string shown_on_a_terminal(const Programs& folder, const std::string& options) {
    int ours = -1, terminal = -1;
    EXPECT_EQ(::openpty(&ours, &terminal, nullptr, nullptr, nullptr), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(terminal, STDERR_FILENO);
        const std::string script = "exec \"$0\" check a.nc b.nc c.nc -j 1 " + options + " > out";
        if (::chdir(folder.path().c_str()) == 0)
            ::execl("/bin/sh", "sh", "-c", script.c_str(), NCSIM_PROGRAM, nullptr);
        ::_exit(127);
    }
    ::close(terminal);
    // The check is at b.nc, and the verdict of a.nc is printed.
    const int pipe = ::open((folder.path() / "b.nc").c_str(), O_WRONLY);
    std::string shown;
    std::array<char, 4096> bytes{};
    const auto listen = [&] {
        const ssize_t n = ::read(ours, bytes.data(), bytes.size());
        if (n > 0) shown.append(bytes.data(), static_cast<std::size_t>(n));
        return n > 0;
    };
    if (options.empty()) {
        while (!contains(shown, "1 of 3 programs") && listen()) {
        }
    }
    const std::string slot = kSlot;
    EXPECT_EQ(::write(pipe, slot.data(), slot.size()), static_cast<ssize_t>(slot.size()));
    ::close(pipe);
    while (listen()) {
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ours);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status;
    return shown;
}

TEST(Progress, OfACheckIsForTerminals) {
    const Programs folder;
    const std::string shown = shown_on_a_terminal(folder, "");
    EXPECT_TRUE(shown.starts_with("\r[=")) << shown;
    EXPECT_TRUE(contains(shown, "  1 of 3 programs\x1b[K")) << shown;
    EXPECT_TRUE(shown.ends_with("\r\x1b[K")) << shown;
    const std::string out = folder.read("out");
    EXPECT_TRUE(out.starts_with("a.nc:8:1: error: ")) << out;
    EXPECT_FALSE(contains(out, "\r"));
    EXPECT_EQ(shown_on_a_terminal(folder, "-q"), "");
    folder.shell("rm b.nc");
    folder.write("b.nc", kSlot);
    const Ran plain = folder.run({"check", "a.nc", "b.nc", "c.nc", "-j", "1"});
    EXPECT_EQ(plain.out, out);
    EXPECT_EQ(plain.err, "");
}

}  // namespace
}  // namespace ncsim::cli_test
