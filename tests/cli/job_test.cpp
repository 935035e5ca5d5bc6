// SPDX-License-Identifier: GPL-3.0-or-later
//
// Job files with several set-ups.
#include "cli/run_program.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

constexpr const char* kHead = "G21 G90 G17 G94\nT1 M6\nS6000 M3\n";

// Set-up 1 removes 2 mm around an island of 60 x 20 mm, set-up 2 a slot of 60 x 10 x 2 mm.
constexpr const char* kJob =
    "version = 2\nunits = \"mm\"\nstock = \"60x40x20\"\nstart = [0, 0, 100]\n"
    "[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 10\nlength = 22\nstick_out = 40\n"
    "holder = [[30, 30, 50]]\n"
    "[[setup]]\nname = \"top\"\nprogram = \"top.nc\"\n"
    "[[setup.fixture]]\nvise = { at = [0, 0, -25], opening = 40, jaw_width = 100, "
    "jaw_height = 15, jaw_depth = 20, parallels = [6, 5] }\n"
    "[[setup]]\nname = \"back\"\nprogram = \"back.nc\"\nturn = \"X180\"\n"
    "move = [0, 0, -20]\nfixture = []\n";

struct JobFolder : Folder {
    explicit JobFolder(const std::string& job = kJob) {
        write("top.nc", std::string(kHead) +
                            "G0 X-40 Y-15 Z20\nG0 Z2\nG1 Z-2 F300\nG1 X40 F800\nG1 Y15\n"
                            "G1 X-40\nG0 Z20\nM30\n");
        write("back.nc", std::string(kHead) +
                             "G0 X-40 Y-10 Z20\nG0 Z1\nG1 Z-2 F300\nG1 X40 F800\nG0 Z20\nM30\n");
        write("job.toml", job);
    }
    // Replaces a text of the job file.
    void change(const std::string& old, const std::string& text) const {
        std::string job = read("job.toml");
        const std::size_t at = job.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        write("job.toml", job.replace(at, old.size(), text));
    }
    json report(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"check", "job.toml", "--json", "a.json"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = run(words);
        EXPECT_TRUE(has("a.json")) << ran.err;
        json result = json::parse(read("a.json"));
        std::filesystem::remove(path() / "a.json");
        return result;
    }
};

TEST(JobOfTwoSetUps, IsCheckedRunMeasuredAndListedInOneCommand) {
    const JobFolder folder;
    const Ran check = folder.run({"check", "job.toml"});
    EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
    EXPECT_TRUE(contains(check.out, "2 programs: 2 clean")) << check.out;
    EXPECT_TRUE(contains(check.out, "\njob.toml: clean\n")) << check.out;
    const Ran run = folder.run({"run", "job.toml", "--report", "r.json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "set-up 1, top: top.nc\n")) << run.out;
    EXPECT_TRUE(contains(run.out, "45.600 cm3 of 48.000 cm3")) << run.out;
    EXPECT_TRUE(contains(run.out, "44.400 cm3 of 45.600 cm3")) << run.out;
    EXPECT_NEAR(json::parse(folder.read("r.json"))["volume_mm3"]["part"].get<double>(), 44400.0,
                1e-6);
    const Ran measure = folder.run({"measure", "job.toml", "--json", "m.json"});
    EXPECT_TRUE(contains(measure.out, "set-up 2, back: back.nc\n")) << measure.out;
    EXPECT_NEAR(json::parse(folder.read("m.json"))["volume_mm3"].get<double>(), 44400.0, 1e-6);
    const Ran tools = folder.run({"tools", "job.toml"});
    EXPECT_TRUE(contains(tools.out, "set-up 2, back: back.nc\nT1")) << tools.out;
    EXPECT_EQ(json::parse(folder.run({"tools", "job.toml", "--json"}).out)["programs"].size(), 2U);
}

// The stock of the second set-up is that of two calls by hand.
TEST(JobOfTwoSetUps, MakesThePartOfTwoCallsByHand) {
    const JobFolder folder;
    const std::vector<std::string> tool{"--tool=T1=flat:D10:L22", "--start=0,0,100"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), tool.begin(), tool.end());
        return folder.run(words).exit_code;
    };
    ASSERT_EQ(with({"run", "top.nc", "-q", "--stock", "60x40x20", "--save-stock", "a.ncstock"}), 0);
    ASSERT_EQ(with({"run", "back.nc", "-q", "--stock", "a.ncstock", "--stock-turn", "X180",
                    "--stock-move", "0,0,-20", "--stl", "hand.stl"}),
              0);
    ASSERT_EQ(folder.run({"run", "job.toml", "-q", "--stl", "job.stl"}).exit_code, 0);
    EXPECT_EQ(folder.read("job.stl"), folder.read("hand.stl"));
}

