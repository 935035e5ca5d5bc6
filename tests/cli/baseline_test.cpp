// SPDX-License-Identifier: GPL-3.0-or-later
//
// Known findings: findings that are accepted, findings that never are, and the reports about both.
#include "cli/run_program.h"
#include "support/count.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// Crosses the stock at rapid: one error, in line 8.
const std::string kRapid = replaced(kSlot, "G1 X30. F500.", "G0 X30.");

// Folder with the program and a baseline that contains the error.
struct Known : Folder {
    explicit Known(const std::string& program = kRapid) {
        write("part.nc", program);
        EXPECT_NE(run({"check", "part.nc", "--write-baseline", "known.json"}).exit_code, 2);
    }
    Ran check(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"check", "part.nc", "--baseline", "known.json"});
        return run(more);
    }
    json checked() const {
        check({"-q", "--json", "out.json"});
        return json::parse(read("out.json"))["programs"][0];
    }
};

TEST(Baseline, AcceptsWhatIsKnownAndSaysSo) {
    const Known folder;
    EXPECT_EQ(folder.run({"check", "part.nc"}).exit_code, 1);
    const Ran ran = folder.check(
        {"--json", "out.json", "--sarif", "out.sarif", "--junit", "out.xml", "--html", "out.html"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out,
                         "part.nc: accepted: 0 errors, 0 warnings, 0 notes, 0 doubts, 1 in the "
                         "baseline\n  baseline known.json\n"))
        << ran.out;
    EXPECT_FALSE(contains(ran.out, "part.nc:8")) << ran.out;
    const json program = json::parse(folder.read("out.json"))["programs"][0];
    EXPECT_EQ(program["verdict"], "accepted");
    EXPECT_EQ(program["baseline"], json::parse(R"({"file": "known.json", "accepted": 1,
                                                   "no_longer_found": []})"));
    EXPECT_EQ(program["counts"]["error"], 0);
    EXPECT_EQ(program["findings"][0]["accepted"], "");
    const json result = json::parse(folder.read("out.sarif"))["runs"][0]["results"][0];
    EXPECT_EQ(result["suppressions"], json::parse(R"([{"kind":"external","status":"accepted"}])"));
    EXPECT_TRUE(contains(folder.read("out.xml"), "failures=\"0\""));
    EXPECT_TRUE(contains(folder.read("out.html"), "in the baseline"));
    EXPECT_EQ(folder.check({"--github"}).out.find("::error"), std::string::npos);
    folder.write("clean.nc", kSlot);
    EXPECT_TRUE(contains(folder.check({"clean.nc"}).out,
                         "accepted:\n  part.nc: 0 errors, 0 warnings, 0 notes, 0 doubts, 1 in the "
                         "baseline\n2 programs: 1 clean, 1 accepted, 0 not proven, "));
}

TEST(Baseline, KnowsALineThatMoved) {
    const Known folder;
    std::string moved = "(a new comment)\n" + kRapid;
    moved = replaced(moved, "G0 X30.", "N80 g0 x30. ");
    moved = replaced(moved, "G0 Z5.\n", "N60 G0 Z5.\n\n(another)\n");
    folder.write("part.nc", moved);
    const Ran ran = folder.check();
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_FALSE(contains(ran.out, "no longer")) << ran.out;
}

TEST(Baseline, HidesNothingElse) {
    const Known folder;
    const std::vector<std::pair<std::string, std::string>> others{
        {"G0 Z-2.", "G0 Z-3."},             // removes more
        {"Y0. Z5.", "Y5. Z5."},             // elsewhere
        {"G0 X30.", "G0 X30. (again)"},     // another block
        {"D=10.", "D=11."},                 // more, again
        {"M3", "M3\nG0 X-10. Y0. Z-1.\n"},  // one more
        {"G0 X30.", "G0 X30.\nG0 X-30. Y9."},
    };
    for (const auto& [from, to] : others) {
        folder.write("part.nc", replaced(kRapid, from, to));
        EXPECT_EQ(folder.check().exit_code, 1) << to;
    }
    folder.write("other.nc", kRapid);
    EXPECT_EQ(folder.run({"check", "other.nc", "--baseline", "known.json"}).exit_code, 1);
    // A smaller violation of the same kind is not a new finding.
    folder.write("part.nc", replaced(kRapid, "G0 Z-2.", "G0 Z-1."));
    EXPECT_EQ(folder.check().exit_code, 0);
}

