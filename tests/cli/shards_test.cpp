// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many programs: lists, folders, merged shards, cached verdicts.
#include "cli/run_program.h"
#include "support/count.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// Writes programs of all verdicts and an unreadable file; most programs are clean.
std::vector<std::string> many_programs(const Folder& folder) {
    std::vector<std::string> names;
    std::string list;
    for (int i = 0; i < 11; ++i) {
        std::string text = kSlot;
        if (i % 5 == 1) text = replaced(text, "G1 X30. F500.", "G0 X30. F500.");
        if (i == 6)
            text = replaced(text, "G0 X30. F500.",
                            "G0 X30. F500. (Gr\xf6\xdf"
                            "e)");
        if (i == 3) text = replaced(text, "(FROM/0.,0.,100.)", "");
        if (i == 4) text = replaced(text, "(STOCK", "(" + std::string(300, 'x') + ")\n(STOCK");
        if (i == 7) text += std::string(1, '\0') + std::string(100, '\1');
        names.push_back(fmt::format("p{}/part {}.nc", i % 3, i));
        std::filesystem::create_directories(folder.path() / fmt::format("p{}", i % 3));
        folder.write(names.back(), text);
        list += names.back() + (i % 2 ? "\n" : "\r\n");
    }
    folder.write("list.txt", list);
    return names;
}

const std::vector<std::string> kReports{"--json",    "all.json", "--sarif",
                                        "all.sarif", "--junit",  "all.xml"};
const std::vector<std::string> kFiles{"all.json", "all.sarif", "all.xml"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Shards, PutTogetherAreOneRun) {
    Folder folder;
    many_programs(folder);
    const Ran once = folder.run(with({"check", "--list", "list.txt"}, kReports));
    EXPECT_EQ(once.exit_code, 2) << once.out;  // a program cannot be read
    std::vector<std::string> reports;
    for (const std::string& file : kFiles)
        reports.push_back(folder.read(file));
    for (const int n : {1, 2, 7, 64}) {
        const std::string out = fmt::format("out{}", n);
        // Shards in any order, some twice.
        for (int k = 0; k < n + 3; ++k) {
            const int i = k * 5 % n;
            const Ran ran = folder.run({"check", "--list", "list.txt", "--shard",
                                        fmt::format("{}/{}", i, n), "--out", out});
            ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
            EXPECT_TRUE(contains(ran.out, fmt::format("shard {} of {}: ", i, n))) << ran.out;
        }
        for (int i = 0; i < n; ++i)
            ASSERT_EQ(folder
                          .run({"check", "--list", "list.txt", "--shard",
                                fmt::format("{}/{}", i, n), "--out", out})
                          .exit_code,
                      0);
        const Ran merged = folder.run(with({"merge", out}, kReports));
        EXPECT_EQ(merged.exit_code, once.exit_code) << merged.err;
        EXPECT_EQ(merged.out, once.out);
        for (std::size_t i = 0; i < kFiles.size(); ++i)
            EXPECT_EQ(folder.read(kFiles[i]), reports[i]) << kFiles[i] << ", " << n << " shards";
    }
}