TEST(JobOfTwoSetUps, IsComparedWithAnotherJob) {
    JobFolder folder;
    EXPECT_EQ(folder.run({"diff", "job.toml", "job.toml"}).exit_code, 0);
    // The slot of set-up 2 is 0.5 mm deeper in the new job.
    std::string back = folder.read("back.nc");
    back.replace(back.find("G1 Z-2"), 6, "G1 Z-2.5");
    folder.write("deep.nc", back);
    std::string job = folder.read("job.toml");
    folder.write("new.toml", job.replace(job.find("back.nc"), 7, "deep.nc"));
    const Ran ran = folder.run({"diff", "job.toml", "new.toml", "--json", "d.json"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const json d = json::parse(folder.read("d.json"));
    ASSERT_EQ(d["set_ups"].size(), 2U);
    EXPECT_EQ(d["set_ups"][0]["differs"], false);
    EXPECT_EQ(d["set_ups"][1]["set_up"], "set-up 2, back");
    EXPECT_NEAR(d["set_ups"][1]["only_in_old"]["volume_mm3"], 60 * 10 * 0.5, 1e-6);
    EXPECT_EQ(d["differs"], true);
    EXPECT_EQ(folder.run({"diff", "job.toml", "new.toml", "--setup", "top"}).exit_code, 0);
    // Options of a job do not hold for the other job.
    folder.change("version = 2\n", "version = 2\nmodel = \"cda-flat\"\n");
    EXPECT_EQ(folder.run({"diff", "job.toml", "new.toml", "--setup", "top"}).exit_code, 2);
    EXPECT_EQ(folder.run({"diff", "new.toml", "job.toml", "--setup", "top"}).exit_code, 2);
    folder.change("model = \"cda-flat\"\n", "");
    // A program replaces that of the selected set-up.
    EXPECT_EQ(folder.run({"diff", "job.toml", "deep.nc", "--setup", "back"}).exit_code, 1);
    EXPECT_EQ(folder.run({"diff", "job.toml", "back.nc", "--setup", "back"}).exit_code, 0);
    EXPECT_TRUE(contains(folder.run({"diff", "job.toml", "deep.nc"}).err, "--setup"));
}

TEST(JobOfTwoSetUps, ThatPlacesThePartElsewhereDiffers) {
    JobFolder folder;
    std::string job = folder.read("job.toml");
    folder.write("new.toml", job.replace(job.find("[0, 0, -20]"), 11, "[1, 0, -20]"));
    const Ran ran = folder.run({"diff", "job.toml", "new.toml"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out, "set-up 2, back\nthe stocks differ")) << ran.out;
}

TEST(JobOfTwoSetUps, DiffRefusesWhatItCannotPair) {
    JobFolder folder;
    const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 2) << ran.out;
        EXPECT_TRUE(contains(ran.err, why)) << ran.err;
    };
    std::string job = folder.read("job.toml");
    folder.write("one.toml", job.substr(0, job.rfind("[[setup]]")));
    refused({"diff", "top.nc", "job.toml"}, "'top.nc' is not; expected OLD as a job");
    refused({"diff", "job.toml", "one.toml"}, "'job.toml' has 2 programs and 'one.toml' has 1");
    refused({"diff", "job.toml", "job.toml", "--json", "top.nc"}, "top.nc");
    EXPECT_TRUE(contains(folder.read("top.nc"), "G21"));
}