// Consecutive rapid moves make one finding, at the block where the first begins.
TEST(Baseline, HidesNoneOfARow) {
    const auto with = [](const std::string& moves) {
        return replaced(kSlot, "G1 X30. F500.\n", "G1 X-15. F500.\n" + moves);
    };
    const std::string row = "G0 X15.\nG0 Y9.\nG0 X-15.\nG0 X0.\n";
    const Known folder(with(row));
    EXPECT_EQ(folder.check().exit_code, 0);
    const auto rows = json::parse(folder.read("known.json"))["findings"];
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0]["count"], 3);
    const std::vector<std::pair<std::string, std::string>> others{
        {"G0 X-15.", "G0 X-14."},                      // different block, removes less
        {"G0 Y9.\nG0 X-15.\n", "G1 Y9.\nG0 X-15.\n"},  // fewer rapid moves
    };
    folder.write("part.nc", with("(moved)\n" + row));
    EXPECT_EQ(folder.check().exit_code, 0);
    for (const auto& [from, to] : others) {
        folder.write("part.nc", with(replaced(row, from, to)));
        EXPECT_EQ(folder.check().exit_code, 1) << to;
    }
}

TEST(Baseline, AcceptsNoneOfThoseThatNobodyCanTellApart) {
    const Known folder;
    folder.write("mill.toml", "[spindle]\nmax = 500\n");
    const auto errors = [&](const std::string& cuts, const std::string& option) {
        folder.write("part.nc", replaced(kSlot, "G1 X30. F500.\n", cuts));
        folder.run({"check", "part.nc", "--machine", "mill.toml", option, "known.json", "--json",
                    "out.json"});
        return json::parse(folder.read("out.json"))["programs"][0]["counts"]["error"];
    };
    const std::string one = "S1000\nG1 X30. F500.\nS400\nG1 X-30.\n";
    EXPECT_EQ(errors(one, "--write-baseline"), 1);
    EXPECT_EQ(errors(one, "--baseline"), 0);
    EXPECT_EQ(errors(one + one, "--baseline"), 2);
    EXPECT_EQ(errors(one + one, "--write-baseline"), 2);
    EXPECT_EQ(errors(one + one, "--baseline"), 0);
    EXPECT_EQ(errors(one, "--baseline"), 0);
    // Below a minimum, a lower spindle speed is a worse violation, not a smaller one.
    folder.write("mill.toml", "[spindle]\nmin = 2000\n");
    EXPECT_EQ(errors("G1 X30. F500.\n", "--write-baseline"), 1);
    EXPECT_EQ(errors("G1 X30. F500.\n", "--baseline"), 0);
    EXPECT_EQ(errors("S900\nG1 X30. F500.\n", "--baseline"), 1);
}

TEST(Baseline, ProvesNothing) {
    // A doubt is not a finding.
    const Known doubtful(replaced(kRapid, "(FROM/0.,0.,100.)", ""));
    const Ran ran = doubtful.check();
    EXPECT_EQ(ran.exit_code, 4) << ran.out;
    EXPECT_TRUE(contains(ran.out, "part.nc: not proven: 0 errors")) << ran.out;
    // The action of a control on a faulty block is unknown, even if the finding is accepted.
    const Known faulty(replaced(kSlot, "M30", "G2 X10. Y10. F100.\nM30"));
    EXPECT_EQ(faulty.run({"check", "part.nc"}).exit_code, 1);
    const Ran not_proven = faulty.check();
    EXPECT_EQ(not_proven.exit_code, 4) << not_proven.out;
    EXPECT_TRUE(contains(not_proven.out, "part.nc:10:")) << not_proven.out;
    EXPECT_TRUE(contains(not_proven.out, "[not-simulated]")) << not_proven.out;
    const Ran both = faulty.check({"--accept", "not-simulated"});
    EXPECT_EQ(both.exit_code, 0) << both.out;
    EXPECT_TRUE(contains(both.out, "part.nc: accepted (accepted not-simulated): ")) << both.out;
}

