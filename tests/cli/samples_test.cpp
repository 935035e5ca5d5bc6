// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples run without further files, and the figures of the thesis about the samples hold.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

using nlohmann::json;

std::string sample(const char* name) {
    return std::string(NCSIM_SOURCE_DIR).append("/samples/").append(name);
}

json report_of(const char* name, std::vector<std::string> more = {}) {
    Folder folder;
    std::vector<std::string> arguments{"run", sample(name), "-q", "--report", "a.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = folder.run(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return json::parse(folder.read("a.json"));
}

// Returns the last line of the statistics by column name.
std::map<std::string, double> last_statistics(const char* name) {
    Folder folder;
    folder.run({"run", sample(name), "-q", "--stats", "a.csv"});
    std::istringstream text(folder.read("a.csv"));
    std::string names;
    std::string line;
    std::string last;
    std::getline(text, names);
    while (std::getline(text, line))
        last = line;
    std::map<std::string, double> row;
    std::istringstream columns(names);
    std::istringstream values(last);
    std::string column;
    std::string value;
    while (std::getline(columns, column, ',') && std::getline(values, value, ',')) {
        row[column] = std::stod(value);
    }
    return row;
}

TEST(Samples, SimpleIsAboutTwentyHullsWithFewIntersections) {
    const json report = report_of("simple.nc");
    EXPECT_EQ(report["model"]["hulls"], 22);
    EXPECT_EQ(report["tools"].size(), 1U);
    EXPECT_LT(last_statistics("simple.nc")["zero_cells_per_negative_cell"], 3.0);
}

TEST(Samples, ComplexIsAboutAHundredAndTwentyHullsAndItsDiagonalMeetsThemAll) {
    const json report = report_of("complex.nc");
    EXPECT_EQ(report["model"]["hulls"], 126);
    EXPECT_EQ(report["tools"].size(), 2U);
    EXPECT_GT(last_statistics("complex.nc")["zero_cells_per_negative_cell"], 6.0);
}

TEST(Samples, BothModelsAgreeOnTheVolumeOfEach) {
    for (const char* name : {"simple.nc", "complex.nc"}) {
        SCOPED_TRACE(name);
        const json tree = report_of(name, {"--model", "cda", "--block-volumes"});
        const json flat = report_of(name, {"--model", "cda-flat", "--block-volumes"});
        EXPECT_NEAR(tree["volume_mm3"]["part"].get<double>(),
                    flat["volume_mm3"]["part"].get<double>(), 1e-3);
        EXPECT_EQ(tree["blocks"].size(), flat["blocks"].size());
    }
}

TEST(Samples, WaveIsMoreThanNineHundredShortMovesOfABall) {
    const json report = report_of("wave.nc", {});
    EXPECT_GE(report["program"]["feed_moves"], 930);
    EXPECT_GE(report["model"]["hulls"], 930);
    // The flute length is in samples/ncsim.toml.
    EXPECT_EQ(report["tools"][0]["shape"], "ball end mill D6 L20");
    EXPECT_EQ(report["part"]["shells"], 1);
}

// With samples/ncsim.toml a check of the samples is clean.
TEST(Samples, AreCleanWithTheirSetUps) {
    Folder folder;
    const Ran ran = folder.run({"check", sample("simple.nc"), sample("complex.nc"),
                                sample("wave.nc"), sample("five-axis.nc")});
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_NE(ran.out.find("4 programs: 4 clean"), std::string::npos) << ran.out;
}

// Copies the sample of two set-ups to `folder`, with a text of job.toml replaced.
void copy_two_sides(const Folder& folder, const std::string& old, const std::string& text) {
    namespace fs = std::filesystem;
    for (const auto& file : fs::directory_iterator(sample("two-sides")))
        fs::copy_file(file.path(), folder.path() / file.path().filename());
    std::string job = folder.read("job.toml");
    const std::size_t at = job.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    folder.write("job.toml", job.replace(at, old.size(), text));
}

TEST(Samples, TwoSidesIsCleanInOneCommand) {
    Folder folder;
    const Ran job = folder.run({"check", sample("two-sides/job.toml")});
    EXPECT_EQ(job.exit_code, 0) << job.out << job.err;
    EXPECT_TRUE(contains(job.out, "2 programs: 2 clean")) << job.out;
    // Each program alone has the same set-up by samples/ncsim.toml.
    const Ran back = folder.run({"check", sample("two-sides/back.nc")});
    EXPECT_EQ(back.exit_code, 0) << back.out << back.err;
    EXPECT_TRUE(contains(back.out, "the part of set-up 1, top")) << back.out;
}

TEST(Samples, JobsAreReadByEveryCommand) {
    namespace fs = std::filesystem;
    const Folder folder;
    std::size_t jobs = 0;
    for (const auto& file : fs::recursive_directory_iterator(sample(""))) {
        if (!file.is_regular_file()) continue;
        const std::string path = file.path().string();
        std::ifstream in(path);
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        if (!path.ends_with(".toml") || path.ends_with("ncsim.toml") ||
            !contains(text, "version = 2"))
            continue;
        ++jobs;
        for (const std::vector<std::string>& words :
             std::vector<std::vector<std::string>>{{"run", path},
                                                   {"check", path},
                                                   {"measure", path},
                                                   {"tools", path},
                                                   {"machine", path},
                                                   {"diff", path, path},
                                                   {"sheet", path, "--html", "sheet.html"}}) {
            const Ran ran = folder.run(words);
            EXPECT_EQ(ran.exit_code, 0) << words.front() << ' ' << path << '\n'
                                        << ran.err << ran.out;
        }
        // All commands see the same stock.
        const std::string sheet = folder.read("sheet.html");
        const auto program =
            json::parse(folder.run({"check", path, "-q", "--json", "-"}).out)["programs"].back();
        EXPECT_TRUE(contains(sheet, program["stock"])) << program["stock"];
        EXPECT_TRUE(contains(folder.run({"run", path}).err, program["stock"])) << program["stock"];
    }
    EXPECT_EQ(jobs, 2U);
}

TEST(Samples, PicturesShowTheViseAndTheClamps) {
    Folder folder;
    const std::string job = sample("two-sides/job.toml");
    const auto draw = [&](const char* set_up, const char* file, std::vector<std::string> more) {
        std::vector<std::string> words{"run", job,      "--setup", set_up, "--png",
                                       file,  "--size", "320x240", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = folder.run(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return folder.read(file);
    };
    for (const char* set_up : {"1", "2"}) {
        const std::string bare = draw(set_up, "bare.png", {});
        const std::string held = draw(set_up, "held.png", {"--show-fixtures"});
        EXPECT_FALSE(bare == held) << set_up;
    }
    folder.write("slot.nc", "G21 G90\n(T1 D=6. - flat end mill)\nT1 M6\nG0 X0 Y0 Z5\nM30\n");
    const Ran none = folder.run(
        {"run", "slot.nc", "--stock", "20x20x5", "--png", "none.png", "--show-fixtures"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_TRUE(
        contains(none.err, "--show-fixtures: neither the job nor the machine has a fixture"))
        << none.err;
    EXPECT_FALSE(folder.has("none.png"));
}

TEST(Samples, TwoSidesWithAShiftedZeroHitsAClamp) {
    Folder folder;
    copy_two_sides(folder, "zero = [0, 0, 0]", "zero = [2, 0, 0]");
    const Ran ran = folder.run({"check", "job.toml"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_TRUE(contains(ran.out, "the cutter of T2 meets the fixture 'clamp right: arm'"))
        << ran.out;
    EXPECT_FALSE(contains(ran.out, "'clamp left")) << ran.out;
    // The zero is 2 mm too low: the tool enters the part in a rapid move.
    Folder low;
    copy_two_sides(low, "zero = [0, 0, 0]", "zero = [0, 0, -2]");
    const Ran deep = low.run({"check", "job.toml"});
    EXPECT_EQ(deep.exit_code, 1) << deep.out;
    EXPECT_TRUE(contains(deep.out, "set-up 2, back: rapid move through material")) << deep.out;
}

}  // namespace
}  // namespace ncsim::cli_test