TEST(JobOfTwoSetUps, ShowsItsMachine) {
    JobFolder folder;
    const Ran none = folder.run({"machine", "job.toml"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_TRUE(contains(none.err, "'job.toml': the job names no machine")) << none.err;
    folder.write("mill.toml", "name = \"a mill\"\n");
    folder.change("version = 2\n", "version = 2\nmachine = \"mill.toml\"\n");
    folder.change("program = \"top.nc\"\n",
                  "program = \"top.nc\"\noffsets = { G54 = [1, 2, 3] }\n");
    const Ran ran = folder.run({"machine", "job.toml"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(contains(ran.out, "a mill\n")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "set-up 1, top\n  G54 at 1, 2, 3\n  fixture vise")) << ran.out;
}

// The stock of set-up 2 is kept for set-up 3; the verdict of set-up 3 still depends on top.nc.
TEST(JobOfThreeSetUps, KnowsTheFilesOfAllEarlierSetUps) {
    JobFolder folder;
    std::string job = folder.read("job.toml");
    folder.write("job.toml", job + "[[setup]]\nprogram = \"last.nc\"\nfixture = []\n");
    folder.write("last.nc", folder.read("back.nc"));
    const auto stock_of_last = [&] {
        const json report = folder.report({"--cache", "cache"});
        EXPECT_EQ(report["programs"].size(), 3U);
        return report["programs"][2]["ledger"]["stock_mm3"].get<double>();
    };
    const double before = stock_of_last();
    std::string top = folder.read("top.nc");
    folder.write("top.nc", top.replace(top.find("G1 Z-2"), 6, "G1 Z-1"));
    const double after = stock_of_last();
    EXPECT_GT(after, before + 1000.0);
    EXPECT_DOUBLE_EQ(stock_of_last(), after);
}

TEST(JobOfTwoSetUps, OneIsSelectedByNumberOrName) {
    const JobFolder folder;
    for (const char* name : {"2", "back"}) {
        const Ran ran = folder.run({"check", "job.toml", "--setup", name});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_TRUE(contains(ran.out, "back.nc (set-up 2, back): clean")) << ran.out;
        EXPECT_FALSE(contains(ran.out, "top.nc")) << ran.out;
    }
    EXPECT_TRUE(contains(folder.run({"check", "job.toml", "--setup", "3"}).err,
                         "no such set-up; expected 1 (top), 2 (back)"));
    EXPECT_EQ(folder.run({"run", "top.nc", "--setup", "1"}).exit_code, 2);
    // A program of the job is checked in its set-up.
    const Ran alone = folder.run({"check", "--job", "job.toml", "back.nc"});
    EXPECT_TRUE(contains(alone.out, "the part of set-up 1, top")) << alone.out;
}

TEST(JobOfTwoSetUps, HasTheWorstVerdict) {
    const JobFolder folder;
    // A stop next to the stock is in the way in set-up 1.
    folder.change("[[setup.fixture]]\n",
                  "[[setup.fixture]]\nbox = [[-42, -14, -10], [-38, -6, 3]]\n[[setup.fixture]]\n");
    const json failed = folder.report();
    EXPECT_EQ(failed["job"], "job.toml");
    EXPECT_EQ(failed["job_verdict"], "failed");
    EXPECT_EQ(failed["programs"][0]["verdict"], "failed");
    EXPECT_EQ(failed["programs"][0]["program"], "set-up 1, top");
    EXPECT_EQ(failed["programs"][1]["verdict"], "clean");
    EXPECT_EQ(folder.run({"check", "job.toml"}).exit_code, 1);
    EXPECT_EQ(folder.run({"check", "job.toml", "--setup", "2"}).exit_code, 0);
}

TEST(JobOfTwoSetUps, WhatSetUpOneAssumesKeepsSetUpTwoNotProven) {
    const JobFolder folder;
    folder.change("start = [0, 0, 100]\n", "");
    folder.change("name = \"back\"", "name = \"back\"\nstart = [0, 0, 100]");
    const json open = folder.report();
    EXPECT_EQ(open["programs"][0]["verdict"], "not-proven");
    EXPECT_EQ(open["programs"][1]["verdict"], "not-proven");
    EXPECT_TRUE(contains(open["programs"][1]["doubts"][0]["message"], "the part of set-up 1, top"));
    EXPECT_EQ(open["job_verdict"], "not-proven");
    // A reason that is accepted for the job does not return in the next set-up.
    const std::string reason = open["programs"][0]["doubts"][0]["reason"];
    folder.change("version = 2", "version = 2\naccept = [\"" + reason + "\"]");
    const json accepted = folder.report();
    EXPECT_EQ(accepted["programs"][0]["verdict"], "accepted");
    EXPECT_EQ(accepted["programs"][1]["verdict"], "clean");
    EXPECT_EQ(folder.run({"check", "job.toml"}).exit_code, 0);
}

TEST(JobOfTwoSetUps, ThatLeavesNoPartIsNotVerifiedFurther) {
    const JobFolder folder;
    folder.change("[[tool]]\nnumber = 1", "[[tool]]\nnumber = 7");
    const json report = folder.report();
    EXPECT_EQ(report["programs"][0]["verdict"], "not-proven");
    EXPECT_EQ(report["programs"][1]["verdict"], "not-verified");
    EXPECT_TRUE(contains(report["programs"][1]["failure"], "set-up 1, top (top.nc) leaves no part"))
        << report["programs"][1];
}

TEST(JobOfTwoSetUps, TurnsThePartByAnyAngle) {
    const JobFolder folder;
    folder.change("turn = \"X180\"", "turn = \"X180,Z30\"");
    EXPECT_EQ(folder.run({"check", "job.toml"}).exit_code, 0);
    folder.run({"measure", "job.toml", "-q", "--json", "m.json"});
    const json sheet = json::parse(folder.read("m.json"));
    // A rectangle of 60 x 40 turned by 30 degrees.
    const double x = 30.0 * 0.8660254 + 20.0 * 0.5;
    const double y = 30.0 * 0.5 + 20.0 * 0.8660254;
    EXPECT_NEAR(sheet["extents"]["max"][0].get<double>(), x, 1e-4);
    EXPECT_NEAR(sheet["extents"]["max"][1].get<double>(), y, 1e-4);
    EXPECT_NEAR(sheet["extents"]["max"][2].get<double>(), 0.0, 1e-4);
    EXPECT_LT(sheet["volume_mm3"].get<double>(), 45600.0);
    // A full turn in parts is no turn.
    folder.change("X180,Z30", "X180,Z30,Z-75,Z45");
    folder.run({"measure", "job.toml", "-q", "--json", "n.json"});
    EXPECT_NEAR(json::parse(folder.read("n.json"))["volume_mm3"].get<double>(), 44400.0, 1e-2);
}

TEST(JobOfTwoSetUps, ASetUpMayHaveSeveralPrograms) {
    const JobFolder folder;
    folder.change("program = \"top.nc\"", "programs = [\"top.nc\", \"more.nc\"]");
    folder.write("more.nc", std::string(kHead) +
                                "G0 X-40 Y0 Z20\nZ1\nG1 Z-1 F300\nX40 F800\n"
                                "G0 Z20\nM30\n");
    const json report = folder.report();
    ASSERT_EQ(report["programs"].size(), 3U);
    EXPECT_EQ(report["programs"][1]["program"], "set-up 1, top, program 2 of 2");
    EXPECT_EQ(report["job_verdict"], "clean");
    const Ran run = folder.run({"run", "job.toml"});
    EXPECT_TRUE(contains(run.out, "45.000 cm3 of 45.600 cm3")) << run.out;
    EXPECT_TRUE(contains(run.out, "43.800 cm3 of 45.000 cm3")) << run.out;
    EXPECT_EQ(folder.report({"--setup", "1"})["programs"].size(), 2U);
}

// Part and fixtures move against the zero together.
TEST(JobOfTwoSetUps, ZeroMovesPartAndFixtures) {
    const JobFolder folder;
    folder.change("[[setup]]\nname = \"top\"", "[[setup]]\nzero = [30, 0, 0]\nname = \"top\"");
    folder.change("fixture = []", "");
    const Ran run = folder.run({"run", "job.toml", "--setup", "1"});
    EXPECT_TRUE(contains(run.err, "X -60 to 0")) << run.err;
}

TEST(JobOfTwoSetUps, WritesOutputsBelowItsFolder) {
    const JobFolder folder;
    std::filesystem::create_directory(folder.path() / "out");
    folder.change("version = 2", "version = 2\noutputs = { stl = \"out/part.stl\" }");
    folder.change("name = \"top\"", "name = \"top\"\noutputs = { stl = \"out/top.stl\" }");
    ASSERT_EQ(folder.run({"check", "job.toml"}).exit_code, 0);
    EXPECT_FALSE(folder.has("out/part.stl"));
    const Ran ran = folder.shell("cd / && \"$0\" run -q \"$OLDPWD/job.toml\"");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(folder.has("out/part.stl"));
    EXPECT_TRUE(folder.has("out/top.stl"));
    EXPECT_NE(folder.read("out/part.stl"), folder.read("out/top.stl"));
}

TEST(JobOfTwoSetUps, RefusesHostileFilesAndWritesNothing) {
    const std::vector<std::pair<std::string, std::string>> kWrong{
        {"unist = \"mm\"", "job.toml:1:9: 'unist' is not known"},
        {"unist = \"mm\"", "(did you mean units?)"},
        {"outputs = { png = \"../x.png\" }", "outputs of a job are below the folder"},
        {"outputs = { png = \"/tmp/x.png\" }", "outputs of a job are below the folder"},
        {"outputs = { png = \"link/x.png\" }", "outputs of a job are below the folder"},
        {"outputs = { png = \"x.stl\" }", "expected a name that ends in .png"},
        {"program = \"top.nc\"", "with [[setup]], write program in each set-up"},
        {"machine = \"job.toml\"", "job.toml:"},
        {"machine = \"pipe\"", "it is no regular file"},
        {"tolerance = 99", "job.toml:1:13: --tolerance: expected"},
        {"tool_table = 3", "cannot read"},
        {"stock = \"1x\"", "job.toml"},
        {"assumed = [\"luck\"]", "not \"luck\""}};
    for (const auto& [line, message] : kWrong) {
        const JobFolder folder;
        std::filesystem::create_directory_symlink("/tmp", folder.path() / "link");
        ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
        std::string job = folder.read("job.toml");
        if (line.starts_with("stock")) job = "version = 2\n";
        folder.write("job.toml", line + "\n" + job);
        const std::vector<std::string> before = folder.files();
        for (const char* command : {"check", "run", "measure"}) {
            const Ran ran = folder.run({command, "job.toml"});
            EXPECT_EQ(ran.exit_code, 2) << command << ' ' << line << ran.out << ran.err;
            EXPECT_TRUE(contains(ran.out + ran.err, message)) << command << ' ' << line << '\n'
                                                              << ran.err;
        }
        EXPECT_EQ(folder.files(), before) << line;
    }
    const std::vector<std::pair<std::string, std::string>> kSetUps{
        {"program = \"job.toml\"", "a job cannot contain a job"},
        {"program = \"pipe\"", "it is no regular file"},
        {"program = \"none.nc\"", "cannot read 'none.nc'"},
        {"progam = \"top.nc\"", "(did you mean program?)"},
        {"turn = \"X180\"\nprogram = \"top.nc\"", "the stock is where [stock] places it"},
        {"turn = \"Q1\"\nprogram = \"top.nc\"", "expected angles about axes"},
        {"program = \"top.nc\"\nfixture = 3", "write [[setup.fixture]]"}};
    for (const auto& [line, message] : kSetUps) {
        const JobFolder folder("version = 2\nstock = \"60x40x20\"\n[[setup]]\n" + line + "\n");
        ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
        const std::vector<std::string> before = folder.files();
        for (const char* command : {"check", "run"}) {
            const Ran ran = folder.run({command, "job.toml"});
            EXPECT_EQ(ran.exit_code, 2) << command << ' ' << line;
            EXPECT_TRUE(contains(ran.out + ran.err, message)) << line << '\n' << ran.out << ran.err;
        }
        EXPECT_EQ(folder.files(), before) << line;
    }
    const JobFolder folder;
    EXPECT_EQ(folder.run({"check", "job.toml", "top.nc"}).exit_code, 2);
    EXPECT_EQ(folder.run({"run", "job.toml", "--job", "job.toml"}).exit_code, 2);
    EXPECT_EQ(folder.shell("\"$0\" run --job - < job.toml").exit_code, 2);
    EXPECT_EQ(folder.shell("\"$0\" check --job - < job.toml").exit_code, 2);
}

// A check that a clamp or the machine fails must not be clean with the saved job.
TEST(SavedJob, KeepsFixturesAndMachine) {
    JobFolder folder(
        "version = 2\nprogram = \"top.nc\"\nunits = \"mm\"\nstock = \"60x40x20\"\n"
        "start = [0, 0, 100]\nmachine = \"mill.toml\"\nbelow_stock = 3\n"
        "[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 10\nlength = 22\n"
        "[[fixture]]\nname = \"stop\"\nclearance = 0.5\nbox = [[35, -20, -20], [45, -10, 5]]\n"
        "[[fixture]]\noffset = \"G55\"\nbox = [[0, 0, -20], [1, 1, -10]]\n");
    folder.write("mill.toml",
                 "name = \"a mill\"\n[travel]\nx = [-200, 20]\n[offsets]\n"
                 "G54 = [0, 0, 0]\nG55 = [100, 0, 0]\n");
    const json before = folder.report();
    EXPECT_EQ(before["programs"][0]["verdict"], "failed");
    ASSERT_EQ(folder.run({"run", "job.toml", "-q", "--save-job", "saved/again.toml"}).exit_code, 2);
    std::filesystem::create_directory(folder.path() / "saved");
    ASSERT_EQ(folder.run({"run", "job.toml", "-q", "--save-job", "saved/again.toml"}).exit_code, 0);
    folder.run({"check", "saved/again.toml", "-q", "--json", "a.json"});
    const json after = json::parse(folder.read("a.json"));
    EXPECT_EQ(after["programs"][0]["findings"], before["programs"][0]["findings"]);
    folder.change("box = [[35, -20, -20], [45, -10, 5]]", "mesh = \"stop.stl\"");
    folder.run({"run", "top.nc", "--stock", "5x5x5@30,-20,-5", "--tool", "T1=flat:D1:L20", "-q",
                "--stl", "stop.stl"});
    const Ran mesh = folder.run({"run", "job.toml", "-q", "--save-job", "b.toml"});
    EXPECT_EQ(mesh.exit_code, 2) << mesh.err;
    EXPECT_TRUE(contains(mesh.err, "the fixture 'stop' is a mesh (job.toml:16")) << mesh.err;
    EXPECT_FALSE(folder.has("b.toml"));
}

TEST(Fixtures, AreBoxesByTheSizesOfViseAndClamp) {
    const JobFolder folder;
    folder.change("fixture = []",
                  "[[setup.fixture]]\nname = \"left\"\nclamp = { at = [-20, -15, 0], toward = "
                  "\"-X\", length = 40, width = 12, height = 10 }\n");
    const Ran ran = folder.run({"check", "job.toml"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out, "meets the fixture 'left: arm'")) << ran.out;
    const std::vector<std::pair<std::string, std::string>> kWrong{
        {"vise = { at = [0, 0, 0] }", "'setup.fixture.vise' needs opening"},
        {"vise = { opning = 3 }", "(did you mean opening?)"},
        {"vise = { at = [0, 0, 0], opening = 0 }", "expected a number above 0"},
        {"vise = { at = [0, 0, 0], along = \"Z\" }", "expected \"X\" or \"Y\""},
        {"clamp = { at = [0, 0, 0], toward = \"X\" }", "expected \"+X\""},
        {"clamp = { at = [0, 0, 0], toward = \"+X\", length = 9, width = 9, height = 9, heel = 3 }",
         "heel and table belong together"},
        {"box = [[0, 0, 0], [1, 1, 1]]\nclamp = { at = [0, 0, 0], toward = \"+X\", length = 9, "
         "width = 9, height = 9 }",
         "a fixture has one shape"}};
    for (const auto& [line, message] : kWrong) {
        const JobFolder wrong;
        wrong.change("fixture = []", "[[setup.fixture]]\n" + line);
        const Ran refused = wrong.run({"check", "job.toml"});
        EXPECT_EQ(refused.exit_code, 2) << line;
        EXPECT_TRUE(contains(refused.err, message)) << line << '\n' << refused.err;
        EXPECT_TRUE(contains(refused.err, "job.toml:")) << refused.err;
    }
}

TEST(Sheet, OfAJobHasAllThatTheOperatorNeeds) {
    const JobFolder folder;
    const Ran ran = folder.run({"sheet", "job.toml", "--html", "sheet.html"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const std::string page = folder.read("sheet.html");
    for (const char* text :
         {"set-up 1, top", "set-up 2, back", "top.nc", "flat end mill D10 L22", "40 mm", "D30 x 50",
          "vise: fixed jaw", "turned X180", "60 x 40 x 20 mm", "<svg"})
        EXPECT_TRUE(contains(page, text)) << text << '\n' << page;
    EXPECT_TRUE(contains(page, "194 mm feed")) << page;
    EXPECT_TRUE(contains(page, "origin of G54 in machine coordinates")) << page;
    EXPECT_FALSE(contains(page, "<h2>Operations</h2>")) << page;
    // Names from files stay text.
    folder.change("name = \"back\"", "name = \"<b>back\"");
    ASSERT_EQ(folder.run({"sheet", "job.toml", "--html", "sheet.html"}).exit_code, 0);
    EXPECT_FALSE(contains(folder.read("sheet.html"), "<b>"));
    EXPECT_EQ(folder.run({"sheet", "job.toml"}).exit_code, 2);
    EXPECT_EQ(folder.run({"sheet", "job.toml", "--html", "job.toml"}).exit_code, 2);
}

TEST(Precedence, IsCommandLineThenJobThenProject) {
    const JobFolder folder;
    folder.write("ncsim.toml",
                 "version = 1\nstock = \"90x90x20\"\ntolerance = 0.02\n"
                 "tool = [\"T1=flat:D4\", \"T9=flat:D8\"]\nmax-time = 500\n");
    folder.change("version = 2", "version = 2\ntolerance = 0.01");
    for (const char* command : {"run", "check"}) {
        const Ran ran = folder.run({command, "job.toml", "--verbose"});
        const std::string text = ran.out + ran.err;
        EXPECT_TRUE(contains(text,
                             "note: 'tolerance' = 0.01 of job.toml:2:13 counts; "
                             "ncsim.toml:3:13 has 0.02"))
            << text;
        EXPECT_TRUE(contains(text, "note: 'stock' = \"60x40x20\" of job.toml:4:9 counts")) << text;
        EXPECT_TRUE(contains(text, "note: 'tool' of job.toml:")) << text;
        EXPECT_TRUE(contains(text, "setting  tolerance = 0.01  job.toml:2:13")) << text;
        EXPECT_TRUE(contains(text, "max-time = 500  ncsim.toml:5:12")) << text;
        EXPECT_TRUE(contains(text, "tool = T9=flat:D8  ncsim.toml:4:8")) << text;
        EXPECT_FALSE(contains(text, "setting  stock = 90x90x20")) << text;
        EXPECT_TRUE(contains(text, "tool 1  job.toml:")) << text;
    }
    const Ran run = folder.run({"run", "job.toml", "--setup", "1"});
    EXPECT_TRUE(contains(run.err, "tolerance  arcs 0.01 mm")) << run.err;
    EXPECT_TRUE(contains(run.err, "60 x 40 x 20")) << run.err;
    EXPECT_FALSE(contains(run.err, "setting ")) << run.err;
    const Ran given =
        folder.run({"run", "job.toml", "--setup", "1", "--tolerance", "0.005", "--verbose"});
    EXPECT_TRUE(contains(given.err, "tolerance  arcs 0.005 mm")) << given.err;
    EXPECT_TRUE(contains(given.err, "setting  --tolerance 0.005  (command line)")) << given.err;
    EXPECT_FALSE(contains(given.err, "setting  tolerance = 0.01")) << given.err;
}

}  // namespace
}  // namespace ncsim::cli_test