TEST(Baseline, CountsWarningsWhereTheyFail) {
    const Known folder(replaced(kSlot, "M30", "(ncsim: ignores x)\nM30"));
    EXPECT_EQ(folder.check().exit_code, 0);
    EXPECT_EQ(folder.checked()["verdict"], "clean");
    EXPECT_EQ(folder.run({"check", "part.nc", "--warnings-as-errors"}).exit_code, 1);
    const Ran ran = folder.check({"--warnings-as-errors"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_TRUE(contains(ran.out, "part.nc: accepted: ")) << ran.out;
}

TEST(Baseline, TellsWhatIsNoLongerThere) {
    const Known folder;
    folder.write("part.nc", kSlot);
    const Ran ran = folder.check({"--json", "out.json"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_TRUE(contains(ran.out,
                         "part.nc: no longer there, but in the baseline: error: rapid move "
                         "through material: removed 800 mm3 [rapid-in-material]\n"
                         "part.nc: clean: "))
        << ran.out;
    EXPECT_EQ(folder.checked()["baseline"]["no_longer_found"][0]["line"], 8);
    // A rule that was not requested reports no missing finding.
    EXPECT_FALSE(contains(folder.check({"--ignore", "collision"}).out, "no longer"));
    std::filesystem::rename(folder.path() / "part.nc", folder.path() / "new.nc");
    const Ran renamed = folder.run({"check", "new.nc", "--baseline", "known.json"});
    EXPECT_EQ(renamed.err, "ncsim: known.json: 1 known finding of 'part.nc', which is not there\n");
}

TEST(Baseline, IsSeenFromItsFolder) {
    const Known folder;
    std::filesystem::create_directories(folder.path() / "below");
    EXPECT_EQ(
        folder.shell("cd below && \"$0\" check ../part.nc --baseline ../known.json").exit_code, 0);
    EXPECT_EQ(folder.shell("\"$0\" check \"$PWD/part.nc\" --baseline known.json").exit_code, 0);
    folder.shell("cd below && \"$0\" check ../part.nc --write-baseline ../again.json");
    EXPECT_EQ(folder.read("again.json"), folder.read("known.json"));
    folder.write("ncsim.toml", "version = 1\nbaseline = \"known.json\"\n");
    EXPECT_EQ(folder.shell("cd below && \"$0\" check ../part.nc").exit_code, 0);
    EXPECT_EQ(folder.shell("cd / && \"$0\" check \"$OLDPWD\"").exit_code, 0);
}

TEST(Baseline, KeepsWhatPeopleWroteThere) {
    const Known folder;
    folder.write("ncsim.toml", "version = 1\nbaseline = \"known.json\"\n");
    folder.write("known.json",
                 replaced(folder.read("known.json"), "\"rule\"", "\"why\":\"soft foam\",\"rule\""));
    folder.write("other.nc", kRapid);
    // --write-baseline with a single program updates only the findings of the program in the file.
    EXPECT_EQ(folder.run({"check", "other.nc", "--write-baseline", "known.json"}).exit_code, 1);
    const json known = json::parse(folder.read("known.json"))["findings"];
    ASSERT_EQ(known.size(), 2U);
    EXPECT_EQ(known[0]["program"], "other.nc");
    EXPECT_EQ(known[1]["why"], "soft foam");
    const std::string before = folder.read("known.json");
    EXPECT_EQ(folder.run({"check", ".", "--write-baseline", "known.json"}).exit_code, 0);
    EXPECT_EQ(folder.read("known.json"), before);
    folder.run({"check", ".", "--sarif", "out.sarif"});
    EXPECT_TRUE(contains(folder.read("out.sarif"), "\"justification\": \"soft foam\""));
    folder.write("part.nc", kSlot);
    folder.run({"check", ".", "--write-baseline", "known.json"});
    EXPECT_EQ(json::parse(folder.read("known.json"))["findings"].size(), 1U);
}

TEST(Baseline, IsTheSameInShardsAndFromACache) {
    const Known folder;
    folder.write("new.nc", replaced(kRapid, "Y0.", "Y5."));
    folder.write("clean.nc", kSlot);
    folder.write("list.txt", "part.nc\nnew.nc\nclean.nc\n");
    const std::vector<std::string> command{"check",      "--list",     "list.txt",
                                           "--baseline", "known.json", "--no-project"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), command.begin(), command.end());
        return folder.run(more);
    };
    const Ran once = with({"--json", "once.json", "--write-baseline", "once-known.json"});
    EXPECT_EQ(once.exit_code, 1) << once.out;
    for (const char* shard : {"0/2", "1/2"})
        EXPECT_EQ(with({"--shard", shard, "--out", "out"}).exit_code, 0);
    const Ran merged = folder.run(
        {"merge", "out", "--json", "merged.json", "--write-baseline", "merged-known.json"});
    EXPECT_EQ(merged.out, once.out);
    EXPECT_EQ(folder.read("merged.json"), folder.read("once.json"));
    EXPECT_EQ(folder.read("merged-known.json"), folder.read("once-known.json"));
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(with({"--cache", "cache"}).out, once.out);
    // Baseline entries of different programs do not affect the cached verdict; entries of this
    // program do.
    folder.write("known.json", folder.read("once-known.json"));
    EXPECT_EQ(with({"--cache", "cache"}).exit_code, 0);
    std::size_t entries = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder.path() / "cache"))
        entries += file.is_regular_file() ? 1 : 0;
    EXPECT_EQ(entries, 4U);
    folder.write("known.json", "{\"ncsim-baseline\": 1, \"findings\": []}\n");
    EXPECT_EQ(with({"--cache", "cache"}).exit_code, 1);
    EXPECT_EQ(folder.run({"merge", "out"}).exit_code, 1);
    EXPECT_EQ(with({"--shard", "0/2", "--out", "out"}).exit_code, 0);
    EXPECT_TRUE(contains(folder.run({"merge", "out"}).err, "other options were asked for"));
}

