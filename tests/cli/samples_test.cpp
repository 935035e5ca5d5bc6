// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples run without further files, and the figures of the thesis about the samples hold.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

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

}  // namespace
}  // namespace ncsim::cli_test
