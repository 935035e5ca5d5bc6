// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fourteen small parts, each written for Fanuc (.nc), in Klartext (.h) and for SINUMERIK 840D
// (.mpf): the three programs leave the same part, to the byte.
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace ncsim::cli_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTriples = fs::path(NCSIM_SOURCE_DIR) / "tests" / "cli" / "triples";

const std::vector<std::string> kSetUp{"--stock",         "80x60x20", "--tool",
                                      "T1=flat:D10:L30", "--tool",   "T2=drill:D6:L40",
                                      "--compensation",  "D1=5",     "--no-project"};

std::vector<std::string> parts() {
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(kTriples)) {
        if (file.path().extension() == ".nc") names.push_back(file.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

class Triples : public testing::TestWithParam<std::string> {};

TEST_P(Triples, LeaveTheSamePart) {
    const Folder folder;
    std::vector<std::string> stocks;
    for (const std::string ending : {".nc", ".h", ".mpf"}) {
        const std::string name = GetParam() + ending;
        fs::copy(kTriples / name, folder.path() / name);
        const std::string stock = "part" + ending + ".ncstock";
        std::vector<std::string> arguments{"run", name, "-q", "--save-stock", stock};
        if (ending == ".nc") arguments.insert(arguments.end(), {"--dialect", "fanuc"});
        arguments.insert(arguments.end(), kSetUp.begin(), kSetUp.end());
        const Ran ran = folder.run(arguments);
        EXPECT_EQ(ran.exit_code, 0) << name << '\n' << ran.err;
        stocks.push_back(folder.read_cells(stock));
        EXPECT_GT(stocks.back().size(), 100U) << name;
    }
    EXPECT_TRUE(stocks[0] == stocks[1]) << "Klartext";
    EXPECT_TRUE(stocks[0] == stocks[2]) << "SINUMERIK";
}

INSTANTIATE_TEST_SUITE_P(Parts, Triples, testing::ValuesIn(parts()), [](const auto& part) {
    std::string name = part.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(TripleParts, AreFourteenDifferentParts) {
    EXPECT_EQ(parts().size(), 14U);
}

TEST(TripleParts, DiffFindsNoDifference) {
    const Folder folder;
    for (const std::string name : {"holes.h", "holes.mpf", "lines.h"})
        fs::copy(kTriples / name, folder.path() / name);
    std::vector<std::string> arguments{"diff", "holes.h", "holes.mpf", "-q"};
    arguments.insert(arguments.end(), kSetUp.begin(), kSetUp.end());
    EXPECT_EQ(folder.run(arguments).exit_code, 0);
    arguments[2] = "lines.h";
    EXPECT_EQ(folder.run(arguments).exit_code, 1);
}

}  // namespace
}  // namespace ncsim::cli_test