TEST(Baseline, ThatIsNoneIsRefused) {
    const Known folder;
    const std::string whole = folder.read("known.json");
    for (const std::string& text :
         {std::string(), std::string("[]"), std::string("{\"findings\": []}"),
          whole.substr(0, whole.size() / 2), replaced(whole, ": 1,", ": 2,"),
          replaced(whole, "\"rule\"", "\"role\""), replaced(whole, "\"count\"", "\"counted\""),
          replaced(whole, "\"line\":8", "\"line\":\"8\""), replaced(whole, "\"min\"", "\"mim\"")}) {
        folder.write("known.json", text);
        const Ran ran = folder.check();
        EXPECT_EQ(ran.exit_code, 2) << text;
        EXPECT_TRUE(contains(ran.err, "'known.json'")) << ran.err;
        // The unreadable baseline is not overwritten.
        EXPECT_EQ(folder.run({"check", "part.nc", "--write-baseline", "known.json"}).exit_code, 2);
        EXPECT_EQ(folder.read("known.json"), text);
    }
    folder.write("known.json", whole);
    EXPECT_EQ(folder.check({"--json", "known.json"}).exit_code, 2);
    EXPECT_EQ(folder.read("known.json"), whole);
    EXPECT_EQ(folder.run({"check", "part.nc", "--baseline", "nowhere.json"}).exit_code, 2);
}

}  // namespace
}  // namespace ncsim::cli_test
