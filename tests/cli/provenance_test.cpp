// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that one command writes and a second command reads: values that the first command assumed
// are not specified values for the second.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

// Program in which a value is missing, with the expected reason for doubt.
struct Guess {
    const char* name;
    std::string program;
    std::string reason;
    bool in_job = true;  // a job file can specify the value
};

const std::string kNoMode = replaced(kSlot, "G21 G90", "G90");

std::vector<Guess> guesses() {
    return {
        {"stock", replaced(kSlot, "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n", ""), "stock-guess"},
        {"stock-place",
         replaced(kSlot, "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n",
                  "(Material Size)\n(X= 40, Y= 30, Z= 10)\n"),
         "stock-guess"},
        {"tool", replaced(kSlot, "(T1 D=10. CR=0. - ZMIN=-2. - flat end mill)\n", ""),
         "tool-guess"},
        {"kind", replaced(kSlot, " CR=0. - ZMIN=-2. - flat end mill", " - ZMIN=-2."), "tool-guess"},
        {"flutes",
         replaced(replaced(kSlot, "(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)",
                           "(STOCK/BLOCK,40.,30.,40.,20.,15.,40.)"),
                  "Z-2.\nG1", "Z-30.\nG1"),
         "flutes-guess"},
        {"units", kNoMode, "units-guess"},
        {"start", replaced(kSlot, " (FROM/0.,0.,100.)", ""), "start-unknown", false},
        {"left-out", replaced(kSlot, "S1000 M3\n", "S1000 M3\nM451\n"), "left-out", false},
        {"error", replaced(kSlot, "S1000 M3\n", "S1000 M3\nG2 X10.\n"), "", false},
    };
}

json verdict_of(const Folder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"-q", "--no-project", "--json", "verdict.json"});
    const Ran ran = folder.run(arguments);
    EXPECT_TRUE(folder.has("verdict.json")) << ran.err;
    return json::parse(folder.read("verdict.json"))["programs"][0];
}

std::set<std::string> doubts_of(const json& program) {
    std::set<std::string> reasons;
    for (const json& d : program["doubts"])
        reasons.insert(d["reason"]);
    return reasons;
}

// A path in the air above the slot: clean on any stock below.
const char* const kSecond =
    "(T1 D=10. CR=0. L=60. - flat end mill)\n"
    "G21 G90 G17 (FROM/0.,0.,100.)\nT1 M6\nS1000 M3\nG0 X-60. Y10. Z5.\nG0 Z-1.\n"
    "G1 X60. F500.\nG0 Z5.\nM30\n";

class Provenance : public testing::TestWithParam<std::size_t> {
protected:
    Provenance() : guess_(guesses()[GetParam()]) { folder_.write("first.nc", guess_.program); }

    // Runs the first program as a draft with one output, also if errors are expected.
    void run_first(const std::string& option, const std::string& file) const {
        const Ran ran = folder_.run({"run", "first.nc", "--draft", "-q", option, file});
        ASSERT_TRUE(folder_.has(file)) << ran.err;
    }

    Guess guess_;
    Folder folder_;
};

TEST_P(Provenance, OfAJobFileStaysAGuess) {
    if (!guess_.in_job) return;
    for (const std::vector<std::string>& writer :
         {std::vector<std::string>{"tools", "first.nc", "--save-job", "a.toml"},
          {"run", "first.nc", "--draft", "-q", "--save-job", "b.toml"}}) {
        folder_.run(writer);
        // `tools` does not guess a tool but requests a description.
        if (guess_.name == std::string("tool") && writer.front() == "tools") continue;
        const json program = verdict_of(folder_, {"--job", writer.back(), "first.nc"});
        EXPECT_EQ(program["verdict"], "not-proven") << writer.front() << program.dump(1);
        EXPECT_TRUE(doubts_of(program).contains(guess_.reason)) << program.dump(1);
        // Also if a job file is written from a job file.
        folder_.run({"run", "--job", writer.back(), "-q", "--save-job", "again.toml"});
        const json again = verdict_of(folder_, {"--job", "again.toml", "first.nc"});
        EXPECT_TRUE(doubts_of(again).contains(guess_.reason)) << again.dump(1);
    }
}