TEST(Shards, AreRefusedWhereOneIsMissingForeignOrCutOff) {
    Folder folder;
    many_programs(folder);
    const auto shard = [&](const std::string& number, const std::vector<std::string>& more = {}) {
        EXPECT_EQ(
            folder
                .run(with({"check", "--list", "list.txt", "--shard", number, "--out", "out"}, more))
                .exit_code,
            0);
    };
    shard("0/3");
    shard("2/3");
    const Ran missing = folder.run({"merge", "out", "--json", "all.json"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_TRUE(contains(missing.err, "of 11 programs are in no shard")) << missing.err;
    EXPECT_FALSE(folder.has("all.json"));
    shard("1/3");
    EXPECT_EQ(folder.run({"merge", "out"}).exit_code, 2);  // a result of a program, not of a shard

    const std::string name = "out/shard-0001-of-0003.ndjson";
    const std::string whole = folder.read(name);
    folder.write(name, whole.substr(0, whole.size() / 2));
    const Ran cut = folder.run({"merge", "out"});
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_TRUE(contains(cut.err, "it is cut off")) << cut.err;
    // Incomplete results are computed again; complete results stay untouched.
    for (const std::size_t size : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
        folder.write(name, whole.substr(0, size));
        shard("1/3");
        EXPECT_EQ(folder.read(name), whole) << size;
    }
    folder.write(name, whole + "more\n");
    shard("1/3");
    EXPECT_EQ(folder.read(name), whole);

    shard("1/3", {"--ignore", "plunge"});
    const Ran foreign = folder.run({"merge", "out"});
    EXPECT_EQ(foreign.exit_code, 2);
    EXPECT_TRUE(contains(foreign.err, "other options were asked for")) << foreign.err;

    folder.write("other.ndjson", "{\"a\": 1}\n");
    EXPECT_TRUE(
        contains(folder.run({"merge", "other.ndjson"}).err, "is no result of ncsim check --shard"));
    EXPECT_EQ(folder.run({"merge", "nothing-there"}).exit_code, 2);
}

TEST(Shards, ThatContradictEachOtherAreRefused) {
    Folder folder;
    many_programs(folder);
    for (const char* out : {"a", "b"})
        EXPECT_EQ(
            folder.run({"check", "--list", "list.txt", "--shard", "0/1", "--out", out}).exit_code,
            0);
    EXPECT_EQ(folder.run({"merge", "a", "b", "-q"}).out, folder.run({"merge", "a", "-q"}).out);
    folder.write("p0/part 0.nc", replaced(kSlot, "G1 X30. F500.", "G0 X30. F500."));
    std::filesystem::remove_all(folder.path() / "b");
    EXPECT_EQ(folder.run({"check", "--list", "list.txt", "--shard", "0/1", "--out", "b"}).exit_code,
              0);
    const Ran ran = folder.run({"merge", "a", "b"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(contains(ran.err, "with another result")) << ran.err;
}

TEST(Shards, TakeTheirNumberFromTheScheduler) {
    Folder folder;
    many_programs(folder);
    const auto specified = [&](const std::string& environment, const char* number = "auto") {
        return folder.shell(environment + " \"$0\" check --list list.txt --out out --shard " +
                            number);
    };
    EXPECT_TRUE(contains(specified("SLURM_ARRAY_TASK_ID=11 SLURM_ARRAY_TASK_MIN=10 "
                                   "SLURM_ARRAY_TASK_COUNT=4")
                             .out,
                         "shard 1 of 4: "));
    EXPECT_TRUE(contains(
        specified("JOB_COMPLETION_INDEX=2; export JOB_COMPLETION_INDEX;", "$JOB_COMPLETION_INDEX/3")
            .out,
        "shard 2 of 3: "));
    EXPECT_TRUE(contains(specified("CI_NODE_INDEX=3 CI_NODE_TOTAL=3").out, "shard 2 of 3: "));
    EXPECT_EQ(specified("CI_NODE_INDEX=4 CI_NODE_TOTAL=3").exit_code, 2);
    const Ran uncounted = specified("SLURM_ARRAY_TASK_ID=2");
    EXPECT_EQ(uncounted.exit_code, 2);
    EXPECT_TRUE(contains(uncounted.err, "SLURM_ARRAY_TASK_COUNT is not")) << uncounted.err;
    EXPECT_EQ(specified("").exit_code, 2);
    for (const char* number : {"3/3", "-1/3", "1", "1/0", "1/x", "a/3", ""})
        EXPECT_EQ(
            folder.run({"check", "--list", "list.txt", "--shard", number, "--out", "o"}).exit_code,
            2)
            << number;
}

TEST(Check, TakesFoldersAndTellsAtTheEndWhichProgramsFailed) {
    Folder folder;
    many_programs(folder);
    folder.write("p0/notes.txt", "not a program");
    const Ran ran = folder.run({"check", "p0", "p1", "p2"});
    EXPECT_TRUE(contains(ran.out,
                         "failed:\n  p0/part 6.nc: 1 error, 0 warnings, 0 notes, 0 doubts\n"
                         "  p1/part 1.nc: 1 error"))
        << ran.out;
    EXPECT_TRUE(contains(ran.out, "11 programs: ")) << ran.out;
    EXPECT_TRUE(contains(ran.err, "1 left out: no NC program")) << ran.err;
    // A rule that was not requested is named once; clean programs are not listed.
    EXPECT_EQ(test::count(ran.out, "over-travel"), 1U) << ran.out;
    EXPECT_FALSE(contains(ran.out, "part 0.nc")) << ran.out;
    EXPECT_EQ(folder.run({"check", "p9"}).exit_code, 2);
    std::filesystem::create_directories(folder.path() / "empty");
    EXPECT_EQ(folder.run({"check", "empty"}).exit_code, 2);
    EXPECT_EQ(folder.run({"check"}).exit_code, 2);
    EXPECT_EQ(folder.shell("printf 'p0/part 0.nc\\n' | \"$0\" check --list -").exit_code, 0);
}

TEST(Cache, KnowsWhatHasNotChanged) {
    Folder folder;
    many_programs(folder);
    const std::vector<std::string> command =
        with({"check", "--list", "list.txt", "--cache", "cache"}, kReports);
    const Ran cold = folder.run(command);
    std::vector<std::string> reports;
    for (const std::string& file : kFiles)
        reports.push_back(folder.read(file));
    const auto is_same = [&](const Ran& ran) {
        EXPECT_EQ(ran.out, cold.out);
        EXPECT_EQ(ran.err, cold.err);
        EXPECT_EQ(ran.exit_code, cold.exit_code);
        for (std::size_t i = 0; i < kFiles.size(); ++i)
            EXPECT_EQ(folder.read(kFiles[i]), reports[i]);
    };
    is_same(folder.run(command));
    EXPECT_EQ(folder.run({"check", "--list", "list.txt"}).out, cold.out);

    // A flipped bit in an entry is a cache miss.
    namespace fs = std::filesystem;
    std::size_t entries = 0;
    for (const auto& file : fs::recursive_directory_iterator(folder.path() / "cache")) {
        if (!file.is_regular_file()) continue;
        ++entries;
        const std::string name = fs::relative(file.path(), folder.path()).string();
        std::string text = folder.read(name);
        text[text.size() / 2] ^= 1;
        folder.write(name, text);
    }
    EXPECT_EQ(entries, 10U);  // no entry for the unreadable program
    is_same(folder.run(command));
    is_same(folder.run(command));

    folder.write("p0/part 0.nc", replaced(kSlot, "G1 X30. F500.", "G0 X30. F500."));
    EXPECT_TRUE(contains(folder.run(command).out, "p0/part 0.nc:8:1: error: rapid move"));
    EXPECT_FALSE(contains(folder.run(with(command, {"--ignore", "collision"})).out, "part 0.nc"));
}

// A verdict copied to the name of a second entry is not valid.
TEST(Cache, KnowsWhoseAVerdictIs) {
    namespace fs = std::filesystem;
    const auto entry_of = [](const Folder& folder) {
        for (const auto& file : fs::recursive_directory_iterator(folder.path() / "cache")) {
            if (file.is_regular_file()) return file.path();
        }
        return fs::path();
    };
    Folder folder;
    folder.write("good.nc", kSlot);
    folder.write("bad.nc", replaced(kSlot, "G1 X30. F500.", "G0 X30. F500."));
    ASSERT_EQ(folder.run({"check", "good.nc", "--cache", "cache"}).exit_code, 0);
    const std::string good = folder.read(fs::relative(entry_of(folder), folder.path()).string());
    fs::remove_all(folder.path() / "cache");
    ASSERT_EQ(folder.run({"check", "bad.nc", "--cache", "cache"}).exit_code, 1);
    folder.write(fs::relative(entry_of(folder), folder.path()).string(), good);
    const Ran ran = folder.run({"check", "bad.nc", "--cache", "cache"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out, "bad.nc: failed: ")) << ran.out;
}

// The cache key of a program includes the files that the program calls, also files that do not
// exist yet.
TEST(Cache, KnowsWhichFilesWereRead) {
    Folder folder;
    folder.write("main.ngc", replaced(kSlot, "G1 X30. F500.", "o<cut> call"));
    const std::vector<std::string> command{"check", "main.ngc", "--cache", "cache"};
    const std::string missing = folder.run(command).out;
    EXPECT_EQ(folder.run(command).out, missing);
    folder.write("cut.ngc", "o<cut> sub\nG1 X30. F500.\no<cut> endsub\nM2\n");
    const std::string there = folder.run(command).out;
    EXPECT_NE(there, missing);
    folder.write("cut.ngc", "o<cut> sub\nG0 X30.\no<cut> endsub\nM2\n");
    EXPECT_TRUE(contains(folder.run(command).out, "rapid-in-material"));
    folder.write("cut.ngc", "o<cut> sub\nG1 X30. F500.\no<cut> endsub\nM2\n");
    folder.write("mill.toml", "[spindle]\nmax = 500\n");
    const auto on_mill = with(command, {"--machine", "mill.toml"});
    EXPECT_TRUE(contains(folder.run(on_mill).out, "spindle-limit"));
    folder.write("mill.toml", "[spindle]\nmax = 5000\n");
    EXPECT_FALSE(contains(folder.run(on_mill).out, "[spindle-limit]"));
}

// Reports name files relative to the current folder.
TEST(Cache, KnowsFromWhereItIsAsked) {
    Folder folder;
    folder.write("part.nc", kSlot);
    std::filesystem::create_directories(folder.path() / "below");
    const std::string part = (folder.path() / "part.nc").string();
    const std::string cache = (folder.path() / "cache").string();
    const auto asked = [&](const std::string& where, const std::string& more) {
        EXPECT_EQ(folder
                      .shell("cd " + where + " && \"$0\" check " + part + more +
                             " --json \"$OLDPWD\"/out.json -q")
                      .exit_code,
                  0);
        return folder.read("out.json");
    };
    for (const char* where : {"below", "."})
        EXPECT_EQ(asked(where, " --cache " + cache), asked(where, "")) << where;
    EXPECT_NE(asked("below", ""), asked(".", ""));
}

TEST(Cache, LetsNoOutputOverwriteWhatWasRead) {
    Folder folder;
    folder.write("main.ngc", replaced(kSlot, "G1 X30. F500.", "o<cut> call"));
    const std::string cut = "o<cut> sub\nG1 X30. F500.\no<cut> endsub\nM2\n";
    folder.write("cut.ngc", cut);
    for (int i = 0; i < 2; ++i) {
        folder.run({"check", "main.ngc", "--cache", "cache"});
        const Ran ran = folder.run({"check", "main.ngc", "--cache", "cache", "--json", "cut.ngc"});
        EXPECT_EQ(ran.exit_code, 2) << ran.out;
        EXPECT_EQ(folder.read("cut.ngc"), cut);
    }
}

TEST(Cache, ThatCannotBeWrittenIsToldOnceAndLosesNothing) {
    Folder folder;
    many_programs(folder);
    const std::string out = folder.run({"check", "--list", "list.txt"}).out;
    folder.write("file", "no folder");
    const Ran ran = folder.run({"check", "--list", "list.txt", "--cache", "file"});
    EXPECT_EQ(ran.out, out);
    EXPECT_EQ(test::count(ran.err, "cannot write to the cache 'file'"), 1U) << ran.err;
}

}  // namespace
}  // namespace ncsim::cli_test