TEST_P(Provenance, OfAStockFileIsADoubtOfTheNextProgram) {
    folder_.write("second.nc", kSecond);
    for (const auto& [option, file] :
         std::vector<std::pair<std::string, std::string>>{{"--save-stock", "a.ncstock"},
                                                          {"--stl", "a.stl"},
                                                          {"--vrml", "a.wrl"},
                                                          {"--gltf", "a.glb"},
                                                          {"--step", "a.step"}}) {
        run_first(option, file);
        const json program = verdict_of(folder_, {"second.nc", "--stock", file});
        EXPECT_EQ(program["verdict"], "not-proven") << file << program.dump(1);
        EXPECT_TRUE(doubts_of(program).contains("file-origin")) << file << program.dump(1);
    }
    // The assumptions of a stock file persist in the next stock file.
    folder_.run({"run", "second.nc", "-q", "--stock", "a.ncstock", "--save-stock", "b.ncstock"});
    EXPECT_TRUE(doubts_of(verdict_of(folder_, {"second.nc", "--stock", "b.ncstock"}))
                    .contains("file-origin"));
}

TEST_P(Provenance, OfADesignOrAFixtureIsADoubt) {
    folder_.write("second.nc", kSecond);
    run_first("--stl", "a.stl");
    folder_.write("machine.toml", "[[fixture]]\nname = \"block\"\nmesh = \"a.stl\"\n");
    for (const std::vector<std::string>& reader :
         {std::vector<std::string>{"second.nc", "--stock", "40x30x10", "--design", "a.stl"},
          {"second.nc", "--stock", "40x30x10", "--machine", "machine.toml"}}) {
        EXPECT_TRUE(doubts_of(verdict_of(folder_, reader)).contains("file-origin")) << reader[3];
    }
}

std::string name_of(const testing::TestParamInfo<std::size_t>& test) {
    std::string name = guesses()[test.param].name;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(EachGuess, Provenance, testing::Range<std::size_t>(0, guesses().size()),
                         name_of);

TEST(ProvenanceOfFiles, OfARunWithEverythingSpecifiedIsNoDoubt) {
    Folder folder;
    folder.write("first.nc", kSlot);
    folder.write("second.nc", kSecond);
    ASSERT_EQ(folder
                  .run({"run", "first.nc", "-q", "--save-job", "a.toml", "--save-stock",
                        "a.ncstock", "--stl", "a.stl", "--gltf", "a.glb", "--step", "a.step"})
                  .exit_code,
              0);
    EXPECT_EQ(verdict_of(folder, {"--job", "a.toml", "first.nc"})["verdict"], "clean");
    for (const char* stock : {"a.ncstock", "a.stl", "a.glb", "a.step"})
        EXPECT_EQ(verdict_of(folder, {"second.nc", "--stock", stock})["verdict"], "clean") << stock;
}

TEST(ProvenanceOfFiles, IsGoneWhenTheUserRemovesTheMark) {
    Folder folder;
    folder.write("first.nc", replaced(kSlot, " CR=0. - ZMIN=-2. - flat end mill", " - ZMIN=-2."));
    folder.run({"tools", "first.nc", "--save-job", "a.toml"});
    const std::string job = folder.read("a.toml");
    EXPECT_EQ(verdict_of(folder, {"--job", "a.toml", "first.nc"})["verdict"], "not-proven");
    const std::string mark = "assumed = [\"kind\", \"length\"]\n";
    folder.write("a.toml", replaced(job, mark, ""));
    EXPECT_EQ(verdict_of(folder, {"--job", "a.toml", "first.nc"})["verdict"], "clean");
    folder.write("a.toml", replaced(job, mark, "assumed = [\"colour\"]\n"));
    const Ran ran = folder.run({"check", "--job", "a.toml", "first.nc"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("'tool.assumed': expected \"shape\", \"kind\""), std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find("not \"colour\""), std::string::npos) << ran.err;
}

TEST(ProvenanceOfFiles, OfFilesOfVersion01IsUnknown) {
    Folder folder;
    folder.write("first.nc", kSlot);
    folder.write("second.nc", kSecond);
    folder.run({"run", "first.nc", "-q", "--save-job", "a.toml", "--save-stock", "a.ncstock"});
    folder.write("a.toml", replaced(folder.read("a.toml"), "version = 2", "version = 1"));
    folder.shell(
        "sed -i '/^source/d; /^surface/d; /^origin/d; s/^ncsim stock 3$/ncsim stock 1/'"
        " a.ncstock");
    EXPECT_TRUE(
        doubts_of(verdict_of(folder, {"--job", "a.toml", "first.nc"})).contains("file-origin"));
    EXPECT_TRUE(doubts_of(verdict_of(folder, {"second.nc", "--stock", "a.ncstock"}))
                    .contains("file-origin"));
}

TEST(Units, ThatAreSpecifiedAreNoDoubt) {
    Folder folder;
    folder.write("slot.nc", kNoMode);
    EXPECT_EQ(verdict_of(folder, {"slot.nc"})["verdict"], "not-proven");
    EXPECT_EQ(verdict_of(folder, {"slot.nc", "--units", "mm"})["verdict"], "clean");
}

}  // namespace
}  // namespace ncsim::cli_test
